#include "isolaw/rules/factors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "isolaw/num/statistics.hpp"

namespace isolaw::rules {
namespace {

constexpr double normal_97_5 = 1.959963984540054;  // quantile of the normal distribution for a two-sided 95 %

}  // namespace

std::optional<TestFactors> test_factors(Quantity quantity, BlockValues const& block) {
  double mean = 0.0;
  for (int number = 1; number <= 3; ++number) {
    auto const* cycle = block.find(number);
    if (cycle == nullptr) return std::nullopt;
    mean += peak_to_peak(*cycle, quantity) / 3.0;
  }
  TestFactors factors{.min = std::numeric_limits<double>::infinity(), .max = 0.0};
  for (auto const& cycle : block.cycles) {
    double const value = peak_to_peak(cycle, quantity), factor = value / mean;
    if (!(value > 0.0) || !std::isfinite(factor)) return std::nullopt;
    if (factor > factors.max) factors.max = factor, factors.max_cycle = cycle.number;
    if (factor <= factors.min) factors.min = factor, factors.min_cycle = cycle.number;
  }
  return factors;
}

CombinedFactors combine(FactorRule const& rule, FactorPair const& environment, FactorPair const& test,
                        FactorPair const& spec) {
  CombinedFactors combined{.min = (1.0 - rule.system_factor * (1.0 - environment.min)) * test.min * spec.min,
                           .max = (1.0 + rule.system_factor * (environment.max - 1.0)) * test.max * spec.max};
  if (rule.max_not_below && combined.max < *rule.max_not_below) {
    combined.max = *rule.max_not_below;
    combined.max_is_default = true;
  }
  if (rule.min_not_above && combined.min > *rule.min_not_above) {
    combined.min = *rule.min_not_above;
    combined.min_is_default = true;
  }
  return combined;
}

double system_half_width_percent(double cov_percent, int installed, int tested) {
  auto const N = static_cast<double>(installed), n = static_cast<double>(std::min(tested, installed));
  // With one installed device the formula divides by zero. The factor is then 0 if the device was tested, else 1.
  double const finite = installed > 1 ? std::min(1.0, std::sqrt((N - n) / (N - 1.0))) : (tested > 0 ? 0.0 : 1.0);
  return normal_97_5 * cov_percent / std::sqrt(N) * finite;
}

double prediction_half_width_percent(double cov_percent, int installed, int tested) {
  if (tested < 2) return std::numeric_limits<double>::quiet_NaN();
  auto const N = static_cast<double>(installed), n = static_cast<double>(std::min(tested, installed));
  return num::student_97_5(n - 1.0) * cov_percent * std::sqrt(1.0 / n - 1.0 / N);
}

}  // namespace isolaw::rules
