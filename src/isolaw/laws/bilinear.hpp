// Bilinear: elastic and post-elastic stiffness with kinematic hardening.
// Source: Cucuzza et al. 2025, Eq. (1), gives the virgin branch. The cyclic branches follow Masing's rules, that is an
// elastic-perfectly-plastic part in parallel with K2.  Units kN, mm.  Step: exact along a straight path.
#pragma once

#include "isolaw/laws/canonical.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"

namespace isolaw::laws {

struct Bilinear {
  static constexpr LawInfo info{
      .id = "bilinear",
      .name = "Bilinear",
      .title = "Bilinear, kinematic hardening",
      .source = "Cucuzza et al. 2025, Eq. (1)",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true},
      .formula =
          "F = K2 x + z\n"
          "z -> z + (K1 - K2) dx, kept within +-(K1 - K2) xy",
      .note =
          "Table 4 prints the third parameter as F_y [mm]; it is read as the yield displacement xy of Eq. (1). From it follow the characteristic strength Qd = (K1 - K2) xy and the yield force K1 xy. Read as a yield force or a characteristic strength in kN, the printed numbers would give other loops.",
      .set = LawSet::paper,
      .step_cost = 22};

  template <class T>
  struct Params {
    T K1, K2, xy;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K1,
       parameter("K1", "kN/mm", "elastic stiffness", positive, Interval{1.0, 1.9}, {1.0, 10.0, stiffness})},
      {&Params<T>::K2,
       parameter("K2", "kN/mm", "post-elastic stiffness", any_value, Interval{0.35, 0.95}, {0.05, 1.0, stiffness})},
      {&Params<T>::xy,
       parameter("xy", "mm", "yield displacement", not_negative, Interval{30.0, 80.0}, {0.01, 0.6, disp})
           .in_paper("F_y")},
  });

  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{"K1 >= K2", [](Params<double> const& p) { return p.K1 >= p.K2; }}};
  static Canonical canonical(Params<double> const& p) { return BilinearForm{p.K1, p.K2, p.xy}; }

  template <class T>
  struct State {
    T z = T(0.0);  // force of the elastic-perfectly-plastic part
    T strength = T(0.0);
  };

  template <class T>
  static State<T> start(Params<T> const& p, Step const&, Integration) {
    return {.z = T(0.0), .strength = abs((p.K1 - p.K2) * p.xy)};
  }

  template <class T>
  static T step(Params<T> const& p, State<T>& state, Step const& step) {
    T const trial = state.z + (p.K1 - p.K2) * T(step.dx);
    // min and max return their first argument if one of the two is NaN, so a NaN strength gives a NaN force.
    state.z = min(state.strength, max(-state.strength, trial));
    return p.K2 * T(step.x1) + state.z;
  }
};

}  // namespace isolaw::laws
