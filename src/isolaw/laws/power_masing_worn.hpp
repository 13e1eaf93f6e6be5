// The law power-masing with two more terms. The first makes the hysteretic force decrease with the distance travelled.
// The second is a lasting force: each growth of the largest |x| adds a force in proportion to it, positive for a growth
// at x > 0 and negative for one at x < 0. The terms describe differences between the first and last cycles of a record,
// and between its two sides.
// Source: this project; docs/league.md lists the variants tried. Units kN, mm. Step: exact, as in power-masing.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/wear.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/power_masing.hpp"

namespace isolaw::laws {

struct PowerMasingWorn : PowerMasing {
  static constexpr LawInfo info{
      .id = "power-masing-worn",
      .name = "Power-law Masing (wear)",
      .title = "Power-law Masing with scragging, wear and a kept force",
      .source = "isolaw, Eqs. of power-masing and two terms; chosen by prediction among some 45",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true, .masing = true},
      .formula =
          "F = Fh (1 + NT)^(-r) + B q/100 + (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3))\n"
          "Fh of Y, g and U, w, m and N as for power-masing, without wear\n"
          "NT: travel over M, the largest |x| so far, dNT = |dx|/M, and dNT = |dx|/M - 60 NT dM/M while M grows\n"
          "q: how far M has grown at x > 0, less how far at x < 0",
      .note =
          "Predicts the measured bearing's amplitudes and later cycles better than power-masing; on the building's four motions it gains little over it. If every stage of a record begins on the same side, B cannot be distinguished from an offset of the rig that grows with the amplitude. U is fixed, because a free U follows the first samples of one stage and predicts the next stage worse. Beyond the tests it behaves as power-masing.",
      .step_cost = 281};

  template <class T>
  struct Params : PowerMasing::Params<T> {
    T B, r;
  };

  template <class T>
  static constexpr auto rows = [] {
    auto all = rows_and(std::to_array<Row<T, Params<T>>>({
        {&Params<T>::B,
         parameter("B", "kN",
                   "force that remains after the motion has grown 100 mm farther to one side than to the other",
                   any_value, std::nullopt, {-0.05, 0.15, force_at_reference})},
        {&Params<T>::r,
         parameter("r", "1", "exponent of wear with travel", not_negative, std::nullopt, {0.0, 0.2, one})},
    }));
    for (auto& row : all)
      if (row.info.name == "U") row.info.fixed_by_default = 0.15;
    return all;
  }();

  static Params<double> with_factors(Params<double> p, double a, double b) {
    static_cast<PowerMasing::Params<double>&>(p) = PowerMasing::with_factors(p, a, b);
    p.B *= a;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct PowerMasingWorn : PowerMasing]
  template <class X>
  using Memory = Remembered<X, OpenBranches, Wear<X>, Sides<X>>;

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    auto const [hysteretic, elastic] = forces(p, state, step, memory);
    return hysteretic * exp2(-p.r * N(memory.log2_worn)) + elastic + p.B * N(memory.one_sided_growth / reference_mm);
  }
  // [end]
};

}  // namespace isolaw::laws
