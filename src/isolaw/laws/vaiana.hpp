// Vaiana (VRM+D class): transcendental and rate independent, with different loading and unloading branches.
// Source: Cucuzza et al. 2025, Eqs. (6)-(12), after Vaiana et al. 2021. Here the source's auxiliary length is infinite:
// the branch starts from the reversal point (xP, fP) itself and needs no internal variable and no logarithm. Units N,
// m.  Step: exact. A branch that is begun again at any of its points stays the same branch, so each step takes the
// sample before it as (xP, fP).
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

struct Vaiana {
  static constexpr LawInfo info{
      .id = "vaiana",
      .name = "Vaiana",
      .title = "Vaiana, asymmetric transcendental",
      .source = "Cucuzza et al. 2025, Eqs. (6)-(12)",
      .force = N,
      .length = m,
      .traits = {.rate_independent = true},
      .formula =
          "from the last turning point (xP, fP), loading:   F = cu(x) - (cu(xP) - fP) exp(-alpha+ (x - xP))\n"
          "unloading:   F = cl(x) + (fP - cl(xP)) exp(-alpha- (xP - x))\n"
          "cu(x) = fe+(x) + Kb+ x + f0+,   cl(x) = fe-(x) + Kb- x - f0-\n"
          "fe+(x) = beta1+ (exp(beta2+ x) - 1) + 4 gamma1+ / (1 + exp(-gamma2+ (x - gamma3+))) - 2 gamma1+\n"
          "fe-(x) = beta1- (exp(beta2- x) - 1) + 4 gamma1- / (1 + exp(-gamma2- (x - gamma3-))) - 2 gamma1-",
      .note =
          "The auxiliary length of Eqs. (11)-(12) is infinite here (the source takes exp(-alpha u) = 1e-20). The paper calibrates ten of the sixteen parameters and sets the sigmoid (gamma1, gamma2, gamma3) to zero.",
      .set = LawSet::paper,
      .step_cost = 205};

  // The suffix _p stands for loading, with increasing displacement, and _m for unloading.
  template <class T>
  struct Params {
    T Kb_p, Kb_m, f0_p, f0_m, alpha_p, alpha_m, beta1_p, beta1_m, beta2_p, beta2_m;
    T gamma1_p, gamma1_m, gamma2_p, gamma2_m, gamma3_p, gamma3_m;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::Kb_p, parameter("Kb+", "N/m", "slope of the loading limit curve", any_value, Interval{1e5, 6e5},
                                   {0.0, 1.2, stiffness})},
      {&Params<T>::Kb_m, parameter("Kb-", "N/m", "slope of the unloading limit curve", any_value, Interval{1e5, 6e5},
                                   {0.0, 1.2, stiffness})},
      {&Params<T>::f0_p, parameter("f0+", "N", "half distance of the limit curves, loading", not_negative,
                                   Interval{1e4, 1e5}, {0.0, 2.5, strength})
                             .in_paper("F_0+")},
      {&Params<T>::f0_m, parameter("f0-", "N", "half distance of the limit curves, unloading", not_negative,
                                   Interval{1e4, 1e5}, {0.0, 2.5, strength})
                             .in_paper("F_0-")},
      {&Params<T>::alpha_p, parameter("alpha+", "1/m", "rate of approach to the limit curve, loading", not_negative,
                                      Interval{0.0, 50.0}, {0.5, 50.0, per_disp}, Scale::logarithmic)},
      {&Params<T>::alpha_m, parameter("alpha-", "1/m", "rate of approach to the limit curve, unloading", not_negative,
                                      Interval{0.0, 50.0}, {0.5, 50.0, per_disp}, Scale::logarithmic)},
      {&Params<T>::beta1_p, parameter("beta1+", "N", "size of the exponential hardening, loading", any_value,
                                      Interval{0.0, 0.9}, {-1.0, 1.0, force}, Scale::logarithmic)},
      {&Params<T>::beta1_m, parameter("beta1-", "N", "size of the exponential hardening, unloading", any_value,
                                      Interval{-0.9, 0.0}, {-1.0, 1.0, force}, Scale::logarithmic)},
      {&Params<T>::beta2_p, parameter("beta2+", "1/m", "rate of the exponential hardening, loading", any_value,
                                      Interval{15.0, 50.0}, {0.2, 15.0, per_disp})},
      {&Params<T>::beta2_m, parameter("beta2-", "1/m", "rate of the exponential hardening, unloading", any_value,
                                      Interval{-50.0, -15.0}, {-15.0, -0.2, per_disp})},
      {&Params<T>::gamma1_p, parameter("gamma1+", "N", "size of the sigmoid, loading", any_value, std::nullopt,
                                       {-0.5, 0.5, force}, Scale::linear, 0.0)},
      {&Params<T>::gamma1_m, parameter("gamma1-", "N", "size of the sigmoid, unloading", any_value, std::nullopt,
                                       {-0.5, 0.5, force}, Scale::linear, 0.0)},
      {&Params<T>::gamma2_p, parameter("gamma2+", "1/m", "steepness of the sigmoid, loading", any_value, std::nullopt,
                                       {1.0, 50.0, per_disp}, Scale::logarithmic, 0.0)},
      {&Params<T>::gamma2_m, parameter("gamma2-", "1/m", "steepness of the sigmoid, unloading", any_value, std::nullopt,
                                       {1.0, 50.0, per_disp}, Scale::logarithmic, 0.0)},
      {&Params<T>::gamma3_p, parameter("gamma3+", "m", "centre of the sigmoid, loading", any_value, std::nullopt,
                                       {-1.2, 1.2, disp}, Scale::linear, 0.0)},
      {&Params<T>::gamma3_m, parameter("gamma3-", "m", "centre of the sigmoid, unloading", any_value, std::nullopt,
                                       {-1.2, 1.2, disp}, Scale::linear, 0.0)},
  });

  static Canonical canonical(Params<double> const& p) {
    return LimitCurvesForm{.loading = {p.Kb_p, p.f0_p, p.alpha_p, p.beta1_p, p.beta2_p, p.gamma1_p},
                           .unloading = {p.Kb_m, p.f0_m, p.alpha_m, p.beta1_m, p.beta2_m, p.gamma1_m}};
  }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.Kb_p *= a;
    p.Kb_m *= a;
    p.beta1_p *= a;
    p.beta1_m *= a;
    p.gamma1_p *= a;
    p.gamma1_m *= a;
    p.f0_p *= b;
    p.f0_m *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Vaiana]
  template <class N>
  struct State {
    N f = N(0.0);      // the force [N] at the end of the last step
    N limit = N(0.0);  // the force [N] of the limit curve for the present direction, at the end of the last step
    template <class Each>
    void members(Each& each) {
      each(f, limit);
    }
  };

  template <class T, class X, class N>
  static N step(Params<T> const& p, NoConstants const&, State<N>& state, StepOf<X> const& step) {
    if (!moves(step)) return state.f;
    bool const loading = step.direction > 0.0;
    if (step.reversal) state.limit = limit_curve(p, loading, N(step.x0));
    N const next = limit_curve(p, loading, N(step.x1));
    N const decay = exp(-(loading ? p.alpha_p : p.alpha_m) * N(step.length));
    state.f = next - (state.limit - state.f) * decay;
    state.limit = next;
    return state.f;
  }

  // The limit curve of Eq. (6): cu(x) for loading, cl(x) for unloading.
  template <class T, class N>
  static N limit_curve(Params<T> const& p, bool loading, N const& x) {
    auto const curve = [&](T const& Kb, T const& offset, T const& beta1, T const& beta2, T const& gamma1,
                           T const& gamma2, T const& gamma3) -> N {
      T const one(1.0);
      N const hardening = beta1 * (exp(beta2 * x) - one);
      N const sigmoid = T(4.0) * gamma1 / (one + exp(-gamma2 * (x - gamma3))) - T(2.0) * gamma1;
      return hardening + sigmoid + Kb * x + offset;
    };
    return loading ? curve(p.Kb_p, p.f0_p, p.beta1_p, p.beta2_p, p.gamma1_p, p.gamma2_p, p.gamma3_p)
                   : curve(p.Kb_m, -p.f0_m, p.beta1_m, p.beta2_m, p.gamma1_m, p.gamma2_m, p.gamma3_m);
  }
  // [end]
};

}  // namespace isolaw::laws
