// Ozdemir: a force that follows a backstress, with Graesser and Cozzarelli's term g(x) for superelastic alloys.
// Source: Ozdemir 1976; Graesser and Cozzarelli 1991, F' = Ks (x' - |x'| |s/Ys|^n sgn(s)), s = F - b, with the
// backstress b = Ks alpha (x - F/Ks + g(x)). Solved for F and s':
//     F = (Ks alpha (x + g) + s) / (1 + alpha),   s' = Ks (x' (1 - alpha g'(x)) - (1 + alpha) |x'| |s/Ys|^n sgn(s)).
// This file uses z = s / (1 + alpha): F = alpha K (x + g) + z, K = Ks / (1 + alpha), Y = Ys (1 + alpha)^(-1 - 1/n). It
// leaves out -alpha g' in z', so that z follows one curve between reversals (saturating_flow.hpp). For g = 0 this
// equals the source. Otherwise a branch leaves a reversal with a slope that is alpha K g' above the source's, and z
// saturates at +-Y instead of +-Y (1 - alpha g')^(1/n).  Units kN, mm.  Step: exact along a straight path.
#pragma once

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/num/error_function.hpp"

namespace isolaw::laws {

using num::erf;

struct Ozdemir {
  static constexpr LawInfo info{
      .id = "ozdemir",
      .name = "Ozdemir",
      .title = "Ozdemir, rate-independent flow about a backstress",
      .source = "Ozdemir 1976, Eqs. of force and backstress; Graesser and Cozzarelli 1991",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .odd = true, .exact_flow = true},
      .formula =
          "F = alpha K (x + fT |x/100|^c erf(a x)) + z\n"
          "dz = K (dx - |dx| |z/Y|^n sgn(z))",
      .note =
          "Made for metals and, with fT, for alloys that return by themselves. The source's stiffness is (1 + alpha) K, its strength (1 + alpha)^(1 + 1/n) Y. With fT the source also reduces the slope of z by alpha K times the slope of its term; here the term is only elastic. Without fT the law is bouc-wen with gamma 0: unloading is as much steeper than K as loading is flatter. Beyond the tests the force grows as alpha K x. Loops of unloading and reloading do not close.",
      .step_cost = 523};

  template <class T>
  struct Params {
    T K, Y, n, alpha, fT, c, a;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::K, parameter("K", "kN/mm", "first stiffness of the hysteretic part", positive, std::nullopt,
                                {0.5, 15.0, stiffness}, Scale::logarithmic)},
      {&Params<T>::Y, parameter("Y", "kN", "force at which the hysteretic part saturates", positive, std::nullopt,
                                {0.5, 5.0, strength}, Scale::logarithmic)},
      {&Params<T>::n,
       parameter("n", "1", "sharpness of yielding", positive, std::nullopt, {0.1, 3.0, one}, Scale::logarithmic)},
      {&Params<T>::alpha,
       parameter("alpha", "1", "stiffness of the elastic part divided by that of the hysteretic part", not_negative,
                 std::nullopt, {0.01, 1.5, one}, Scale::logarithmic)},
      {&Params<T>::fT, parameter("fT", "mm", "displacement that is added to x in the elastic force, at 100 mm",
                                 any_value, std::nullopt, {0.0, 2.0, disp}, Scale::linear, 0.0)},
      {&Params<T>::c, parameter("c", "1", "exponent with which fT's term grows with displacement", not_negative,
                                std::nullopt, {0.0, 2.0, one}, Scale::linear, 0.0)},
      {&Params<T>::a, parameter("a", "1/mm", "rate at which fT's term sets in", not_negative, std::nullopt,
                                {0.2, 20.0, per_disp}, Scale::logarithmic, 0.01)},
  });

  static Canonical canonical(Params<double> const& p) {
    if (p.alpha * p.fT * p.a != 0.0) return NoForm{"elastic force fT |x/100|^c erf(a x)"};
    return BoucWenForm{
        .alpha = p.alpha / (1.0 + p.alpha),
        .Ke = (1.0 + p.alpha) * p.K,
        .beta = std::pow(p.K / p.Y, p.n),
        .gamma = 0.0,
        .n = p.n,
    };
  }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.K *= b;
    p.Y *= b;
    p.alpha *= a / b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Ozdemir]
  template <class N>
  struct State {
    // z is the hysteretic part of the force [kN]. `time` is the t at which the curve u(t) of Constants::flow has the
    // value of z / Y, taken positive in the direction of motion.
    N z = N(0.0), time = N(0.0);
    template <class Each>
    void members(Each& each) {
      each(z, time);
    }
  };
  template <class T, class X>
  struct Constants {
    T rate;  // K/Y: how much the time t of the curve u(t) of `flow` grows per mm of travel
    Flow<T, X, Reach::within_saturation> flow;
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    c.rate = p.K / p.Y;
    c.flow.fit(p.n, T(1.0));
    return c;
  }

  template <class T, class X, class N>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step) {
    if (moves(step)) {
      N const direction(step.direction);
      if (step.reversal) state.time = c.flow.time_at(direction * state.z / p.Y);
      state.time += c.rate * N(step.length);
      state.z = direction * p.Y * c.flow.value_at(state.time);
    }
    constexpr double log2_100 = 6.643856189774724;
    N const x(step.x1), ahead = p.fT * exp2(p.c * N(log2_abs_x1(step) - log2_100)) * erf(p.a * x);
    return rounded(p.alpha * p.K * (x + ahead)) + state.z;
  }
  // [end]
};

}  // namespace isolaw::laws
