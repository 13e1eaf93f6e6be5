// Kikuchi-Aiken: loops between the peaks so far, whose secant stiffness, damping and shape depend on the peak, and
// inner branches by Masing's rules.
// Source: Kikuchi and Aiken 1997; docs/laws.md. Units kN, mm. Step: exact; every sample depends only on the turning
// points and the peak of the displacement, which the record decides. Departures: the published outer branch misses the
// peak that it leads to by 2 exp(-2a) - 2 b exp(-2c) of the hysteretic force (1e-6 to 5e-4 for the published
// compounds). The missing force is added as a term in (s/2)^8, so that the force is continuous. One rule sets both the
// cap of a and the strain above which b sets in; this holds for the published compounds too.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/laws/canonical.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"
#include "isolaw/laws/scragging.hpp"

namespace isolaw::laws {

namespace kikuchi_aiken {

// The functions of the peak: force, equivalent damping ratio, hysteretic share, and exponent of the hardening part.
template <class T>
struct AtPeak {
  T force, damping, share, exponent;
};

template <class T>
class Loops {
 public:
  Loops() = default;
  Loops(Path const& path, T const& largest_a, T const& c)
      : turned_(path.deepest),
        least_area_(area_left(max(largest_a, T(num::smallest_power_base)))),
        c_(c * T(num::log2_e)),
        twice_c2_(T(2.0) * c * c) {}

  // The force at the end of a step; must be called at every step. at_peak(m) gives AtPeak for a peak m.
  template <class Functions>
  T force(Step const& step, Memory const& memory, Functions&& at_peak) {
    if (memory.kept != Memory::none) turn(memory.kept, step.x0);
    if (memory.peak <= 0.0) return T(0.0);
    if (memory.peak_grows) grow(memory.peak, at_peak(memory.peak));
    double const x = step.x1 / peak_, size = std::abs(x), side = x < 0.0 ? -1.0 : 1.0;
    if (memory.branch == Memory::none) {
      hysteretic_ = T(side) * strength_;
    } else {
      Turn const& from = turned_[memory.branch];
      double const s = std::abs(step.x1 - from.x) / peak_;
      hysteretic_ = from.force + T(memory.direction) * strength_ * from.scale * shape(s, memory.branch == 0, from.bump);
    }
    T const hardening = exp2(exponent_ * T(std::log2(std::max(size, num::smallest_power_base))));
    return half_elastic_ * T(side) * (T(size) + hardening) + hysteretic_;
  }

  T a() const { return a_ * T(1.0 / num::log2_e); }
  T b() const { return b_; }

 private:
  struct Turn {
    double x = 0.0;
    bool bump = false;  // whether the branch from this turn has the term of b
    T force = T(0.0), scale = T(0.0);
  };

  // (1 - exp(-2a))/a: the share of the loop's parallelogram that the exponential branches cut off.
  static T area_left(T const& a) { return (T(1.0) - exp2(T(-2.0 * num::log2_e) * a)) / a; }

  void grow(double peak, AtPeak<T> const& now) {
    peak_ = peak;
    strength_ = now.share * now.force;
    half_elastic_ = T(0.5) * (now.force - strength_);
    exponent_ = now.exponent;
    T const wanted = T(1.0) - T(0.5 * std::numbers::pi) * now.damping / now.share;
    // A NaN is not lost: max returns its first argument if one of the two is NaN, and b_ is computed from `wanted` too.
    T const area = max(least_area_, wanted);
    // Newton's method for area a - 1 + exp(-2a) = 0, which is convex; five steps from 1/area suffice for any area <= 1.
    T a = T(1.0) / area;
    for (int i = 0; i < 5; ++i) {
      T const e = exp2(T(-2.0 * num::log2_e) * a);
      a = a - (area * a - T(1.0) + e) / (area - T(2.0) * e);
    }
    a_ = a * T(num::log2_e);
    b_ = twice_c2_ * (area - wanted);
    closing_ = T(0.0);
    closing_ = T(2.0) - shape(2.0, true, true);
  }

  T shape(double s, bool outer, bool bump) const {  // f(s) of a branch that has moved s peaks since its turn
    T f = T(2.0) - T(2.0) * exp2(-a_ * T(s));
    if (bump) f = f + b_ * T(s) * exp2(-c_ * T(s));
    if (!outer) return f;
    double const half2 = 0.25 * s * s, half4 = half2 * half2;
    return f + closing_ * T(half4 * half4);
  }

  // An inner branch is scaled so that it returns to the point where the branch before it began. It has no term of b if
  // both turns are on the same side, or if the branch before it has none.
  void turn(std::size_t place, double x) {
    Turn& now = turned_[place];
    now = {.x = x, .bump = true, .force = hysteretic_, .scale = T(1.0)};
    if (place == 0) return;
    Turn const& before = turned_[place - 1];
    double const s = std::abs(x - before.x) / peak_;
    now.bump = before.bump && x * before.x <= 0.0;
    now.scale =
        before.scale * shape(s, place == 1, before.bump) / max(shape(s, false, now.bump), T(num::smallest_power_base));
  }

  double peak_ = 0.0;
  T hysteretic_ = T(0.0);
  T strength_ = T(0.0), half_elastic_ = T(0.0), exponent_ = T(0.0);  // u Fm, (1 - u) Fm / 2, n
  T a_ = T(0.0), b_ = T(0.0), closing_ = T(0.0);                     // a_ is a log2(e), for exp2
  std::vector<Turn> turned_;
  T least_area_ = T(0.0), c_ = T(0.0), twice_c2_ = T(0.0);  // c_ is c log2(e), for exp2
};

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
          "f(s) = 2 - 2 exp(-a s) + b s exp(-c s),   from a peak + (2 - f(2)) (s/2)^8;   A = 1 from a peak,\n"
          "later such that the branch meets the one before where that began; Masing's rules close branches\n"
          "(1 - exp(-2 a))/a = 1 - pi h/(2 U), a up to amax;   b = c^2 (pi h/U - 2 + 2 (1 - exp(-2 a))/a), 0 below amax\n"
          "Fm = G1 (m/100)^(1-p) (1 + s1 (m - xn)),   h = h0 + h1 m, not below 0,   U = u0 + u1 m within 0.05 to 1,\n"
          "n = 1 + n1 (m - xn),   both without m - xn below xn",
      .note =
          "Made for high damping rubber. The functions are of millimetres, so that no height of rubber is needed; a published compound's functions of strain have the same p, h0 and u0, and h1, u1, n1 and s1 times the height. A closed loop dissipates 2 pi h Fm m, to 1 % where a is above 2. b is left out after two turns on one side or after a branch without it. Beyond the tests Fm grows as m^(1-p), with s1 eventually as m^(2-p): at 2 and 5 times the amplitude it is 2^(1-p) and 5^(1-p) times as large, and with s1 up to 2 and 5 times more. h, U and n follow straight lines to their given ends. At five times the fitted amplitude these lines mean little, and where h has fallen to 0 a new peak may give back more work than the way to it took. A known material of this law is elastic below a strain of 0.05 and keeps the values and turning points of rejected trials; here only the path decides them. A virgin device has no bounded slope at 0 where p is above 0.",
      .step_cost = 272};

  template <class T>
  struct Params {
    T G1, p, h0, h1, u0, u1, n1, xn, s1, amax, c;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::G1, parameter("G1", "kN", "force at a peak of 100 mm", not_negative, std::nullopt,
                                 {0.3, 3.0, force_at_reference}, Scale::logarithmic)},
      {&Params<T>::p, parameter("p", "1", "exponent of the secant stiffness's fall with the peak", Interval{0.0, 0.95},
                                std::nullopt, {0.0, 0.7, one})},
      {&Params<T>::h0,
       parameter("h0", "1", "equivalent damping ratio of small loops", not_negative, std::nullopt, {0.08, 0.3, one})},
      {&Params<T>::h1, parameter("h1", "1/mm", "change of the damping ratio with the peak", any_value, std::nullopt,
                                 {-0.07, 0.05, per_disp})},
      {&Params<T>::u0, parameter("u0", "1", "hysteretic share of the force of small loops", Interval{0.0, 1.0},
                                 std::nullopt, {0.2, 0.6, one})},
      {&Params<T>::u1, parameter("u1", "1/mm", "change of the hysteretic share with the peak", any_value, std::nullopt,
                                 {-0.3, 0.1, per_disp})},
      {&Params<T>::n1, parameter("n1", "1/mm", "growth of the exponent of hardening with the peak", not_negative,
                                 std::nullopt, {0.0, 6.0, per_disp})},
      {&Params<T>::xn,
       parameter("xn", "mm", "peak above which n1 and s1 act", not_negative, std::nullopt, {0.1, 0.9, disp})},
      {&Params<T>::s1, parameter("s1", "1/mm", "growth of the force at the peak above xn", not_negative, std::nullopt,
                                 {0.0, 1.0, per_disp})},
      {&Params<T>::amax, parameter("amax", "1", "largest rate a of the branches' exponential", Interval{1.0, infinity},
                                   std::nullopt, {5.0, 20.0, one}, Scale::linear, 10.19171)},
      {&Params<T>::c, parameter("c", "1", "decay of the term b, which acts where a has reached amax", not_negative,
                                std::nullopt, {2.0, 50.0, one}, Scale::logarithmic)},
  });

  static Canonical canonical(Params<double> const&) {
    return NoForm{"functions of the peak: KikuchiAikenHDR has only the functions of its own compounds"};
  }

  template <class T>
  using State = kikuchi_aiken::Loops<T>;

  template <class T>
  static State<T> start(Params<T> const& p, Path const& path) {
    return State<T>(path, p.amax, p.c);
  }

  template <class T>
  static T step(Params<T> const& p, State<T>& state, Step const& step, Memory const& memory) {
    return state.force(step, memory, [&](double m) -> kikuchi_aiken::AtPeak<T> {
      T const one(1.0), zero(0.0), peak(m);
      T const beyond = max(peak - p.xn, zero);
      return {.force = p.G1 * power(T(m / reference_mm), one - p.p) * (one + p.s1 * beyond),
              .damping = max(p.h0 + p.h1 * peak, zero),
              .share = min(max(p.u0 + p.u1 * peak, T(least_share)), one),
              .exponent = one + p.n1 * beyond};
    });
  }

 private:
  static constexpr double least_share = 0.05;
};

}  // namespace isolaw::laws
