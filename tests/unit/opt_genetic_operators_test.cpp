// Tests each operator of the genetic algorithm alone. Statistical bounds are five standard deviations and the keys are
// fixed, so a failure means changed behaviour and not bad luck.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "isolaw/opt/genetic.hpp"
#include "not_finite.hpp"

namespace isolaw::opt {
namespace {

using Values = std::vector<double>;
using Indices = std::vector<std::size_t>;

num::Draws some_draws(std::uint64_t key = 1) {
  return {num::Stream(key), 0, 0};
}

// Returns the chi-square of counts against given probabilities, in standard deviations above its mean.
double excess_chi_square(std::span<int const> counts, std::span<double const> probabilities) {
  double const total = std::accumulate(counts.begin(), counts.end(), 0.0);
  double chi_square = 0.0, freedom = -1.0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    double const expected = total * probabilities[i];
    if (expected == 0.0) continue;
    chi_square += (counts[i] - expected) * (counts[i] - expected) / expected;
    freedom += 1.0;
  }
  return (chi_square - freedom) / std::sqrt(2.0 * freedom);
}

TEST(RouletteWeights, FollowTheRatioToTheWorstFiniteValue) {
  auto const weights = roulette_weights(Values{0.0, 0.1, 0.2, 0.4}, 8.0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(weights[i], std::exp(Values{0, -2, -4, -8}[i]), 1e-15);
}

TEST(RouletteWeights, DoNotDependOnTheUnitOfTheValues) {
  auto const small = roulette_weights(Values{1e-200, 3e-200}, 8.0), large = roulette_weights(Values{1e300, 3e300}, 8.0);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(small[i], large[i], 1e-15);
}

TEST(RouletteWeights, AreZeroForFailedPointsWhichAreNoReference) {
  EXPECT_EQ(roulette_weights(Values{nan, 1.0, infinity, -infinity}, 2.0), (Values{0.0, std::exp(-2.0), 0.0, 0.0}));
  EXPECT_EQ(roulette_weights(Values{nan, infinity}, 8.0), (Values{0.0, 0.0}));
}

TEST(RouletteWeights, AreEqualWhereValuesAreEqualOrPressureIsNone) {
  EXPECT_EQ(roulette_weights(Values{0.0, 0.0}, 8.0), (Values{1.0, 1.0}));
  EXPECT_EQ(roulette_weights(Values{-3.0, -3.0}, 8.0), (Values{1.0, 1.0}));
  EXPECT_EQ(roulette_weights(Values{1.0, 5.0}, 0.0), (Values{1.0, 1.0}));
}

TEST(RouletteWeights, OfValuesBelowZeroAreCountedFromTheSmallest) {
  auto const weights = roulette_weights(Values{-1.0, 0.0, 1.0}, 8.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(weights[i], std::exp(Values{0, -4, -8}[i]), 1e-15);
  for (double const weight : roulette_weights(Values{-1.7e308, 1.7e308}, 8.0)) EXPECT_TRUE(std::isfinite(weight));
}

TEST(RouletteWheel, FrequenciesFollowTheWeights) {
  Values const weights{0.0, 3.0, 0.0, 1.0, 0.5, 0.0, 5.5, 0.0};
  RouletteWheel const wheel(weights);
  auto draws = some_draws();
  std::vector<int> counts(weights.size());
  for (int i = 0; i < 50'000; ++i) ++counts[wheel.spin(draws)];
  Values probabilities;
  for (double const weight : weights) probabilities.push_back(weight / 10.0);
  EXPECT_LT(excess_chi_square(counts, probabilities), 5.0);
  for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_EQ(counts[i] == 0, weights[i] == 0.0) << i;
}

TEST(RouletteWheel, OneWeightTakesAll) {
  RouletteWheel const wheel(Values{0.0, 1e-300, 0.0});
  auto draws = some_draws();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(wheel.spin(draws), 1u);
}

TEST(DrawCuts, EveryAdmissiblePairIsEquallyLikely) {
  for (std::size_t const n : {2u, 3u, 6u}) {
    auto draws = some_draws(n);
    std::map<std::pair<std::size_t, std::size_t>, int> seen;
    for (int i = 0; i < 20'000; ++i) {
      auto const [first, second] = draw_cuts(n, draws);
      ASSERT_LT(first, second);
      ASSERT_LE(second, n);
      ASSERT_NE(second - first, n);
      ++seen[{first, second}];
    }
    ASSERT_EQ(seen.size(), n * (n + 1) / 2 - 1);
    std::vector<int> counts;
    for (auto const& [pair, count] : seen) counts.push_back(count);
    EXPECT_LT(excess_chi_square(counts, Values(counts.size(), 1.0 / static_cast<double>(counts.size()))), 5.0) << n;
  }
}

TEST(Crossover, ExchangesOneRunOfGenesAndKeepsEachAtItsPosition) {
  constexpr std::size_t n = 6;
  auto draws = some_draws();
  for (int repetition = 0; repetition < 500; ++repetition) {
    Values a(n), b(n);
    for (std::size_t i = 0; i < n; ++i) a[i] = static_cast<double>(i), b[i] = 100.0 + a[i];
    crossover(a, b, draws);
    int exchanged = 0, changes = 0;
    for (std::size_t i = 0; i < n; ++i) {
      auto const gene = static_cast<double>(i);
      EXPECT_EQ(std::minmax(a[i], b[i]), std::minmax(gene, 100.0 + gene));
      exchanged += a[i] >= 100.0;
      changes += i > 0 && (a[i] >= 100.0) != (a[i - 1] >= 100.0);
    }
    EXPECT_GE(exchanged, 1);
    EXPECT_LT(exchanged, static_cast<int>(n));
    EXPECT_GE(changes, 1);  // a range of genes at an end of the point gives one change, a range inside gives two
    EXPECT_LE(changes, 2);
  }
}

TEST(Crossover, OfASingleGeneChangesNothing) {
  Values a{0.25}, b{0.75};
  auto draws = some_draws();
  crossover(a, b, draws);
  EXPECT_EQ(a, Values{0.25});
  EXPECT_EQ(b, Values{0.75});
}

TEST(Mutate, ChangesGenesAtItsRateAndPutsUniformValues) {
  constexpr int n = 200'000;
  constexpr double rate = 0.01;
  Values point(n, -1.0);
  auto draws = some_draws();
  mutate(point, rate, draws);
  Values changed;
  for (double const gene : point) {
    if (gene == -1.0) continue;
    ASSERT_GE(gene, 0.0);
    ASSERT_LT(gene, 1.0);
    changed.push_back(gene);
  }
  auto const count = static_cast<double>(changed.size());
  EXPECT_NEAR(count, n * rate, 5.0 * std::sqrt(n * rate * (1.0 - rate)));
  double const mean = std::accumulate(changed.begin(), changed.end(), 0.0) / count;
  EXPECT_NEAR(mean, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / count));
}

TEST(Mutate, NeverAndAlways) {
  Values point(1000, -1.0);
  auto draws = some_draws();
  mutate(point, 0.0, draws);
  EXPECT_EQ(std::ranges::count(point, -1.0), 1000);
  mutate(point, 1.0, draws);
  EXPECT_EQ(std::ranges::count(point, -1.0), 0);
}

TEST(Survivors, AreTheBestOfBothBestFirst) {
  EXPECT_EQ(survivors(Values{5, 1, 3}, Values{4, 0, 9}, 3), (Indices{4, 1, 2}));
  EXPECT_EQ(survivors({}, Values{2, 1}, 2), (Indices{1, 0}));
}

TEST(Survivors, TiesKeepParentsFirstThenTheOrderGiven) {
  EXPECT_EQ(survivors(Values{1, 1, 2}, Values{1, 0, 1}, 5), (Indices{4, 0, 1, 3, 5}));
}

TEST(Survivors, FailedPointsOnlyWhereNothingBetterExists) {
  EXPECT_EQ(survivors(Values{nan, 1, -infinity}, Values{infinity, 2, nan}, 2), (Indices{1, 4}));
  EXPECT_EQ(survivors(Values{nan, 1}, Values{infinity, nan}, 3), (Indices{1, 0, 2}));
}

}  // namespace
}  // namespace isolaw::opt
