// Abe with a constant yield force: Abe without the factor (1 + |x/Uh|^p) of Eq. (19).
// Source: Cucuzza et al. 2025, Eqs. (15)-(21) with Yt = Y0. This is the closest reading of law 5 in Table A.5 and is
// kept for comparison with that table; it is not known which form the authors computed. Units kN, mm.  Step: exact
// between samples (saturating_flow.hpp); `paper`: one classical Runge-Kutta step per sample.
#pragma once

#include "isolaw/laws/abe.hpp"

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

  template <class T>
  struct State {
    T u = T(0.0);  // F2 / Y0
    T time = T(0.0);
    abe_parts::Constants<T> constants;
    SaturatingFlow<T> flow;
  };

  template <class T>
  static State<T> start(Params<T> const& p, Step const& first, Integration integration) {
    State<T> state;
    state.constants = abe_parts::constants<T>(p, first);
    if (integration == Integration::converged) state.flow.fit(p.n, T(1.0));
    return state;
  }

  template <class T>
  static T step(Params<T> const& p, State<T>& state, Step const& step) {
    auto& c = state.constants;
    if (step.length > 0.0) {
      T const direction(step.direction);
      if (step.reversal) state.time = state.flow.time_at(direction * state.u);
      state.time += abe_parts::travel(p, c, abe_parts::Piece(step, step.x0, step.x1));
      state.u = direction * state.flow.value_at(state.time);
      if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c, step.peak1);
    }
    return abe_parts::elastic_force(p, c, step) + p.Y0 * state.u;
  }

  template <class T>
  static T step_paper(Params<T> const& p, State<T>& state, Step const& step) {
    auto& c = state.constants;
    T const direction(step.direction);
    state.u = runge_kutta(state.u, step.dx, [&](double t, T const& u) {
      double const x = step.x0 + t * step.dx;
      abe_parts::Point<T> const at{T(1.0), T(1.0), abe_parts::inverse_Ut_at(p, c, x, step.peak0)};
      return abe_parts::hysteretic_slope(u, at, p.n, direction);
    });
    if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c, step.peak1);
    return abe_parts::elastic_force(p, c, step) + p.Y0 * state.u;
  }
};

}  // namespace isolaw::laws
