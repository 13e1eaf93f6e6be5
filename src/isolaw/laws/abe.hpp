// Abe: the sum of an elastic part that softens with the peak displacement, a hysteretic part whose yield force grows
// with displacement, and a hardening part.
// Source: Cucuzza et al. 2025, Eqs. (15)-(21), after Abe, Yoshida and Fujino 2004; U_h, U_0, U_s are X_h, X_0, X_s in
// Table 4. Units kN, mm.  Step: the hysteretic force first follows the exact solution of dF2/dx (saturating_flow.hpp)
// for the mean yield force of the step. Then the effect of the change of the yield force is added. The growth of the
// yield displacement with the peak is exact. Integration::paper takes one classical Runge-Kutta step per sample.
#pragma once

#include <algorithm>
#include <cmath>

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/flows/runge_kutta.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/abe_parts.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

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
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K1 *= a;
    p.a *= a;
    p.K2 *= a;
    p.Y0 *= b;
    return p;
  }
  // A step holds so many values at once that kernels compute fewer parameter sets together (fit/kernels.cpp).
  static constexpr bool crowded = true;

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Abe]
  template <class N>
  struct State {
    N F2 = N(0.0);      // the hysteretic force [kN]
    N growth = N(0.0);  // |x / Uh|^p at the present displacement x; the yield force is Y0 (1 + growth)
    abe_parts::Softened<N> softened;
    template <class Each>
    void members(Each& each) {
      each(F2, growth, softened);
    }
  };
  template <class T, class X>
  struct Constants {
    abe_parts::Constants<T> parts;
    T per_p_plus_1, per_p_plus_2, per_Y0;
    Flow<T, X, Reach::beyond_saturation> flow;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    c.parts = abe_parts::constants<T>(p);
    c.per_p_plus_1 = T(1.0) / (p.p + T(1.0));
    c.per_p_plus_2 = T(1.0) / (p.p + T(2.0));
    c.per_Y0 = T(1.0) / p.Y0;
    c.flow.fit(p.n, T(1.0));
    return c;
  }

  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& first) {
    abe_parts::follow_peak(p, c.parts, state.softened, first.peak1);
    state.growth = growth_at<N>(p, c, first.x1);
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    if (moves(step)) {
      // The step is cut at x = 0, where |x|^p is not smooth, and into pieces of 0.0317 times the largest |x| so far. A
      // sine of 200 samples per cycle moves by at most 2 pi / 200 = 0.0314 of its peak from sample to sample, so its
      // steps are not cut. A step that would need more than 64 pieces is cut into 64 longer ones. Every piece but the
      // last has the full length: with pieces of equal length the force would jump where their number changes.
      double const length = value_of(step.length);
      double const piece = std::max(0.0317 * value_of(step.peak1), length / 64.0);
      X x = step.x0, peak = step.peak0;
      auto const go = [&](X const& end) {
        X const next = max(abs(end), peak);
        advance(p, c, state, N(step.direction), x, end, peak, next);
        x = end;
        peak = next;
      };
      auto const go_through_zero = [&](X const& end) {
        if (value_of(x) * value_of(end) < 0.0) go(X(0.0));
        go(end);
      };
      for (int i = 1; i < 64 && i * piece < length; ++i) go_through_zero(step.x0 + step.dx * (i * piece / length));
      go_through_zero(step.x1);
    }
    return abe_parts::elastic_force(p, c.parts, state.softened, step) + state.F2;
  }

  template <class N, class T, class X>
  static N growth_at(Params<T> const& p, Constants<T, X> const& c, X const& x) {
    if (x == 0.0) return N(0.0);
    return exp2(p.p * (N(log2(abs(x))) - c.parts.log2_Uh));
  }

  // Advances F2 over a piece of the step. F2 first follows the exact flow du/dt = f(u) of u = F2 / Y, with the yield
  // force Y held at its mean over the piece. Two terms then add the effect of d, the relative change of Y over the
  // piece. The result is of fourth order where Y is smooth. Let t be the travel and f0, f1 the rates du/dt at the ends
  // of the piece. The first term comes from the change of Y itself (with f - u f' = n + (1 - n) f):
  //     n d t/12 (1 - f1 / f0)
  // The second comes from the curvature of Y f(F2 / Y) over Y (with |u|^n = 1 - f, taken with the sign of u):
  //     n (1 - n) d^2 t/24 (1 - f)
  // After a long travel F2 is at the yield force of the piece's end, which is d/2 above the mean. The first term
  // therefore tends to d/2, and the second to 0.
  // The mean of |x / Uh|^p over x is exact, since its integral is x |x / Uh|^p / (p + 1). A piece that is too short for
  // a difference of two integrals uses the mean of its two ends. The flow needs the mean over the travel instead, and
  // if the peak grows, the travel per x falls as 1 / (Us + peak). The covariance of |x / Uh|^p and this travel, both
  // taken as linear in x, is therefore added to the mean.
  template <class T, class X, class N>
  static void advance(Params<T> const& p, Constants<T, X> const& c, State<N>& state, N const& direction, X const& x0,
                      X const& x1, X const& peak0, X const& peak1) {
    N const one(1.0), before = state.growth, after = growth_at<N>(p, c, x1);
    X const length = abs(x1 - x0);
    double const size = value_of(max(abs(x0), abs(x1)));
    bool const tiny = value_of(length) <= std::max(1e-6 * size, smallest_power_base);
    N mean = tiny ? N(0.5) * (before + after)
                  : (rounded(N(x1) * after) - N(x0) * before) * c.per_p_plus_1 * N(1.0 / (x1 - x0));
    // `change` is how much |x / Uh|^p changes over the piece. Unless the piece is very short, it is taken from the
    // straight line that fits the curve best. The difference of the values at the two ends would jump where a piece
    // comes to end exactly at x = 0.
    N change = after - before;
    if (value_of(length) > 1e-3 * size) {
      X const begin = x0 / (x1 - x0), end = x1 / (x1 - x0);
      N const first_moment = (N(end * end) * after - N(begin * begin) * before) * c.per_p_plus_2;
      change = N(12.0) * (first_moment - N(0.5 * (begin + end)) * mean);
    }
    X const growth = peak1 - peak0;
    if (grows(growth)) mean = mean - N(growth / 12.0) * change / (p.Us + N(0.5 * (peak0 + peak1)));
    N const Yt = p.Y0 * (one + mean), per_mean = one / (one + mean);
    N const travel = abe_parts::travel(p, c.parts, state.softened, length, peak0, peak1);
    auto const moved = c.flow.advance(direction * state.F2 * c.per_Y0 * per_mean, travel);
    N const d = change * per_mean, relaxed = p.n * travel, some = N(1.0 / 12.0) * relaxed;
    // `relaxed` is n t. The product relaxed (1 + some) fade is n t - (n t)^3 / 72 + ... for a short travel, as the
    // first term above needs. For a long travel the product tends to 6 and moved.ratio to 0, so `first` tends to d/2.
    N const fade = one / (one + some + N(2.0) * some * some), fade2 = fade * fade;
    N const first = d * (some + some * some) * fade * (one - moved.ratio);
    N const second = d * d * (some * (fade2 * fade2)) * (one - p.n) * (N(0.5) - N(0.25) * (moved.rate0 + moved.rate1));
    N const limit = N(0.5) * abs(d);
    N const effect = max(-limit, min(rounded(first) + second, limit));
    state.F2 = rounded(direction * Yt * (moved.u + effect));
    state.growth = after;
    if (grows(growth)) abe_parts::follow_peak(p, c.parts, state.softened, peak1);
  }
  // [end]

  template <class T>
  static Constants<T, double> paper_constants(Params<T> const& p) {
    Constants<T, double> c;
    c.parts = abe_parts::constants<T>(p);
    return c;
  }
  template <class T>
  static T step_paper(Params<T> const& p, Constants<T, double> const& c, State<T>& state, Step const& step) {
    T const direction(step.direction);
    auto const point = [&](T const& growth, double x) -> abe_parts::Point<T> {
      T const Yt = p.Y0 * (T(1.0) + growth);
      return {Yt, T(1.0) / Yt, abe_parts::inverse_Ut_at(p, c.parts, state.softened, x, step.peak0)};
    };
    T const growth = growth_at<T>(p, c, step.x1);
    auto const before = point(state.growth, step.x0), after = point(growth, step.x1);
    double const x = step.x0 + 0.5 * step.dx;
    auto const middle = point(growth_at<T>(p, c, x), x);
    state.F2 = runge_kutta(state.F2, step.dx, [&](double t, T const& F2) {
      return abe_parts::hysteretic_slope(F2, t == 0.0 ? before : t == 1.0 ? after : middle, p.n, direction);
    });
    state.growth = growth;
    if (step.peak1 > step.peak0) abe_parts::follow_peak(p, c.parts, state.softened, step.peak1);
    return abe_parts::elastic_force(p, c.parts, state.softened, step) + state.F2;
  }
};

}  // namespace isolaw::laws
