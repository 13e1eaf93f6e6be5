// Power-law Masing with scragging: hysteretic branches that follow one power law and Masing's rules, an elastic force
// that softens with the amplitude and hardens towards the peak, and a virgin stiffness that travel removes (scragging).
// Source: this project; docs/laws.md. Units kN, mm. Step: exact, without integration. The force at a sample depends
// only on the turning points and peaks of the displacement, which the record alone determines.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/masing.hpp"
#include "isolaw/laws/parts/scragging.hpp"

namespace isolaw::laws {

struct PowerMasing {
  static constexpr LawInfo info{
      .id = "power-masing",
      .name = "Power-law Masing",
      .title = "Power-law Masing with scragging",
      .source = "isolaw, Eqs. below; found by a search over some 145 forms of the formula",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true, .masing = true},
      .formula =
          "F = Fh + (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3))\n"
          "Fh = sk(x) from the start, fb + 2 sk((x - xb)/2) from a turning point (xb, fb); Masing's rules close branches\n"
          "sk(x) = Y (x/100) ((U + |x|)/100)^(g-1)\n"
          "w = (1 + sgn(x) Fh/sk(M))/2, M the largest |x| so far, m that of the side of x\n"
          "N: travel of that side over m, dN = |dx|/m, and dN = |dx|/m - 60 N dm/m while m grows",
      .note =
          "The structure was found on one measured device, where the exponents 6, 1/3 and 60 were chosen too; the objective hardly depends on them. On a side that was never visited, the slope of |x|^g at zero is infinite. Beyond the tests the force grows with x^2 through H.",
      .set = LawSet::usual,
      .step_cost = 230};

  template <class T>
  struct Params {
    T Y, g, K, H, C, U;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::Y, parameter("Y", "kN", "hysteretic force of the skeleton at 100 mm", not_negative, std::nullopt,
                                {0.02, 1.5, force_at_reference})},
      scragging_rows<T, Params<T>>[0],
      scragging_rows<T, Params<T>>[1],
      scragging_rows<T, Params<T>>[2],
      scragging_rows<T, Params<T>>[3],
      {
        &Params<T>::U, parameter("U", "mm", "rounding of the first slope", not_negative, std::nullopt,
                                 {1e-4, 0.05, disp}, Scale::logarithmic)
      },
  });

  // Returns the parameter rows of a law that extends this one: the rows of this law, then `added`.
  template <class T, class Extended, std::size_t Added>
  static constexpr auto rows_and(std::array<Row<T, Extended>, Added> const& added) {
    std::array<Row<T, Extended>, rows<T>.size() + Added> all{};
    for (std::size_t i = 0; i < rows<T>.size(); ++i) all[i] = {rows<T>[i].member, rows<T>[i].info};
    for (std::size_t i = 0; i < Added; ++i) all[rows<T>.size() + i] = added[i];
    return all;
  }

  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K *= a;
    p.H *= a;
    p.C *= a;
    p.Y *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct PowerMasing]
  template <class N>
  struct State {
    MasingBranches<N> branches;
    N per_strength = N(0.0);  // 1 / the strength, which is the force of the skeleton at the largest |x| so far [1/kN]
    Scragging<N> scragging;
    template <class Points>
    void make_room(Points const& points) {
      branches.make_room(points);
    }
    template <class Each>
    void members(Each& each) {
      each(branches, per_strength, scragging);
    }
  };
  template <class X>
  using Memory = Remembered<X, OpenBranches, Peaks<X>, Sides<X>>;

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    auto const [hysteretic, elastic] = forces(p, state, step, memory);
    return hysteretic + elastic;
  }

  // The hysteretic force Fh and the elastic force that acts in parallel. forces() must be called at every step.
  template <class N>
  struct Forces {
    N hysteretic, elastic;
  };
  template <class T, class X, class N, class PathMemory>
  static Forces<N> forces(Params<T> const& p, State<N>& state, StepOf<X> const& step, PathMemory const& memory) {
    state.make_room(memory);
    N const Fh = state.branches.move(step.x1, memory, [&](X const& x) { return skeleton(p, x); });
    if (memory.peak_grows) state.per_strength = T(1.0) / max(N(skeleton(p, memory.peak)), N(smallest_power_base));
    // If both arguments are equal, min and max return the first. A hysteretic force that just equals its strength
    // therefore keeps its slope.
    N const share = min(max(Fh * state.per_strength, N(-1.0)), N(1.0));
    return {Fh, state.scragging.force(p, step.x1, memory, share, p.U)};
  }

  template <class T, class X>
  static auto skeleton(Params<T> const& p, X const& x) {
    return p.Y * NumberOf<T, X>(x / reference_mm) *
           power((p.U + NumberOf<T, X>(abs(x))) * T(1.0 / reference_mm), p.g - T(1.0));
  }
  // [end]
};

}  // namespace isolaw::laws
