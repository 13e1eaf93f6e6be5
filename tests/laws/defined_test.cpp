// Some formulas of Cucuzza et al. 2025 become 0/0, infinite or undefined for some parameters or motions. These tests
// state which value isolaw gives.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "laws/motion.hpp"
#include "laws/paper.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Integration;

template <class Law>
class Defined : public ::testing::Test {};
TYPED_TEST_SUITE(Defined, EveryLaw, LawName);

TYPED_TEST(Defined, AFiniteForceEverywhereInTheBoxOnACoarseRecord) {
  for (std::uint32_t index = 0; index < 2000; ++index) {
    auto const values = candidate<TypeParam>(index);
    auto const motion = index % 2 == 0 ? sine(208.0, 0.5, 3, 10) : irregular(index, 208.0, 3, 10);
    ASSERT_TRUE(all_finite(forces<TypeParam>(values, motion))) << describe<TypeParam>(values);
  }
}

// Each parameter is at an end of its interval, lower or upper at random.
TYPED_TEST(Defined, AFiniteForceInTheCornersOfTheBox) {
  auto const intervals = box<TypeParam>();
  for (std::uint32_t index = 0; index < 1000; ++index) {
    num::Draws draws(num::Stream(5), 0, index);
    Values<TypeParam> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = draws.below(2) == 0 ? intervals[i].lower : intervals[i].upper;
    ASSERT_TRUE(all_finite(forces<TypeParam>(values, irregular(index, 208.0, 2, 20)))) << describe<TypeParam>(values);
  }
}

// A single step from one end of the motion to the other, hundreds of yield displacements long, must give the same force
// as a thousand steps, within the error that error_of_long_steps() allows. Laws that depend on velocity are left out,
// because refining the path also changes the velocity.
TYPED_TEST(Defined, StepsFarLargerThanTheYieldDisplacement) {
  if constexpr (TypeParam::info.traits.rate_independent) {
    auto const motion = polyline(std::vector{0.0, 200.0, -200.0, 200.0, 20.0, -150.0}, 1);
    double const allowed = error_of_long_steps(TypeParam::info.id);
    for (std::uint32_t index = 0; index < 100; ++index) {
      auto const values = candidate<TypeParam>(index);
      auto const one = forces<TypeParam>(values, motion), many = forces<TypeParam>(values, motion, 1000);
      ASSERT_TRUE(all_finite(one)) << describe<TypeParam>(values);
      EXPECT_LT(largest_difference(one, many), allowed * largest_magnitude(many)) << describe<TypeParam>(values);
    }
  }
}

TYPED_TEST(Defined, ARecordOfOneSample) {
  for (double const x : {0.0, 35.0, -35.0})
    for (auto const integration : both_integrations) {
      Motion const one{{x}, {120.0}}, three{{x, 40.0, 80.0}, {120.0, 120.0, 120.0}};
      auto const values = candidate<TypeParam>(3);
      auto const force = forces<TypeParam>(values, one, 4, integration);
      ASSERT_EQ(force.size(), 1u);
      EXPECT_TRUE(std::isfinite(force[0]));
      EXPECT_EQ(force[0], forces<TypeParam>(values, three, 4, integration)[0]) << "the future changes the first force";
    }
}

template <class Law>
class DefinedByThePaper : public ::testing::Test {};
TYPED_TEST_SUITE(DefinedByThePaper, PaperLaws, LawName);

TYPED_TEST(DefinedByThePaper, TheVirginStateIsTheFirstSampleWhereverItIs) {
  double const length = TypeParam::info.length.in_record_units;
  for (auto const integration : both_integrations)
    for (std::uint32_t index = 0; index < 20; ++index)
      for (double const x_mm : {-120.0, -0.3, 0.0, 7.0, 180.0}) {
        // At 20 mm/s cosh does not overflow in virgin_force(), which gives the expected force.
        double const v_mm_s = 20.0;
        auto const values = candidate<TypeParam>(index);
        auto const force = forces<TypeParam>(values, Motion{{x_mm, x_mm + 1.0}, {v_mm_s, v_mm_s}}, 1, integration);
        double const expected = virgin_force<TypeParam>(values, x_mm / length, v_mm_s / length);
        EXPECT_NEAR(force[0], expected, 1e-12 * std::abs(expected)) << x_mm << " mm: " << describe<TypeParam>(values);
      }
}

// The damping force is C v with C = (a9 + a10 x^2) / sqrt(a11^2 + v^2). If a11 = 0, C is infinite at v = 0. At rest the
// damping force must nevertheless be 0, and at the smallest velocity it must have its full value.
TEST(DefinedJankowski, NoMotionAndNoSaturationVelocity) {
  using laws::Jankowski;
  auto const values = named<Jankowski>({{"a1", 3e5},
                                        {"a2", 4e6},
                                        {"a3", 5e6},
                                        {"a4", 4e4},
                                        {"a5", 5e3},
                                        {"a6", 1e6},
                                        {"a7", 4.0},
                                        {"a8", 15.0},
                                        {"a9", 5e4},
                                        {"a10", 8e4},
                                        {"a11", 0.0}});
  Motion const motion{{100.0, 100.0, 100.0}, {0.0, 1e-9, -1e-9}};
  auto const force = forces<Jankowski>(values, motion);
  double const x = 0.1, stiffness = 3e5 + 4e6 * 0.01 + 5e6 * 1e-4 + 4e4 + 1e6 / std::cosh(1.5);
  double const damping = 5e4 + 8e4 * 0.01;
  EXPECT_NEAR(force[0], stiffness * x, 1e-12 * stiffness * x);
  EXPECT_NEAR(force[1], stiffness * x + damping, 1e-9 * damping);
  EXPECT_NEAR(force[2], stiffness * x - damping, 1e-9 * damping);
}

TEST(DefinedHwangWu, NoMotionAndNoSaturationVelocity) {
  using laws::HwangWu;
  auto const values = named<HwangWu>({{"a1", 5e3},
                                      {"a2", -2.0},
                                      {"a3", 5e-3},
                                      {"a4", 60.0},
                                      {"a5", 0.5},
                                      {"a6", 2e4},
                                      {"a7", 4.0},
                                      {"a8", 0.0},
                                      {"a9", -1e-6},
                                      {"a10", -1e-5}});
  Motion const motion{{100.0, 100.0, 100.0}, {0.0, 1e-9, -1e-9}};
  auto const force = forces<HwangWu>(values, motion);
  double const stiffness = 5e3 - 2.0 * 100.0 + 5e-3 * 1e4 + 60.0, damping = 2.0 * (2e4 + 4.0 * 100.0);
  EXPECT_NEAR(force[0], stiffness * 10.0, 1e-12 * stiffness * 10.0);
  EXPECT_NEAR(force[1], stiffness * 10.0 + damping, 1e-9 * damping);
  EXPECT_NEAR(force[2], stiffness * 10.0 - damping, 1e-9 * damping);
}

// The stiffness terms 1 / cosh^2(a5 v) and 1 / cosh(a7 v) are 0 where cosh overflows, and 1 at v = 0.
TEST(DefinedJankowski, CoshBeyondTheLargestDouble) {
  using laws::Jankowski;
  for (double const rate : {1e4, 1e10, 1e300}) {
    auto const values = named<Jankowski>(
        {{"a1", 1.0}, {"a4", 10.0}, {"a5", rate}, {"a6", 100.0}, {"a7", rate}, {"a8", 2.0}, {"a11", 1.0}});
    auto const force = forces<Jankowski>(values, Motion{{500.0, 500.0, -500.0}, {500.0, 0.0, -500.0}});
    double const sech = 1.0 / std::cosh(1.0);
    EXPECT_EQ(force[0], 0.5) << rate;
    EXPECT_NEAR(force[1], 0.5 * (1.0 + 10.0 + 100.0 * sech), 1e-12) << rate;
    EXPECT_EQ(force[2], -0.5) << rate;
  }
  auto const far =
      forces<Jankowski>(named<Jankowski>({{"a6", 100.0}, {"a8", 1e5}, {"a11", 1.0}}), Motion{{500.0}, {0.0}});
  EXPECT_EQ(far[0], 0.0);
}

TEST(DefinedHwangWu, CoshBeyondTheLargestDouble) {
  using laws::HwangWu;
  auto const values = named<HwangWu>({{"a1", 1.0}, {"a4", 10.0}, {"a5", 1e300}, {"a8", 1.0}});
  auto const force = forces<HwangWu>(values, Motion{{50.0, 50.0}, {500.0, 0.0}});
  EXPECT_EQ(force[0], 5.0);
  EXPECT_DOUBLE_EQ(force[1], 55.0);
}

// With alpha = 0 a branch keeps its distance from its limit curve for ever. The loading and unloading branches are then
// straight lines, and each branch starts at the force where the last one ended.
TEST(DefinedVaiana, ABranchThatNeverApproachesItsLimitCurve) {
  using laws::Vaiana;
  auto const values =
      named<Vaiana>({{"Kb+", 4e5}, {"Kb-", 3e5}, {"f0+", 4e4}, {"f0-", 3e4}, {"beta2+", 20.0}, {"beta2-", -20.0}});
  auto const force = forces<Vaiana>(values, polyline(std::vector{0.0, 100.0, -50.0, 20.0}, 10));
  EXPECT_NEAR(force[10], 4e5 * 0.1, 1e-7);
  EXPECT_NEAR(force[20], 4e4 - 3e5 * 0.15, 1e-7);
  EXPECT_NEAR(force[30], 4e4 - 4.5e4 + 4e5 * 0.07, 1e-7);
}

// A loading branch may start above the upper limit curve, here because the record starts at -200 mm with zero force.
// For such a point Eqs. (11)-(12) of Cucuzza et al. 2025 would take the logarithm of a negative number. The branch
// equations that isolaw uses hold from any point.
TEST(DefinedVaiana, AReversalPointOutsideTheLimitCurves) {
  using laws::Vaiana;
  double const Kb = 4e5, f0 = 4e4, alpha = 30.0;
  auto const values =
      named<Vaiana>({{"Kb+", Kb}, {"Kb-", Kb}, {"f0+", f0}, {"f0-", f0}, {"alpha+", alpha}, {"alpha-", alpha}});
  // At x = -0.2 m the force of a device that has never moved is 0 kN. This is above the upper limit curve, cu(-0.2) =
  // -40 kN, so the force falls towards the curve.
  auto const force = forces<Vaiana>(values, polyline(std::vector{-200.0, 0.0}, 50));
  for (std::size_t i = 0; i <= 50; ++i) {
    double const x = -0.2 + 0.004 * static_cast<double>(i), upper = Kb * x + f0;
    EXPECT_NEAR(force[i], upper - (Kb * -0.2 + f0) * std::exp(-alpha * (x + 0.2)), 1e-9 * f0) << x;
  }
}

// The elastic stiffness is K1 (beta + (1 - beta) exp(-Umax / alpha)), Umax being the largest |x| so far. With alpha = 0
// it must fall to K1 beta as soon as the device has moved.
TEST(DefinedAbe, SofteningOverNoDisplacement) {
  using laws::AbeY0;
  auto const values = named<AbeY0>({{"K1", 8.0},
                                    {"alpha", 0.0},
                                    {"beta", 0.25},
                                    {"n", 0.3},
                                    {"Y0", 1e-9},
                                    {"Uh", 100.0},
                                    {"U0", 4.0},
                                    {"Us", 20.0},
                                    {"r", 0.1}});
  auto const force = forces<AbeY0>(values, Motion{{0.0, 1e-3, 50.0, -20.0, 0.0}, {0.0, 1.0, 1.0, -1.0, 1.0}});
  for (auto const& [sample, expected] : {std::pair{0, 0.0}, {1, 0.002}, {2, 100.0}, {3, -40.0}, {4, 0.0}})
    EXPECT_NEAR(force[static_cast<std::size_t>(sample)], expected, 1e-8) << sample;
}

// With beta + gamma <= 0 the hysteretic variable z grows without bound. With beta < 0 it grows without bound on
// unloading from saturation. For both cases the forces must not be finite, so that no user takes them for real ones.
TEST(DefinedBoucWen, ParametersWithoutABoundedForceAreNotFinite) {
  using laws::BoucWen;
  auto const motion = sine(200.0, 0.5, 2, 40);
  for (auto const& [beta, gamma] : {std::pair{-0.05, 0.03}, {0.03, -0.05}, {0.04, -0.04}, {-0.02, 0.05}}) {
    auto const values =
        named<BoucWen>({{"alpha", 0.2}, {"Ke", 3.0}, {"A", 1.0}, {"beta", beta}, {"n", 1.1}, {"gamma", gamma}});
    EXPECT_FALSE(all_finite(forces<BoucWen>(values, motion))) << "beta " << beta << ", gamma " << gamma;
  }
}

}  // namespace
}  // namespace isolaw::law_tests
