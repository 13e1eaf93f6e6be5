// A smooth variant of power-masing: two fading memories of the motion replace its turning points. It is made for
// programs whose materials cannot keep turning points. Small vibrations relax its force, and loops of unloading and
// reloading below 1 mm give out work, so prefer power-masing wherever turning points can be kept.
// Source: this project; docs/laws.md. Units kN, mm. Step: exact along a straight path.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/scragging.hpp"

namespace isolaw::laws {

using std::log;

struct PowerScragging {
  static constexpr LawInfo info{
      .id = "power-scragging",
      .name = "Power law with fading memory",
      .title = "Power law with fading memory and scragging",
      .source = "isolaw, Eqs. below; found by a search over some 145 forms of the formula",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true},
      .formula =
          "F = Fh + (x/100) (K (m/100)^(g-1) + W H (m/100) (|x|/m)^6 + W^2 C (1 + N)^(-1/3)),   W = (1 + sgn(x) w)/2\n"
          "Fh = Y (M/100)^g w,   w = (1 - s) w1 + s w2\n"
          "dw1 = (dx - w1 |dx|) / (U (M/100)^h),   dw2 = (dx - w2 |dx|) / (u U (M/100)^h)\n"
          "M the largest |x| so far, m that of the side of x, N its travel as for power-masing",
      .note =
          "The structure was found on one measured device. Tremor makes the force relax, and loops of unloading and reloading below 1 mm give back more work than they take. After a turn the force changes within the length of the quick memory. This length may be so short that noise of 1e-9 of the amplitude moves the force by up to 1e-4 of its peak.",
      .step_cost = 210};

  template <class T>
  struct Params {
    T Y, g, K, H, C, U, h, s, u;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::Y,
       parameter("Y", "kN", "hysteretic force at 100 mm", not_negative, std::nullopt, {0.02, 1.0, force_at_reference})},
      scragging_rows<T, Params<T>>[0],
      scragging_rows<T, Params<T>>[1],
      scragging_rows<T, Params<T>>[2],
      scragging_rows<T, Params<T>>[3],
      {
        &Params<T>::U, parameter("U", "mm", "length of the slow memory at an amplitude of 100 mm", positive,
                                 std::nullopt, {0.01, 1.0, disp}, Scale::logarithmic)
      },
      {
        &Params<T>::h, parameter("h", "1", "exponent with which the slow memory grows with amplitude", not_negative,
                                 std::nullopt, {0.0, 1.6, one})
      },
      {
        &Params<T>::s, parameter("s", "1", "share of the quick memory in the hysteretic force", Interval{0.0, 1.0},
                                 std::nullopt, {0.0, 0.8, one})
      },
      {
        &Params<T>::u, parameter("u", "1", "length of the quick memory divided by that of the slow one", positive,
                                 std::nullopt, {0.005, 0.5, one}, Scale::logarithmic)
      },
  });

  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K *= a;
    p.H *= a;
    p.C *= a;
    p.Y *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct PowerScragging]
  template <class N>
  struct State {
    // M is the largest |x| so far.
    N slow = N(0.0), quick = N(0.0);  // the two fading memories w1 and w2 of the direction of motion, -1 to 1
    N strength = N(0.0);              // largest hysteretic force, Y (M/100)^g [kN]
    N per_length = N(0.0);            // log2(e) / length of the memory w1, which is U (M/100)^h [mm]
    Scragging<N> scragging;
    template <class Each>
    void members(Each& each) {
      each(slow, quick, strength, per_length, scragging);
    }
  };
  template <class X>
  using Memory = Remembered<X, Peaks<X>, Sides<X>>;

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    T const rounding = T(0.01) * p.U;
    if (!(memory.peak > 0.0)) return state.scragging.force(p, step.x1, memory, N(0.0), rounding);
    N way = N(memory.length_below_peak) * state.per_length;
    if (memory.peak_grows) {
      way = way + T(log2_e) * growth(p, memory.peak0, memory.peak);
      state.strength = p.Y * power(N(memory.peak / reference_mm), p.g);
      N const memory_length = p.U * power(N(memory.peak / reference_mm), p.h);
      state.per_length = T(log2_e) / max(memory_length, N(smallest_power_base));
    }
    N const towards(memory.direction);
    state.slow = towards + (state.slow - towards) * exp2(-way);
    state.quick = towards + (state.quick - towards) * exp2(-way / p.u);
    N const share = state.slow + p.s * (state.quick - state.slow);
    return state.strength * share + state.scragging.force(p, step.x1, memory, share, rounding);
  }

  // Returns the integral of dM / (U (M/100)^h) over the growth of the peak M in this step. The divisor is the length of
  // the slow memory, which changes with M.
  template <class T, class X>
  static NumberOf<T, X> growth(Params<T> const& p, X const& peak0, X const& peak) {
    using N = NumberOf<T, X>;
    T const a = T(1.0) - p.h, lengths = T(reference_mm) / p.U;
    N const after = power(N(peak / reference_mm), a);
    // With h >= 1 the integral from peak 0 has no bound. The value 1e3 makes the memory forget everything before.
    if (!(peak0 > 0.0)) return select(a > T(0.0), lengths * after / max(a, T(1e-300)), N(1e3));
    X const ratio = log(peak / peak0);
    N const before = power(N(peak0 / reference_mm), a), small = a * N(ratio);
    // Near h = 1 the difference of the powers loses its digits, but its series is exact to 1e-14.
    N const series =
        N(ratio) * before *
        (N(1.0) + small * (N(1.0 / 2) + small * (N(1.0 / 6) + small * (N(1.0 / 24) + small * N(1.0 / 120)))));
    return lengths * select(abs(small) < N(0.005), series, (after - before) / select(abs(a) < T(1e-300), T(1.0), a));
  }
  // [end]
};

}  // namespace isolaw::laws
