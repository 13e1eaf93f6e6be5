// Vaiana in the plane, for straight limit curves (no exponential hardening, no sigmoid) that are the same for loading
// and unloading: F = Kb d + f0 q with q' = alpha (n - q) along the path, d the displacement and n the direction of
// motion. Other parameters give no unique law in two directions. Step: exact along a straight path.
#pragma once

#include "isolaw/laws/plane/vector.hpp"
#include "isolaw/laws/vaiana.hpp"

namespace isolaw::laws::plane {

struct Vaiana {
  using OneDirection = laws::Vaiana;
  static constexpr LawInfo const& info = OneDirection::info;
  template <class T>
  using Params = OneDirection::Params<T>;

  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{
          "Kb+ = Kb- , f0+ = f0- , alpha+ = alpha-",
          [](Params<double> const& p) { return p.Kb_p == p.Kb_m && p.f0_p == p.f0_m && p.alpha_p == p.alpha_m; }},
      JointLimit<Params<double>>{"beta1+ = beta1- = gamma1+ = gamma1- = 0", [](Params<double> const& p) {
                                   return p.beta1_p == 0.0 && p.beta1_m == 0.0 && p.gamma1_p == 0.0 &&
                                          p.gamma1_m == 0.0;
                                 }}};

  template <class T>
  struct State {
    Vector<T> q{T(0.0), T(0.0)};
  };

  template <class T>
  static State<T> start(Params<T> const&) {
    return {};
  }

  template <class T>
  static Vector<T> step(Params<T> const& p, State<T>& state, Vector<T> const& from, Vector<T> const& to, double) {
    state.q = fading(state.q, Straight<T>(from, to), p.alpha_p);
    return p.Kb_p * to + p.f0_p * state.q;
  }
};

}  // namespace isolaw::laws::plane
