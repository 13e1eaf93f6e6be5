// The exact flow of several hysteretic laws: the solution of their differential equation between two reversals.
// Bouc-Wen's z and Abe's F2, divided by their saturation value and taken positive in the direction of motion, obey one
// autonomous equation in the dimensionless travel t, called time:
//     du/dt = 1 - u^n            for u >= 0  (from both sides towards saturation, u = 1)
//     du/dt = 1 + kappa |u|^n    for u <  0  (unloading, u rises to 0)
// Between two reversals u therefore always runs along a piece of one curve u(t), with t = 0 at u = 0. On either side of
// 0 one polynomial gives |u|. It needs no search in a table, no gather and no power per sample, and it has neither a
// step size nor a stability limit. Its variable x is chosen so that a low degree suffices. With E = exp(-rate |t|),
//     x = (1 - E) / (1 + bend E)
//   - rate = n for u > 0, because near saturation u is an analytic function of exp(-n t). For u < 0, look back in time
//     from u = 0: if kappa < 0, |u| comes to rest, and rate = n |kappa|^(1/n); if kappa > 0, |u| grows ever faster, and
//     rate is negative;
//   - for n above 1.3, bend = 2^(n-1) - 1 removes a pole that u has beyond saturation (exactly for n = 2, u = tanh t);
//   - near 0, u = t - t^(n+1) / (n + 1) ... is not smooth in x. The polynomial is therefore one in v = x^(1/5), since
//     u is 5 (1 + n) times differentiable in v.
// So |u| = x G(v), and conversely x = |u| H(|u|^(1/5)), with G and H of degree 16. They are fitted once per parameter
// set. Quadrature gives the travel t to 17 fixed values of |u|, with the pole of 1 / (1 - |u|^n) removed in closed
// form. H interpolates x / |u| at these values, and G interpolates |u| / x at 17 fixed v, for which Newton's method
// finds |u| on H. All of this is arithmetic with fixed matrices, the same for all parameter sets.
// Largest error in u over n in [0.01, 3], kappa in (-1, 3]: 1e-7 (abe with n < 0.1: 3e-7). For n > 2 with kappa > 1 it
// grows to 2e-5, and near kappa = -1 the equation magnifies errors by up to 1 / (1 + kappa) (tests/verification). For
// other n or kappa, and for abe beyond |u| = 3, a lane uses the table of tabulated_flow.hpp, with an error of 1e-5.
// Rejected: the table for all lanes (its gathers made AVX2 as slow as SSE2); coefficients as polynomials of n and kappa
// (2,400 numbers still leave 1e-6); Runge-Kutta with sub-steps (32 per sample still leave 3.8 % in the objective of abe
// near its optimum); an exponential step with frozen exponent (first order where n < 1 and u crosses 0).
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "isolaw/laws/flows/tabulated_flow.hpp"
#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

namespace flow_parts {

// `terms` is the number of coefficients of G and of H. Newton's first guess is extrapolated from up to `guesses`
// solutions.
inline constexpr std::size_t terms = 17, guesses = 6;

// The numbers that the fit of G and H needs for every parameter set. They are computed at the first call of get().
struct Nodes {
  using Values = std::array<double, terms>;
  // The fixed points of the fit, ascending in (0, 1): values of v, or of |u|^(1/5) divided by its largest value.
  Values place;
  Values fifth;  // the fifth power of each `place`
  Values log2_fifth;
  Values inverse_place;
  // Row i: weights for the values at all places. Their weighted sum is the mean over |u| from 0 to the |u| of place i.
  std::array<Values, terms> mean;
  // `chebyshev` turns values at the points `place` into coefficients of the Chebyshev polynomials T_k(y), y = 2 place -
  // 1; `power` turns those into coefficients of y^k. One matrix in place of the two would lose six digits.
  std::array<Values, terms> chebyshev, power;
  // The fit first subtracts a rough polynomial through a few of the points, because a small remainder has small
  // rounding errors. `few` holds the indices of these points. `chebyshev_of_few` turns the values there into the
  // coefficients of T_k, and `at_places` holds T_k at all points `place`.
  static constexpr std::array<std::size_t, 7> few{0, 2, 5, 8, 11, 14, 16};
  std::array<std::array<double, few.size()>, few.size()> chebyshev_of_few;
  std::array<std::array<double, few.size()>, terms> at_places;
  // Row i: weights that extrapolate Newton's first guess for place i from the solutions for the places above it; the
  // topmost solution is 1.
  std::array<std::array<double, guesses>, terms> guess;

  static Nodes const& get();
};

// A lane uses the polynomials if n lies between least_n and SaturatingFlow::largest_n and kappa is at most
// largest_kappa. Other lanes use the table.
inline constexpr double least_n = 0.01, largest_kappa = 3.0;
// For n above this the curve bends so sharply that the fit of G makes another pass of Newton's method.
inline constexpr double sharp_n = 1.5;
// If |u|, followed back in time, comes to rest only beyond 1 / least_rest, it is treated as if it never came to rest.
// `rate` is then negative and at least least_rate times n in size.
inline constexpr double least_rest = 0.05, least_rate = 0.05;
// The time is a logarithm of E (see the top of this file), which falls to 0 at saturation. A smaller E is replaced by
// this one, so that the time stays finite.
inline constexpr double saturated = 1e-13;

}  // namespace flow_parts

template <class T, Reach reach = Reach::within_saturation>
class SaturatingFlow {
  static constexpr bool beyond = reach == Reach::beyond_saturation;
  static constexpr double largest_n = beyond ? 1.3 : 3.05;
  static constexpr double largest_u = beyond ? 3.0 : 1.0;
  using Mask = decltype(std::declval<T>() < std::declval<T>());
  using Coefficients = std::array<T, flow_parts::terms>;

 public:
  // About the largest u below saturation, u = 1, for which time_at() is still exact.
  static constexpr double end_of_curve = 1.0 - 1e-12;
  // Needs n > 0 and kappa > -1, and kappa = 1 for Reach::beyond_saturation; other values give results that are not
  // finite. Where the polynomials cannot follow the curve, as for n above largest_n, a table takes their place.
  void fit(T const& n, T const& kappa);
  // time_at gives the time at which the curve has the value u, value_at the value at a time: value_at(time_at(u) +
  // travel) is u after that travel. Each inverts the other within rounding, so that repeated conversion does not drift.
  T time_at(T const& u) const;
  T value_at(T const& time) const {
    static_assert(!beyond);
    Mask const below = time < T(0.0);
    T value = any(below) ? value_at<true>(time, below) : value_at<false>(time, below);
    if (tabulated_) value = select(outside_ > T(0.0), table_.value_at(time + table_zero_), value);
    return value;
  }

  // advance() gives u after the given travel, which may also start from u > 1; the rates du/dt before and after the
  // travel; and their ratio rate1 / rate0, which is right even where both rates are 0.
  struct Advance {
    T u, rate0, rate1, ratio;
  };
  Advance advance(T const& u, T const& travel) const;

 private:
  // The polynomials G and H of one side of u = 0. They are stored for a scaled x, which is 1 at |u| = largest_u:
  // |u| = x G(2 x^(1/5) - 1), and x = w H(2 w^(1/5) - 1) with w = |u| / largest_u.
  struct Side {
    Coefficients value, inverse;
    // `rate` and `bend` as at the top of this file; `end` is the x at largest_u before x was scaled, and per_end =
    // 1/end.
    T rate, bend, end, per_end;
    void fit(T const& n, T const& kappa, T const& rest, bool bends);
  };
  // Chooses for each lane the coefficient of its side of u = 0. `mixed` says that some lanes are below 0.
  template <bool mixed>
  static T pick(Mask const& below, T const& above_zero, T const& below_zero) {
    if constexpr (mixed)
      return select(below, below_zero, above_zero);
    else
      return above_zero;
  }
  // Sums even and odd powers separately, which halves the latency.
  template <bool mixed>
  T polynomial(Coefficients Side::*c, Mask const& below, T const& y) const {
    auto const at = [&](std::size_t i) { return pick<mixed>(below, (rising_.*c)[i], (unloading_.*c)[i]); };
    T const square = y * y;
    T even = at(flow_parts::terms - 1), odd = at(flow_parts::terms - 2);
    for (std::size_t i = flow_parts::terms - 1; i > 2; i -= 2) {
      even = even * square + at(i - 2);
      odd = odd * square + at(i - 3);
    }
    return (even * square + at(0)) + y * odd;
  }
  struct Slope {
    T value, slope;
  };
  template <class At>
  static Slope with_slope(At const& at, T const& y) {
    T const square = y * y;
    T even = at(flow_parts::terms - 1), odd = at(flow_parts::terms - 2), even_slope(0.0), odd_slope(0.0);
    for (std::size_t i = flow_parts::terms - 1; i > 2; i -= 2) {
      even_slope = even_slope * square + even;
      odd_slope = odd_slope * square + odd;
      even = even * square + at(i - 2);
      odd = odd * square + at(i - 3);
    }
    even_slope = even_slope * square + even;
    even = even * square + at(0);
    T const slopes = even_slope + y * odd_slope, twice = y + y;
    return {even + y * odd, odd + twice * slopes};
  }
  // Returns |u| and d|u| / dx.
  template <bool mixed>
  Slope value_of(Mask const& below, T const& x) const {
    T const v = rounded(fifth_root(x));
    auto const g = with_slope([&](std::size_t i) { return pick<mixed>(below, rising_.value[i], unloading_.value[i]); },
                              v + v - T(1.0));
    return {rounded(x * g.value), rounded(g.value + T(0.4) * v * g.slope)};
  }
  template <bool mixed>
  T value_at(T const& time, Mask const& below) const;
  template <bool mixed>
  T time_at(T const& u, Mask const& below) const;

  Side rising_, unloading_;
  T n_;
  T first_time_, first_rate_;  // the time from u = -1 to u = 0, and du/dt at u = -1, which is also used below -1
  T outside_;  // 1 in lanes that need the table, because the polynomials do not serve their n or kappa; 0 in others
  bool bends_ = false;
  mutable bool tabulated_ = false;
  mutable TabulatedFlow<T, reach> table_;  // filled once a lane needs it; tabulated_ is then true
  T kappa_, table_zero_;
};

template <class T, Reach reach>
void SaturatingFlow<T, reach>::Side::fit(T const& n, T const& kappa, T const& rest, bool bends) {
  using flow_parts::terms;
  auto const& nodes = flow_parts::Nodes::get();
  constexpr double log2_largest = beyond ? 1.5849625007211562 : 0.0;
  T const one(1.0), zero(0.0);
  auto const transform = [](auto const& matrix, Coefficients const& values, std::size_t row) {
    T sum = rounded(T(matrix[row][0]) * values[0]);
    for (std::size_t k = 1; k < terms; ++k) sum = sum + T(matrix[row][k]) * values[k];
    return sum;
  };
  // At the points Nodes::place: dt/d|u| without its pole where |u| comes to rest, and the values to interpolate, which
  // are first x / |u| and then |u| / x.
  Coefficients smooth, nodal;
  for (std::size_t i = 0; i < terms; ++i) {
    T const u(largest_u * nodes.fifth[i]);
    T const flow = one + kappa * exp2(n * T(nodes.log2_fifth[i] + log2_largest)), pole = rounded(n * (one - rest * u));
    smooth[i] = select(rest > zero, pole - flow, pole) / (flow * pole);
  }
  for (std::size_t i = 0; i < terms; ++i) {
    T const u(largest_u * nodes.fifth[i]);
    T const less = expm1(-(rate * (u * transform(nodes.mean, smooth, i)))), decay = one + less;
    nodal[i] = rounded(rest * decay) - less * T(1.0 / (largest_u * nodes.fifth[i]));
    if (bends) nodal[i] = nodal[i] / (one + bend * ((one - rest * u) * decay));
  }
  auto const interpolate = [&](Coefficients& found) {
    constexpr auto& few = flow_parts::Nodes::few;
    std::array<T, few.size()> rough;
    for (std::size_t k = 0; k < few.size(); ++k) {
      rough[k] = rounded(T(nodes.chebyshev_of_few[k][0]) * nodal[few[0]]);
      for (std::size_t j = 1; j < few.size(); ++j)
        rough[k] = rough[k] + T(nodes.chebyshev_of_few[k][j]) * nodal[few[j]];
    }
    Coefficients c;
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t k = 0; k < few.size(); ++k) nodal[i] = nodal[i] - T(nodes.at_places[i][k]) * rough[k];
    for (std::size_t k = 0; k < terms; ++k) {
      c[k] = transform(nodes.chebyshev, nodal, k);
      if (k < few.size()) c[k] = c[k] + rough[k];
    }
    for (std::size_t k = 0; k < terms; ++k) {
      found[k] = rounded(T(nodes.power[k][k]) * c[k]);
      for (std::size_t j = k + 2; j < terms; j += 2) found[k] = found[k] + T(nodes.power[k][j]) * c[j];
    }
  };
  interpolate(inverse);
  for (std::size_t k = 0; k < terms; ++k) inverse[k] = rounded(T(largest_u) * inverse[k]);
  end = inverse[0];
  for (std::size_t k = 1; k < terms; ++k) end = end + inverse[k];
  per_end = one / end;
  for (std::size_t k = 0; k < terms; ++k) inverse[k] = rounded(inverse[k] * per_end);
  // For each fixed v = x^(1/5), from the largest down, finds place = w^(1/5), where w = |u| / largest_u, such that
  // place H^(1/5) is v.
  bool const sharp = any(n > T(flow_parts::sharp_n));
  std::array<T, terms + 1> place;
  place[terms] = one;
  for (std::size_t i = terms; i-- > 0;) {
    T at(nodes.place[i]);
    if (i + 1 < terms) {
      auto const& weight = nodes.guess[i];
      at = rounded(T(weight[0]) * place[i + 1]);
      for (std::size_t k = 1; k < flow_parts::guesses && i + k < terms; ++k) at = at + T(weight[k]) * place[i + 1 + k];
    }
    auto const better = [&](T const& guess) -> T {
      auto const h = with_slope([&](std::size_t k) { return inverse[k]; }, guess + guess - one);
      T const root = fifth_root(h.value), five = T(5.0) * h.value;
      return guess - (guess * root - T(nodes.place[i])) * five / (root * (five + (guess + guess) * h.slope));
    };
    at = better(at);
    if (i + 4 >= terms)
      at = better(at);
    else if (sharp)
      at = select(n > T(flow_parts::sharp_n), better(at), at);
    place[i] = at;
    T const stretch = at * T(nodes.inverse_place[i]), square = stretch * stretch;
    nodal[i] = rounded(T(largest_u) * (square * square * stretch));
  }
  interpolate(value);
}

template <class T, Reach reach>
void SaturatingFlow<T, reach>::fit(T const& n, T const& kappa) {
  T const one(1.0), zero(0.0);
  n_ = n;
  kappa_ = kappa;
  // 1 where x lies between `least` and `largest`, else 0. A NaN gives 0.
  auto const within = [&](T const& x, double least, double largest) {
    return select(x < T(least), zero, select(x <= T(largest), one, zero));
  };
  T const fitting = within(n, flow_parts::least_n, largest_n) *
                    (beyond ? within(kappa, 1.0, 1.0) : within(kappa, -1.0, flow_parts::largest_kappa)) *
                    select(kappa > T(-1.0), one, zero);
  outside_ = one - fitting;
  rising_.rate = n;
  if constexpr (beyond) {
    rising_.bend = unloading_.bend = zero;
    unloading_.rate = -n;
    rising_.fit(n, -one, one, false);
    unloading_.fit(n, one, zero, false);
    tabulated_ = false;
  } else {
    rising_.bend = select(n > T(1.3), exp2(n - one) - one, zero);
    // Followed back from u = 0, |u| would come to rest at 1 / rest; rest = 0 if it never rests, or only very far away.
    T const power = exp2(log2(max(-kappa, T(1e-300))) / n);
    T const rest = select(power > T(flow_parts::least_rest), power, zero), least = T(flow_parts::least_rate) * n;
    unloading_.rate = select(rest > zero, n * rest, -max(T(0.4) * n * kappa, least));
    unloading_.bend = select(rest > zero, rising_.bend, zero);
    bends_ = any(rising_.bend > zero);
    rising_.fit(n, -one, one, bends_);
    unloading_.fit(n, kappa, rest, bends_);
    first_rate_ = one + kappa;
    first_time_ = zero;
    tabulated_ = false;
    first_time_ = -time_at(-one);
    tabulated_ = any(outside_ > zero);
    if (tabulated_) {
      table_.tabulate(n, kappa);
      table_zero_ = table_.time_at(zero);
    }
  }
}

template <class T, Reach reach>
template <bool mixed>
T SaturatingFlow<T, reach>::value_at(T const& time, Mask const& below) const {
  T const one(1.0), way = abs(time), rate = pick<mixed>(below, rising_.rate, unloading_.rate);
  T inside = way;
  if constexpr (mixed) inside = select(below, min(way, first_time_), way);
  T x = rounded(-expm1(-rounded(rate * inside)));
  if (bends_) x = x / (one + pick<mixed>(below, rising_.bend, unloading_.bend) * (one - x));
  x = rounded(x * pick<mixed>(below, rising_.per_end, unloading_.per_end));
  T const v = rounded(fifth_root(x)), u = rounded(x * polynomial<mixed>(&Side::value, below, v + v - one));
  if constexpr (mixed)
    return select(below, -(u + first_rate_ * (way - inside)), min(u, one));
  else
    return min(u, one);
}

template <class T, Reach reach>
T SaturatingFlow<T, reach>::time_at(T const& u) const {
  static_assert(!beyond);
  Mask const below = u < T(0.0);
  T time = any(below) ? time_at<true>(u, below) : time_at<false>(u, below);
  if (tabulated_) time = select(outside_ > T(0.0), table_.time_at(u) - table_zero_, time);
  return time;
}
template <class T, Reach reach>
template <bool mixed>
T SaturatingFlow<T, reach>::time_at(T const& u, Mask const& below) const {
  constexpr double ln2 = 0.69314718055994530942;
  T const one(1.0), size = abs(u), w = min(size, one), root = rounded(fifth_root(w));
  T x = rounded(w * polynomial<mixed>(&Side::inverse, below, root + root - one));
  for (int pass = 0; pass < 2; ++pass) {
    auto const found = value_of<mixed>(below, x);
    x = x - (found.value - w) / found.slope;
  }
  x = rounded(x * pick<mixed>(below, rising_.end, unloading_.end));
  T E = one - x;
  if (bends_) E = E / (one + pick<mixed>(below, rising_.bend, unloading_.bend) * x);
  T const way = -T(ln2) * log2(max(E, T(flow_parts::saturated))) / pick<mixed>(below, rising_.rate, unloading_.rate);
  if constexpr (mixed)
    return select(below, -(way + (size - w) / first_rate_), way);
  else
    return way;
}

template <class T, Reach reach>
auto SaturatingFlow<T, reach>::advance(T const& u, T const& travel) const -> Advance {
  static_assert(beyond);
  T const one(1.0), zero(0.0), size = abs(u), w = min(size, T(largest_u));
  T const less = expm1(-(n_ * travel));
  // One end of the travel: s = 1 - E, which is negative below u = 0, and the x, u and slope there.
  struct Start {
    T s, x;
    Slope u;
    T per_end;
  };
  auto const start = [&]<bool mixed>(Mask const& below, std::bool_constant<mixed>) -> Start {
    T const root = rounded(fifth_root(w * T(1.0 / largest_u)));
    T const x = w * T(1.0 / largest_u) * polynomial<mixed>(&Side::inverse, below, root + root - one);
    return {x * pick<mixed>(below, rising_.end, unloading_.end), x, value_of<mixed>(below, x),
            pick<mixed>(below, rising_.per_end, unloading_.per_end)};
  };
  Mask const below0 = u < zero;
  Start const a = any(below0) ? start(below0, std::true_type()) : start(below0, std::false_type());
  T const E0 = one - a.s, s = a.s - E0 * less;
  auto const finish = [&]<bool mixed>(Mask const& below, std::bool_constant<mixed>) -> Start {
    T const per_end = pick<mixed>(below, rising_.per_end, unloading_.per_end), x = min(s * per_end, one);
    return {s, x, value_of<mixed>(below, x), per_end};
  };
  Mask const below1 = s < zero;
  Start const b = any(below1) ? finish(below1, std::true_type()) : finish(below1, std::false_type());
  T const decay = one + less, slope0 = a.u.slope * abs(a.per_end), slope1 = b.u.slope * abs(b.per_end);
  T const rate = n_ * E0, ratio = decay * slope1 / slope0;
  // H converts u to x with a small error. The effect of this error on the end is removed, so that such errors do not
  // add up over the steps.
  T end = select(below1, -b.u.value, b.u.value) + (w - a.u.value) * select(below0, -ratio, ratio);
  end = select(u > one, max(end, one), min(end, one));
  Advance moved{end, rate * slope0, rate * decay * slope1, ratio};
  Mask const outside = select(outside_ > zero, T(2.0 * largest_u), size) > T(largest_u);
  if (any(outside)) {
    if (!tabulated_) {
      table_.tabulate(n_, kappa_);
      tabulated_ = true;
    }
    auto const other = table_.advance(u, travel);
    moved.u = select(outside, other.u, moved.u);
    moved.rate0 = select(outside, other.rate0, moved.rate0);
    moved.rate1 = select(outside, other.rate1, moved.rate1);
    // The rates fall along the flow, so their ratio lies between 0 and 1. Close to saturation both rates consist of
    // rounding errors, so their ratio is limited to this range.
    moved.ratio = select(outside, max(zero, min(other.rate1 / other.rate0, one)), moved.ratio);
  }
  return moved;
}

}  // namespace isolaw::laws
