#include "isolaw/analysis/problems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "isolaw/num/row_kernels.hpp"

namespace isolaw::analysis {
namespace {

void values_of_residuals(opt::DeviationProblem const& problem, opt::Points const& points, std::span<double> values) {
  std::size_t const stride = num::padded(points.size());
  std::vector<double> rows(stride * problem.weights().size()), sums(stride), rounded(stride);
  problem.residual_rows(points, stride, rows);
  num::row_kernels().sizes({rows.data(), stride, problem.weights()}, points.size(), 0.0, sums.data(), rounded.data());
  for (std::size_t i = 0; i < points.size(); ++i)
    values[i] = std::isfinite(sums[i]) ? sums[i] : std::numeric_limits<double>::infinity();
}

}  // namespace

ReweightedProblem::ReweightedProblem(opt::DeviationProblem const& base, std::vector<double> weights)
    : base_(base), weights_(std::move(weights)) {
  if (auto const* fewer = base.outline())
    outline_ = std::make_unique<ReweightedProblem>(*fewer, base.on_outline(weights_));
}

void ReweightedProblem::evaluate(opt::Points const& points, std::span<double> values) const {
  values_of_residuals(*this, points, values);
}

HeldCoordinateProblem::HeldCoordinateProblem(opt::DeviationProblem const& base, std::size_t coordinate, double value)
    : base_(base), coordinate_(coordinate), value_(value) {
  if (auto const* fewer = base.outline()) outline_ = std::make_unique<HeldCoordinateProblem>(*fewer, coordinate, value);
}

opt::Points HeldCoordinateProblem::with_held(opt::Points const& points) const {
  opt::Points all(base_.dimension(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0, next = 0; k < all.dimension; ++k) all[i][k] = k == coordinate_ ? value_ : points[i][next++];
  return all;
}
void HeldCoordinateProblem::evaluate(opt::Points const& points, std::span<double> values) const {
  base_.evaluate(with_held(points), values);
}
void HeldCoordinateProblem::residuals(opt::Points const& points, std::span<double> values) const {
  base_.residuals(with_held(points), values);
}

void HeldCoordinateProblem::residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const {
  base_.residual_rows(with_held(points), stride, rows);
}

SeveralRecordsProblem::SeveralRecordsProblem(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                             std::span<double const> shares)
    : box_(box) {
  std::vector<double> used;
  for (std::size_t d = 0; d < models.size(); ++d) {
    if (shares[d] <= 0.0) continue;
    add(*models[d], shares[d]);
    used.push_back(shares[d]);
  }
  for (auto const* model : models_) {
    auto outline = model->outline();
    if (!outline) return;
    thinned_models_.push_back(std::move(*outline));
  }
  outline_.reset(new SeveralRecordsProblem(box));
  for (std::size_t d = 0; d < thinned_models_.size(); ++d) outline_->add(thinned_models_[d], used[d]);
}

void SeveralRecordsProblem::add(fit::LawOnRecord const& model, double share) {
  models_.push_back(&model);
  for (double const weight : model.residual_weights()) weights_.push_back(share * weight);
}

std::vector<double> SeveralRecordsProblem::on_outline(std::span<double const> weights) const {
  std::vector<double> all;
  for (auto const* model : models_) {
    auto const some = model->on_outline(weights.first(model->samples()));
    all.insert(all.end(), some.begin(), some.end());
    weights = weights.subspan(model->samples());
  }
  return all;
}

void SeveralRecordsProblem::evaluate(opt::Points const& points, std::span<double> values) const {
  values_of_residuals(*this, points, values);
}

void SeveralRecordsProblem::residuals(opt::Points const& points, std::span<double> values) const {
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

void SeveralRecordsProblem::residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const {
  for (auto const* model : models_) {
    model->residual_rows(
        points.size(), [&](std::size_t i, std::span<double> parameters) { box_.expand(points[i], parameters); }, stride,
        rows);
    rows = rows.subspan(model->samples() * stride);
  }
}

}  // namespace isolaw::analysis
