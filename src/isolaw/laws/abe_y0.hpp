// Abe with a constant yield force: Abe without the factor (1 + |x/Uh|^p) of Eq. (19).
// Source: Cucuzza et al. 2025, Eqs. (15)-(21) with Yt = Y0. The closest reading of Table A.5's law 5, kept for comparison
// with that table; what the authors ran is not known.
// Units kN, mm.  Step: exact between samples (saturating_flow.hpp); `paper`: one classical Runge-Kutta step per sample.
#pragma once

#include "isolaw/laws/abe.hpp"

namespace isolaw::laws {

struct AbeY0 {
  static constexpr LawInfo info{
      .id = "abe-y0",
      .title = "Abe with constant yield force",
      .source = "Cucuzza et al. 2025, Eqs. (15)-(21) with Yt = Y0",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .path_integrated = true},
      .note = "Closest reading of the published law 5: with Table A.5's means its loops agree with the other laws."};

  template <class T>
  struct Params {
    T K1, alpha, beta, a, b, n, Y0, Uh, U0, Us, K2, r;
  };

  template <class T>
  static constexpr std::array rows{
      Row<T, Params<T>>{&Params<T>::K1,
                        {.name = "K1", .unit = "kN/mm", .meaning = "initial elastic stiffness", .physical = any_value,
                         .published = Interval{5.0, 10.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.5 * s.stiffness, 20.0 * s.stiffness}; }}},
      Row<T, Params<T>>{&Params<T>::alpha,
                        {.name = "alpha", .unit = "mm", .meaning = "peak displacement over which it decays", .physical = not_negative,
                         .published = Interval{0.0, 10.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.001 * s.disp, 1.0 * s.disp}; },
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::beta,
                        {.name = "beta", .unit = "1", .meaning = "share of it that remains", .physical = any_value,
                         .published = Interval{0.01, 1.0},
                         .scaled = [](RecordScales const&) { return Interval{0.01, 1.0}; }}},
      Row<T, Params<T>>{&Params<T>::a,
                        {.name = "a", .unit = "kN", .meaning = "force of the rounded step at zero displacement", .physical = any_value,
                         .published = Interval{0.5, 1.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.0 * s.force, 0.2 * s.force}; }}},
      Row<T, Params<T>>{&Params<T>::b,
                        {.name = "b", .unit = "1/mm", .meaning = "rate of that step", .physical = not_negative,
                         .published = Interval{5.0, 10.0},
                         .scaled = [](RecordScales const& s) { return Interval{2.0 / s.disp, 2000.0 / s.disp}; },
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::n,
                        {.name = "n", .unit = "1", .meaning = "sharpness of yielding", .physical = positive,
                         .published = Interval{0.01, 0.5},
                         .scaled = [](RecordScales const&) { return Interval{0.01, 1.0}; }}},
      Row<T, Params<T>>{&Params<T>::Y0,
                        {.name = "Y0", .unit = "kN", .meaning = "yield force", .physical = positive,
                         .published = Interval{10.0, 70.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.02 * s.force, 0.8 * s.force}; }}},
      Row<T, Params<T>>{&Params<T>::Uh,
                        {.name = "Uh", .unit = "mm", .meaning = "displacement at which hardening begins", .physical = positive,
                         .published = Interval{50.0, 150.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.5 * s.disp, 4.0 * s.disp}; }}},
      Row<T, Params<T>>{&Params<T>::U0,
                        {.name = "U0", .unit = "mm", .meaning = "yield displacement", .physical = positive,
                         .published = Interval{2.0, 6.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.001 * s.disp, 0.3 * s.disp}; },
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::Us,
                        {.name = "Us", .unit = "mm", .meaning = "peak displacement over which it grows", .physical = positive,
                         .published = Interval{5.0, 50.0},
                         .scaled = [](RecordScales const& s) { return Interval{0.01 * s.disp, 3.0 * s.disp}; },
                         .scaled_search = Scale::logarithmic}},
      Row<T, Params<T>>{&Params<T>::K2,
                        {.name = "K2", .unit = "kN/mm", .meaning = "hardening stiffness", .physical = any_value,
                         .published = Interval{0.01, 0.5},
                         .scaled = [](RecordScales const& s) { return Interval{0.0 * s.stiffness, 1.2 * s.stiffness}; }}},
      Row<T, Params<T>>{&Params<T>::r,
                        {.name = "r", .unit = "1", .meaning = "exponent of the hardening force", .physical = not_negative,
                         .published = Interval{0.01, 0.2},
                         .scaled = [](RecordScales const&) { return Interval{0.01, 2.0}; }}},
  };

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
    if (integration == Integration::converged) state.flow = SaturatingFlow<T>(p.n, T(1.0));
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
      return abe_parts::hysteretic_slope(u, T(1.0), abe_parts::inverse_Ut_at(p, c, x, step.peak0), p.n, direction);
    });
    if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c, step.peak1);
    return abe_parts::elastic_force(p, c, step) + p.Y0 * state.u;
  }
};

}  // namespace isolaw::laws
