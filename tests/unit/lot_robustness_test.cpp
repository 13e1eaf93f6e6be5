// Tests the robustness index beta on numbers worked out by hand. tests/verification compares beta with the published
// table.
#include "isolaw/lot/robustness.hpp"
#include "not_finite.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace isolaw::lot {
namespace {

using Values = std::vector<double>;

TEST(PercentDifferences, AreRelativeToTheMeanOfTheDeviceMeans) {
  EXPECT_EQ(percent_differences(Values{1, 2, 3}), (Values{-50, 0, 50}));
  EXPECT_EQ(percent_differences(Values{4}), Values{0});
}

TEST(PercentDifferences, OfANegativeParameterArePositiveWhereItsMagnitudeIsLarger) {
  EXPECT_EQ(percent_differences(Values{-1, -2, -3}), (Values{-50, 0, 50}));
}

TEST(PercentDifferences, AreEmptyWhereUndefined) {
  for (auto const& values : {Values{}, Values{-1, 1}, Values{0, 0}, Values{1, nan}, Values{1e9, -1e9, 1e-3}})
    EXPECT_TRUE(percent_differences(values).empty());
}

TEST(LargestRelativeDifference, IsTheLargestOnEitherSide) {
  EXPECT_DOUBLE_EQ(*largest_relative_difference(Values{1, 2, 3}), 0.5);
  EXPECT_DOUBLE_EQ(*largest_relative_difference(Values{1, 1, 1, 5}), 1.5);
  EXPECT_DOUBLE_EQ(*largest_relative_difference(Values{-1, -5, -5, -5}), 0.75);
  EXPECT_EQ(*largest_relative_difference(Values{7, 7}), 0.0);
}

TEST(LargestRelativeDifference, DoesNotDependOnTheUnit) {
  EXPECT_DOUBLE_EQ(*largest_relative_difference(Values{1e-12, 2e-12, 3e-12}), 0.5);
  EXPECT_DOUBLE_EQ(*largest_relative_difference(Values{1e12, 2e12, 3e12}), 0.5);
}

TEST(LargestRelativeDifference, IsUndefinedForOneDeviceAMeanNearZeroAndWhatIsNotFinite) {
  for (auto const& values : {Values{}, Values{3}, Values{-2, 2}, Values{0, 0, 0}, Values{1, nan}})
    EXPECT_FALSE(largest_relative_difference(values));
  EXPECT_TRUE(largest_relative_difference(Values{-1, 1 + 1e-6}));  // this mean is small but not near zero
}

TEST(RobustnessIndex, IsTheMeanOverTheParameters) {
  auto const [beta, note] = robustness_index({"K1", "K2"}, {{1, 2, 3}, {10, 10, 10}});
  ASSERT_TRUE(beta);
  EXPECT_DOUBLE_EQ(*beta, 0.25);
  EXPECT_EQ(note, "");
}

TEST(RobustnessIndex, SaysWhyItIsUndefined) {
  EXPECT_EQ(robustness_index({"K1", "K2"}, {{1}, {2}}).note, "one device: no spread between devices");
  EXPECT_EQ(robustness_index({"K1"}, {{}}).note, "no device");
  EXPECT_EQ(robustness_index({}, {}).note, "no free parameter");
  EXPECT_EQ(robustness_index({"K1", "a9", "a10"}, {{1, 2}, {-1, 1}, {0, 0}}).note,
            "mean over devices near zero: a9, a10");
  EXPECT_EQ(robustness_index({"K1", "a9"}, {{1, nan}, {-1, 1}}).note,
            "a device's mean is not finite: K1; mean over devices near zero: a9");
  EXPECT_FALSE(robustness_index({"K1", "a9"}, {{1, 2}, {-1, 1}}).beta);
}

}  // namespace
}  // namespace isolaw::lot
