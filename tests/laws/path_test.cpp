// Tests of make_path(), which turns a record's displacements into the steps that laws follow.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "isolaw/laws/law.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

using laws::make_path;
using laws::Path;

TEST(Path, FirstStepStandsStillAtTheFirstSample) {
  std::vector<double> const x{-3.0, -1.0}, v{5.0, 6.0};
  auto const first = make_path(x, v, 4).steps.front();
  EXPECT_EQ(first.x0, -3.0);
  EXPECT_EQ(first.x1, -3.0);
  EXPECT_EQ(first.v0, 5.0);
  EXPECT_EQ(first.v1, 5.0);
  EXPECT_EQ(first.dx, 0.0);
  EXPECT_EQ(first.length, 0.0);
  EXPECT_EQ(first.direction, 0.0);
  EXPECT_FALSE(first.reversal);
  EXPECT_EQ(first.peak0, 3.0);
  EXPECT_EQ(first.peak1, 3.0);
}

// The first motion counts as a reversal. During a hold the direction stays, so motion that continues after the hold in
// the same direction is no reversal.
TEST(Path, DirectionsAndReversals) {
  std::vector<double> const x{1.0, 1.0, 2.0, 2.0, 3.0, 2.5, 2.5, 2.0, 4.0};
  std::vector<double> const direction{0, 0, 1, 1, 1, -1, -1, -1, 1};
  std::vector<bool> const reversal{false, false, true, false, false, true, false, false, true};
  auto const path = make_path(x, {});
  ASSERT_EQ(path.steps.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_EQ(path.steps[i].direction, direction[i]) << i;
    EXPECT_EQ(path.steps[i].reversal, reversal[i]) << i;
    EXPECT_EQ(path.steps[i].v1, 0.0) << i;
  }
}

TEST(Path, ThePeakIsTheLargestMagnitudeSoFar) {
  std::vector<double> const x{0.5, -2.0, 1.0, 3.0, -1.0}, peak{0.5, 2.0, 2.0, 3.0, 3.0};
  auto const path = make_path(x, {});
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(path.steps[i].peak1, peak[i]) << i;
}

// Refinement divides each sampling interval into equal steps. Displacement and velocity vary linearly between the
// samples.
TEST(Path, RefinementGoesThroughTheSamples) {
  auto const motion = irregular(1, 100.0, 2, 25);
  for (int const refinement : {1, 2, 3, 7}) {
    auto const path = make_path(motion.disp_mm, motion.velocity_mm_s, refinement);
    ASSERT_EQ(path.samples(), motion.size());
    auto const stride = static_cast<std::size_t>(refinement);
    double peak = 0.0;
    for (std::size_t i = 0; i < path.steps.size(); ++i) {
      auto const& step = path.steps[i];
      std::size_t const sample = (i + stride - 1) / stride;
      if (i % stride == 0) {
        EXPECT_EQ(step.x1, motion.disp_mm[sample]);
        EXPECT_EQ(step.v1, motion.velocity_mm_s[sample]);
      } else {
        double const t = static_cast<double>(i % stride) / refinement;
        EXPECT_NEAR(step.x1, std::lerp(motion.disp_mm[sample - 1], motion.disp_mm[sample], t), 1e-13 * 100.0);
        EXPECT_NEAR(step.v1, std::lerp(motion.velocity_mm_s[sample - 1], motion.velocity_mm_s[sample], t),
                    1e-13 * 1000.0);
      }
      if (i > 0) {
        EXPECT_EQ(step.x0, path.steps[i - 1].x1);
        EXPECT_EQ(step.v0, path.steps[i - 1].v1);
        EXPECT_EQ(step.peak0, path.steps[i - 1].peak1);
        EXPECT_EQ(step.log2_abs_x0, path.steps[i - 1].log2_abs_x1);
      }
      EXPECT_EQ(step.dx, step.x1 - step.x0);
      EXPECT_EQ(step.length, std::abs(step.dx));
      EXPECT_EQ(step.peak1, peak = std::max(peak, std::abs(step.x1)));
      EXPECT_EQ(step.log2_abs_x1, std::log2(std::abs(step.x1)));
    }
  }
}

// make_path_with_turning_points() fits a parabola around a turn and adds its vertex to the path. For samples of x = 4 -
// (t - 1.3)^2 at uneven times the vertex must be exact, have no velocity, and not be marked as a sample.
TEST(Path, ATurningPointIsTheVertexOfTheParabola) {
  std::vector<double> const t{0.0, 0.5, 1.0, 1.8, 2.5};
  std::vector<double> x, v;
  for (double const at : t) {
    x.push_back(4.0 - (at - 1.3) * (at - 1.3));
    v.push_back(-2.0 * (at - 1.3));
  }
  auto const path = laws::make_path_with_turning_points(x, v, t);
  ASSERT_EQ(path.samples(), 5u);
  ASSERT_EQ(path.steps.size(), 6u);
  auto const& turn = path.steps[3];  // the step after the sample of largest x, at t = 1
  EXPECT_NEAR(turn.x1, 4.0, 1e-15);
  EXPECT_EQ(turn.v1, 0.0);
  EXPECT_FALSE(turn.sample);
  EXPECT_TRUE(path.steps[4].reversal);
  EXPECT_EQ(path.steps[4].peak0, turn.x1);
  std::size_t sample = 0;
  for (auto const& step : path.steps) {
    if (!step.sample) continue;
    EXPECT_EQ(step.x1, x[sample++]);
  }
}

// At 20 samples a cycle the largest sample may be 1.2 % below the peak of the sine. The added turning points must be
// within 0.024 % of the peak.
TEST(Path, TurningPointsOfASineAreItsPeaks) {
  std::vector<double> t, x, v;
  for (int i = 0; i < 100; ++i) {
    t.push_back(0.05 * i);
    x.push_back(std::sin(2.0 * std::numbers::pi * (t.back() + 0.02)));
    v.push_back(0.0);
  }
  auto const path = laws::make_path_with_turning_points(x, v, t, 3);
  EXPECT_EQ(path.samples(), 100u);
  int turns = 0;
  for (auto const& step : path.steps)
    if (step.reversal && step.peak0 > 0.0 && step.direction != 0.0 && &step != &path.steps[1]) {
      EXPECT_NEAR(std::abs(step.x0), 1.0, 2.4e-4);
      ++turns;
    }
  EXPECT_EQ(turns, 10);
}

// A plateau, a record that never turns, and a turn exactly at a sample get no additional point.
TEST(Path, NoTurningPointWhereThereIsNone) {
  std::vector<double> const t{0.0, 1.0, 2.0, 3.0, 4.0};
  for (auto const& x : {std::vector{0.0, 1.0, 2.0, 3.0, 4.0}, std::vector{0.0, 1.0, 1.0, 1.0, 0.0},
                        std::vector{0.0, 1.0, 0.0, 1.0, 0.0}, std::vector{2.0, 2.0, 2.0, 2.0, 2.0}})
    EXPECT_EQ(laws::make_path_with_turning_points(x, {}, t).steps.size(), 5u);
}

TEST(Path, TheLogarithmOfZeroIsFinite) {
  std::vector<double> const x{0.0, 1.0, 0.0};
  for (auto const& step : make_path(x, {}).steps) EXPECT_TRUE(std::isfinite(step.log2_abs_x1));
}

}  // namespace
}  // namespace isolaw::law_tests
