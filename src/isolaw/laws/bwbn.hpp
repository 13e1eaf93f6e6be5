// Bouc-Wen-Baber-Noori: Bouc-Wen whose strength and stiffness degrade with the work of its hysteretic part, and which
// slips where the force passes a small value, so that its loops are pinched.
// Source: Baber and Noori 1986, Foliente 1995. Units kN, mm. OpenSees' material BWBN has the same parameters (called
// Ao, zetas, Shi, deltaShi, lamda), but its zu, the largest |z|, depends neither on degradation nor on A.  Step:
// between reversals u = z / zu moves along one curve (saturating_flow.hpp), more slowly with pinching and degradation.
// Classical Runge-Kutta steps advance the place on that curve together with the work e. The path alone decides the
// number of these steps, and each step uses the zu at its middle. No step is unstable; without pinching and degradation
// every step is exact.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct Bwbn {
  static constexpr LawInfo info{
      .id = "bwbn",
      .name = "Bouc-Wen-Baber-Noori",
      .title = "Bouc-Wen-Baber-Noori, degradation and pinching",
      .source = "Baber and Noori 1986, Eqs. of z and h; Foliente 1995",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .path_integrated = true, .exact_flow = true},
      .formula =
          "F = alpha ko x + (1 - alpha) ko z,   de = (1 - alpha) ko z dx\n"
          "dz = h (A - (1 + dnu e) |z|^n (beta sgn(z dx) + gamma)) dx / (1 + deta e)\n"
          "h = 1 - z1 exp(-(z sgn(dx) - q zu)^2 / z2^2),   zu = (A / ((1 + dnu e) (beta + gamma)))^(1/n)\n"
          "z1 = zs (1 - exp(-p e)),   z2 = (psi + dpsi e) (lambda + z1)",
      .note =
          "Made for timber joints and reinforced concrete. Rubber bearings show no pinching, so their tests do not determine zs, p, psi and dpsi. zs, p, psi and lambda trade off against one another; q and lambda are fixed unless freed. e is the work of z in kN mm. A does not degrade here. If zs is near 1, z hardly passes q zu again. OpenSees' own BWBN takes one implicit Euler step per step of the analysis and starts its iteration from the same guess of z in every state. Beyond the tests only the part alpha ko x of the force grows without bound. The tests do not show how further work would degrade the device.",
      .step_cost = 5881};

  template <class T>
  struct Params {
    T alpha, ko, A, beta, gamma, n, q, zs, p, psi, dpsi, lambda, dnu, deta;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::alpha, parameter("alpha", "1", "ratio of post-yield to elastic stiffness", Interval{0.0, 1.0},
                                    std::nullopt, {0.01, 0.6, one})},
      {&Params<T>::ko, parameter("ko", "kN/mm", "elastic stiffness", positive, std::nullopt, {1.0, 12.0, stiffness})},
      {&Params<T>::A, parameter("A", "1", "amplitude of the hysteretic variable", positive, std::nullopt,
                                {0.5, 2.0, one}, Scale::linear, 1.0)},
      {&Params<T>::beta,
       parameter("beta", "1/mm^n", "shape of the loop; its term changes sign from loading to unloading", positive,
                 std::nullopt, {0.05, 60.0, per_disp}, Scale::logarithmic)},
      {&Params<T>::gamma,
       parameter("gamma", "1/mm^n", "shape of the loop; its term has the same sign in loading and unloading", any_value,
                 std::nullopt, {0.0, 60.0, per_disp})},
      {&Params<T>::n, parameter("n", "1", "sharpness of yielding", positive, std::nullopt, {0.5, 2.0, one})},
      {&Params<T>::q, parameter("q", "1", "z at which the device slips, divided by the largest z", not_negative,
                                std::nullopt, {0.0, 0.5, one}, Scale::linear, 0.25)},
      {&Params<T>::zs, parameter("zs", "1", "share of the stiffness that slip finally takes away", Interval{0.0, 1.0},
                                 std::nullopt, {0.0, 0.95, one})},
      {&Params<T>::p, parameter("p", "1/(kN mm)", "rate at which slip sets in with work", not_negative, std::nullopt,
                                {0.1, 1000.0, per_work}, Scale::logarithmic)},
      {&Params<T>::psi, parameter("psi", "mm", "range of z over which the device slips", positive, std::nullopt,
                                  {0.005, 0.5, disp}, Scale::logarithmic)},
      {&Params<T>::dpsi,
       parameter("dpsi", "1/kN", "growth of psi with work", not_negative, std::nullopt, {0.0, 1.0, disp_per_work})},
      {&Params<T>::lambda, parameter("lambda", "1", "share of the range psi at the start, before slip sets in",
                                     positive, std::nullopt, {0.05, 0.8, one}, Scale::linear, 0.3)},
      {&Params<T>::dnu,
       parameter("dnu", "1/(kN mm)", "strength lost with work", not_negative, std::nullopt, {0.0, 2.0, per_work})},
      {&Params<T>::deta,
       parameter("deta", "1/(kN mm)", "stiffness lost with work", not_negative, std::nullopt, {0.0, 2.0, per_work})},
  });

  // reduced() returns parameters with A = 1 that give the same forces. They make z A times smaller. Therefore psi, the
  // range of z in which the device slips, and dpsi, the growth of this range with work, are divided by A.
  static constexpr std::string_view redundant = "A";
  static constexpr double redundant_value = 1.0;
  static constexpr std::array<std::string_view, 6> redundant_with{"alpha", "ko", "beta", "gamma", "psi", "dpsi"};
  static Params<double> reduced(Params<double> p) {
    double const scale = num::power(p.A, p.n - 1.0), elastic = p.alpha * p.ko + (1.0 - p.alpha) * p.ko * p.A;
    p.alpha = p.alpha * p.ko / elastic;
    p.ko = elastic;
    p.beta *= scale;
    p.gamma *= scale;
    p.psi /= p.A;
    p.dpsi /= p.A;
    p.A = 1.0;
    return p;
  }

  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{"beta + gamma > 0", [](Params<double> const& p) { return p.beta + p.gamma > 0.0; }}};

  static Canonical canonical(Params<double> const& p) {
    if (p.zs * p.p != 0.0 || p.dnu != 0.0 || p.deta != 0.0) return NoForm{"pinching and degradation with work"};
    auto const r = reduced(p);
    return BoucWenForm{r.alpha, r.ko, r.beta, r.gamma, r.n};
  }
  // The parameters that multiply the work of z are divided by b, because this work becomes b times as large.
  static Params<double> with_factors(Params<double> p, double a, double b) {
    double const elastic = a * p.alpha * p.ko;
    p.ko = elastic + b * (1.0 - p.alpha) * p.ko;
    p.alpha = elastic / p.ko;
    p.p /= b;
    p.dpsi /= b;
    p.dnu /= b;
    p.deta /= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Bwbn]
  // z is the hysteretic variable [mm], and e the work of its force, with which strength and stiffness degrade.
  template <class N>
  struct State {
    N z = N(0.0), e = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(z, e);
    }
  };
  template <class T, class X>
  struct Constants {
    T strength;  // zu, the largest |z|, before any degradation [mm]
    T share;     // (1 - alpha) ko, the hysteretic force for z = 1 mm [kN/mm]
    Flow<T, X, Reach::within_saturation> flow;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    T const both = p.beta + p.gamma;
    c.strength = exp2((log2(p.A) - log2(both)) / p.n);
    c.share = (T(1.0) - p.alpha) * p.ko;
    c.flow.fit(p.n, (p.beta - p.gamma) / both);
    return c;
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    if (moves(step)) {
      // The step is cut into pieces of 1/50 of the largest |x| so far, and the last piece is the remainder: with pieces
      // of equal length the force would jump where their number changes. A step is at most twice as long as the largest
      // |x|, which gives 100 pieces. An infinite displacement makes the second argument of std::min NaN; std::min then
      // returns its first.
      double const wanted = std::min(2.0 * pieces_to_the_peak, value_of(pieces_to_the_peak * step.length / step.peak1));
      X left = step.length;
      for (double i = 1.0; i < wanted; i += 1.0) {
        X const piece = step.peak1 / pieces_to_the_peak;
        advance(p, c, state, N(step.direction), piece);
        left = left - piece;
      }
      advance(p, c, state, N(step.direction), left);
    }
    return rounded(p.alpha * p.ko * N(step.x1)) + c.share * state.z;
  }

  static constexpr double pieces_to_the_peak = 50.0;

  template <class T, class X, class N>
  static void advance(Params<T> const& p, Constants<T, X> const& c, State<N>& state, N const& direction, X const& way) {
    N const length(way), half(0.5 * way), one(1.0), none(0.0), z = direction * state.z;
    N const work = max(state.e + half * c.share * z, none);
    N const zu = c.strength * exp2(-log2(one + p.dnu * work) / p.n), pace = p.A / zu;
    // If degradation brings zu below z, the excess of z / zu over 1 decays as exp(-n t) over the curve's time t, as
    // 1 - u does near saturation.
    N const inside = min(z / zu, N(c.flow.end_of_curve)), beyond = z / zu - inside;
    N const begin = c.flow.time_at(inside);
    // How fast the place on the curve advances per unit of travel, at the given z and work e.
    auto const speed = [&](N const& at, N const& e) -> N {
      N const done = max(e, none), z1 = p.zs * (one - exp(-p.p * done));
      N const z2 = (p.psi + p.dpsi * done) * (p.lambda + z1);
      N const off = (at - p.q * zu) / max(z2, N(smallest_power_base));
      return pace * (one - z1 * exp(-off * off)) / (one + p.deta * done);
    };
    auto const value = [&](N const& time) -> N {
      return rounded(zu * (c.flow.value_at(begin + rounded(time)) + rounded(beyond * exp(-p.n * time))));
    };
    N const speed1 = speed(z, state.e);
    N const z_2 = value(half * speed1), speed2 = speed(z_2, state.e + half * c.share * z);
    N const z_3 = value(half * speed2), speed3 = speed(z_3, state.e + half * c.share * z_2);
    N const z_4 = value(length * speed3), speed4 = speed(z_4, state.e + length * c.share * z_3);
    N const sixth(way / 6.0), two(2.0);
    state.e += sixth * c.share * (z + two * (z_2 + z_3) + z_4);
    state.z = direction * value(sixth * (speed1 + two * (speed2 + speed3) + speed4));
  }
  // [end]

  // With beta <= 0 or beta + gamma <= 0 the force has no bound, so the law gives NaN.
  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const&, State<N>& state, StepOf<X> const&) {
    T const nan(std::numeric_limits<double>::quiet_NaN());
    state.z = select(min(p.beta, p.beta + p.gamma) > T(0.0), T(0.0), nan);
  }
};

}  // namespace isolaw::laws
