// Hwang-Wu: a non-linear spring and dashpot that degrade with the work done on the device.
// Source: Cucuzza et al. 2025, Eqs. (22)-(24), after Hwang et al. 2002. Units N, cm, s: Tables 4 and A.5 print no
// units, and only with these do stiffness and force agree with the other laws. Step: classical Runge-Kutta steps
// integrate dW = F(x, v, W) dx, with displacement and velocity linear between the samples. Integration::paper takes the
// same steps. At 200 samples per cycle the error is 3e-7 of the peak force with the paper's mean parameters; it grows
// where a9 or a10 times the work of one sample exceeds 1. Within the bounds of a search, damping or stiffness may be
// negative at some displacements. The device may then give out more work than it took in, and the exponentials of a
// negative W grow without bound. The force overflows, and the search passes over such parameters.
#pragma once

#include "isolaw/laws/flows/runge_kutta.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct HwangWu {
  static constexpr LawInfo info{
      .id = "hwang-wu",
      .name = "Hwang-Wu",
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
          "W is all the work done since the start, including the elastic part, in N cm; the paper gives no unit of W. The upper bound of a1 is illegible in Table 4; 6e3 N/cm is used.",
      .set = LawSet::paper,
      .step_cost = 870};

  template <class T>
  struct Params {
    T a1, a2, a3, a4, a5, a6, a7, a8, a9, a10;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::a1,
       parameter("a1", "N/cm", "constant stiffness", any_value, Interval{2.8e3, 6e3}, {0.0, 1.5, stiffness})},
      {&Params<T>::a2, parameter("a2", "N/cm^3", "coefficient of the stiffness that grows with x^2", any_value,
                                 Interval{-5.0, -0.04}, {-1.5, 1.5, stiffness_per_disp2})},
      {&Params<T>::a3, parameter("a3", "N/cm^5", "coefficient of the stiffness that grows with x^4", any_value,
                                 Interval{1e-4, 0.01}, {-1.5, 1.5, stiffness_per_disp4})},
      {&Params<T>::a4, parameter("a4", "N/cm", "stiffness that fades with work and velocity", any_value,
                                 Interval{20.75, 90.0}, {0.0, 2.0, stiffness})},
      {&Params<T>::a5, parameter("a5", "s/cm", "rate at which the stiffness a4 fades with velocity", not_negative,
                                 Interval{1e-3, 0.9}, {0.05, 100.0, per_velocity}, Scale::logarithmic)},
      {&Params<T>::a6, parameter("a6", "N", "damping force at high velocity, after much work", any_value,
                                 Interval{1e4, 1.5e5}, {0.0, 4.0, strength})},
      {&Params<T>::a7, parameter("a7", "N/cm^2", "coefficient of the damping force that grows with x^2", any_value,
                                 Interval{1.0, 8.0}, {-2.0, 4.0, strength_per_disp2})},
      {&Params<T>::a8, parameter("a8", "cm/s", "velocity around which the damping force stops growing", not_negative,
                                 Interval{50.0, 150.0}, {0.001, 5.0, velocity}, Scale::logarithmic)},
      {&Params<T>::a9, parameter("a9", "1/(N cm)", "rate at which the stiffness a4 fades with work", not_positive,
                                 Interval{-5e-6, -1e-9}, {-300.0, -1e-3, per_work}, Scale::logarithmic)},
      {&Params<T>::a10,
       parameter("a10", "1/(N cm)", "rate at which a part of the damping fades with work", not_positive,
                 Interval{-2.925e-5, 0.0}, {-300.0, -1e-3, per_work}, Scale::logarithmic)},
  });

  // a9 and a10 are divided by b, because b multiplies most of the work W. This is exact only if a = b, since W is the
  // work of the whole force.
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.a1 *= a;
    p.a2 *= a;
    p.a3 *= a;
    p.a4 *= a;
    p.a6 *= b;
    p.a7 *= b;
    p.a9 /= b;
    p.a10 /= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct HwangWu]
  // The force at one point of the path, with displacement x and velocity v, in three terms. Exponentials of the work W
  // multiply the last two.
  template <class N>
  struct Coefficients {
    N elastic = N(0.0);    // spring without work: (a1 + a2 x^2 + a3 x^4) x [N]
    N softening = N(0.0);  // a4 x / cosh^2(a5 v)
    N damping = N(0.0);    // (a6 + a7 x^2) v / sqrt(a8^2 + v^2)
    template <class Each>
    void members(Each& each) {
      each(elastic, softening, damping);
    }
  };
  template <class N>
  struct State {
    N W = N(0.0);
    Coefficients<N> now;
    template <class Each>
    void members(Each& each) {
      each(W, now);
    }
  };
  template <class T, class X>
  struct Constants {
    T decay9, decay10;  // a9 and a10 times log2(e), because a power of 2 takes the place of the exponential
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    return {T(log2_e) * p.a9, T(log2_e) * p.a10};
  }

  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const&, State<N>& state, StepOf<X> const& first) {
    coefficients(p, first.x1, first.v1, state.now);
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    Coefficients<N> const before = state.now;
    coefficients(p, step.x1, step.v1, state.now);
    if (moves(step)) {
      Coefficients<N> middle;
      coefficients(p, 0.5 * (step.x0 + step.x1), 0.5 * (step.v0 + step.v1), middle);
      state.W = runge_kutta(state.W, step.dx, [&](double t, N const& W) {
        return force(c, t == 0.0 ? before : t == 1.0 ? state.now : middle, W);
      });
    }
    return force(c, state.now, state.W);
  }

  template <class T, class X, class N>
  static void coefficients(Params<T> const& p, X const& at_x, X const& at_v, Coefficients<N>& c) {
    N const x(at_x), v(at_v), x2(at_x * at_x);
    c.elastic = rounded((p.a1 + x2 * (p.a2 + x2 * p.a3)) * x);
    c.softening = p.a4 * x * sech_squared(p.a5 * v);
    // At rest, and at speeds whose square underflows, the damping force is 0, so that a8 = 0 does not give 0 / 0.
    if (at_v * at_v < smallest_square)
      c.damping = slope_alone(at_v, select(p.a8 > T(0.0), (p.a6 + p.a7 * x2) / p.a8, N(0.0)));
    else
      c.damping = (p.a6 + p.a7 * x2) * v / sqrt(rounded(p.a8 * p.a8) + v * v);
  }

  template <class T, class X, class N>
  static N force(Constants<T, X> const& k, Coefficients<N> const& c, N const& W) {
    return c.elastic + c.softening * exp2(k.decay9 * W) + c.damping * (T(1.0) + exp2(k.decay10 * W));
  }
  // [end]
};

}  // namespace isolaw::laws
