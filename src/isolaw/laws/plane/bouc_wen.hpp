// Bouc-Wen in the plane, in the form that does not depend on the axes.
// Source: Park, Wen and Ang 1986, written for the direction of motion:
//     dz = A dx - z |z|^(n-2) (z.dx) (beta sgn(z.dx) + gamma)
// The form often printed, with |z_x dx_x| + |z_y dx_y|, changes by some per cent of the strength when the axes turn.
// Step: let p be the component of z along the motion and s the one across it. z, and A times the travel, are divided by
// the largest |z|. Then, with c = 1 for p > 0 and c = (gamma - beta) / (gamma + beta) for p < 0,
//     p' = 1 - c |z|^(n-2) p^2,   s' = -c |z|^(n-2) p s
// For n = 2, p and s are hyperbolic or circular functions (exact); other n take steps of sixth order (follow.hpp). p
// only rises, so it passes 0 at most once, and one of these steps ends exactly there.
#pragma once

#include <limits>

#include "isolaw/laws/bouc_wen.hpp"
#include "isolaw/laws/plane/circular.hpp"
#include "isolaw/laws/plane/follow.hpp"

namespace isolaw::laws::plane {

struct BoucWen {
  using OneDirection = laws::BoucWen;
  static constexpr LawInfo const& info = OneDirection::info;
  template <class T>
  using Params = OneDirection::Params<T>;

  template <class T>
  struct State {
    Vector<T> z{T(0.0), T(0.0)};      // the hysteretic variable divided by z_max
    T z_max = T(0.0), rate = T(0.0);  // the largest |z| [mm], and A / z_max, which makes travel dimensionless
    T unloading = T(0.0);             // c = (gamma - beta) / (gamma + beta) of the equations above
  };

  template <class T>
  static State<T> start(Params<T> const& p) {
    T const both = p.beta + p.gamma, not_a_number(std::numeric_limits<double>::quiet_NaN());
    State<T> state;
    state.z_max = select(min(p.beta, both) > T(0.0), OneDirection::largest_z(p), not_a_number);
    state.rate = p.A / state.z_max;
    state.unloading = (p.gamma - p.beta) / both;
    return state;
  }

  template <class T>
  static Vector<T> step(Params<T> const& p, State<T>& state, Vector<T> const& from, Vector<T> const& to, double) {
    T const zero(0.0), one(1.0);
    Straight<T> const way(from, to);
    Split<T> z(state.z, way.direction);
    T const travel = state.rate * way.length;
    auto const is_two = abs(p.n - T(2.0)) <= zero;
    T const closed = select(is_two, travel, zero), stepped = select(is_two, zero, travel);
    if (any(closed > zero)) flow_of_two(z, closed, state.unloading);
    if (any(stepped > zero)) flow(z, min(stepped, T(longest_memory)), p.n, state.unloading);
    // A step without motion leaves z as it is. It only gives z the derivatives that an elastic step would have.
    state.z = chosen(travel <= zero, state.z + state.rate * way.moved, z.joined(way.direction));
    return (p.alpha * p.Ke) * to + ((one - p.alpha) * p.Ke * state.z_max) * state.z;
  }

 private:
  template <class T>
  static void flow_of_two(Split<T>& z, T const& travel, T const& unloading) {
    T const zero(0.0), one(1.0), from = min(z.along, zero);
    // While the motion unloads, z.along is negative and c is `unloading`; from z.along = 0 on, c is 1. The travel is
    // therefore cut at z.along = 0: `part` is the travel up to there, or all of it if z.along stays negative.
    T const to_zero = Circular<T>::length_to(-from, unloading), part = min(travel, to_zero);
    Circular<T> const back(unloading, part);
    T const per = one / (one + unloading * from * back.tan);
    auto const unloads = z.along < zero, passes = travel >= to_zero;
    T const across_at_zero = z.across / sqrt(max(one - unloading * from * from, T(num::smallest_power_base)));
    z.across = select(unloads, select(passes, across_at_zero, z.across * back.sec * per), z.across);
    z.along = select(unloads, select(passes, zero, (from + back.tan) * per), z.along);
    T const rest = select(unloads, max(travel - to_zero, zero), travel);
    Circular<T> const on(one, rest);
    T const p = max(z.along, zero), per_on = one / (one + p * on.tan);
    auto const loads = rest > zero;
    z.along = select(loads, (p + on.tan) * per_on, z.along);
    z.across = select(loads, z.across * on.sec * per_on, z.across);
  }

  template <class T>
  static void flow(Split<T>& z, T const& travel, T const& n, T const& unloading) {
    T const zero(0.0), one(1.0), half(0.5), fall = half * (n - T(2.0)), tiny(num::smallest_power_base);
    auto const rates = [&](Split<T> const& at, T const& c) {
      T const pull = c * at.along * power(square(at), fall);
      return Split<T>(one - pull * at.along, -pull * at.across);
    };
    // The longest step from `at`: a fraction of |z|, or of 1 / (n |c|), since the rates change at most at the rate n
    // |c|.
    auto const longest = [&](Split<T> const& at, T const& c) {
      T const own = one / max(n * abs(c), one);
      return T(step_share) * max(min(sqrt(square(at)), own), T(least_distance));
    };
    T l = zero;
    while (any(select(z.along < zero, travel - l, zero) > zero)) {
      auto const unloads = select(z.along < zero, travel - l, zero) > zero;
      T const left = travel - l, speed = rates(z, unloading).along, bound = longest(z, unloading) / max(speed, one);
      // A step that would pass p = 0 takes p as its variable and computes the travel, so that it ends at p = 0.
      auto const near = -z.along < T(1.25) * bound * max(speed, tiny);
      T landed = zero, across_there = zero;
      if (any(near)) {
        auto const by_p = [&](Split<T> const& at, T const& p) {
          auto const k = rates(Split<T>(p, at.across), unloading);
          return Split<T>(one / max(k.along, tiny), k.across / max(k.along, tiny));
        };
        auto const there = sixth_order(Split<T>(zero, z.across), z.along, -z.along, by_p);
        landed = there.along;
        across_there = there.across;
      }
      auto const lands = select(near, landed, left + left) <= left;
      T const h = min(left, bound);
      auto const next = sixth_order(z, l, h, [&](Split<T> const& at, T const&) { return rates(at, unloading); });
      z.across = select(unloads, select(lands, across_there, next.across), z.across);
      z.along = select(unloads, select(lands, zero, next.along), z.along);
      l = select(unloads, select(lands, l + landed, select(bound < left, l + h, travel)), l);
    }
    follow(
        z, l, travel, [&](Split<T> const& at, T const&) { return rates(at, one); },
        [&](Split<T> const& at, T const&) { return longest(at, one); });
  }
};

}  // namespace isolaw::laws::plane
