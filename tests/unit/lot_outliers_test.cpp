// Tests the search for outlying devices against scores worked out by hand.
#include "isolaw/lot/outliers.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "not_finite.hpp"

namespace isolaw::lot {
namespace {

using Values = std::vector<double>;
using Names = std::vector<std::string>;

std::vector<Outlier> among(Values const& values) {
  return find_outliers(Names{"K_eff"}, std::vector<Values>{values});
}

// The median is 11 and the deviations from it are 2, 1, 0, 1 and 9, so the median absolute deviation (MAD) is 1.
TEST(Outliers, HaveTheModifiedScoreOfIglewiczAndHoaglin) {
  auto const found = among({9, 10, 11, 12, 20});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].device, 4u);
  EXPECT_EQ(found[0].property, 0u);
  EXPECT_EQ(found[0].value, 20.0);
  EXPECT_EQ(found[0].median, 11.0);
  EXPECT_NEAR(found[0].score, 0.6745 * 9.0 / 1.0, 1e-3);
  EXPECT_NEAR(found[0].percent, 100.0 * 9.0 / 11.0, 1e-12);
}

TEST(Outliers, AreBeyondTheirThresholdOnEitherSide) {
  double const beyond = 3.5 * 1.4826;  // the threshold, for a MAD of 1
  EXPECT_TRUE(among({9, 9, 10, 11, 10 + 0.999 * beyond}).empty());
  ASSERT_EQ(among({9, 9, 10, 11, 10 + 1.001 * beyond}).size(), 1u);
  auto const below = among({10 - 1.001 * beyond, 9, 10, 11, 11});
  ASSERT_EQ(below.size(), 1u);
  EXPECT_NEAR(below[0].score, -3.5 * 1.001, 1e-9);
  EXPECT_LT(below[0].percent, 0.0);
}

TEST(Outliers, OfANegativeQuantityAreBelowItsMedianWhereLargerInMagnitude) {
  auto const found = among({-9, -10, -11, -12, -20});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].score, 0.0);
  EXPECT_NEAR(found[0].percent, -100.0 * 9.0 / 11.0, 1e-12);
}

// The scatter of a lot is taken as at least 0.5 % of the median, so a device is an outlier only beyond 3.5 times this,
// 1.75 %.
TEST(Outliers, AreNotNamedByRounding) {
  EXPECT_TRUE(among({2, 2, 2, 2, 2, 2, 2, 2, 2, 2 + 1e-15}).empty());
  EXPECT_TRUE(among({2, 2, 2, 2, 2, 2, 2, 2, 2, 2 * 1.0174}).empty());
  EXPECT_EQ(among({2, 2, 2, 2, 2, 2, 2, 2, 2, 2 * 1.0176}).size(), 1u);
  EXPECT_TRUE(among({0, 0, 0, 0, 1e-9}).empty());  // median and MAD are 0, so every score is 0
}

TEST(Outliers, NeedFourValues) {
  EXPECT_TRUE(among({1, 1, 9}).empty());
  EXPECT_TRUE(among({1, 1, nan, 9, nan}).empty());
  EXPECT_EQ(among({1, 1, 1, 9}).size(), 1u);
  EXPECT_TRUE(among({}).empty());
  EXPECT_TRUE(find_outliers(Names{}, std::vector<Values>{}).empty());
}

TEST(Outliers, OfDevicesWithoutTheValueKeepTheirIndex) {
  auto const found = among({nan, 1, 1, nan, 1, 1, 9});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].device, 6u);
  EXPECT_EQ(found[0].median, 1.0);
}

TEST(Outliers, ComeLargestFirstOverAllProperties) {
  auto const found = find_outliers(Names{"K1", "xy"}, std::vector<Values>{{1, 1, 1, 1, 1.1}, {3, 3, 3, 0.3, 3}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].property, 1u);
  EXPECT_EQ(found[0].device, 3u);
  EXPECT_NEAR(found[0].score, -0.9 / 0.005, 1e-9);
  EXPECT_EQ(found[1].property, 0u);
  EXPECT_EQ(found[1].device, 4u);
  EXPECT_NEAR(found[1].score, 0.1 / 0.005, 1e-9);
}

TEST(Outliers, DoNotDependOnTheUnit) {
  for (double const unit : {1e-9, 1e9}) {
    auto const found = among({9 * unit, 10 * unit, 11 * unit, 12 * unit, 20 * unit});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].score, 9.0 / 1.4826, 1e-12);
  }
}

TEST(Outliers, RefuseWhatIsNoTableOfValues) {
  EXPECT_THROW(among({1, 1, 1, infinity}), Error);
  EXPECT_THROW(find_outliers(Names{"K1", "xy"}, std::vector<Values>{{1, 1}}), Error);
  try {
    find_outliers(Names{"K1", "xy", "z"}, std::vector<Values>{{1, 1}, {1}, {-infinity, 2}});
    FAIL();
  } catch (Error const& error) {
    EXPECT_EQ(error.complaints().size(), 2u);
  }
}

}  // namespace
}  // namespace isolaw::lot
