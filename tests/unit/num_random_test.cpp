// Tests random numbers: the published test vectors of the generator, and the properties of streams and draws.
// Statistical bounds are five standard deviations and the keys are fixed, so a failure means that the numbers have
// changed.
#include "isolaw/num/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <vector>

namespace isolaw::num {
namespace {

using Words = std::array<std::uint32_t, 4>;

static_assert(std::uniform_random_bit_generator<Draws>);

// Returns the chi-square of counts that should be equal, in standard deviations above its mean.
double excess_chi_square(std::span<int const> counts, double draws) {
  double const expected = draws / static_cast<double>(counts.size());
  double chi_square = 0.0;
  for (int const count : counts) chi_square += (count - expected) * (count - expected) / expected;
  double const freedom = static_cast<double>(counts.size()) - 1.0;
  return (chi_square - freedom) / std::sqrt(2.0 * freedom);
}

// Known answers for philox4x32 with 10 rounds, from the file kat_vectors of Random123 1.09.
TEST(Philox, KnownAnswers) {
  EXPECT_EQ(philox_4x32_10({0, 0, 0, 0}, 0), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox_4x32_10({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffff),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox_4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// Stored campaigns can be repeated only if the order in which draws take words from the generator never changes.
TEST(Draws, TakeTheWordsOfSuccessiveBlocksOfTheirPlace) {
  Draws draws(Stream(0x0123456789abcdef), 7, 9);
  for (std::uint32_t block = 0; block < 3; ++block)
    for (auto const word : philox_4x32_10({block, 0, 7, 9}, 0x0123456789abcdef)) EXPECT_EQ(draws(), word);
}

TEST(Draws, DependOnTheirPlaceAlone) {
  Stream const stream(42);
  std::vector<double> forwards, backwards(20);
  for (std::uint32_t b = 0; b < 20; ++b) forwards.push_back(Draws(stream, 1, b).uniform());
  for (std::uint32_t b = 20; b-- > 0;) {
    Draws other(stream, 2, b);  // draws at another place must not disturb the draws here
    other.normal();
    backwards[b] = Draws(stream, 1, b).uniform();
  }
  EXPECT_EQ(forwards, backwards);
}

TEST(Stream, PlacesAndPartsOfANameGiveDifferentNumbers) {
  std::set<std::uint64_t> seen;
  auto const is_new = [&](Stream const& stream, std::uint32_t a, std::uint32_t b) {
    Draws draws(stream, a, b);
    auto const low = draws();
    return seen.insert((std::uint64_t{draws()} << 32) | low).second;
  };
  Stream const root(1);
  for (std::uint32_t i = 0; i < 30; ++i)
    for (std::uint32_t j = 0; j < 30; ++j) {
      EXPECT_TRUE(is_new(root, i, j));
      // Splitting by (i, j) and by (j, i) gives different streams.
      EXPECT_TRUE(is_new(root.split(i).split(j), 0, 0)) << i << ' ' << j;
    }
  EXPECT_NE(root.split(0).key(), root.key());
  EXPECT_EQ(root.split(5).key(), Stream(1).split(5).key());
}

TEST(Draws, UniformIsUniformAlone) {
  constexpr int n = 200'000;
  std::array<int, 64> counts{};
  Draws draws(Stream(3), 0, 0);
  for (int i = 0; i < n; ++i) {
    double const u = draws.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++counts[static_cast<std::size_t>(u * 64.0)];
  }
  EXPECT_LT(excess_chi_square(counts, n), 5.0);
}

// Pairs of numbers must be independent: successive draws at one place (a, b) of a stream, first draws at neighbouring
// places, and first draws of neighbouring streams.
TEST(Draws, UniformIsUniformInPairs) {
  constexpr std::uint32_t n = 100'000;
  std::array<int, 64> successive{}, places{}, streams{};
  auto const cell = [](double u, double v) {
    return static_cast<std::size_t>(u * 8.0) * 8 + static_cast<std::size_t>(v * 8.0);
  };
  Stream const root(4);
  Draws draws(root, 0, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    double const first = draws.uniform(), second = draws.uniform();
    ++successive[cell(first, second)];
    ++places[cell(Draws(root, 1, 2 * i).uniform(), Draws(root, 1, 2 * i + 1).uniform())];
    ++streams[cell(Draws(root.split(2 * i), 0, 0).uniform(), Draws(root.split(2 * i + 1), 0, 0).uniform())];
  }
  EXPECT_LT(excess_chi_square(successive, n), 5.0);
  EXPECT_LT(excess_chi_square(places, n), 5.0);
  EXPECT_LT(excess_chi_square(streams, n), 5.0);
}

TEST(Draws, BelowIsInRangeAndUniform) {
  Draws draws(Stream(5), 0, 0);
  EXPECT_EQ(draws.below(1), 0u);
  for (std::size_t const n : {2u, 3u, 6u, 8u, 13u}) {
    constexpr int tries = 60'000;
    std::vector<int> counts(n);
    for (int i = 0; i < tries; ++i) {
      auto const k = draws.below(n);
      ASSERT_LT(k, n);
      ++counts[k];
    }
    EXPECT_LT(excess_chi_square(counts, tries), 5.0) << n;
  }
}

// A third of the numbers below 3 x 2^62 are below 2^62. Taking the remainder of a 64-bit number would make it a half.
TEST(Draws, BelowIsUnbiasedForHugeRanges) {
  constexpr int tries = 20'000;
  constexpr std::size_t third = std::size_t{1} << 62;
  Draws draws(Stream(6), 0, 0);
  int low = 0;
  for (int i = 0; i < tries; ++i) {
    auto const k = draws.below(3 * third);
    ASSERT_LT(k, 3 * third);
    low += k < third;
  }
  EXPECT_NEAR(low / double{tries}, 1.0 / 3.0, 5.0 * std::sqrt(2.0 / 9.0 / tries));
}

TEST(Draws, NormalHasTheMomentsOfTheNormalDistribution) {
  constexpr int n = 200'000;
  Draws draws(Stream(7), 0, 0);
  double m1 = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < n; ++i) {
    double const x = draws.normal();
    ASSERT_TRUE(std::isfinite(x));
    m1 += x / n;
    m2 += x * x / n;
    m3 += x * x * x / n;
    m4 += x * x * x * x / n;
    beyond_two += std::abs(x) > 2.0;
  }
  EXPECT_NEAR(m1, 0.0, 5.0 * std::sqrt(1.0 / n));
  EXPECT_NEAR(m2, 1.0, 5.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(m3, 0.0, 5.0 * std::sqrt(15.0 / n));
  EXPECT_NEAR(m4, 3.0, 5.0 * std::sqrt(96.0 / n));
  double const p = std::erfc(2.0 / std::sqrt(2.0));
  EXPECT_NEAR(beyond_two / double{n}, p, 5.0 * std::sqrt(p / n));
}

}  // namespace
}  // namespace isolaw::num
