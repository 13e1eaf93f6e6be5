// with_factors multiplies the elastic part of a law's force by a and the hysteretic or viscous part by b. The parts are
// differences of forces: doubling a adds the elastic part, doubling b the hysteretic one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "laws/candidates.hpp"
#include "laws/motion.hpp"
#include "laws/records.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::law_tests {
namespace {

template <class Law>
class Factors : public ::testing::Test {};
TYPED_TEST_SUITE(Factors, EveryLaw, LawName);

// Returns two cycles each of 100, 208 and 150 mm at 0.5 Hz, with 400 samples a cycle.
Motion cycles() {
  Motion motion;
  for (double const amplitude : {100.0, 208.0, 150.0})
    for (int i = motion.disp_mm.empty() ? 0 : 1; i <= 800; ++i) {
      double const phase = 2.0 * std::numbers::pi * i / 400.0;
      motion.disp_mm.push_back(amplitude * std::sin(phase));
      motion.velocity_mm_s.push_back(amplitude * std::numbers::pi * std::cos(phase));
    }
  return motion;
}

std::vector<double> force_with(laws::LawEntry const& law, std::span<double const> parameters, double a, double b) {
  std::vector<double> values(parameters.begin(), parameters.end());
  law.with_factors(values, a, b);
  return forces(law, values, cycles(), laws::Integration::converged);
}

// Returns a first + b second.
std::vector<double> sum(double a, std::span<double const> first, double b, std::span<double const> second) {
  std::vector<double> all(first.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = a * first[i] + b * second[i];
  return all;
}

constexpr std::array factors{std::pair{1.0, 1.0}, std::pair{1.9, 1.4}, std::pair{0.6, 0.8}, std::pair{0.7, 1.5}};

TYPED_TEST(Factors, MultiplyThePartsOfTheForce) {
  auto const& law = laws::find_law(TypeParam::info.id);
  if (law.one_factor) return;  // EqualFactorsMultiplyTheForce tests such a law
  for (std::uint32_t index = 0; index < 20; ++index) {
    auto values = candidate<TypeParam>(index);
    for (auto const& [name, value] : parameters_for_factors(law.info.id)) values[law.index_of(name)] = value;
    auto const force = forces(law, values, cycles(), laws::Integration::converged);
    auto const elastic = sum(1.0, force_with(law, values, 2.0, 1.0), -1.0, force);
    auto const hysteretic = sum(1.0, force_with(law, values, 1.0, 2.0), -1.0, force);
    double const peak = largest_magnitude(force);
    for (auto const& [a, b] : factors)
      EXPECT_LT(largest_difference(force_with(law, values, a, b), sum(a, elastic, b, hysteretic)),
                error_of_factors(law.info.id) * peak)
          << "a " << a << ", b " << b << ", " << describe(law, values);
  }
}

// Equal factors on both parts must multiply the whole force, even if a part depends on the work of the other part.
TYPED_TEST(Factors, EqualFactorsMultiplyTheForce) {
  auto const& law = laws::find_law(TypeParam::info.id);
  for (std::uint32_t index = 0; index < 10; ++index) {
    auto const values = candidate<TypeParam>(index);
    auto const force = forces(law, values, cycles(), laws::Integration::converged);
    EXPECT_LT(largest_difference(force_with(law, values, 1.3, 1.3), sum(1.3, force, 0.0, force)),
              1e-12 * largest_magnitude(force))
        << describe(law, values);
  }
}

// Positive factors keep parameters within their limits, and 1 changes nothing beyond rounding.
TYPED_TEST(Factors, KeepTheLimitsOfTheParameters) {
  auto const& law = laws::find_law(TypeParam::info.id);
  for (std::uint32_t index = 0; index < 20; ++index) {
    auto const from = candidate<TypeParam>(index);
    if (law.unmet(from)) continue;
    for (auto const& [a, b] : factors) {
      std::vector<double> values(from.begin(), from.end());
      law.with_factors(values, a, b);
      EXPECT_FALSE(law.unmet(values)) << describe(law, values);
      for (std::size_t i = 0; i < values.size(); ++i) {
        auto const& limits = law.parameters[i].physical;
        EXPECT_TRUE(limits.lower <= values[i] && values[i] <= limits.upper) << describe(law, values);
        if (a == 1.0 && b == 1.0) {
          EXPECT_NEAR(values[i], from[i], 1e-14 * std::abs(from[i])) << describe(law, values);
        }
      }
    }
  }
}

}  // namespace
}  // namespace isolaw::law_tests
