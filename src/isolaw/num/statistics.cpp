#include "isolaw/num/statistics.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <limits>

namespace isolaw::num {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double mad_to_std = 1.4826;  // standard deviation / median absolute deviation of a normal distribution

struct Deviations {
  double mean = nan;
  double sum_of_squares = nan;  // sum of (value - mean)^2 over all values
};

// Two-pass algorithm (Chan, Golub and LeVeque 1983). Without rounding errors the deviations from the mean would have
// the sum 0; their actual sum corrects the mean and the sum of squares.
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
  // By Cauchy's inequality the difference is not negative, except for rounding errors.
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

double median(std::span<double const> values) {
  if (values.empty() || std::ranges::any_of(values, [](double value) { return std::isnan(value); })) return nan;
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  auto const half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

// Solves P(|t| > q) = 0.05 for q. With x = freedom / (freedom + q^2), this probability is the regularised incomplete
// beta function I(x; freedom/2, 1/2), which ibeta_inv() inverts.
double student_97_5(double freedom) {
  double const x = boost::math::ibeta_inv(0.5 * freedom, 0.5, 0.05);
  return std::sqrt(freedom * (1.0 - x) / x);
}

ModifiedScores modified_scores(std::span<double const> values, double least_scale) {
  std::vector<double> present(values.begin(), values.end());
  std::erase_if(present, [](double value) { return std::isnan(value); });
  ModifiedScores result{.median = median(present), .scores = {}};
  std::vector<double> distances;
  for (double const value : present) distances.push_back(std::abs(value - result.median));
  double const scale = std::max(mad_to_std * median(distances), least_scale * std::abs(result.median));
  for (double const value : values)
    result.scores.push_back(scale > 0.0 || std::isnan(value) ? (value - result.median) / scale : 0.0);
  return result;
}

}  // namespace isolaw::num
