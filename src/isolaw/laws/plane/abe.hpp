// Abe in the plane, with a yield force that grows with the distance from the origin (abe) or stays constant (abe-y0).
// Source: Abe, Yoshida and Fujino 2004, part II, for the form F = F1 + F2 + F3. The largest distance from the origin so
// far takes the place of the largest displacement. The hysteretic force F2 has the yield force Yt = Y0 (1 + |x / Uh|^p)
// or Y0, and the yield displacement Ut:
//     dF2 = (Yt / Ut) (dx - |F2 / Yt|^(n-1) F2 / Yt |dx|)
// The elastic forces F1 and F3 have the direction of the vector x and the size that they have in one direction. Tests
// in one direction do not show whether a motion also softens F1 at right angles to itself (Softening). Step: sixth
// order (follow.hpp), in two pieces that meet where the distance begins to exceed the largest one so far.
#pragma once

#include "isolaw/laws/abe.hpp"
#include "isolaw/laws/abe_y0.hpp"
#include "isolaw/laws/plane/follow.hpp"

namespace isolaw::laws::plane {

template <class Law, Softening softening = Softening::by_distance>
struct AbeOf {
  using OneDirection = Law;
  static constexpr LawInfo const& info = OneDirection::info;
  template <class T>
  using Params = typename OneDirection::template Params<T>;

  template <class T>
  struct State {
    Vector<T> f{T(0.0), T(0.0)};      // hysteretic force F2 / Y0
    T peak = T(0.0);                  // largest distance from the origin so far
    Vector<T> peaks{T(0.0), T(0.0)};  // largest |x| and largest |y| so far, for Softening::by_axis
  };

  template <class T>
  static State<T> start(Params<T> const&) {
    return {};
  }

  template <class T>
  static Vector<T> step(Params<T> const& p, State<T>& state, Vector<T> const& from, Vector<T> const& to, double) {
    T const zero(0.0), one(1.0), peak0 = state.peak, distance1 = norm(to);
    Straight<T> const way(from, to);
    Split<T> const origin(from, way.direction);  // the start of the step, in components along and across the motion
    // After this length of the step the distance from the origin exceeds the largest one so far.
    T const reach = sqrt(max((peak0 - abs(origin.across)) * (peak0 + abs(origin.across)), zero)) - origin.along;
    T const inside = min(max(reach, zero), way.length);
    Split<T> f(state.f, way.direction);
    move(p, f, origin, zero, inside, peak0, false);
    move(p, f, origin, inside, way.length, peak0, true);
    state.peak = max(peak0, distance1);
    T const per_U = one / yield_length(p, peak0);
    // A step without motion leaves f as it is. It only gives f the derivatives that an elastic step would have.
    Vector<T> const at_rest = state.f + (strength(p, norm(from)) * per_U) * way.moved;
    state.f = chosen(way.length > zero, f.joined(way.direction), at_rest);
    if constexpr (softening == Softening::by_axis) {
      state.peaks = {max(state.peaks.x, abs(to.x)), max(state.peaks.y, abs(to.y))};
      return Vector<T>{radial(p, state.peaks.x, distance1) * to.x, radial(p, state.peaks.y, distance1) * to.y} +
             p.Y0 * state.f;
    } else {
      return radial(p, state.peak, distance1) * to + p.Y0 * state.f;
    }
  }

 private:
  static constexpr bool grows = requires(Params<double> const& p) { p.p; };

  template <class T>
  static T yield_length(Params<T> const& p, T const& peak) {
    return p.U0 * (T(1.0) + peak / p.Us);
  }
  // The yield force Yt at this distance from the origin, divided by Y0.
  template <class T>
  static T strength(Params<T> const& p, T const& distance) {
    if constexpr (grows)
      return T(1.0) + power(distance / p.Uh, p.p);
    else
      return T(1.0);
  }

  // Integrates f over the part of the step from `begin` to `end`. If `extends` is true, the distance from the origin
  // exceeds peak0 throughout this part, so the distance itself is the peak. Otherwise the peak is peak0.
  template <class T>
  static void move(Params<T> const& p, Split<T>& f, Split<T> const& origin, T const& begin, T const& end,
                   T const& peak0, bool extends) {
    T const one(1.0), half(0.5), fall = half * (p.n - one);
    auto const distance_at = [&](T const& l) {
      T const along = origin.along + l;
      return sqrt(rounded(along * along) + origin.across * origin.across);
    };
    auto const length_at = [&](T const& distance) { return yield_length(p, extends ? distance : peak0); };
    auto const slope = [&](Split<T> const& at, T const& l) {
      T const distance = distance_at(l), Y = strength(p, distance), per_Y = one / Y, per_U = one / length_at(distance);
      Split<T> const q(at.along * per_Y, at.across * per_Y);
      T const pull = power(square(q), fall);
      return Split<T>((Y * per_U) * (one - pull * q.along), -((Y * per_U) * pull) * q.across);
    };
    auto const longest = [&](Split<T> const& at, T const& l) {
      T const distance = distance_at(l), Y = strength(p, distance), U = length_at(distance);
      T const own = one / max(one, p.n);
      T size = max(min(sqrt(square(at)) / Y, own), T(least_distance)) * U;
      if (grows || extends) size = min(size, max(distance, T(least_distance) * U));
      return T(step_share) * size;
    };
    // Motion more than longest_memory yield displacements of travel before `end` has no effect on F2 any more, so the
    // integration skips it.
    T l = max(begin, end - T(longest_memory) * yield_length(p, max(peak0, max(distance_at(begin), distance_at(end)))));
    follow(f, l, end, slope, longest);
  }

  // The elastic force F1 + F3 divided by the distance from the origin.
  template <class T>
  static T radial(Params<T> const& p, T const& peak, T const& distance) {
    T const one(1.0), tiny(num::smallest_power_base);
    // The term a (1 - exp(-b distance)) of F1, divided by the distance, tends to a b at distance 0.
    T const step = select(distance > tiny, p.a * (one - exp(-p.b * distance)) / max(distance, tiny), p.a * p.b);
    return abe_parts::softened_K1<T, T>(p, peak) + step + p.K2 * power(distance / p.Uh, p.r);
  }
};

using Abe = AbeOf<laws::Abe>;
using AbeY0 = AbeOf<laws::AbeY0>;

}  // namespace isolaw::laws::plane
