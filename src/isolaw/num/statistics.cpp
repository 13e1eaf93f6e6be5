#include "isolaw/num/statistics.hpp"

#include <cmath>
#include <limits>

namespace isolaw::num {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Deviations {
  double mean = nan;
  double sum_of_squares = nan;  // about the mean
};

// Corrected two-pass algorithm (Chan, Golub, LeVeque 1983): the sum of the deviations, zero but for rounding, measures
// the error of the first pass's mean and is taken out of both results.
Deviations deviations(std::span<double const> values) {
  if (values.empty()) return {};
  auto const n = static_cast<double>(values.size());
  double sum = 0.0;
  for (double const value : values) sum += value;
  double const first_mean = sum / n;
  double residual = 0.0, squares = 0.0;
  for (double const value : values) {
    double const d = value - first_mean;
    residual += d;
    squares += d * d;
  }
  // By Cauchy's inequality the correction is at most `squares`; rounding alone could make the difference negative.
  double const corrected = squares - residual * residual / n;
  return {first_mean + residual / n, corrected < 0.0 ? 0.0 : corrected};
}

}  // namespace

Moments moments(std::span<double const> values) {
  auto const [mean, sum_of_squares] = deviations(values);
  if (values.size() < 2) return {values.size(), mean, std::isfinite(mean) ? 0.0 : nan};
  return {values.size(), mean, std::sqrt(sum_of_squares / static_cast<double>(values.size() - 1))};
}

double population_std(std::span<double const> values) {
  return std::sqrt(deviations(values).sum_of_squares / static_cast<double>(values.size()));
}

}  // namespace isolaw::num
