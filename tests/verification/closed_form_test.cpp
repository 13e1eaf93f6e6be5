// The laws are compared with closed forms: loops that can be integrated by hand, differential laws at exponents for
// which the equation has a solution, and algebraic laws at arguments where cosh and the square root are rational.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "laws/candidates.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Abe;
using laws::AbeY0;
using laws::Bilinear;
using laws::BoucWen;
using laws::HwangWu;
using laws::Integration;
using laws::Jankowski;
using laws::MenegottoPinto;
using laws::Vaiana;

// Returns the work from sample `first` to the end, by the trapezoidal rule and in the law's units.
double loop_energy(std::vector<double> const& force, std::vector<double> const& x, std::size_t first) {
  double energy = 0.0;
  for (std::size_t i = first; i + 1 < x.size(); ++i) energy += 0.5 * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
  return energy;
}

Motion three_triangles(double amplitude_mm, int steps) {
  double const D = amplitude_mm;
  return polyline(std::vector{0.0, D, -D, D, -D, D}, steps);
}

// The closed forms are K_eff = K2 + Qd / D and energy 4 Qd (D - xy). The path has samples at its corners, so the
// trapezoidal rule errs only around the two yield points, by at most (K1 - K2) h^2 / 4 each for samples h apart.
TEST(ClosedForm, BilinearLoop) {
  double const K1 = 1.65, K2 = 0.43, xy = 40.6, D = 208.0, Qd = (K1 - K2) * xy;
  constexpr int steps = 5000;
  auto const motion = three_triangles(D, steps);
  auto const force = forces<Bilinear>(named<Bilinear>({{"K1", K1}, {"K2", K2}, {"xy", xy}}), motion);
  EXPECT_NEAR((force[5 * steps] - force[4 * steps]) / (2.0 * D), K2 + Qd / D, 1e-12);
  double const h = 2.0 * D / steps;
  EXPECT_NEAR(loop_energy(force, motion.disp_mm, 3 * steps), 4.0 * Qd * (D - xy), 2.0 * (K1 - K2) * h * h / 4.0);
}

// Eq. (1) with kinematic hardening gives the expected forces on the first loading, on unloading and on reloading, on
// both sides of each yield point.
TEST(ClosedForm, BilinearBranches) {
  auto const values = named<Bilinear>({{"K1", 2.0}, {"K2", 0.5}, {"xy", 10.0}});  // so the strength (K1 - K2) xy is 15
  Motion motion;
  motion.disp_mm = {0.0, 8.0, 10.0, 30.0, 20.0, 10.0, 0.0, -30.0, -15.0, -10.0, 0.0};
  motion.velocity_mm_s.assign(motion.disp_mm.size(), 0.0);
  std::vector<double> const expected{0.0, 16.0, 20.0, 30.0, 10.0, -10.0, -15.0, -30.0, 0.0, 10.0, 15.0};
  auto const force = forces<Bilinear>(values, motion);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(force[i], expected[i], 1e-12) << motion.disp_mm[i];
}

// Tests the steel model of the 1983 report on Menegotto and Pinto's law. Other programs computed the expected values.
TEST(ClosedForm, MenegottoPintoBranches) {
  auto const values =
      named<MenegottoPinto>({{"E", 1.0}, {"Fy", 1.0}, {"b", 0.1}, {"R0", 20.0}, {"cR1", 0.925}, {"cR2", 0.15}});
  Motion motion;
  motion.disp_mm = {0.0, 1.0, 5.0, -5.0, 5.0, 2.0, 5.0, 6.0};
  motion.velocity_mm_s.assign(motion.disp_mm.size(), 0.0);
  std::vector<double> const expected{0.0,         0.969342696,  1.4,         -1.375243036,
                                     1.353082051, -0.378071558, 1.345535478, 1.478107786};
  auto const force = forces<MenegottoPinto>(values, motion);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(force[i], expected[i], 5.1e-10) << i;
}

// Without the exponential and sigmoid terms the force approaches the limit curves kb x +- f0 as exp(-alpha travel).
// Then K_eff = kb + f0 tanh(alpha D) / D, and the energy is 4 f0 [D - tanh(alpha D) / alpha]. With kb 0.6 kN/mm, f0 25
// kN, alpha 0.08 / mm and D 150 mm they are 0.766667 kN/mm and 13750.00 kN mm, rounded to the last printed digit. The
// first loop stays open by 2 f0 exp(-2 alpha D) = 2e-9 kN. With samples h apart the trapezoidal rule errs by 2 f0 alpha
// h^2 / 6 = 1e-3 kN mm in all.
TEST(ClosedForm, VaianaLoop) {
  double const kb = 0.6, f0 = 25.0, alpha = 0.08, D = 150.0;
  constexpr int steps = 8000;
  auto const values = named<Vaiana>({{"Kb+", 1e6 * kb},
                                     {"Kb-", 1e6 * kb},
                                     {"f0+", 1e3 * f0},
                                     {"f0-", 1e3 * f0},
                                     {"alpha+", 1e3 * alpha},
                                     {"alpha-", 1e3 * alpha},
                                     {"beta2+", 20.0},
                                     {"beta2-", -20.0}});
  auto const motion = three_triangles(D, steps);
  auto force = forces<Vaiana>(values, motion);
  for (double& f : force) f *= 1e-3;
  double const stiffness = (force[5 * steps] - force[4 * steps]) / (2.0 * D);
  double const energy = loop_energy(force, motion.disp_mm, 3 * steps);
  EXPECT_NEAR(stiffness, kb + f0 * std::tanh(alpha * D) / D, 1e-9);
  EXPECT_NEAR(stiffness, 0.766667, 5e-7);
  EXPECT_NEAR(energy, 4.0 * f0 * (D - std::tanh(alpha * D) / alpha), 2e-3);
  EXPECT_NEAR(energy, 13750.00, 0.005);
}

// Tests the limit curves of Eqs. (6)-(9) with all sixteen parameters. The points lie so far along a branch that the
// distance to the limit curve has decayed to exp(-40) = 4e-18 (40 is alpha times the travel). The expected values were
// written out by hand from the equations.
TEST(ClosedForm, VaianaLimitCurves) {
  double const ln2 = std::numbers::ln2;
  auto const values = named<Vaiana>({{"Kb+", 4e5},
                                     {"Kb-", 3e5},
                                     {"f0+", 4e4},
                                     {"f0-", 3e4},
                                     {"alpha+", 200.0},
                                     {"alpha-", 100.0},
                                     {"beta1+", 50.0},
                                     {"beta1-", -70.0},
                                     {"beta2+", 10.0 * ln2},
                                     {"beta2-", -20.0 * ln2},
                                     {"gamma1+", 900.0},
                                     {"gamma1-", 700.0},
                                     {"gamma2+", 10.0 * ln2},
                                     {"gamma2-", 20.0 * ln2},
                                     {"gamma3+", 0.1},
                                     {"gamma3-", -0.1}});
  auto const force = forces<Vaiana>(values, polyline(std::vector{0.0, 200.0, -200.0}, 100));
  // At x = 0.2 m, exp(2 ln2) = 4 and 1 + exp(-ln2) = 3/2.
  EXPECT_NEAR(force[100], 50.0 * 3.0 + 4.0 * 900.0 / 1.5 - 2.0 * 900.0 + 4e5 * 0.2 + 4e4, 1e-8);
  // At x = -0.2 m, exp(4 ln2) = 16 and 1 + exp(2 ln2) = 5.
  EXPECT_NEAR(force[200], -70.0 * 15.0 + 4.0 * 700.0 / 5.0 - 2.0 * 700.0 + 3e5 * -0.2 - 3e4, 1e-8);
}

// Returns y = s z of Bouc-Wen's law with n = 1 after a travel t in one direction, from the value y at the start of this
// travel. The direction is s = +1 or -1, and
//     y' = A + c y  for y < 0, c = gamma - beta;     y' = A - b y  for y >= 0, b = beta + gamma.
// Both equations are linear and have exponential solutions. y passes zero at most once, upwards.
double bouc_wen_n1(double y, double travel, double A, double beta, double gamma) {
  double const b = beta + gamma, c = gamma - beta;
  if (y < 0.0) {
    double const to_zero = c == 0.0 ? -y / A : -std::log1p(c * y / A) / c;
    if (travel < to_zero) return c == 0.0 ? y + A * travel : y * std::exp(c * travel) + A / c * std::expm1(c * travel);
    travel -= to_zero;
    y = 0.0;
  }
  return y * std::exp(-b * travel) - A / b * std::expm1(-b * travel);
}

struct Shape {
  double A, beta, gamma;
};

// saturating_flow.hpp, which bouc-wen uses, states an error below 1e-5 of saturation for any n.
TEST(ClosedForm, BoucWenWithExponentOne) {
  constexpr double alpha = 0.15, Ke = 3.0;
  for (auto const& [A, beta, gamma] :
       {Shape{1.0, 0.05, 0.05}, Shape{1.4, 0.075, 0.025}, Shape{2.0, 0.03, 0.07}, Shape{1.0, 0.06, -0.03}}) {
    auto const values =
        named<BoucWen>({{"alpha", alpha}, {"Ke", Ke}, {"A", A}, {"beta", beta}, {"n", 1.0}, {"gamma", gamma}});
    for (auto const& motion :
         {polyline(std::vector{0.0, 30.0, 12.0, 21.0, -50.0, -45.0, -60.0, 80.0, 79.0, 80.0, -200.0, 5.0}, 17),
          polyline(std::vector{25.0, 30.0, -80.0, 90.0}, 3), irregular(17, 200.0, 4, 60)}) {
      auto const force = forces<BoucWen>(values, motion);
      double const z_max = A / (beta + gamma), tolerance = 1e-5 * (1.0 - alpha) * Ke * z_max;
      double z = 0.0;
      for (std::size_t i = 0; i < motion.size(); ++i) {
        double const x = motion.disp_mm[i], dx = i == 0 ? 0.0 : x - motion.disp_mm[i - 1], s = dx < 0.0 ? -1.0 : 1.0;
        z = s * bouc_wen_n1(s * z, std::abs(dx), A, beta, gamma);
        ASSERT_NEAR(force[i], alpha * Ke * x + (1.0 - alpha) * Ke * z, tolerance)
            << "beta " << beta << ", gamma " << gamma << ", sample " << i;
      }
    }
  }
}

// With gamma far above beta, unloading from saturation starts at the small slope A (1 + kappa), where kappa = (beta -
// gamma) / (beta + gamma) is near -1. z therefore leaves saturation slowly, and an error made at the start is
// multiplied by up to 1 / (1 + kappa). The tolerance contains this factor. The search box that isolaw makes from a
// record's sizes allows gamma = 1200 beta.
TEST(ClosedForm, BoucWenThatHardlyUnloads) {
  for (double const ratio : {5.0, 20.0, 200.0, 1000.0}) {
    double const beta = 0.1 / (1.0 + ratio), gamma = ratio * beta, z_max = 10.0, one_plus_kappa = 2.0 * beta / 0.1;
    auto const values =
        named<BoucWen>({{"alpha", 0.0}, {"Ke", 1.0}, {"A", 1.0}, {"beta", beta}, {"n", 1.0}, {"gamma", gamma}});
    auto const motion = polyline(std::vector{0.0, 200.0, 120.0, 150.0, -200.0, 200.0}, 50);
    auto const force = forces<BoucWen>(values, motion);
    double z = 0.0, worst = 0.0;
    for (std::size_t i = 1; i < motion.size(); ++i) {
      double const dx = motion.disp_mm[i] - motion.disp_mm[i - 1], s = dx < 0.0 ? -1.0 : 1.0;
      z = s * bouc_wen_n1(s * z, std::abs(dx), 1.0, beta, gamma);
      worst = std::max(worst, std::abs(force[i] - z));
    }
    EXPECT_LT(worst, 1e-5 * z_max * 0.5 / one_plus_kappa) << "gamma = " << ratio << " beta";
  }
}

// The parameter A is redundant: the force stays the same if z becomes c z, A becomes c A, beta and gamma are multiplied
// by c^(1-n), and alpha Ke and (1 - alpha) Ke z keep their values. The forces then differ only by rounding, which grows
// over the 320 steps of the path.
TEST(ClosedForm, BoucWenRescaled) {
  constexpr double alpha = 0.2, Ke = 3.0, A = 1.2, beta = 0.05, gamma = 0.03, n = 1.2;
  auto const motion = irregular(4, 200.0, 4, 80);
  auto const original = forces<BoucWen>(
      named<BoucWen>({{"alpha", alpha}, {"Ke", Ke}, {"A", A}, {"beta", beta}, {"n", n}, {"gamma", gamma}}), motion);
  for (double const c : {0.5, 3.0}) {
    double const elastic = alpha * Ke, hysteretic = (1.0 - alpha) * Ke / c, power = std::pow(c, 1.0 - n);
    auto const rescaled = forces<BoucWen>(named<BoucWen>({{"alpha", elastic / (elastic + hysteretic)},
                                                          {"Ke", elastic + hysteretic},
                                                          {"A", c * A},
                                                          {"beta", power * beta},
                                                          {"n", n},
                                                          {"gamma", power * gamma}}),
                                          motion);
    EXPECT_LT(largest_difference(rescaled, original), 1e-11 * largest_magnitude(original)) << c;
  }
}

// Returns parameters of Abe's law with the yield force Y0. With 1e-12 kN the hysteretic force F2 vanishes. The elastic
// force F1 and the hardening force F3 remain, which depend only on x and on the largest displacement so far.
template <class Law>
Values<Law> without_hysteresis(double Y0) {
  auto values = named<Law>({{"K1", 8.0},
                            {"alpha", 6.0},
                            {"beta", 0.2},
                            {"a", 0.7},
                            {"b", 0.3},
                            {"n", 0.3},
                            {"Y0", Y0},
                            {"Uh", 80.0},
                            {"U0", 4.0},
                            {"Us", 20.0},
                            {"K2", 0.2},
                            {"r", 0.15}});
  if constexpr (requires { &laws::ParamsOf<Law, double>::p; }) values[index_of<Law>("p")] = 1.7;
  return values;
}

template <class Law>
void elastic_parts_alone() {
  auto const motion = irregular(9, 150.0, 4, 60);
  for (auto const integration : both_integrations)
    for (bool const first : {true, false}) {
      auto values = without_hysteresis<Law>(1e-12);
      if (first) {
        values[index_of<Law>("K2")] = 0.0;
      } else {
        values[index_of<Law>("K1")] = values[index_of<Law>("a")] = 0.0;
      }
      // From sample to sample the motion covers about 10 mm, which is long beside the yield displacement U0 = 4 mm.
      // Each Runge-Kutta step of Integration::paper is therefore divided into 20.
      auto const force = forces<Law>(values, motion, integration == Integration::paper ? 20 : 1, integration);
      double peak = 0.0;
      for (std::size_t i = 0; i < motion.size(); ++i) {
        double const x = motion.disp_mm[i], size = std::abs(x), sign = x < 0.0 ? -1.0 : 1.0;
        peak = std::max(peak, size);
        double const F1 = 8.0 * (0.2 + 0.8 * std::exp(-peak / 6.0)) * x + 0.7 * (1.0 - std::exp(-0.3 * size)) * sign;
        double const F3 = 0.2 * std::pow(size / 80.0, 0.15) * x;
        ASSERT_NEAR(force[i], first ? F1 : F3, 1e-10) << x;
      }
    }
}
TEST(ClosedForm, AbeElasticPartsAlone) {
  elastic_parts_alone<Abe>();
}
TEST(ClosedForm, AbeY0ElasticPartsAlone) {
  elastic_parts_alone<AbeY0>();
}

// A long motion in one direction saturates F2 at +-Y0. In abe the yield force grows with x unless Uh is very large;
// with Uh = 1e12 the growth (400 / 1e12)^1.7 is negligible. Near saturation 1 - F2 / Y0 falls by the factor exp(-n) per
// yield displacement of 4 mm. After 400 mm with n = 0.3 it is about e^-30.
template <class Law>
void saturates() {
  auto values = without_hysteresis<Law>(45.0);
  values[index_of<Law>("K1")] = values[index_of<Law>("a")] = values[index_of<Law>("K2")] = 0.0;
  values[index_of<Law>("Uh")] = 1e12;
  values[index_of<Law>("Us")] = 1e6;
  auto const force = forces<Law>(values, polyline(std::vector{0.0, 400.0, -400.0}, 40));
  EXPECT_NEAR(force[40], 45.0, 1e-5 * 45.0);
  EXPECT_NEAR(force[80], -45.0, 1e-5 * 45.0);
}
TEST(ClosedForm, AbeSaturated) {
  saturates<Abe>();
}
TEST(ClosedForm, AbeY0Saturated) {
  saturates<AbeY0>();
}

// With n = 1 and the constant yield displacement U0 (Us huge), u = F2 / Y0 follows Bouc-Wen's exponential with A = beta
// = 1 / U0 and gamma = 0. If the yield displacement grows, the first loading obeys du/dx = (1 - u) / [U0 (1 + x / Us)],
// so u = 1 - (1 + x / Us)^(-Us / U0). The tolerance is the error that saturating_flow.hpp allows.
TEST(ClosedForm, AbeY0WithExponentOne) {
  auto values = named<AbeY0>({{"alpha", 1.0}, {"n", 1.0}, {"Y0", 45.0}, {"Uh", 80.0}, {"U0", 5.0}, {"Us", 1e9}});
  auto const motion = polyline(std::vector{0.0, 12.0, 3.0, 9.0, -30.0, -28.0, 60.0}, 9);
  auto const constant = forces<AbeY0>(values, motion);
  double u = 0.0;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    double const dx = motion.disp_mm[i] - motion.disp_mm[i - 1], s = dx < 0.0 ? -1.0 : 1.0;
    u = s * bouc_wen_n1(s * u, std::abs(dx) / 5.0, 1.0, 1.0, 0.0);
    EXPECT_NEAR(constant[i], 45.0 * u, 1e-5 * 45.0) << i;
  }
  values[index_of<AbeY0>("Us")] = 20.0;
  auto const virgin = polyline(std::vector{0.0, 100.0}, 20);
  auto const growing = forces<AbeY0>(values, virgin);
  for (std::size_t i = 0; i < virgin.size(); ++i)
    EXPECT_NEAR(growing[i], 45.0 * (1.0 - std::pow(1.0 + virgin.disp_mm[i] / 20.0, -4.0)), 1e-5 * 45.0) << i;
}

// At these points cosh and the root are rational numbers: cosh(ln 2) = 5/4, and v / sqrt(a11^2 + v^2) = 4/5 for v = 0.4
// m/s and a11 = 0.3 m/s.
TEST(ClosedForm, JankowskiByHand) {
  double const ln2 = std::numbers::ln2;
  auto const values = named<Jankowski>({{"a1", 100.0},
                                        {"a2", 1000.0},
                                        {"a3", 10000.0},
                                        {"a4", 500.0},
                                        {"a5", ln2 / 0.4},
                                        {"a6", 2000.0},
                                        {"a7", ln2 / 0.4},
                                        {"a8", ln2 / 0.1},
                                        {"a9", 40.0},
                                        {"a10", 600.0},
                                        {"a11", 0.3}});
  // At 100 mm the device moves at 400 mm/s, rests, and moves at -400 mm/s. At -100 mm it moves at 400 mm/s, and at 0 at
  // -400 mm/s.
  auto const force =
      forces<Jankowski>(values, Motion{{100.0, 100.0, 100.0, -100.0, 0.0}, {400.0, 0.0, -400.0, 400.0, -400.0}});
  // The law takes x in m and v in m/s. At x = +-0.1, x^2 = 0.01 and x^4 = 1e-4, so the terms of the stiffness with a1,
  // a2 and a3 are 100 + 10 + 1 = 111. 1 / cosh(ln 2) = 4/5. In motion the terms with a4 and a6 are therefore 500 *
  // (4/5)^2 = 320 and 2000 * 4/5 * 4/5 = 1280, and the elastic force is (111 + 320 + 1280) * 0.1 = 171.1. At rest the
  // terms are 500 and 2000 * 4/5 = 1600, and the force is 221.1. In the damping force v / sqrt(v^2 + a11^2) = 0.4 / 0.5
  // = 4/5, so it is (40 + 6) * 4/5 = 36.8, and 40 * 4/5 = 32 at x = 0.
  EXPECT_NEAR(force[0], 171.1 + 36.8, 1e-11);
  EXPECT_NEAR(force[1], 221.1, 1e-11);
  EXPECT_NEAR(force[2], 171.1 - 36.8, 1e-11);
  EXPECT_NEAR(force[3], -171.1 + 36.8, 1e-11);
  EXPECT_NEAR(force[4], -32.0, 1e-11);
}

// With a9 = a10 = 0 the force does not depend on the work: F = (a1 + a2 x^2 + a3 x^4 + a4 / cosh^2(a5 v)) x + 2 (a6 +
// a7 x^2) v / sqrt(a8^2 + v^2).
TEST(ClosedForm, HwangWuWithoutWork) {
  auto const values = named<HwangWu>(
      {{"a1", 4e3}, {"a2", -2.0}, {"a3", 5e-3}, {"a4", 60.0}, {"a5", 0.05}, {"a6", 3e4}, {"a7", 5.0}, {"a8", 80.0}});
  auto const motion = irregular(21, 200.0, 4, 60);
  auto const force = forces<HwangWu>(values, motion);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    double const x = motion.disp_mm[i] / 10.0, v = motion.velocity_mm_s[i] / 10.0, x2 = x * x,
                 cosh = std::cosh(0.05 * v);
    double const K = 4e3 - 2.0 * x2 + 5e-3 * x2 * x2 + 60.0 / (cosh * cosh);
    double const C = 2.0 * (3e4 + 5.0 * x2) / std::sqrt(80.0 * 80.0 + v * v);
    ASSERT_NEAR(force[i], K * x + C * v, 1e-12 * largest_magnitude(force)) << i;
  }
}

// If only the terms with a4 and a9 act, F = a4 x exp(a9 W) at v = 0, where W is the work since the start at x0. So
// exp(-a9 W) W' = a4 x and W = -ln(1 - a9 a4 (x^2 - x0^2) / 2) / a9. Runge-Kutta with 200 steps errs by less than 1e-9
// while a9 W stays of order one.
TEST(ClosedForm, HwangWuDegradesWithTheWholeWork) {
  double const a4 = 50.0, a9 = -1e-4;
  auto const values = named<HwangWu>({{"a4", a4}, {"a8", 1.0}, {"a9", a9}});
  auto motion = polyline(std::vector{100.0, 300.0, -300.0}, 200);
  std::ranges::fill(motion.velocity_mm_s, 0.0);
  auto const force = forces<HwangWu>(values, motion);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    double const x = motion.disp_mm[i] / 10.0, softened = 1.0 / (1.0 - a9 * a4 * (x * x - 100.0) / 2.0);
    EXPECT_NEAR(force[i], a4 * x * softened, 1e-8 * a4 * 30.0) << x;
  }
}

}  // namespace
}  // namespace isolaw::law_tests
