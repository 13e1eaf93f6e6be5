#include "isolaw/analysis/problems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isolaw::analysis {
namespace {

void values_of_residuals(opt::DeviationProblem const& problem, opt::Points const& points, std::span<double> values) {
  auto const weights = problem.weights();
  std::vector<double> residuals(points.size() * weights.size());
  problem.residuals(points, residuals);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) sum += weights[j] * std::abs(residuals[i * weights.size() + j]);
    values[i] = std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }
}

}  // namespace

void Reweighted::evaluate(opt::Points const& points, std::span<double> values) const {
  values_of_residuals(*this, points, values);
}

opt::Points Held::with_held(opt::Points const& points) const {
  opt::Points all(base_.dimension(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0, next = 0; k < all.dimension; ++k) all[i][k] = k == coordinate_ ? value_ : points[i][next++];
  return all;
}
void Held::evaluate(opt::Points const& points, std::span<double> values) const {
  base_.evaluate(with_held(points), values);
}
void Held::residuals(opt::Points const& points, std::span<double> values) const {
  base_.residuals(with_held(points), values);
}

Joint::Joint(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box, std::span<double const> shares)
    : box_(box) {
  for (std::size_t d = 0; d < models.size(); ++d) {
    if (shares[d] <= 0.0) continue;
    models_.push_back(models[d]);
    for (double const weight : models[d]->residual_weights()) weights_.push_back(shares[d] * weight);
  }
}

void Joint::evaluate(opt::Points const& points, std::span<double> values) const {
  values_of_residuals(*this, points, values);
}

void Joint::residuals(opt::Points const& points, std::span<double> values) const {
  std::vector<double> room;
  std::size_t before = 0;
  for (auto const* model : models_) {
    room.resize(points.size() * model->samples());
    model->residuals(
        points.size(), [&](std::size_t i, std::span<double> parameters) { box_.expand(points[i], parameters); }, room);
    for (std::size_t i = 0; i < points.size(); ++i)
      std::ranges::copy(std::span(room).subspan(i * model->samples(), model->samples()),
                        values.begin() + static_cast<std::ptrdiff_t>(i * weights_.size() + before));
    before += model->samples();
  }
}

}  // namespace isolaw::analysis
