// Trilinear: two elastic-perfectly-plastic elements and a spring in parallel. No release has this law: the tests of
// this folder add it to the list of laws, as CONTRIBUTING describes. Source: Eq. (1) of Cucuzza et al. 2025 with one
// more element (Iwan 1966). Units kN, mm. The step is exact where the displacement changes linearly from sample to
// sample.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct Trilinear {
  static constexpr LawInfo info{.id = "trilinear",
                                .name = "Trilinear",
                                .title = "Trilinear, two elements in parallel",
                                .source = "Cucuzza et al. 2025, Eq. (1), with one element more",
                                .force = kN,
                                .length = mm,
                                .traits = {.rate_independent = true, .odd = true},
                                .formula =
                                    "F = K x + z1 + z2\n"
                                    "z1 -> z1 + k1 dx, kept within +-k1 x1;   z2 -> z2 + k2 dx, within +-k2 x2"};

  template <class T>
  struct Params {
    T K, k1, x1, k2, x2;
  };

  template <class T>
  static constexpr std::array rows{
      Row<T, Params<T>>{&Params<T>::K,
                        {.name = "K",
                         .unit = "kN/mm",
                         .meaning = "last stiffness",
                         .physical = not_negative,
                         .published = std::nullopt,
                         .scaled = {0.05, 1.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::k1,
                        {.name = "k1",
                         .unit = "kN/mm",
                         .meaning = "stiffness of the first element",
                         .physical = not_negative,
                         .published = std::nullopt,
                         .scaled = {0.1, 5.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::x1,
                        {.name = "x1",
                         .unit = "mm",
                         .meaning = "its yield displacement",
                         .physical = not_negative,
                         .published = std::nullopt,
                         .scaled = {0.01, 0.3, disp}}},
      Row<T, Params<T>>{&Params<T>::k2,
                        {.name = "k2",
                         .unit = "kN/mm",
                         .meaning = "stiffness of the second element",
                         .physical = not_negative,
                         .published = std::nullopt,
                         .scaled = {0.1, 5.0, stiffness}}},
      Row<T, Params<T>>{&Params<T>::x2,
                        {.name = "x2",
                         .unit = "mm",
                         .meaning = "its yield displacement",
                         .physical = not_negative,
                         .published = std::nullopt,
                         .scaled = {0.05, 0.9, disp}}},
  };

  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{"x1 <= x2", [](Params<double> const& p) { return p.x1 <= p.x2; }}};
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K *= a;
    p.k1 *= b;
    p.k2 *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Trilinear]
  template <class N>
  struct State {
    N z1 = N(0.0), z2 = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(z1, z2);
    }
  };

  template <class T, class X, class N>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step) {
    state.z1 = within(N(p.k1 * p.x1), state.z1 + p.k1 * N(step.dx));
    state.z2 = within(N(p.k2 * p.x2), state.z2 + p.k2 * N(step.dx));
    return p.K * N(step.x1) + state.z1 + state.z2;
  }

  template <class N>
  static N within(N const& strength, N const& trial) {
    return min(strength, max(-strength, trial));
  }
  // [end]
};

}  // namespace isolaw::laws
