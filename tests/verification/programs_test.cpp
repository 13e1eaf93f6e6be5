// isolaw replays an exported law: it computes the forces that the materials of another program give for it. These
// replays are compared with closed forms and with values of independent implementations.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "isolaw/programs/materials.hpp"

namespace isolaw::programs {
namespace {

std::vector<double> line(double from, double to, int steps) {
  std::vector<double> points;
  for (int i = 1; i <= steps; ++i) points.push_back(from + (to - from) * i / steps);
  return points;
}

std::vector<double> operator+(std::vector<double> a, std::vector<double> const& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double energy(std::vector<double> const& x, std::vector<double> const& f, std::size_t first) {
  double sum = 0.0;
  for (std::size_t i = first + 1; i < x.size(); ++i) sum += 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1]);
  return sum;
}

// For a bilinear loop of amplitude D the closed forms are K_eff = K2 + Qd / D and energy 4 Qd (D - Dy).
TEST(Replay, bilinear_materials_have_the_closed_form) {
  double const K1 = 6.0, K2 = 0.9, Qd = 30.0, D = 150.0, b = K2 / K1;
  auto const x = line(0, D, 1) + line(D, -D, 1) + line(-D, D, 1000);
  for (auto const& command :
       {Command{"Steel01", {Qd / (1.0 - b), K1, b}}, Command{"elastomericBearingPlasticity", {K1, Qd, b, 0.0, 2.0}}}) {
    auto const f = replay({&command, 1}, x);
    EXPECT_NEAR((f.back() - f[1]) / (2.0 * D), K2 + Qd / D, 1e-12) << command.name;
    auto const loop = line(D, -D, 20000) + line(-D, D, 20000);
    auto const around = line(0, D, 1) + loop;
    // The trapezoidal rule errs at each corner by less than half a step times the change of slope.
    EXPECT_NEAR(energy(around, replay({&command, 1}, around), 0), 4.0 * Qd * (D - Qd / (K1 - K2)), 0.01)
        << command.name;
  }
}

// Another implementation gave the expected values. The first expected value can also be computed by hand: it is 0.1 +
// 0.9 / 2^(1/20).
TEST(Replay, steel02_has_the_branches_of_menegotto_and_pinto) {
  Command const command{"Steel02", {1.0, 1.0, 0.1, 20.0, 0.925, 0.15}};
  auto const f = replay({&command, 1}, std::vector<double>{1, 5, -5, 5, 2, 5, 6});
  std::vector<double> const expected{0.969342696,  1.4,         -1.375243036, 1.353082051,
                                     -0.378071558, 1.345535478, 1.478107786};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(f[i], expected[i], 5.1e-10) << i;
}

// Without hardening the force approaches the limit curves kb x +- f0 as exp(-alpha travel). Then K_eff = kb + f0
// tanh(alpha D) / D, and the energy is 4 f0 (D - tanh(alpha D) / alpha). With kb 0.6 kN/mm, f0 25 kN, alpha 0.08 / mm
// and D 150 mm they are 0.766667 kN/mm and 13750.00 kN mm.
TEST(Replay, asymmetric_material_without_hardening_has_the_closed_form) {
  double const kb = 0.6, f0 = 25.0, alpha = 0.08, D = 150.0;
  Command const command{"HystereticAsym", {kb + 2.0 * alpha * f0, kb, f0, 0, 0, 0}};
  auto const x = line(0, D, 2000) + line(D, -D, 4000) + line(-D, D, 4000);
  auto const f = replay({&command, 1}, x);
  EXPECT_NEAR((f.back() - f[5999]) / (2.0 * D), 0.766667, 1e-6);
  EXPECT_NEAR(energy(x, f, 1999), 13750.0, 0.05);
}

// Tests the example in the material's documentation: the displacement goes from 0 to 1, -1 and 1, with first stiffness
// 5, last stiffness 0.5 and strength 0.45. An independent port of the material gave the expected forces, and the energy
// of the loop from -1 to 1 and back.
TEST(Replay, asymmetric_material_gives_the_documented_sets) {
  struct Set {
    double b1, b2, gamma, at_1, at_0, at_minus_1, again, energy;
  };
  for (auto const& s : {Set{0, 0, .5, 1.561286, -.443956, -.576179, 1.566218, 1.484883},
                        Set{1, 1, .5, 1.911689, -.443956, -.926582, 1.916620, 1.484883},
                        Set{1, 0, .5, 2.279568, -.443956, -.208300, 2.284500, 1.484883},
                        Set{1.5, 1, .3, 2.892083, -.443956, -.698899, 2.896120, 1.456075},
                        Set{0, 1, .5, 1.193407, -.443956, -1.294461, 1.198338, 1.484883},
                        Set{1, 1.3, .3, 1.424023, -.443956, -1.705164, 1.428061, 1.456075}}) {
    Command const command{"HystereticAsym", {5.0, 0.5, 0.45, s.b1, s.b2, s.gamma}};
    auto const x = line(0, 1, 1000) + line(1, 0, 1000) + line(0, -1, 1000) + line(-1, 1, 2000) + line(1, -1, 2000) +
                   line(-1, 1, 2000);
    auto const f = replay({&command, 1}, x);
    EXPECT_NEAR(f[999], s.at_1, 1e-6);
    EXPECT_NEAR(f[1999], s.at_0, 1e-6);
    EXPECT_NEAR(f[2999], s.at_minus_1, 1e-6);
    EXPECT_NEAR(f[4999], s.again, 1e-6);
    EXPECT_NEAR(energy(x, f, 4999), s.energy, 1e-5) << s.b1 << " " << s.b2;
  }
}

// With n = 1 and gamma = 0 Wen's material obeys dz/dx = A - beta |z| sgn(dx z). Exactly solved, its branches would be
// those of the asymmetric material (HystereticAsym) without hardening. The error of the material falls with the first
// power of its step.
TEST(Replay, bouc_wen_of_exponent_one_is_the_asymmetric_material_as_the_step_goes_to_zero) {
  double const kb = 0.6, f0 = 25.0, alpha = 0.08, D = 150.0, Ke = kb + alpha * f0;
  Command const algebraic{"HystereticAsym", {kb + 2.0 * alpha * f0, kb, f0, 0, 0, 0}};
  Command const wen{"BoucWen", {kb / Ke, Ke, 1.0, 0.0, alpha, 1.0, 0, 0, 0}};
  double before = 0.0;
  for (int steps : {200, 400, 800}) {
    auto const x = line(0, D, steps) + line(D, -D, steps) + line(-D, D, steps);
    auto const a = replay({&algebraic, 1}, x), b = replay({&wen, 1}, x);
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    if (before > 0.0) {
      EXPECT_NEAR(before / largest, 2.0, 0.1);
    }
    before = largest;
  }
  EXPECT_LT(before, 0.3);
}

// If the displacement goes very far in one direction, the distance between the force and its limit curve is lost to
// rounding. From there on the force is NaN, and it stays NaN when the motion turns back.
TEST(Replay, asymmetric_material_turns_into_no_number_on_a_long_travel) {
  Command const command{"HystereticAsym", {4.6, 0.6, 25.0, 0, 0, 0}};
  double const alpha = 0.08;
  auto const x = line(0, 60.0 / alpha, 1000) + line(60.0 / alpha, 0, 10);
  auto const f = replay({&command, 1}, x);
  EXPECT_TRUE(std::isfinite(f[500]));  // at a travel of 30 / alpha
  EXPECT_TRUE(std::isnan(f[999]));
  EXPECT_TRUE(std::isnan(f.back()));
}

}  // namespace
}  // namespace isolaw::programs
