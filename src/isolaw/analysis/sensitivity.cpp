#include "isolaw/analysis/sensitivity.hpp"

#include <algorithm>
#include <cmath>

namespace isolaw::analysis {

using num::Index;

Sensitivity sensitivity(opt::DeviationProblem const& problem, std::span<double const> point) {
  constexpr double step = 1e-5;
  std::size_t const n = problem.dimension(), samples = problem.weights().size();
  opt::Points points(n, 2 * n + 1);
  for (std::size_t i = 0; i < points.size(); ++i) std::ranges::copy(point, points[i].begin());
  for (std::size_t k = 0; k < n; ++k) {
    points[2 * k + 1][k] = std::max(point[k] - step, 0.0);
    points[2 * k + 2][k] = std::min(point[k] + step, 1.0);
  }
  std::vector<double> residuals(points.size() * samples);
  problem.residuals(points, residuals);

  std::vector<std::size_t> counted;
  for (std::size_t j = 0; j < samples; ++j)
    if (problem.weights()[j] > 0.0) counted.push_back(j);
  Sensitivity result;
  auto const rows = static_cast<Index>(counted.size());
  result.residuals.resize(rows);
  result.weights.resize(rows);
  result.jacobian.resize(rows, static_cast<Index>(n));
  for (Index row = 0; row < rows; ++row) {
    auto const j = counted[static_cast<std::size_t>(row)];
    result.residuals[row] = residuals[j];
    result.weights[row] = problem.weights()[j];
    for (std::size_t k = 0; k < n; ++k)
      result.jacobian(row, static_cast<Index>(k)) =
          (residuals[(2 * k + 2) * samples + j] - residuals[(2 * k + 1) * samples + j]) /
          (points[2 * k + 2][k] - points[2 * k + 1][k]);
  }
  for (Index k = 0; k < result.jacobian.cols(); ++k)
    if (!result.jacobian.col(k).allFinite()) result.jacobian.col(k).setZero();
  return result;
}

double slope(fit::SearchParameter const& parameter, double coordinate) {
  constexpr double step = 1e-6;
  double const below = std::max(coordinate - step, 0.0), above = std::min(coordinate + step, 1.0);
  return (parameter.at(above) - parameter.at(below)) / (above - below);
}

double natural_size(fit::SearchParameter const& parameter, double value) {
  double const least = 0.01 * (parameter.upper - parameter.lower);
  bool const of_one_sign = parameter.lower * parameter.upper >= 0.0;
  if (of_one_sign && value != 0.0) return std::abs(value);
  return std::max(std::abs(value), least);
}

std::vector<fit::SearchParameter const*> free_parameters(fit::SearchBox const& box) {
  std::vector<fit::SearchParameter const*> free;
  for (auto const& p : box.parameters)
    if (p.free) free.push_back(&p);
  return free;
}

}  // namespace isolaw::analysis
