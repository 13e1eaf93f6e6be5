// Hwang-Wu: non-linear spring and dashpot that degrade with the work done on the device.
// Source: Cucuzza et al. 2025, Eqs. (22)-(24), after Hwang et al. 2002. Units N, cm, s: Tables 4 and A.5 print none,
// and only these give the stiffness and force of the other laws. Step: dW = F(x, v, W) dx by classical Runge-Kutta
// steps, displacement and velocity linear between the samples; the same for both kinds of integration. At 200 samples
// per cycle the error is 3e-7 of the peak force with the published means; it grows where a9 or a10 times the work of
// one sample exceeds 1. Where damping or stiffness is negative somewhere up to the peak (the automatic box allows it),
// the device may give out more work than it took in, and the exponentials of a negative W run away: no bounded force,
// rejected.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"
#include "isolaw/laws/runge_kutta.hpp"

namespace isolaw::laws {

struct HwangWu {
  static constexpr LawInfo info{
      .id = "hwang-wu",
      .title = "Hwang-Wu, degrading spring and dashpot",
      .source = "Cucuzza et al. 2025, Eqs. (22)-(24)",
      .force = N,
      .length = cm,
      .traits = {.odd = true, .path_integrated = true},
      .formula =
          "F = K x + C v,   W = integral of F dx from the start\n"
          "K = a1 + a2 x^2 + a3 x^4 + a4 exp(a9 W) / cosh^2(a5 v)\n"
          "C = (a6 + a7 x^2) / sqrt(a8^2 + v^2) (1 + exp(a10 W))",
      .note =
          "W is all the work done since the start, elastic part included, in N cm; the authors' unit of W is open. The upper bound of a1 is lost in Table 4; 6e3 N/cm is used."};

  template <class T>
  struct Params {
    T a1, a2, a3, a4, a5, a6, a7, a8, a9, a10;
  };

  template <class T>
  static constexpr std::array rows{
      Row<T, Params<T>>{&Params<T>::a1,
                        {.name = "a1",
                         .unit = "N/cm",
                         .meaning = "constant stiffness",
                         .physical = any_value,
                         .published = Interval{2.8e3, 6e3},
                         .scaled = {0.0, 1.5, stiffness}}},
      Row<T, Params<T>>{&Params<T>::a2,
                        {.name = "a2",
                         .unit = "N/cm^3",
                         .meaning = "stiffness growing with x^2",
                         .physical = any_value,
                         .published = Interval{-5.0, -0.04},
                         .scaled = {-1.5, 1.5, stiffness_per_disp2}}},
      Row<T, Params<T>>{&Params<T>::a3,
                        {.name = "a3",
                         .unit = "N/cm^5",
                         .meaning = "stiffness growing with x^4",
                         .physical = any_value,
                         .published = Interval{1e-4, 0.01},
                         .scaled = {-1.5, 1.5, stiffness_per_disp4}}},
      Row<T, Params<T>>{&Params<T>::a4,
                        {.name = "a4",
                         .unit = "N/cm",
                         .meaning = "stiffness lost with work and velocity",
                         .physical = any_value,
                         .published = Interval{20.75, 90.0},
                         .scaled = {0.0, 2.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::a5,
                        {.name = "a5",
                         .unit = "s/cm",
                         .meaning = "its decay with velocity",
                         .physical = not_negative,
                         .published = Interval{1e-3, 0.9},
                         .scaled = {0.05, 100.0, per_velocity},
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::a6,
                        {.name = "a6",
                         .unit = "N",
                         .meaning = "damping force",
                         .physical = any_value,
                         .published = Interval{1e4, 1.5e5},
                         .scaled = {0.0, 4.0, strength}}},
      Row<T, Params<T>>{&Params<T>::a7,
                        {.name = "a7",
                         .unit = "N/cm^2",
                         .meaning = "damping growing with x^2",
                         .physical = any_value,
                         .published = Interval{1.0, 8.0},
                         .scaled = {-2.0, 4.0, strength_per_disp2}}},
      Row<T, Params<T>>{&Params<T>::a8,
                        {.name = "a8",
                         .unit = "cm/s",
                         .meaning = "velocity at which damping saturates",
                         .physical = not_negative,
                         .published = Interval{50.0, 150.0},
                         .scaled = {0.001, 5.0, velocity},
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::a9,
                        {.name = "a9",
                         .unit = "1/(N cm)",
                         .meaning = "decay of a4 with work",
                         .physical = not_positive,
                         .published = Interval{-5e-6, -1e-9},
                         .scaled = {-300.0, -1e-3, per_work},
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::a10,
                        {.name = "a10",
                         .unit = "1/(N cm)",
                         .meaning = "decay of damping with work",
                         .physical = not_positive,
                         .published = Interval{-2.925e-5, 0.0},
                         .scaled = {-300.0, -1e-3, per_work},
                         .scaled_search = Scale::logarithmic}},
  };

  // What multiplies the two exponentials of the work, at one point of the path.
  template <class T>
  struct Coefficients {
    T elastic = T(0.0);    // (a1 + a2 x^2 + a3 x^4) x
    T softening = T(0.0);  // a4 x / cosh^2(a5 v)
    T damping = T(0.0);    // (a6 + a7 x^2) v / sqrt(a8^2 + v^2)
  };

  template <class T>
  struct State {
    T W = T(0.0);
    T decay9 = T(0.0), decay10 = T(0.0);  // a9 and a10 in powers of two
    Coefficients<T> now;
  };

  template <class T>
  static State<T> start(Params<T> const& p, Step const& first, Integration) {
    return {.W = T(0.0),
            .decay9 = T(num::log2_e) * p.a9,
            .decay10 = T(num::log2_e) * p.a10,
            .now = coefficients(p, first.x1, first.v1)};
  }

  template <class T>
  static T step(Params<T> const& p, State<T>& state, Step const& step) {
    auto const before = state.now;
    state.now = coefficients(p, step.x1, step.v1);
    if (step.length > 0.0) {
      auto const middle = coefficients(p, 0.5 * (step.x0 + step.x1), 0.5 * (step.v0 + step.v1));
      state.W = runge_kutta(state.W, step.dx, [&](double t, T const& W) {
        return force(state, t == 0.0 ? before : t == 1.0 ? state.now : middle, W);
      });
    }
    return force(state, state.now, state.W);
  }

 private:
  template <class T>
  static Coefficients<T> coefficients(Params<T> const& p, double at_x, double at_v) {
    T const x(at_x), v(at_v), x2(at_x * at_x);
    Coefficients<T> c;
    c.elastic = rounded((p.a1 + x2 * (p.a2 + x2 * p.a3)) * x);
    c.softening = p.a4 * x * sech_squared(p.a5 * v);
    // At rest nothing is damped, also for a8 = 0; likewise where the square of the velocity is lost.
    c.damping = at_v * at_v < smallest_square ? T(0.0) : (p.a6 + p.a7 * x2) * v / sqrt(rounded(p.a8 * p.a8) + v * v);
    return c;
  }

  template <class T>
  static T force(State<T> const& state, Coefficients<T> const& c, T const& W) {
    return c.elastic + c.softening * exp2(state.decay9 * W) + c.damping * (T(1.0) + exp2(state.decay10 * W));
  }
};

}  // namespace isolaw::laws
