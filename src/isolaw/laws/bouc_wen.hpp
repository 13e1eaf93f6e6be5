// Bouc-Wen: smooth hysteresis with post-yield stiffness.
// Source: Cucuzza et al. 2025, Eqs. (13)-(14), after Wen 1976; K_i and K_j of Eq. (13) are both the elastic stiffness
// Ke. Units kN, mm.  Step: between reversals dz/dx depends on z alone. Polynomials, fitted once per parameter set, give
// z almost exactly (saturating_flow.hpp). Integration::paper takes one classical Runge-Kutta step per sample, which
// blows up where a step is longer than about two yield displacements.
#pragma once

#include <limits>

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/flows/runge_kutta.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct BoucWen {
  static constexpr LawInfo info{
      .id = "bouc-wen",
      .name = "Bouc-Wen",
      .title = "Bouc-Wen, smooth hysteresis",
      .source = "Cucuzza et al. 2025, Eqs. (13)-(14)",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .path_integrated = true, .exact_flow = true},
      .formula =
          "F = alpha Ke x + (1 - alpha) Ke z\n"
          "dz/dx = A - |z|^n (beta sgn(z dx) + gamma)",
      .note =
          "A is redundant: (Ke, A, beta, gamma, alpha) can be rescaled without changing the force, so a calibration with A free has no unique answer. The upper bound of alpha is illegible in Table 4; 0.3 is used. Parameters must keep beta > 0 and beta + gamma > 0; others have no bounded force and are rejected.",
      .set = LawSet::paper,
      .step_cost = 267};

  template <class T>
  struct Params {
    T alpha, Ke, A, beta, n, gamma;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::alpha, parameter("alpha", "1", "ratio of post-yield to elastic stiffness", any_value,
                                    Interval{0.1, 0.3}, {0.01, 0.6, one})},
      {&Params<T>::Ke,
       parameter("Ke", "kN/mm", "elastic stiffness", positive, Interval{2.0, 4.0}, {1.0, 12.0, stiffness})},
      {&Params<T>::A,
       parameter("A", "1", "amplitude of the hysteretic variable (redundant with Ke, beta, gamma, alpha)", positive,
                 Interval{1.0, 2.0}, {0.5, 2.0, one})},
      {&Params<T>::beta,
       parameter("beta", "1/mm^n", "shape of the loop; its term changes sign from loading to unloading", any_value,
                 Interval{0.025, 0.075}, {0.05, 60.0, per_disp}, Scale::logarithmic)},
      {&Params<T>::n, parameter("n", "1", "sharpness of yielding", positive, Interval{1.0, 1.25}, {0.5, 2.0, one})},
      {&Params<T>::gamma,
       parameter("gamma", "1/mm^n", "shape of the loop; its term has the same sign in loading and unloading", any_value,
                 Interval{0.025, 0.075}, {-20.0, 60.0, per_disp})},
  });

  // reduced() returns parameters that give the same forces as `p`, with A = 1, so that dz/dx = 1 at z = 0.
  static constexpr std::string_view redundant = "A";
  static constexpr double redundant_value = 1.0;
  static constexpr std::array<std::string_view, 4> redundant_with{"alpha", "Ke", "beta", "gamma"};
  static Params<double> reduced(Params<double> const& p) {
    double const scale = num::power(p.A, p.n - 1.0), elastic = p.alpha * p.Ke + (1.0 - p.alpha) * p.Ke * p.A;
    return {.alpha = p.alpha * p.Ke / elastic,
            .Ke = elastic,
            .A = 1.0,
            .beta = p.beta * scale,
            .n = p.n,
            .gamma = p.gamma * scale};
  }

  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{"beta > 0", [](Params<double> const& p) { return p.beta > 0.0; }},
      JointLimit<Params<double>>{"beta + gamma > 0", [](Params<double> const& p) { return p.beta + p.gamma > 0.0; }}};
  static Canonical canonical(Params<double> const& p) {
    auto const r = reduced(p);
    return BoucWenForm{r.alpha, r.Ke, r.beta, r.gamma, r.n};
  }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    double const elastic = a * p.alpha * p.Ke;
    p.Ke = elastic + b * (1.0 - p.alpha) * p.Ke;
    p.alpha = elastic / p.Ke;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct BoucWen]
  template <class N>
  struct State {
    // z is the hysteretic variable [mm]. `time` is the t at which the curve u(t) of Constants::flow has the value of
    // z / z_max, taken positive in the direction of motion.
    N z = N(0.0), time = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(z, time);
    }
  };
  // u = z / z_max follows the curve u(t) of `flow`. A travel of 1 mm advances t by `rate`.
  template <class T, class X>
  struct Constants {
    T z_max, rate;
    Flow<T, X, Reach::within_saturation> flow;
  };
  template <class T>
  static T largest_z(Params<T> const& p) {
    return exp2((log2(p.A) - log2(p.beta + p.gamma)) / p.n);
  }
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    c.z_max = largest_z(p);
    c.rate = p.A / c.z_max;
    c.flow.fit(p.n, (p.beta - p.gamma) / (p.beta + p.gamma));
    return c;
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    if (moves(step)) {
      N const direction(step.direction);
      if (step.reversal) state.time = c.flow.time_at(direction * state.z / c.z_max);
      state.time += c.rate * N(step.length);
      state.z = direction * c.z_max * c.flow.value_at(state.time);
    }
    return force(p, state.z, N(step.x1));
  }
  template <class T, class N>
  static N force(Params<T> const& p, N const& z, N const& x) {
    return rounded(p.alpha * p.Ke * x) + (T(1.0) - p.alpha) * p.Ke * z;
  }
  // [end]

  // With beta <= 0 or beta + gamma <= 0 the force has no bound, so the law gives NaN, even while z is finite.
  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const&, State<N>& state, StepOf<X> const&) {
    T const nan(std::numeric_limits<double>::quiet_NaN());
    state.z = select(min(p.beta, p.beta + p.gamma) > T(0.0), T(0.0), nan);
  }

  template <class T>
  static Constants<T, double> paper_constants(Params<T> const&) {
    return {};
  }
  template <class T>
  static T step_paper(Params<T> const& p, Constants<T, double> const&, State<T>& state, Step const& step) {
    T const direction(step.direction);
    state.z = runge_kutta(state.z, step.dx, [&](double, T const& z) {
      // beta sgn(z dx) + gamma is `same` if z and the motion dx have the same sign, and `opposite` if not.
      T const same = p.beta + p.gamma, opposite = p.gamma - p.beta;
      return p.A - power(abs(z), p.n) * select(direction * z < T(0.0), opposite, same);
    });
    return force(p, state.z, T(step.x1));
  }
};

}  // namespace isolaw::laws
