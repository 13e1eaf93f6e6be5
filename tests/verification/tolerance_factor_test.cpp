// Compares two-sided tolerance factors k of the normal distribution with printed tables. The interval mean +- k
// standard deviations of a sample holds 95 % of the distribution with a confidence of 95 %.
#include "isolaw/num/tolerance_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace isolaw::num {
namespace {

using Table = std::vector<std::pair<std::size_t, double>>;

// The expected factors are the exact ones of ISO 16269-6:2014. An independent program (Simpson's rule in Python) gave
// the same four digits.
TEST(ToleranceFactor, IsExact) {
  for (auto const& [n, k] : Table{
           {2, 36.5192}, {3, 9.7888}, {4, 6.3411}, {5, 5.0769}, {6, 4.4222}, {10, 3.3934}, {20, 2.7603}, {30, 2.5549}})
    EXPECT_NEAR(tolerance_factor(n), k, 1.01e-4) << n;
}

TEST(ToleranceFactor, TendsToTheNormalQuantile) {
  EXPECT_NEAR(tolerance_factor(1'000'000), 1.959964, 3e-3);
  EXPECT_TRUE(std::isnan(tolerance_factor(1)));
}

// The interval of a sample of four must hold 95 % of the distribution in 95 % of the samples.
TEST(ToleranceFactor, HoldsItsShareWithItsConfidence) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  auto const share_below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  double const k = tolerance_factor(4);
  int held = 0, samples = 200'000;
  for (int i = 0; i < samples; ++i) {
    double sum = 0.0, squares = 0.0;
    for (int j = 0; j < 4; ++j) {
      double const x = normal(random);
      sum += x;
      squares += x * x;
    }
    double const mean = sum / 4, s = std::sqrt((squares - 4 * mean * mean) / 3);
    held += share_below(mean + k * s) - share_below(mean - k * s) >= 0.95;
  }
  EXPECT_NEAR(held / static_cast<double>(samples), 0.95, 0.0015);  // 0.0015 is three standard errors
}

}  // namespace
}  // namespace isolaw::num
