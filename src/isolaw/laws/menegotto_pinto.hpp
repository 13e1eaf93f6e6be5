// Menegotto-Pinto: from each reversal a smooth curve, which starts along the elastic line, leads to the asymptote of
// the other side.
// Source: Menegotto and Pinto 1973 with the sharpness R of Filippou et al. 1983, without isotropic hardening. The
// source computes the intersection (x0, F0) of the elastic line with the asymptote. Here F = b E x + (1 - b) z instead.
// At the reversal (xr, Fr) z has the value zr, at a distance D from the value +-Fy ahead of it. With t = E |x - xr|, z
// has then moved towards +-Fy by (D^-R + t^-R)^(-1/R). The source's x0 follows from E (x0 - xr) = +-D. Units kN, mm.
// Step: exact.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct MenegottoPinto {
  static constexpr LawInfo info{
      .id = "menegotto-pinto",
      .name = "Menegotto-Pinto",
      .title = "Menegotto-Pinto, smooth branches to asymptotes",
      .source = "Menegotto and Pinto 1973, the Equation of a branch; Filippou et al. 1983, that of R",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true},
      .formula =
          "f* = b e* + (1 - b) e* / (1 + |e*|^R)^(1/R),   e* = (x - xr) / (x0 - xr),   f* = (F - Fr) / (F0 - Fr)\n"
          "(xr, Fr) the last reversal, (x0, F0) where its line of slope E meets b E x +- (1 - b) Fy, the side ahead\n"
          "R = R0 (1 - cR1 xi / (cR2 + xi)),   xi = |xm - x0| E / Fy,   xm the farthest reversal ahead, at least +-Fy / E",
      .note =
          "Without isotropic hardening. The law remembers only the last reversal. After a small unloading a real device returns to the curve that it left; this law starts a new curve, which overshoots the old one. Even the smallest noise in a hold does this.",
      .step_cost = 360};

  template <class T>
  struct Params {
    T E, Fy, b, R0, cR1, cR2;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::E, parameter("E", "kN/mm", "initial stiffness", not_negative, std::nullopt, {1.0, 15.0, stiffness})},
      {&Params<T>::Fy, parameter("Fy", "kN", "force at which the elastic line meets the asymptote", not_negative,
                                 std::nullopt, {0.5, 5.0, strength})},
      {&Params<T>::b, parameter("b", "1", "ratio of post-yield to initial stiffness", Interval{0.0, 1.0}, std::nullopt,
                                {0.05, 0.3, one})},
      {&Params<T>::R0, parameter("R0", "1", "sharpness of yielding of the first branch", positive, std::nullopt,
                                 {0.5, 20.0, one}, Scale::logarithmic)},
      {&Params<T>::cR1, parameter("cR1", "1", "share of R0 that plastic excursions take away", Interval{0.0, 1.0},
                                  std::nullopt, {0.5, 0.99, one}, Scale::linear, 0.925)},
      {&Params<T>::cR2, parameter("cR2", "1", "excursion, in yield displacements, that takes away half of cR1",
                                  positive, std::nullopt, {0.05, 0.5, one}, Scale::linear, 0.15)},
  });

  static Canonical canonical(Params<double> const& p) { return MenegottoPintoForm{p.E, p.Fy, p.b, p.R0, p.cR1, p.cR2}; }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    double const elastic = a * p.b * p.E, all = elastic + b * (1.0 - p.b) * p.E;
    p.Fy *= all / p.E;
    p.E = all;
    p.b = elastic / all;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct MenegottoPinto]
  template <class N>
  struct State {
    N z = N(0.0);
    // E times the largest and the least displacement at which the motion has turned [kN]. At first they are the elastic
    // force at the first sample plus Fy, and minus Fy.
    N top = N(0.0), bottom = N(0.0);
    // Set at each reversal: z there (zr above), its distance D from the value +-Fy ahead, and the sharpness R of the
    // branch that begins there.
    N turn_z = N(0.0), distance = N(0.0), sharpness = N(0.0);
    double turn_x = 0.0;
    template <class Each>
    void members(Each& each) {
      each(z, top, bottom, turn_z, distance, sharpness, turn_x);
    }
  };

  template <class T, class X, class N>
  static void start(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& first) {
    N const elastic = p.E * N(first.x1);
    state.top = elastic + p.Fy;
    state.bottom = elastic - p.Fy;
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step) {
    if (step.reversal) turn(p, state, step);
    if (moves(step)) {
      N const travel = p.E * N(step.direction * (step.x1 - state.turn_x));
      // min and max return their first argument if one of the two is NaN, so a NaN distance gives a NaN force.
      N const less = min(state.distance, travel), more = max(state.distance, travel);
      N const ratio = less / max(more, N(smallest_power_base));
      N const rounding = exp2(-log2(T(1.0) + power(ratio, state.sharpness)) / state.sharpness);
      state.z = state.turn_z + N(step.direction) * less * rounding;
    }
    return rounded(p.b * p.E * N(step.x1)) + (T(1.0) - p.b) * state.z;
  }

  template <class T, class X, class N>
  static void turn(Params<T> const& p, State<N>& state, StepOf<X> const& step) {
    N const direction(step.direction), elastic = p.E * N(step.x0);
    bool const rising = step.direction > 0.0;
    if (rising)
      state.bottom = min(state.bottom, elastic);
    else
      state.top = max(state.top, elastic);
    state.turn_x = value_of(step.x0);
    state.turn_z = state.z;
    state.distance = max(p.Fy - direction * state.z, N(0.0));
    N const ahead = (rising ? state.top : state.bottom) - elastic;
    N const excursion = abs(ahead - direction * state.distance) / max(p.Fy, T(smallest_power_base));
    state.sharpness = p.R0 * (T(1.0) - p.cR1 * excursion / max(p.cR2 + excursion, N(smallest_power_base)));
  }
  // [end]
};

}  // namespace isolaw::laws
