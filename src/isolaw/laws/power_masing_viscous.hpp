// The law power-masing in parallel with a dashpot, for tests whose velocity varies independently of their amplitude.
// Source: this project; docs/laws.md. Units kN, mm, s. Step: exact, as in power-masing.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/power_masing.hpp"

namespace isolaw::laws {

struct PowerMasingViscous : PowerMasing {
  static constexpr LawInfo info{
      .id = "power-masing-viscous",
      .name = "Power-law Masing (dashpot)",
      .title = "Power-law Masing with scragging and a dashpot",
      .source = "isolaw, Eqs. of power-masing and a viscous force",
      .force = kN,
      .length = mm,
      .traits = {.odd = true, .remembers = true, .masing = true},
      .formula =
          "F = c v + Fh + (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3))\n"
          "Fh of Y, g and U, w, m and N as for power-masing",
      .note =
          "Tests with sines of one frequency cannot distinguish c from Y and g, because their velocity varies with the amplitude.",
      .step_cost = 230};

  template <class T>
  struct Params : PowerMasing::Params<T> {
    T c;
  };

  static constexpr double force_per_velocity(RecordScales const& s) { return s.force / s.velocity; }

  template <class T>
  static constexpr auto rows = rows_and(std::to_array<Row<T, Params<T>>>({
      {&Params<T>::c,
       parameter("c", "kN s/mm", "viscous damping", not_negative, std::nullopt, {0.0, 0.3, force_per_velocity})},
  }));

  static Params<double> with_factors(Params<double> p, double a, double b) {
    static_cast<PowerMasing::Params<double>&>(p) = PowerMasing::with_factors(p, a, b);
    p.c *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct PowerMasingViscous : PowerMasing]
  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, NoConstants const& c, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    return PowerMasing::step(p, c, state, step, memory) + p.c * N(step.v1);
  }
  // [end]
};

}  // namespace isolaw::laws
