// Bilinear in the plane: kinematic hardening with a circular yield surface.
// Source: perfect plasticity of stiffness K1 - K2 and strength (K1 - K2) xy in parallel with a spring K2. Step: exact
// along a straight path. While z, the force of the plastic part, is inside the circle, it changes elastically. On the
// circle z turns towards the direction of motion: if a is the angle from z to the motion, tan(a / 2) falls as
// exp(-travel / xy) (Krieg and Krieg 1977). Rejected: a radial return, which is exact only for motion along z and of
// first order elsewhere.
#pragma once

#include "isolaw/laws/bilinear.hpp"
#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws::plane {

struct Bilinear {
  using OneDirection = laws::Bilinear;
  static constexpr LawInfo const& info = OneDirection::info;
  template <class T>
  using Params = OneDirection::Params<T>;

  template <class T>
  struct State {
    Vector<T> z{T(0.0), T(0.0)};
  };

  template <class T>
  static State<T> start(Params<T> const&) {
    return {};
  }

  template <class T>
  static Vector<T> step(Params<T> const& p, State<T>& state, Vector<T> const& from, Vector<T> const& to, double) {
    T const one(1.0), zero(0.0), tiny(num::smallest_power_base);
    T const stiffness = p.K1 - p.K2, strength = abs(stiffness * p.xy);
    Straight<T> const way(from, to);
    Split<T> const before(state.z, way.direction);
    T const at_yield = sqrt(max(rounded(strength * strength) - before.across * before.across, zero));
    T const beyond = stiffness * way.length - (at_yield - before.along);
    T const per_strength = one / max(strength, tiny);
    T const half = before.across / max(strength + at_yield, tiny) * exp(-max(beyond, zero) * per_strength);
    T const scale = strength / (one + half * half);
    Split<T> const after(scale * (one - half * half), scale * T(2.0) * half);
    // The test is `beyond <= zero`, not `beyond > zero`: it is false for NaN, so a NaN strength gives a NaN force.
    state.z = chosen(beyond <= zero, state.z + stiffness * way.moved, after.joined(way.direction));
    return p.K2 * to + state.z;
  }
};

}  // namespace isolaw::laws::plane
