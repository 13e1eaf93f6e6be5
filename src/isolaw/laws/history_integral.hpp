// Deformation-history integral: a hysteretic force that remembers about the last length D of the motion, and an elastic
// force that softens with the amplitude. The hysteretic force is proportional to an integral over the travel l from 0
// to L, q(L) = int exp(-(L - l)/D) dx(l) / D, whose weights fade exponentially. It obeys dq = (dx - q |dx|)/D. This law
// sums two such q with different lengths.
// Source: Masaki et al., Kasai et al. for high damping rubber; the link of that name in commercial programs sums
// several q. Units kN, mm. Step: exact along a straight path.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/peaks.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/reference.hpp"

namespace isolaw::laws {

struct HistoryIntegral {
  static constexpr LawInfo info{
      .id = "history-integral",
      .name = "History integral",
      .title = "Deformation-history integral, two memories",
      .source = "Masaki et al. and Kasai et al., Eq. of one direction with exponential weights; two terms",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true},
      .formula =
          "F = K (M/100)^(g-1) x/100 + S ((1 - s) q1 + s q2),   M the largest |x| so far\n"
          "dq1 = (dx - q1 |dx|)/D,   dq2 = (dx - q2 |dx|)/(u D)",
      .note =
          "Made for high damping rubber. Commercial programs do not publish how they soften it with amplitude: the elastic force here is that of power-masing. To have a single memory, fix s at 0; u then has no effect. With g = 1 as well the law is vaiana with straight limit curves, which analysis programs have. The strength S does not grow with amplitude: at 2 and 5 times the tested amplitude the hysteretic force stays the same, while the elastic force is 2^g and 5^g times as large. Tremor makes the force relax; the dead band keeps tremor out. After a turn the force changes within the length of the quick memory. This length may be so short that noise of 1e-9 of the amplitude moves the force by up to 1e-4 of its peak.",
      .step_cost = 125};

  template <class T>
  struct Params {
    T K, g, S, D, s, u;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K,
       parameter("K", "kN", "elastic force at 100 mm", any_value, std::nullopt, {0.0, 1.5, force_at_reference})},
      {&Params<T>::g, parameter("g", "1", "exponent of the elastic force's softening with amplitude", positive,
                                std::nullopt, {0.05, 1.0, one})},
      {&Params<T>::S, parameter("S", "kN", "strength of both memories together", not_negative, std::nullopt,
                                {0.3, 5.0, strength}, Scale::logarithmic)},
      {&Params<T>::D, parameter("D", "mm", "length of the slow memory", positive, std::nullopt, {0.01, 1.0, disp},
                                Scale::logarithmic)},
      {&Params<T>::s, parameter("s", "1", "share of the quick memory in the hysteretic force", Interval{0.0, 1.0},
                                std::nullopt, {0.0, 0.8, one})},
      {&Params<T>::u, parameter("u", "1", "length of the quick memory divided by that of the slow one", positive,
                                std::nullopt, {0.005, 0.5, one}, Scale::logarithmic)},
  });

  static Canonical canonical(Params<double> const&) {
    return NoForm{"two memories and softening with the peak so far; fitted as vaiana without them"};
  }

  // The values that the high damping rubber links of other programs ask for: the length [mm] and the largest force [kN]
  // of each memory, and the elastic stiffness after a given peak.
  struct Memories {
    double slow_mm, slow_kN, quick_mm, quick_kN, elastic_kN_per_mm;
  };
  static Memories memories(Params<double> const& p, double peak_mm) {
    return {.slow_mm = p.D,
            .slow_kN = p.S * (1.0 - p.s),
            .quick_mm = p.u * p.D,
            .quick_kN = p.S * p.s,
            .elastic_kN_per_mm = p.K * std::pow(peak_mm / reference_mm, p.g - 1.0) / reference_mm};
  }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K *= a;
    p.S *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct HistoryIntegral]
  template <class N>
  struct State {
    N slow = N(0.0), quick = N(0.0);  // the memories q1, of length D, and q2, of length u D
    N elastic = N(0.0);               // elastic stiffness K (M/100)^(g-1) / 100 [kN/mm]; M is the largest |x| so far
    template <class Each>
    void members(Each& each) {
      each(slow, quick, elastic);
    }
  };
  template <class X>
  using Memory = Remembered<X, Peaks<X>>;
  template <class T, class X>
  struct Constants {
    // log2(e) / D and log2(e) / (u D): a travel l multiplies the memories by 2^(-l per_slow) and 2^(-l per_quick).
    T per_slow, per_quick;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    T const per_slow = T(log2_e) / max(p.D, T(smallest_power_base));
    return {per_slow, per_slow / max(p.u, T(smallest_power_base))};
  }

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    // The first sample counts as a motion from 0. Its step has no length, so the length comes from `memory`.
    X const way = memory.length_below_peak + (memory.peak - memory.peak0);
    if (may_move(way)) {
      N const towards(memory.direction), length(way);
      state.slow = towards + (state.slow - towards) * exp2(-length * c.per_slow);
      state.quick = towards + (state.quick - towards) * exp2(-length * c.per_quick);
    }
    if (memory.peak_grows)
      state.elastic = p.K * T(1.0 / reference_mm) * power(N(memory.peak / reference_mm), p.g - T(1.0));
    // The slope of the force has no bound as the peak grows from 0. The tangent is therefore limited to the slope of
    // the secant from 0 to 0.01 mm.
    auto const steepest = [&] { return p.K / T(reference_mm) * power(T(1e-4), p.g - T(1.0)); };
    N const x(step.x1);
    N force = rounded(state.elastic * x) + p.S * (state.slow + p.s * (state.quick - state.slow));
    if (memory.peak > 0.0)
      limit_slope(
          force, [&] { return state.elastic * x; }, steepest);
    else
      force = force + slope_alone(step.x1, N(steepest()));
    return force;
  }
  // [end]
};

}  // namespace isolaw::laws
