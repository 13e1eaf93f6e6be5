// Ramberg-Osgood with Masing's rules, in parallel with a spring.
// Source: Ramberg and Osgood 1943, Jennings 1964; docs/laws.md. Units kN, mm. Step: exact; the force on a branch solves
// one equation of one unknown, to the last digits.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/masing.hpp"

namespace isolaw::laws {

struct RambergOsgood {
  static constexpr LawInfo info{
      .id = "ramberg-osgood",
      .name = "Ramberg-Osgood",
      .title = "Ramberg-Osgood with Masing's rules",
      .source = "Ramberg and Osgood 1943, Eq. of the skeleton; Jennings 1964",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true, .masing = true},
      .formula =
          "F = K2 x + sk(x) from the start, K2 x + fb + 2 sk((x - xb)/2) from a turning point (xb, fb)\n"
          "sk solves x = (sk/K) (1 + a |sk/Fy|^(r-1)); Masing's rules close branches",
      .note = "Made for steel and soils. a and Fy are redundant: a is fixed at 1 unless it is freed.",
      .step_cost = 1421};

  template <class T>
  struct Params {
    T K, Fy, a, r, K2;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K, parameter("K", "kN/mm", "first stiffness of the hysteretic part", positive, std::nullopt,
                                {0.5, 20.0, stiffness}, Scale::logarithmic)},
      {&Params<T>::Fy, parameter("Fy", "kN", "hysteretic force at a displacement of (1 + a) Fy/K", positive,
                                 std::nullopt, {0.01, 1.5, force}, Scale::logarithmic)},
      {&Params<T>::a, parameter("a", "1", "displacement of the power term at Fy, divided by Fy/K", positive,
                                std::nullopt, {0.1, 5.0, one}, Scale::linear, 1.0)},
      {&Params<T>::r,
       parameter("r", "1", "exponent of the power term", Interval{1.0, infinity}, std::nullopt, {1.2, 12.0, one})},
      {&Params<T>::K2,
       parameter("K2", "kN/mm", "stiffness of the parallel spring", any_value, std::nullopt, {0.0, 1.0, stiffness})},
  });

  static constexpr std::string_view redundant = "a";
  static constexpr std::array<std::string_view, 1> redundant_with{"Fy"};
  static constexpr double redundant_value = 1.0;
  static Params<double> reduced(Params<double> p) {
    if (p.r > 1.0) p.Fy *= std::pow(p.a, -1.0 / (p.r - 1.0)), p.a = 1.0;
    return p;
  }

  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K2 *= a;
    p.K *= b;
    p.Fy *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct RambergOsgood]
  template <class N>
  struct State {
    MasingBranches<N> branches;
    template <class Points>
    void make_room(Points const& points) {
      branches.make_room(points);
    }
    template <class Each>
    void members(Each& each) {
      each(branches);
    }
  };
  template <class X>
  using Memory = Remembered<X, OpenBranches>;
  template <class T, class X>
  struct Constants {
    T per_yield, root;  // K/Fy, which divides a displacement by the yield displacement Fy/K; and a^(-1/r)
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    return {p.K / p.Fy, power(p.a, T(-1.0) / p.r)};
  }

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    state.make_room(memory);
    return p.K2 * N(step.x1) + state.branches.move(step.x1, memory, [&](X const& x) { return skeleton(p, c, x); });
  }

  // Solves f + a f^r = u. The left side is convex, so Newton's method approaches the root from above. It starts at the
  // smaller of the two f at which one term alone equals u. This start is at most twice the root, and after six steps
  // only rounding errors are left.
  template <class T, class X>
  static NumberOf<T, X> skeleton(Params<T> const& p, Constants<T, X> const& c, X const& at) {
    double const x = value_of(at);
    T const u = T(std::abs(x)) * c.per_yield;
    T f = min(u, c.root * power(u, T(1.0) / p.r));
    for (int i = 0; i < 6; ++i) {
      T const steep = p.a * power(f, p.r - T(1.0));
      // max returns its first argument if one of the two is NaN, so a NaN is not lost.
      f = max(f - (f * (T(1.0) + steep) - u) / (T(1.0) + p.r * steep), T(0.0));
    }
    T const force = T(x < 0.0 ? -1.0 : 1.0) * p.Fy * f;
    return through(at, force, [&] { return p.K / (T(1.0) + p.a * p.r * power(f, p.r - T(1.0))); });
  }
  // [end]
};

}  // namespace isolaw::laws
