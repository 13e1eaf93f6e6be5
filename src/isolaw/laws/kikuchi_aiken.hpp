// Kikuchi-Aiken: loops between plus and minus the peak, which is the largest |x| so far. The secant stiffness, damping
// and shape of the loops depend on the peak; inner branches follow Masing's rules.
// Source: Kikuchi and Aiken 1997; docs/laws.md. Units kN, mm. Step: exact. The force at a sample depends only on the
// turning points and the peak of the displacement, which the record alone determines. Departures from the source:
// - The unit of the hysteretic force is the strength, its value at the peak. On a branch from one peak to the opposite
//   one it has risen by 2 - 2 exp(-a s) + b s exp(-c s), where s is the travel divided by the peak. At s = 2 this
//   branch of the source misses the opposite peak by 2 exp(-2a) - 2 b exp(-2c) (1e-6 to 5e-4 for the published
//   compounds). Here terms in (s/2)^8 add this difference, so that the force is continuous. Inner branches have these
//   terms too, so that a branch that begins just short of a peak is the same as one from the peak. The terms move the
//   forces of the published compounds by up to 1e-5 of the force at the peak.
// - b acts only at peaks where a has reached its largest value, as for the published compounds.
// - b is at most e (1/U - 1) min(c, 5), where U is the hysteretic share of the force at the peak. The term of b is then
//   nowhere larger than the elastic share, so that a loop does not exceed its force at the peak. If c is large, the 5
//   keeps the force from falling by the whole elastic share within a short travel. No published compound reaches this
//   limit up to a strain of 4.1.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/open_branches.hpp"
#include "isolaw/laws/memory/peaks.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/reference.hpp"

namespace isolaw::laws {

namespace kikuchi_aiken {

// `isolaw export` copies the lines up to [end] to C++ files, in this namespace (programs/header_parts.cpp):
// [export namespace kikuchi_aiken]
// Values that depend on the peak: force, equivalent damping ratio, hysteretic share, exponent of the hardening part.
template <class N>
struct AtPeak {
  N force, damping, share, exponent;
};

// (1 - exp(-2a))/a: the share of the bounding parallelogram that a loop with exponential branches leaves out.
template <class T>
inline T area_left(T const& a) {
  return (T(1.0) - exp2(T(-2.0 * log2_e) * a)) / a;
}

template <class T>
struct Constants {
  T least_area;  // area_left for the largest a
  // The member c is the parameter c times log2(e), because powers of 2 take the place of exponentials. The next two are
  // 2 c^2 and exp(-2c) of the parameter c.
  T c, twice_c2, bump_end;
  T most_b;  // e min(c, 5), the limit of b (see the top of this file) without its factor 1/U - 1
};
template <class T>
inline Constants<T> constants(T const& largest_a, T const& c) {
  T const exponent = c * T(log2_e);
  return {area_left(max(largest_a, T(smallest_power_base))), exponent, T(2.0) * c * c, exp2(T(-2.0) * exponent),
          T(2.71828182845904523536) * min(c, T(5.0))};
}

template <class N>
struct Loops {
  struct Turn {
    double x = 0.0;
    // Whether the branch from this turn has the term b s exp(-c s), with s = (travel since the turn) / peak.
    bool bump = false;
    // The hysteretic force at the turn, and the factor by which the rise of the branch from there is multiplied.
    N force = N(0.0), scale = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(x, bump, force, scale);
    }
  };
  N hysteretic = N(0.0);
  // Values at the present peak. If the force there is Fm and its hysteretic share is u, they are the strength u Fm,
  // half the elastic force, (1 - u) Fm / 2, and the exponent of the hardening part.
  N strength = N(0.0), half_elastic = N(0.0), exponent = N(0.0);
  // a log2(e), b and 2 exp(-2a), with the a and b of the branches (see the top of this file).
  N a = N(0.0), b = N(0.0), closing = N(0.0);
  std::vector<Turn> turned;
  template <class Points>
  void make_room(Points const& points) {
    hold(turned, points);
  }
  template <class Each>
  void members(Each& each) {
    each(hysteretic, strength, half_elastic, exponent, a, b, closing, turned);
  }

  // Returns the force at `at`, the end of a step from x0. Once the peak is above 0, this function must be called at
  // every step. at_peak(m) gives AtPeak for a peak m.
  template <class T, class X, class PathMemory, class Functions>
  N force(Constants<T> const& c, X const& x0, X const& at, PathMemory const& memory, Functions&& at_peak) {
    if (memory.turns) turn(c, memory.turn_index, value_of(x0), memory.peak0);
    if (memory.peak_grows) grow(c, at_peak(memory.peak));
    double const side = at < 0.0 ? -1.0 : 1.0;
    X const size = side * at / memory.peak;
    if (memory.branch_index == memory.none) {
      hysteretic = N(side) * strength;
    } else {
      Turn const& from = turned[memory.branch_index];
      X const s = memory.direction * (at - from.x) / memory.peak;
      hysteretic = from.force + N(memory.direction) * strength * from.scale * shape(c, s, from.bump);
    }
    N hardening = exp2(exponent * N(log2(max(size, X(smallest_power_base)))));
    use_secant_near_zero(hardening, size, [&] { return exponent; });
    return half_elastic * N(side) * (N(size) + hardening) + hysteretic;
  }

  template <class T>
  void grow(Constants<T> const& c, AtPeak<N> const& now) {
    strength = now.share * now.force;
    half_elastic = N(0.5) * (now.force - strength);
    exponent = now.exponent;
    N const wanted = N(1.0) - N(1.57079632679489661923) * now.damping / now.share;
    // max returns its first argument if one is NaN, so a NaN in c.least_area stays. A NaN in `wanted` makes b NaN.
    N const area = max(N(c.least_area), wanted);
    // Newton's method for area a - 1 + exp(-2a) = 0, which is convex; five steps from 1/area suffice for any area <= 1.
    N root = N(1.0) / area;
    for (int i = 0; i < 5; ++i) {
      N const e = exp2(N(-2.0 * log2_e) * root);
      root = root - (area * root - N(1.0) + e) / (area - N(2.0) * e);
    }
    a = root * N(log2_e);
    b = min(c.twice_c2 * (area - wanted), c.most_b * (N(1.0) - now.share) / now.share);
    closing = N(2.0) * exp2(N(-2.0) * a);
  }

  // How far the hysteretic force has risen on a branch, at a distance of s times the peak from the turning point where
  // the branch began. It is 2 at s = 2. force() multiplies it by the strength and the scale of the branch.
  template <class T, class X>
  N shape(Constants<T> const& c, X const& s, bool bump) const {
    X const half = 0.5 * s, half2 = half * half, half4 = half2 * half2;
    N f = N(2.0) - N(2.0) * exp2(-a * N(s)) + closing * N(half4 * half4);
    if (bump) f = f + b * N(s) * (exp2(-c.c * N(s)) - c.bump_end * N(half4 * half2 * half));
    return f;
  }

  // Begins a branch at x. An inner branch is scaled so that it returns to the point where the branch before it began.
  // It has no term b s exp(-c s) if both branches began on the same side of x = 0, or if the earlier branch has none.
  template <class T, class X>
  void turn(Constants<T> const& c, std::size_t place, double x, X const& peak) {
    Turn& now = turned[place];
    now.x = x;
    now.bump = true;
    now.force = hysteretic;
    now.scale = N(1.0);
    if (place == 0) return;
    Turn const& before = turned[place - 1];
    X const s = abs(x - before.x) / peak;
    now.bump = before.bump && x * before.x <= 0.0;
    now.scale = before.scale * shape(c, s, before.bump) / max(shape(c, s, now.bump), N(smallest_power_base));
  }
};
// [end]

}  // namespace kikuchi_aiken

struct KikuchiAiken {
  static constexpr LawInfo info{
      .id = "kikuchi-aiken",
      .name = "Kikuchi-Aiken",
      .title = "Kikuchi-Aiken, loops between the peaks so far",
      .source = "Kikuchi and Aiken 1997, Eqs. of Q1, Q2 and their inner branches",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .remembers = true, .masing = true},
      .formula =
          "F = Q1 + Q2,   Q1 = (1 - U)/2 Fm (X + sgn(X) |X|^n),   X = x/m,   m the largest |x| so far\n"
          "Q2 = U Fm sgn(X) where m grows,   Qb +- A U Fm f(|x - xb|/m) from a turning point (xb, Qb)\n"
          "f(s) = 2 - 2 exp(-a s) + b s exp(-c s), plus what it lacks of 2 at s = 2 times (s/2)^8\n"
          "A = 1 on a branch from a peak; on an inner branch it is such that the branch returns to where the one before it began\n"
          "Masing's rules close branches\n"
          "a solves (1 - exp(-2 a))/a = 1 - pi h/(2 U) and is at most amax\n"
          "b = c^2 (pi h/U - 2 + 2 (1 - exp(-2 a))/a) where a is amax, but at most e (1/U - 1) min(c, 5); 0 where a is smaller\n"
          "Fm = G1 (m/100)^(1-p) (1 + s1 (m - xn)),   h = h0 + h1 m, not below 0,   U = u0 + u1 m within 0.05 to 1\n"
          "n = 1 + n1 (m - xn);   m - xn is taken as 0 in Fm and n where m is below xn",
      .note =
          "Made for high damping rubber. Fm, h, U and n are functions of the displacement in mm, so that no height of rubber is needed. To compare with a published compound, whose functions are of strain, multiply h1, u1, n1 and s1 by the height; p, h0 and u0 are the same. A closed loop dissipates 2 pi h Fm m, to 1 % where a is above 2 and b below its limit. The limit of b is not in the source. Without it the force within a loop can be many times that at its peaks; no published compound reaches the limit up to a strain of 4.1. As in the source, b is left out after two turns on one side or after a branch without it. Therefore the force of a motion changes abruptly if one of its turns moves across x = 0, or if a loop on one side just fails to close. Beyond the tests Fm grows as m^(1-p), with s1 eventually as m^(2-p): at 2 and 5 times the amplitude it is 2^(1-p) and 5^(1-p) times as large, and with s1 up to 2 and 5 times more. h, U and n follow straight lines to their given limits. At five times the fitted amplitude these lines mean little. If h has fallen to 0, the way back from a new peak may give back more work than the way to it took. A material of this law in an analysis program is elastic below a strain of 0.05 and keeps the values and turning points of rejected trials; in isolaw only the path counts. If p is above 0, the slope of a virgin device at 0 is infinite.",
      .step_cost = 272};

  template <class T>
  struct Params {
    T G1, p, h0, h1, u0, u1, n1, xn, s1, amax, c;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::G1, parameter("G1", "kN", "peak force at a peak displacement of 100 mm", not_negative, std::nullopt,
                                 {0.3, 3.0, force_at_reference}, Scale::logarithmic)},
      {&Params<T>::p, parameter("p", "1", "exponent with which the secant stiffness falls with the peak displacement",
                                Interval{0.0, 0.95}, std::nullopt, {0.0, 0.7, one})},
      {&Params<T>::h0,
       parameter("h0", "1", "equivalent damping ratio of small loops", not_negative, std::nullopt, {0.08, 0.3, one})},
      {&Params<T>::h1, parameter("h1", "1/mm", "change of the damping ratio for each mm of peak displacement",
                                 any_value, std::nullopt, {-0.07, 0.05, per_disp})},
      {&Params<T>::u0, parameter("u0", "1", "hysteretic share of the force of small loops", Interval{0.0, 1.0},
                                 std::nullopt, {0.2, 0.6, one})},
      {&Params<T>::u1, parameter("u1", "1/mm", "change of the hysteretic share for each mm of peak displacement",
                                 any_value, std::nullopt, {-0.3, 0.1, per_disp})},
      {&Params<T>::n1,
       parameter("n1", "1/mm", "growth of the exponent of hardening for each mm of peak displacement above xn",
                 not_negative, std::nullopt, {0.0, 6.0, per_disp})},
      {&Params<T>::xn, parameter("xn", "mm", "peak displacement above which n1 and s1 act", not_negative, std::nullopt,
                                 {0.1, 0.9, disp})},
      {&Params<T>::s1, parameter("s1", "1/mm", "growth of the peak force for each mm of peak displacement above xn",
                                 not_negative, std::nullopt, {0.0, 1.0, per_disp})},
      {&Params<T>::amax, parameter("amax", "1", "largest rate a of the branches' exponential", Interval{1.0, infinity},
                                   std::nullopt, {5.0, 20.0, one}, Scale::linear, 10.19171)},
      {&Params<T>::c, parameter("c", "1", "decay of the term b, which acts where a has reached amax", not_negative,
                                std::nullopt, {2.0, 50.0, one}, Scale::logarithmic)},
  });

  static Canonical canonical(Params<double> const&) {
    return NoForm{"functions of the peak: KikuchiAikenHDR has only the functions of its own compounds"};
  }
  // G1 multiplies the whole force. The law has no parameters that change one part of the force and leave the other.
  static Params<double> with_factor(Params<double> p, double factor) {
    p.G1 *= factor;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct KikuchiAiken]
  template <class N>
  using State = kikuchi_aiken::Loops<N>;
  template <class X>
  using Memory = Remembered<X, OpenBranches, Peaks<X>>;
  template <class T, class X>
  using Constants = kikuchi_aiken::Constants<T>;
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    return kikuchi_aiken::constants(p.amax, p.c);
  }

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, kikuchi_aiken::Constants<T> const& c, kikuchi_aiken::Loops<N>& state,
                StepOf<X> const& step, PathMemory const& memory) {
    state.make_room(memory);
    // The slope of the force has no bound as the peak grows from 0. The tangent is therefore limited to the slope of
    // the secant from 0 to 0.01 mm.
    auto const steepest = [&] { return p.G1 * power(T(1e-4), -p.p) / T(reference_mm); };
    if (!(memory.peak > 0.0)) return slope_alone(step.x1, N(steepest()));
    N force = state.force(c, step.x0, step.x1, memory, [&](X const& m) { return at_peak<N>(p, N(m)); });
    if (memory.branch_index == memory.none)
      limit_slope(
          force, [&] { return force; }, steepest);
    return force;
  }

  template <class N, class T>
  static kikuchi_aiken::AtPeak<N> at_peak(Params<T> const& p, N const& peak) {
    T const one(1.0), zero(0.0);
    N const beyond = max(peak - p.xn, N(zero));
    return {p.G1 * power(N(peak / N(reference_mm)), one - p.p) * (one + p.s1 * beyond),
            max(p.h0 + p.h1 * peak, N(zero)), min(max(p.u0 + p.u1 * peak, N(least_share)), N(one)),
            one + p.n1 * beyond};
  }
  static constexpr double least_share = 0.05;
  // [end]
};

}  // namespace isolaw::laws
