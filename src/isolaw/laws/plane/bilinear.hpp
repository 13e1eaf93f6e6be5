// Bilinear in the plane: kinematic hardening about a circle.
// Source: perfect plasticity of stiffness K1 - K2 and strength (K1 - K2) xy beside a spring K2. Step: exact along a
// straight path. Inside the circle elastic; on it z turns towards the direction of motion, tan(angle / 2) falling as
// exp(-travel / xy) (Krieg and Krieg 1977). A radial return gives the same for motion along z alone; elsewhere it is
// the first order of this.
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
    // In this order a strength that is not a number stays one.
    state.z = chosen(beyond <= zero, state.z + stiffness * way.moved, after.joined(way.direction));
    return p.K2 * to + state.z;
  }
};

}  // namespace isolaw::laws::plane
