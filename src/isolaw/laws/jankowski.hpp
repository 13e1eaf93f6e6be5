// Jankowski: non-linear spring and dashpot in displacement and velocity, no memory.
// Source: Cucuzza et al. 2025, Eqs. (2)-(5), after Jankowski 2003; the product x'x' printed in Eq. (3) is read as one
// x'. Units N, m, s.  Step: algebraic, exact at every sample.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"

namespace isolaw::laws {

struct Jankowski {
  static constexpr LawInfo info{
      .id = "jankowski",
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
          "The velocity appears once in F = K x + C v (printed twice in Eq. 3). Without motion the damping force is 0, also for a11 = 0."};

  template <class T>
  struct Params {
    T a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11;
  };

  template <class T>
  static constexpr std::array rows{
      Row<T, Params<T>>{&Params<T>::a1,
                        {.name = "a1",
                         .unit = "N/m",
                         .meaning = "constant stiffness",
                         .physical = any_value,
                         .published = Interval{1e4, 1e6},
                         .scaled = {-0.5, 1.5, stiffness}}},
      Row<T, Params<T>>{&Params<T>::a2,
                        {.name = "a2",
                         .unit = "N/m^3",
                         .meaning = "stiffness growing with x^2",
                         .physical = any_value,
                         .published = Interval{1e6, 9e6},
                         .scaled = {-1.0, 2.0, stiffness_per_disp2}}},
      Row<T, Params<T>>{&Params<T>::a3,
                        {.name = "a3",
                         .unit = "N/m^5",
                         .meaning = "stiffness growing with x^4",
                         .physical = any_value,
                         .published = Interval{1e6, 9e6},
                         .scaled = {-1.0, 1.0, stiffness_per_disp4}}},
      Row<T, Params<T>>{&Params<T>::a4,
                        {.name = "a4",
                         .unit = "N/m",
                         .meaning = "stiffness at rest",
                         .physical = any_value,
                         .published = Interval{1e3, 1e5},
                         .scaled = {-6.0, 6.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::a5,
                        {.name = "a5",
                         .unit = "s/m",
                         .meaning = "its decay with velocity",
                         .physical = not_negative,
                         .published = Interval{1e3, 1e4},
                         .scaled = {1.0, 1e4, per_velocity},
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::a6,
                        {.name = "a6",
                         .unit = "N/m",
                         .meaning = "stiffness near the origin",
                         .physical = any_value,
                         .published = Interval{1e5, 3.5e6},
                         .scaled = {-10.0, 20.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::a7,
                        {.name = "a7",
                         .unit = "s/m",
                         .meaning = "its decay with velocity",
                         .physical = not_negative,
                         .published = Interval{0.0, 10.0},
                         .scaled = {0.0, 40.0, per_velocity}}},
      Row<T, Params<T>>{&Params<T>::a8,
                        {.name = "a8",
                         .unit = "1/m",
                         .meaning = "its decay with displacement",
                         .physical = not_negative,
                         .published = Interval{5.0, 20.0},
                         .scaled = {0.1, 40.0, per_disp},
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::a9,
                        {.name = "a9",
                         .unit = "N",
                         .meaning = "damping force",
                         .physical = any_value,
                         .published = Interval{1e4, 1e5},
                         .scaled = {0.0, 4.0, strength}}},
      Row<T, Params<T>>{&Params<T>::a10,
                        {.name = "a10",
                         .unit = "N/m^2",
                         .meaning = "damping growing with x^2",
                         .physical = any_value,
                         .published = Interval{1e4, 1e5},
                         .scaled = {-2.0, 4.0, strength_per_disp2}}},
      Row<T, Params<T>>{&Params<T>::a11,
                        {.name = "a11",
                         .unit = "m/s",
                         .meaning = "velocity at which damping saturates",
                         .physical = not_negative,
                         .published = Interval{0.0, 10.0},
                         .scaled = {0.001, 5.0, velocity},
                         .scaled_search = Scale::logarithmic}},
  };

  template <class T>
  struct State {};

  template <class T>
  static State<T> start(Params<T> const&, Step const&, Integration) {
    return {};
  }

  template <class T>
  static T step(Params<T> const& p, State<T>&, Step const& step) {
    T const x(step.x1), v(step.v1), x2(step.x1 * step.x1);
    // 1/cosh^2 u = 4 E / (1 + E)^2 and 1/cosh u = 2 e / (1 + e^2) with e = exp(-|u|), E = e^2: nothing overflows. Over one
    // denominator, since a division costs as much as an exponential.
    T const one(1.0), two(2.0);
    T const log2_e_v(num::log2_e * step.v1), log2_e_x(num::log2_e * step.x1);
    T const E5 = exp2(-two * abs(p.a5 * log2_e_v)), e7 = exp2(-abs(p.a7 * log2_e_v)), e8 = exp2(-abs(p.a8 * log2_e_x));
    T const square5 = (one + E5) * (one + E5), product78 = (one + e7 * e7) * (one + e8 * e8);
    T const peaks = T(4.0) * (p.a4 * E5 * product78 + rounded(p.a6 * e7 * e8 * square5)), below = square5 * product78;
    T const polynomial = p.a1 + x2 * (p.a2 + x2 * p.a3);
    // Also where the square of the velocity is lost, which for a11 = 0 would leave v / 0.
    if (step.v1 * step.v1 < smallest_square) return (polynomial + peaks / below) * x;
    T const speed = sqrt(rounded(p.a11 * p.a11) + v * v);
    return polynomial * x + (rounded(peaks * x * speed) + (p.a9 + p.a10 * x2) * v * below) / (below * speed);
  }
};

}  // namespace isolaw::laws
