// Halving the step shows the order of convergence of each integration. Further tests measure how much error a record's
// sampling interval leaves in the force.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "laws/motion.hpp"
#include "laws/paper.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Integration;

// Returns the largest error of the force, divided by the peak force. The reference force is computed by the same
// integration with 128 steps per sample.
template <class Law>
double error_at(Values<Law> const& values, Motion const& motion, int refinement, Integration integration) {
  auto const reference = forces<Law>(values, motion, 128, integration);
  return largest_difference(forces<Law>(values, motion, refinement, integration), reference) /
         largest_magnitude(reference);
}

// Returns the observed order of convergence: log2 of the error with `refinement` steps per sample over that with twice
// as many.
template <class Law>
double order_at(Values<Law> const& values, Motion const& motion, int refinement, Integration integration) {
  return std::log2(error_at<Law>(values, motion, refinement, integration) /
                   error_at<Law>(values, motion, 2 * refinement, integration));
}

// With these parameters bouc-wen has z = 10 (1 - e^(-x/10)) along one loading branch. This is smooth, so classical
// Runge-Kutta must show fourth order. All errors are above 1e-11 of the peak force, so rounding does not disturb the
// ratio.
TEST(Order, PaperStepOfBoucWenIsFourth) {
  auto const values =
      named<laws::BoucWen>({{"alpha", 0.2}, {"Ke", 3.0}, {"A", 1.0}, {"beta", 0.06}, {"n", 1.0}, {"gamma", 0.04}});
  double const corners[] = {0.0, 60.0};
  for (int const refinement : {1, 2, 4})
    EXPECT_NEAR(order_at<laws::BoucWen>(values, polyline(corners, 20), refinement, Integration::paper), 4.0, 0.2);
}

// With these parameters (n = 1, p = 2) the law abe is smooth along any branch on which neither x nor the hysteretic
// force F2 changes its sign.
template <class Law>
Values<Law> smooth_abe() {
  auto values = named<Law>({{"K1", 6.0},
                            {"alpha", 5.0},
                            {"beta", 0.1},
                            {"a", 0.7},
                            {"b", 0.5},
                            {"n", 1.0},
                            {"Y0", 40.0},
                            {"Uh", 80.0},
                            {"U0", 4.0},
                            {"Us", 20.0},
                            {"K2", 0.1},
                            {"r", 0.1}});
  if constexpr (requires { &laws::ParamsOf<Law, double>::p; }) values[index_of<Law>("p")] = 2.0;
  return values;
}

TEST(Order, PaperStepOfAbeY0IsFourth) {
  double const corners[] = {0.0, 60.0};
  auto const values = smooth_abe<laws::AbeY0>();
  for (int const refinement : {1, 2, 4})
    EXPECT_NEAR(order_at<laws::AbeY0>(values, polyline(corners, 40), refinement, Integration::paper), 4.0, 0.3);
}

TEST(Order, PaperStepOfAbeIsFourth) {
  double const corners[] = {0.0, 60.0};
  auto const values = smooth_abe<laws::Abe>();
  for (int const refinement : {1, 2, 4})
    EXPECT_NEAR(order_at<laws::Abe>(values, polyline(corners, 40), refinement, Integration::paper), 4.0, 0.3);
}

// abe.hpp states that a step of abe is of fourth order wherever the law is smooth, because the step corrects for the
// change of the yield force. The law is smooth from 45 to 95 mm: the device has been at 100 mm before, so the peak does
// not grow, and F2 has passed zero before 45 mm, since the 25 mm of travel after the reversal exceed the yield
// displacement of 24 mm. The path to 45 mm always has the same fine steps; only the steps from 45 to 95 mm are halved,
// and the force at 95 mm is compared.
TEST(Order, ConvergedStepOfAbeIsFourth) {
  auto const last_force = [](int steps) {
    auto motion = polyline(std::vector{0.0, 100.0, 20.0, 45.0}, 2000);
    for (int i = 1; i <= steps; ++i) {
      motion.disp_mm.push_back(45.0 + 50.0 * i / steps);
      motion.velocity_mm_s.push_back(100.0);
    }
    return forces<laws::Abe>(smooth_abe<laws::Abe>(), motion).back();
  };
  double const reference = last_force(512);
  // With fewer than 16 steps abe would divide each step into shorter pieces, so halving the step would not halve the
  // pieces. With more than 18 the error of the polynomials for the exact solution dominates.
  for (int const steps : {16, 17, 18}) {
    double const order =
        std::log2(std::abs(last_force(steps) - reference) / std::abs(last_force(2 * steps) - reference));
    EXPECT_NEAR(order, 4.0, 0.5) << steps << " steps";
  }
}

// hwang-wu is smooth in displacement, and the velocity varies linearly along the path. With 100 samples a cycle the
// steps are short enough for the terms exp(a9 W) and exp(a10 W), W the work, to show fourth order.
TEST(Order, HwangWuIsFourth) {
  auto values = published_means<laws::HwangWu>(3);
  values[index_of<laws::HwangWu>("a9")] = -5e-6;  // in 1/(N cm); the exponent a9 W reaches order one
  values[index_of<laws::HwangWu>("a10")] = -1e-5;
  auto const motion = sine(208.0, 0.5, 2, 100);
  for (int const refinement : {1, 2, 4})
    EXPECT_NEAR(order_at<laws::HwangWu>(values, motion, refinement, Integration::converged), 4.0, 0.5);
}

template <class Law>
class Convergence : public ::testing::Test {};
TYPED_TEST_SUITE(Convergence, EveryLaw, LawName);

TYPED_TEST(Convergence, RefiningThePathHardlyChangesTheForce) {
  for (std::uint32_t index = 0; index < 100; ++index)
    for (auto const& motion : {sine(208.0, 0.5, 3, 50), irregular(index, 200.0, 3, 50)}) {
      auto const values = candidate<TypeParam>(index);
      auto const coarse = forces<TypeParam>(values, motion), fine = forces<TypeParam>(values, motion, 20);
      EXPECT_LT(largest_difference(coarse, fine), error_of_the_path(TypeParam::info.id) * largest_magnitude(fine))
          << describe<TypeParam>(values);
    }
}

// At 200 samples a cycle, as in a laboratory, the sampling must cause hardly any force error for the published devices.
// The parameter sets at the ends of the search box are left out, because their errors are far larger.
TYPED_TEST(Convergence, TheSamplingOfALaboratoryIsEnough) {
  for (std::size_t number = 0; number < table_a5::devices; ++number) {
    auto const values = device<TypeParam>(number);
    auto const motion = sine(208.0, 0.5, 3, 200);
    auto const coarse = forces<TypeParam>(values, motion), fine = forces<TypeParam>(values, motion, 20);
    EXPECT_LT(largest_difference(coarse, fine), error_of_a_laboratory(TypeParam::info.id) * largest_magnitude(fine))
        << "device " << number + 1;
  }
}

// The integrations `converged` and `paper` share only parts of a law's differential equation, so each checks the other.
// The reference is `paper` with 200 Runge-Kutta steps per sample. It errs itself by up to 1e-4 of the peak force where
// the slope of the force jumps (at zero hysteretic force, if the exponent n is small). The converged integration of
// abe, with one step per sample, errs by 4e-4 on this path, which reverses at almost every sample.
TYPED_TEST(Convergence, FineRungeKuttaAgreesWithTheConvergedIntegration) {
  for (std::size_t number = 0; number < table_a5::devices; ++number) {
    auto const values = device<TypeParam>(number);
    auto const motion = irregular(number, 208.0, 3, 100);
    auto const converged = forces<TypeParam>(values, motion);
    auto const paper = forces<TypeParam>(values, motion, 200, Integration::paper);
    EXPECT_LT(largest_difference(paper, converged), 6e-4 * largest_magnitude(converged)) << "device " << number + 1;
  }
}

}  // namespace
}  // namespace isolaw::law_tests
