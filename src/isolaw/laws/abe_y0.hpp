// Abe with a constant yield force: Y0 without the factor (1 + |x/Uh|^p) of Eq. (19).
// Source: Cucuzza et al. 2025, Eqs. (15)-(21) with the yield force Yt = Y0. It is not known which form of Abe the
// authors computed as law 5. With the mean parameters of Table A.5 the loops of this form agree with those of the other
// laws, so it is the most likely one. Units kN, mm. Step: exact between samples (saturating_flow.hpp);
// Integration::paper takes one classical Runge-Kutta step per sample.
#pragma once

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/flows/runge_kutta.hpp"
#include "isolaw/laws/parts/abe_parts.hpp"

namespace isolaw::laws {

struct AbeY0 {
  static constexpr LawInfo info{
      .id = "abe-y0",
      .name = "Abe (constant yield)",
      .title = "Abe with constant yield force",
      .source = "Cucuzza et al. 2025, Eqs. (15)-(21) with Yt = Y0",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .path_integrated = true, .exact_flow = true},
      .formula =
          "as abe, with Yt = Y0:   F = F1 + F2 + F3,   Umax = largest |x| so far\n"
          "F1 = K1 (beta + (1 - beta) exp(-Umax / alpha)) x + a (1 - exp(-b |x|)) sgn(x)\n"
          "dF2 = (Y0 / Ut) (dx - |dx| |F2 / Y0|^n sgn(F2)),   Ut = U0 (1 + Umax / Us)\n"
          "F3 = K2 |x / Uh|^r x",
      .note =
          "The closest reading of the published law 5: with the means of Table A.5 its loops agree with those of the other laws.",
      .set = LawSet::paper,
      .step_cost = 408};

  template <class T>
  struct Params {
    T K1, alpha, beta, a, b, n, Y0, Uh, U0, Us, K2, r;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K1, abe_parts::K1_info},
      {&Params<T>::alpha, abe_parts::alpha_info},
      {&Params<T>::beta, abe_parts::beta_info},
      {&Params<T>::a, abe_parts::a_info},
      {&Params<T>::b, abe_parts::b_info},
      {&Params<T>::n, abe_parts::n_info},
      {&Params<T>::Y0, abe_parts::Y0_info},
      {&Params<T>::Uh, abe_parts::Uh_info},
      {&Params<T>::U0, abe_parts::U0_info},
      {&Params<T>::Us, abe_parts::Us_info},
      {&Params<T>::K2, abe_parts::K2_info},
      {&Params<T>::r, abe_parts::r_info},
  });

  static Canonical canonical(Params<double> const&) { return abe_parts::beyond_programs; }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K1 *= a;
    p.a *= a;
    p.K2 *= a;
    p.Y0 *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct AbeY0]
  template <class N>
  struct State {
    N u = N(0.0);  // the hysteretic force F2 / its yield force Y0
    // The t at which the curve u(t) of Constants::flow has the value of `u`, which here is positive along the motion.
    N time = N(0.0);
    abe_parts::Softened<N> softened;
    template <class Each>
    void members(Each& each) {
      each(u, time, softened);
    }
  };
  template <class T, class X>
  struct Constants {
    abe_parts::Constants<T> parts;
    Flow<T, X, Reach::within_saturation> flow;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    c.parts = abe_parts::constants<T>(p);
    c.flow.fit(p.n, T(1.0));
    return c;
  }

  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& first) {
    abe_parts::follow_peak(p, c.parts, state.softened, first.peak1);
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    if (moves(step)) {
      N const direction(step.direction);
      if (step.reversal) state.time = c.flow.time_at(direction * state.u);
      state.time += abe_parts::travel(p, c.parts, state.softened, step.length, step.peak0, step.peak1);
      state.u = direction * c.flow.value_at(state.time);
      if (grows(step.peak1 - step.peak0)) abe_parts::follow_peak(p, c.parts, state.softened, step.peak1);
    }
    return abe_parts::elastic_force(p, c.parts, state.softened, step) + p.Y0 * state.u;
  }
  // [end]

  template <class T>
  static Constants<T, double> paper_constants(Params<T> const& p) {
    Constants<T, double> c;
    c.parts = abe_parts::constants<T>(p);
    return c;
  }
  template <class T>
  static T step_paper(Params<T> const& p, Constants<T, double> const& c, State<T>& state, Step const& step) {
    T const direction(step.direction);
    state.u = runge_kutta(state.u, step.dx, [&](double t, T const& u) {
      double const x = step.x0 + t * step.dx;
      abe_parts::Point<T> const at{T(1.0), T(1.0), abe_parts::inverse_Ut_at(p, c.parts, state.softened, x, step.peak0)};
      return abe_parts::hysteretic_slope(u, at, p.n, direction);
    });
    if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c.parts, state.softened, step.peak1);
    return abe_parts::elastic_force(p, c.parts, state.softened, step) + p.Y0 * state.u;
  }
};

}  // namespace isolaw::laws
