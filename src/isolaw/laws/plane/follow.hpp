// Integrates the state q of a law along a straight path by an explicit method of sixth order (Butcher 1964, seven
// stages). The state q and its place on the path decide the length of a step, and no step is tried twice. Other lanes
// of a batch have no influence on the length: a lane gets the same bits as if it were computed alone.
// If the law's exponent n is below 1, |q|^n is not smooth at the origin. Near the origin a step is therefore a share of
// the distance from it, down to least_distance. The total error stays below 1e-6 of the strength for exponents of 0.01
// or more, and below 2e-7 for exponents of 0.1 or more (tests/verification/plane_test.cpp).
// Rejected: tables, which would need a second dimension across the motion and be copied with every trial; an embedded
// error estimate, which takes twice the work at a kink; a splitting of dq/dl into the exact flow of one direction and
// a remainder, because each of the two has a kink at a place where their sum is smooth.
#pragma once

#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws::plane {

// Lengths are in yield displacements. A step is step_share times the distance |q| of the state from the origin, or
// times a shorter length that the law sets. A distance below least_distance counts as least_distance.
inline constexpr double step_share = 0.25;
inline constexpr double least_distance = 1e-8;
// Motion farther back than this, in yield displacements of travel, no longer matters, except for exponents below 0.01.
inline constexpr double longest_memory = 1024.0;

namespace follow_parts {

template <class T>
Split<T> sum(Split<T> const& q, T const&) {
  return q;
}
// Returns q + h (weight1 k1 + weight2 k2 + ...) for the slopes k of a step of length h.
template <class T, class... Rest>
Split<T> sum(Split<T> const& q, T const& h, double weight, Split<T> const& k, Rest const&... rest) {
  T const share = T(weight) * h;
  return sum<T>(Split<T>(q.along + share * k.along, q.across + share * k.across), h, rest...);
}

}  // namespace follow_parts

// One step of length h from q at l; slope(q, l) is dq/dl.
template <class T, class Slope>
Split<T> sixth_order(Split<T> const& q, T const& l, T const& h, Slope const& slope) {
  using follow_parts::sum;
  T const third = l + T(1.0 / 3) * h, half = l + T(0.5) * h;
  auto const k1 = slope(q, l);
  auto const k2 = slope(sum(q, h, 1.0 / 3, k1), third);
  auto const k3 = slope(sum(q, h, 2.0 / 3, k2), l + T(2.0 / 3) * h);
  auto const k4 = slope(sum(q, h, 1.0 / 12, k1, 1.0 / 3, k2, -1.0 / 12, k3), third);
  auto const k5 = slope(sum(q, h, -1.0 / 16, k1, 9.0 / 8, k2, -3.0 / 16, k3, -3.0 / 8, k4), half);
  auto const k6 = slope(sum(q, h, 9.0 / 8, k2, -3.0 / 8, k3, -3.0 / 4, k4, 0.5, k5), half);
  auto const k7 = slope(sum(q, h, 9.0 / 44, k1, -9.0 / 11, k2, 63.0 / 44, k3, 18.0 / 11, k4, -16.0 / 11, k6), l + h);
  return sum(q, h, 11.0 / 120, k1, 27.0 / 40, k3, 27.0 / 40, k4, -4.0 / 15, k5, -4.0 / 15, k6, 11.0 / 120, k7);
}

// Moves q from l to `end` in steps of at most longest(q, l), lane by lane. A lane that has arrived stays as it is.
template <class T, class Slope, class Longest>
void follow(Split<T>& q, T& l, T const& end, Slope const& slope, Longest const& longest) {
  while (any(l < end)) {
    auto const moves = l < end;
    T const left = end - l, bound = longest(q, l);
    auto const arrives = left <= bound;
    T const h = select(arrives, left, bound);
    auto const next = sixth_order(q, l, h, slope);
    q.along = select(moves, next.along, q.along);
    q.across = select(moves, next.across, q.across);
    // A lane goes on only if `bound` is below `left`. A lane with a NaN therefore counts as arrived, and the loop ends.
    l = select(moves, select(bound < left, l + h, end), l);
  }
}

template <class T>
T square(Split<T> const& q) {
  return rounded(q.along * q.along) + q.across * q.across;
}

}  // namespace isolaw::laws::plane
