// Bilinear: elastic and post-elastic stiffness with kinematic hardening.
// Source: Cucuzza et al. 2025, Eq. (1), gives the virgin branch. The cyclic branches follow Masing's rules: the law is
// an elastic-perfectly-plastic part in parallel with a spring K2.  Units kN, mm.  Step: exact along a straight path.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

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
  static Params<double> with_factors(Params<double> p, double a, double b) {
    double const K2 = a * p.K2;
    p.K1 = K2 + b * (p.K1 - p.K2);
    p.K2 = K2;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Bilinear]
  // z is the force of an elastic-perfectly-plastic part of stiffness K1 - K2.
  template <class N>
  struct State {
    N z = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(z);
    }
  };
  template <class T, class X>
  struct Constants {
    T strength;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    return {abs((p.K1 - p.K2) * p.xy)};
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    N const trial = state.z + (p.K1 - p.K2) * N(step.dx);
    // min and max return their first argument if one of the two is NaN, so a NaN strength gives a NaN force.
    state.z = min(N(c.strength), max(N(-c.strength), trial));
    return p.K2 * N(step.x1) + state.z;
  }
  // [end]
};

}  // namespace isolaw::laws
