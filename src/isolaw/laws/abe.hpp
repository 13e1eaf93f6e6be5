// Abe: the sum of an elastic part that softens with the peak displacement, a hysteretic part whose yield force grows
// with displacement, and a hardening part.
// Source: Cucuzza et al. 2025, Eqs. (15)-(21), after Abe, Yoshida and Fujino 2004; X_h, X_0, X_s of Table 4 are U_h,
// U_0, U_s. Units kN, mm.  Step: first the hysteretic force follows the exact flow of dF2/dx (saturating_flow.hpp) with
// the yield force held at its mean over the step; then the effect of the change of the yield force is added. The growth
// of the yield displacement with the peak is integrated exactly. `paper`: one classical Runge-Kutta step per sample.
#pragma once

#include <algorithm>
#include <cmath>

#include "isolaw/laws/canonical.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"
#include "isolaw/laws/runge_kutta.hpp"
#include "isolaw/laws/saturating_flow.hpp"

namespace isolaw::laws {

// Shared by `abe` and `abe-y0`: the parameters, the forces F1 and F3, and the travel measured in yield displacements.
namespace abe_parts {

inline constexpr ParameterInfo K1_info =
    parameter("K1", "kN/mm", "initial elastic stiffness", any_value, Interval{5.0, 10.0}, {0.5, 20.0, stiffness});
inline constexpr ParameterInfo alpha_info =
    parameter("alpha", "mm", "peak displacement over which the elastic stiffness decays", not_negative,
              Interval{0.0, 10.0}, {0.001, 1.0, disp}, Scale::logarithmic);
inline constexpr ParameterInfo beta_info = parameter("beta", "1", "share of the elastic stiffness that remains",
                                                     any_value, Interval{0.01, 1.0}, {0.01, 1.0, one});
inline constexpr ParameterInfo a_info = parameter("a", "kN", "force of the rounded step at zero displacement",
                                                  any_value, Interval{0.5, 1.0}, {0.0, 0.2, force});
inline constexpr ParameterInfo b_info =
    parameter("b", "1/mm", "rate at which the rounded step grows with displacement", not_negative, Interval{5.0, 10.0},
              {2.0, 2000.0, per_disp}, Scale::logarithmic);
inline constexpr ParameterInfo n_info =
    parameter("n", "1", "sharpness of yielding", positive, Interval{0.01, 0.5}, {0.01, 1.0, one});
inline constexpr ParameterInfo Y0_info =
    parameter("Y0", "kN", "yield force", positive, Interval{10.0, 70.0}, {0.02, 0.8, force});
inline constexpr ParameterInfo Uh_info =
    parameter("Uh", "mm", "displacement at which hardening begins", positive, Interval{50.0, 150.0}, {0.2, 4.0, disp})
        .in_paper("X_h");
inline constexpr ParameterInfo U0_info =
    parameter("U0", "mm", "yield displacement", positive, Interval{2.0, 6.0}, {0.005, 0.3, disp}, Scale::logarithmic)
        .in_paper("X_0");
inline constexpr ParameterInfo Us_info =
    parameter("Us", "mm", "peak displacement over which the yield displacement grows", positive, Interval{5.0, 50.0},
              {0.01, 3.0, disp}, Scale::logarithmic)
        .in_paper("X_s");
inline constexpr ParameterInfo K2_info =
    parameter("K2", "kN/mm", "hardening stiffness", any_value, Interval{0.01, 0.5}, {0.0, 1.2, stiffness});
inline constexpr ParameterInfo r_info =
    parameter("r", "1", "exponent of the hardening force", not_negative, Interval{0.01, 0.2}, {0.01, 2.0, one});

inline constexpr NoForm beyond_programs{"yield force and displacement, which change with the peak so far"};

template <class T>
struct Constants {
  T log2_Uh = T(0.0);
  T inverse_U0 = T(0.0), Us_over_U0 = T(0.0);
  T K1_now = T(0.0);      // K1 [beta + (1 - beta) exp(-Umax / alpha)]; it changes only with the peak
  T inverse_Ut = T(0.0);  // 1 / Ut; it changes only with the peak
};

template <class T, class Params>
void follow_peak(Params const& p, Constants<T>& c, double peak) {
  T const one(1.0), Umax(peak);
  // For alpha = 0 the softening part is gone as soon as there is any peak.
  T const left =
      select(p.alpha <= T(0.0), T(peak > 0.0 ? 0.0 : 1.0), exp(-Umax / max(p.alpha, T(num::smallest_power_base))));
  c.K1_now = p.K1 * (p.beta + (one - p.beta) * left);
  c.inverse_Ut = c.inverse_U0 / (one + Umax / p.Us);
}

template <class T, class Params>
Constants<T> constants(Params const& p, Step const& first) {
  Constants<T> c;
  c.log2_Uh = log2(p.Uh);
  c.inverse_U0 = T(1.0) / p.U0;
  c.Us_over_U0 = p.Us / p.U0;
  follow_peak(p, c, first.peak1);
  return c;
}

struct Piece {  // a whole step, or a straight piece of one, with the peaks at both ends
  double x0, x1, length, direction, peak0, peak1;
  template <class Whole>
  Piece(Whole const& whole, double from, double to)
      : x0(from),
        x1(to),
        length(std::abs(to - from)),
        direction(whole.direction),
        peak0(std::max(whole.peak0, std::abs(from))),
        peak1(std::max(peak0, std::abs(to))) {}
};

// The integral of |dx| / Ut over a piece; `c` holds the constants at its start. Ut grows only beyond the earlier peak.
template <class T, class Params>
T travel(Params const& p, Constants<T> const& c, Piece const& piece) {
  double const growth = piece.peak1 - piece.peak0;
  T travelled = rounded(c.inverse_Ut * T(piece.length - growth));
  if (growth > 0.0) {
    constexpr double ln2 = 0.69314718055994530942;
    travelled += c.Us_over_U0 * T(ln2) * log2((p.Us + T(piece.peak1)) / (p.Us + T(piece.peak0)));
  }
  return travelled;
}

// F1 + F3 at the end of the step. The caller must have called follow_peak for the peak at that end.
template <class T, class Params>
T elastic_force(Params const& p, Constants<T> const& c, Step const& step) {
  if (step.x1 == 0.0) return T(0.0);
  T const x(step.x1), sign(step.x1 > 0.0 ? 1.0 : -1.0);
  T const F1 = rounded(c.K1_now * x) + p.a * sign * (T(1.0) - exp(-p.b * abs(x)));
  T const F3 = p.K2 * x * exp2(p.r * (T(step.log2_abs_x1) - c.log2_Uh));
  return F1 + F3;
}

// The quantities in dF2/dx, Eq. (18), that depend on the point of the path.
template <class T>
struct Point {
  T Yt, per_Yt, inverse_Ut;
};
template <class T>
T hysteretic_slope(T const& F2, Point<T> const& at, T const& n, T const& direction) {
  T const ratio = power(abs(F2 * at.per_Yt), n);
  return at.Yt * at.inverse_Ut * (T(1.0) - select(direction * F2 < T(0.0), -ratio, ratio));
}

// 1 / Ut where the path is at x. `c` holds the constants of peak0, the peak before the step.
template <class T, class Params>
T inverse_Ut_at(Params const& p, Constants<T> const& c, double x, double peak0) {
  return std::abs(x) <= peak0 ? c.inverse_Ut : c.inverse_U0 / (T(1.0) + T(std::abs(x)) / p.Us);
}

}  // namespace abe_parts

struct Abe {
  static constexpr LawInfo info{
      .id = "abe",
      .name = "Abe",
      .title = "Abe, peak-dependent hysteresis with growing yield force",
      .source = "Cucuzza et al. 2025, Eqs. (15)-(21)",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .path_integrated = true, .exact_flow = true},
      .formula =
          "F = F1 + F2 + F3,   Umax = largest |x| so far\n"
          "F1 = K1 (beta + (1 - beta) exp(-Umax / alpha)) x + a (1 - exp(-b |x|)) sgn(x)\n"
          "dF2 = (Yt / Ut) (dx - |dx| |F2 / Yt|^n sgn(F2))\n"
          "Yt = Y0 (1 + |x / Uh|^p),   Ut = U0 (1 + Umax / Us)\n"
          "F3 = K2 |x / Uh|^r x",
      .note =
          "Eq. (19) as printed. With it, the means of Table A.5 give loops 49 to 76 % too stiff; without the growth of the yield force (law abe-y0) they agree with the other laws. The paper does not tell which form the authors ran for the table.",
      .set = LawSet::paper,
      .step_cost = 1379};

  template <class T>
  struct Params {
    T K1, alpha, beta, a, b, n, Y0, Uh, p, U0, Us, K2, r;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K1, abe_parts::K1_info},
      {&Params<T>::alpha, abe_parts::alpha_info},
      {&Params<T>::beta, abe_parts::beta_info},
      {&Params<T>::a, abe_parts::a_info},
      {&Params<T>::b, abe_parts::b_info},
      {&Params<T>::n, abe_parts::n_info},
      {&Params<T>::Y0, abe_parts::Y0_info},
      {&Params<T>::Uh, abe_parts::Uh_info},
      {&Params<T>::p, parameter("p", "1", "exponent of the growth of the yield force", not_negative,
                                Interval{0.01, 2.0}, {0.01, 3.0, one})},
      {&Params<T>::U0, abe_parts::U0_info},
      {&Params<T>::Us, abe_parts::Us_info},
      {&Params<T>::K2, abe_parts::K2_info},
      {&Params<T>::r, abe_parts::r_info},
  });

  static Canonical canonical(Params<double> const&) { return abe_parts::beyond_programs; }
  static constexpr bool crowded = true;  // kernels compute fewer lanes at once (fit/kernels.cpp)

  template <class T>
  struct State {
    T F2 = T(0.0);
    T growth = T(0.0);  // |x / Uh|^p at the last sample
    T per_p_plus_1 = T(0.0), per_Y0 = T(0.0);
    abe_parts::Constants<T> constants;
    SaturatingFlow<T, Reach::beyond_saturation> flow;
  };

  template <class T>
  static State<T> start(Params<T> const& p, Step const& first, Integration integration) {
    State<T> state;
    state.constants = abe_parts::constants<T>(p, first);
    state.growth = growth_at(p, state.constants, first.x1);
    state.per_p_plus_1 = T(1.0) / (p.p + T(1.0));
    state.per_Y0 = T(1.0) / p.Y0;
    if (integration == Integration::converged) state.flow.fit(p.n, T(1.0));
    return state;
  }

  template <class T>
  static T step(Params<T> const& p, State<T>& state, Step const& step) {
    auto& c = state.constants;
    if (step.length > 0.0) {
      // Near x = 0, where |x|^p is not smooth, pieces are shorter.
      double const nearest = step.x0 * step.x1 <= 0.0 ? 0.0 : std::min(std::abs(step.x0), std::abs(step.x1));
      // No piece exceeds the largest step of a sine of 200 samples per cycle. An infinite displacement gives 64.
      int const smooth = static_cast<int>(std::ceil(std::min(64.0, step.length / (0.0317 * step.peak1))));
      int const pieces = std::max(nearest < 1.5 * step.length ? 5 : nearest < 4.0 * step.length ? 2 : 1, smooth);
      double x = step.x0;
      for (int i = 1; i <= pieces; ++i) {
        double const end = i == pieces ? step.x1 : step.x0 + step.dx * i / pieces;
        advance(p, state, abe_parts::Piece(step, x, end));
        x = end;
      }
    }
    return abe_parts::elastic_force(p, c, step) + state.F2;
  }

  template <class T>
  static T step_paper(Params<T> const& p, State<T>& state, Step const& step) {
    auto& c = state.constants;
    T const direction(step.direction);
    auto const point = [&](T const& growth, double x) -> abe_parts::Point<T> {
      T const Yt = p.Y0 * (T(1.0) + growth);
      return {Yt, T(1.0) / Yt, abe_parts::inverse_Ut_at(p, c, x, step.peak0)};
    };
    T const growth = growth_at(p, c, step.x1);
    auto const before = point(state.growth, step.x0), after = point(growth, step.x1);
    double const x = step.x0 + 0.5 * step.dx;
    auto const middle = point(growth_at(p, c, x), x);
    state.F2 = runge_kutta(state.F2, step.dx, [&](double t, T const& F2) {
      return abe_parts::hysteretic_slope(F2, t == 0.0 ? before : t == 1.0 ? after : middle, p.n, direction);
    });
    state.growth = growth;
    if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c, step.peak1);
    return abe_parts::elastic_force(p, c, step) + state.F2;
  }

 private:
  template <class T>
  static T growth_at(Params<T> const& p, abe_parts::Constants<T> const& c, double x) {
    if (x == 0.0) return T(0.0);
    return exp2(p.p * (T(std::log2(std::abs(x))) - c.log2_Uh));
  }

  // Advances F2 over a piece. First F2 follows the exact flow with the yield force held at its mean, then the effect of
  // the yield force's relative change d over the piece is added. Both together are of fourth order where the yield
  // force is smooth. For travel t and rates f0, f1 = du/dt at the ends, and with Phi(F2, Y) = Y f(F2 / Y), the flow is
  // perturbed by the change itself (f - u f' = n + (1 - n) f) by
  //     n d t/12 (1 - f1 / f0)
  // and by the curvature of Phi in Y (|u|^n = 1 - f with the sign of u) by
  //     n (1 - n) d^2 t/24 (1 - f).
  // Over a long travel F2 ends at the yield force of the end, d/2 above the mean, so the first term is blended into
  // that limit and the second one fades. The mean of |x / Uh|^p over x is exact, since its integral is x |x / Uh|^p /
  // (p + 1); a piece that is too short for this difference uses the mean of its two ends. The flow needs the mean over
  // the travel instead. If the peak grows, the travel per x falls as 1 / (Us + peak), so the covariance of the two,
  // both taken as straight lines, is added.
  template <class T>
  static void advance(Params<T> const& p, State<T>& state, abe_parts::Piece const& piece) {
    T const one(1.0), direction(piece.direction), before = state.growth;
    T const after = growth_at(p, state.constants, piece.x1);
    double const size = std::max(std::abs(piece.x0), std::abs(piece.x1));
    bool const tiny = piece.length <= std::max(1e-6 * size, num::smallest_power_base);
    T mean = tiny ? T(0.5) * (before + after)
                  : (rounded(T(piece.x1) * after) - T(piece.x0) * before) * state.per_p_plus_1 *
                        T(1.0 / (piece.x1 - piece.x0));
    double const growth = piece.peak1 - piece.peak0;
    if (growth > 0.0) mean = mean - T(growth / 12.0) * (after - before) / (p.Us + T(0.5 * (piece.peak0 + piece.peak1)));
    T const Yt = p.Y0 * (one + mean), per_mean = one / (one + mean);
    T const travel = abe_parts::travel(p, state.constants, piece);
    auto const moved = state.flow.advance(direction * state.F2 * state.per_Y0 * per_mean, travel);
    T const d = (after - before) * per_mean, relaxed = p.n * travel, some = T(1.0 / 12.0) * relaxed;
    // relaxed (1 + some) fade is relaxed - relaxed^3 / 72 + ... for short travel and tends to 6 for long travel.
    T const fade = one / (one + some + T(2.0) * some * some), fade2 = fade * fade;
    T const first = d * (some + some * some) * fade * (one - moved.ratio);
    T const second = d * d * (some * (fade2 * fade2)) * (one - p.n) * (T(0.5) - T(0.25) * (moved.rate0 + moved.rate1));
    T const limit = T(0.5) * abs(d);
    T const effect = max(-limit, min(rounded(first) + second, limit));
    state.F2 = rounded(direction * Yt * (moved.u + effect));
    state.growth = after;
    if (piece.peak1 > piece.peak0) abe_parts::follow_peak(p, state.constants, piece.peak1);
  }
};

}  // namespace isolaw::laws
