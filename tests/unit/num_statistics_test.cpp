// Tests moments and modified scores on numbers worked out by hand.
#include "isolaw/num/statistics.hpp"
#include "not_finite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace isolaw::num {
namespace {

TEST(Moments, SampleAndPopulationForm) {
  std::vector<double> const values{2, 4, 4, 4, 5, 5, 7, 9};  // the mean is 5 and the squared deviations add up to 32
  auto const m = moments(values);
  EXPECT_EQ(m.count, 8u);
  EXPECT_DOUBLE_EQ(m.mean, 5.0);
  EXPECT_DOUBLE_EQ(m.std, std::sqrt(32.0 / 7.0));
  EXPECT_DOUBLE_EQ(population_std(values), 2.0);
}

// The variance is 30, and the squares are about 1e18. A variance computed as the mean of squares less the square of the
// mean would lose all digits.
TEST(Moments, SmallSpreadAboutALargeMean) {
  std::vector<double> const values{1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16};
  EXPECT_DOUBLE_EQ(moments(values).mean, 1e9 + 10);
  EXPECT_DOUBLE_EQ(moments(values).std, std::sqrt(30.0));
  EXPECT_DOUBLE_EQ(population_std(values), std::sqrt(22.5));
}

// Adding 0.1 a thousand times does not give 100 exactly, so the mean from a plain sum is wrong in its last digits. The
// mean from the corrected sum of moments() must be right.
TEST(Moments, EqualValuesHaveNoSpread) {
  std::vector<double> const values(1000, 0.1);
  EXPECT_DOUBLE_EQ(moments(values).mean, 0.1);
  EXPECT_LT(moments(values).std, 1e-16);
}

TEST(Moments, OneValueAndNone) {
  auto const one = moments(std::vector{3.5});
  EXPECT_EQ(one.count, 1u);
  EXPECT_EQ(one.mean, 3.5);
  EXPECT_EQ(one.std, 0.0);
  EXPECT_EQ(population_std(std::vector{3.5}), 0.0);
  auto const none = moments({});
  EXPECT_EQ(none.count, 0u);
  EXPECT_TRUE(std::isnan(none.mean));
  EXPECT_TRUE(std::isnan(none.std));
  EXPECT_TRUE(std::isnan(population_std({})));
}

TEST(Moments, ValuesThatAreNotFiniteAreNotHidden) {
  for (double const bad : {nan, infinity, -infinity}) {
    for (auto const& values : {std::vector{1.0, bad, 2.0}, std::vector{bad}}) {
      EXPECT_FALSE(std::isfinite(moments(values).mean));
      EXPECT_FALSE(std::isfinite(moments(values).std));
      EXPECT_FALSE(std::isfinite(population_std(values)));
    }
  }
}

TEST(Median, IsTheMiddle) {
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2.0);
  EXPECT_EQ(median(std::vector<double>{4, 1, 2, 3}), 2.5);
  EXPECT_EQ(median(std::vector<double>{1, -infinity, infinity}), 1.0);
  EXPECT_TRUE(std::isnan(median({})));
  EXPECT_TRUE(std::isnan(median(std::vector<double>{1, nan, 2})));
}

// The median is 3 and the deviations from it are 2, 1, 0, 1 and 7, so the median absolute deviation (MAD) is 1.
TEST(ModifiedScores, CountDeviationsFromTheMedian) {
  std::vector<double> const values{1, 2, 3, 4, 10};
  auto const found = modified_scores(values, 0.0);
  EXPECT_EQ(found.median, 3.0);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_DOUBLE_EQ(found.scores[i], (values[i] - 3.0) / 1.4826);
  EXPECT_NEAR(found.scores[4], 0.6745 * 7.0, 1e-3);  // with the constant as printed by Iglewicz and Hoaglin
  EXPECT_EQ(modified_scores(values, 10.0).scores[4], 7.0 / 30.0);
  EXPECT_EQ(modified_scores(std::vector<double>{0, 0, 0, 1}, 0.5).scores, std::vector<double>(4, 0.0));
  EXPECT_TRUE(modified_scores({}, 0.1).scores.empty());
}

TEST(ModifiedScores, LeaveOutWhatIsNoNumber) {
  auto const whole = modified_scores(std::vector<double>{1, 2, 3, 4, 10}, 0.0);
  auto const found = modified_scores(std::vector<double>{1, 2, nan, 3, 4, 10}, 0.0);
  EXPECT_EQ(found.median, whole.median);
  ASSERT_EQ(found.scores.size(), 6u);
  EXPECT_TRUE(std::isnan(found.scores[2]));
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(found.scores[i < 2 ? i : i + 1], whole.scores[i]);
  auto const alike = modified_scores(std::vector<double>{0, nan, 0}, 0.0).scores;  // the divisor is 0
  EXPECT_EQ(alike[0], 0.0);
  EXPECT_TRUE(std::isnan(alike[1]));
}

}  // namespace
}  // namespace isolaw::num
