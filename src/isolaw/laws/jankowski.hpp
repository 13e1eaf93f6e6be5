// Jankowski: a non-linear spring and dashpot in displacement and velocity, without memory.
// Source: Cucuzza et al. 2025, Eqs. (2)-(5), after Jankowski 2003; the product x'x' printed in Eq. (3) is read as one
// x'. Units N, m, s.  Step: algebraic, exact at every sample.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct Jankowski {
  static constexpr LawInfo info{
      .id = "jankowski",
      .name = "Jankowski",
      .title = "Jankowski, non-linear spring and dashpot",
      .source = "Cucuzza et al. 2025, Eqs. (2)-(5)",
      .force = N,
      .length = m,
      .traits = {.odd = true},
      .formula =
          "F = K x + C v\n"
          "K = a1 + a2 x^2 + a3 x^4 + a4 / cosh^2(a5 v) + a6 / (cosh(a7 v) cosh(a8 x))\n"
          "C = (a9 + a10 x^2) / sqrt(a11^2 + v^2)",
      .note =
          "F = K x + C v has the velocity once, although Eq. (3) prints it twice. Without motion the damping force is 0, also for a11 = 0.",
      .set = LawSet::paper,
      .step_cost = 270};

  template <class T>
  struct Params {
    T a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::a1,
       parameter("a1", "N/m", "constant stiffness", any_value, Interval{1e4, 1e6}, {-0.5, 1.5, stiffness})},
      {&Params<T>::a2, parameter("a2", "N/m^3", "coefficient of the stiffness that grows with x^2", any_value,
                                 Interval{1e6, 9e6}, {-1.0, 2.0, stiffness_per_disp2})},
      {&Params<T>::a3, parameter("a3", "N/m^5", "coefficient of the stiffness that grows with x^4", any_value,
                                 Interval{1e6, 9e6}, {-1.0, 1.0, stiffness_per_disp4})},
      {&Params<T>::a4, parameter("a4", "N/m", "stiffness that fades with velocity", any_value, Interval{1e3, 1e5},
                                 {-6.0, 6.0, stiffness})},
      {&Params<T>::a5, parameter("a5", "s/m", "rate at which the stiffness a4 fades with velocity", not_negative,
                                 Interval{1e3, 1e4}, {1.0, 1e4, per_velocity}, Scale::logarithmic)},
      {&Params<T>::a6, parameter("a6", "N/m", "stiffness that fades with velocity and displacement", any_value,
                                 Interval{1e5, 3.5e6}, {-10.0, 20.0, stiffness})},
      {&Params<T>::a7, parameter("a7", "s/m", "rate at which the stiffness a6 fades with velocity", not_negative,
                                 Interval{0.0, 10.0}, {0.0, 40.0, per_velocity})},
      {&Params<T>::a8, parameter("a8", "1/m", "rate at which the stiffness a6 fades with displacement", not_negative,
                                 Interval{5.0, 20.0}, {0.1, 40.0, per_disp}, Scale::logarithmic)},
      {&Params<T>::a9,
       parameter("a9", "N", "damping force at high velocity", any_value, Interval{1e4, 1e5}, {0.0, 4.0, strength})},
      {&Params<T>::a10, parameter("a10", "N/m^2", "coefficient of the damping force that grows with x^2", any_value,
                                  Interval{1e4, 1e5}, {-2.0, 4.0, strength_per_disp2})},
      {&Params<T>::a11, parameter("a11", "m/s", "velocity around which the damping force stops growing", not_negative,
                                  Interval{0.0, 10.0}, {0.001, 5.0, velocity}, Scale::logarithmic)},
  });

  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.a1 *= a;
    p.a2 *= a;
    p.a3 *= a;
    p.a4 *= a;
    p.a6 *= a;
    p.a9 *= b;
    p.a10 *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Jankowski]
  template <class N>
  struct State {  // empty: the force depends on the present displacement and velocity alone
    template <class Each>
    void members(Each&) {}
  };

  template <class T, class X, class N>
  static N step(Params<T> const& p, NoConstants const&, State<N>&, StepOf<X> const& step) {
    N const x(step.x1), v(step.v1), x2(step.x1 * step.x1);
    // With e = exp(-|u|) and E = e^2, nothing overflows in 1/cosh^2 u = 4 E / (1 + E)^2 and 1/cosh u = 2 e / (1 + e^2).
    // All terms share one denominator, since a division costs as much as an exponential.
    N const one(1.0), two(2.0);
    N const log2_e_v(log2_e * step.v1), log2_e_x(log2_e * step.x1);
    N const E5 = exp2(-two * abs(p.a5 * log2_e_v)), e7 = exp2(-abs(p.a7 * log2_e_v)), e8 = exp2(-abs(p.a8 * log2_e_x));
    N const square5 = (one + E5) * (one + E5), product78 = (one + e7 * e7) * (one + e8 * e8);
    N const peaks = N(4.0) * (p.a4 * E5 * product78 + rounded(p.a6 * e7 * e8 * square5)), below = square5 * product78;
    N const polynomial = p.a1 + x2 * (p.a2 + x2 * p.a3), damping = p.a9 + p.a10 * x2;
    // At rest, and at speeds whose square underflows, there is no damping force: with a11 = 0 it would be v / 0.
    if (step.v1 * step.v1 < smallest_square)
      return (polynomial + peaks / below) * x + slope_alone(step.v1, select(p.a11 > T(0.0), damping / p.a11, N(0.0)));
    N const speed = sqrt(rounded(p.a11 * p.a11) + v * v);
    return polynomial * x + (rounded(peaks * x * speed) + damping * v * below) / (below * speed);
  }
  // [end]
};

}  // namespace isolaw::laws
