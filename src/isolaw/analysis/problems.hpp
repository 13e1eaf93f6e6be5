// Search problems derived from other ones: with other weights, with one coordinate held, or for several records.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::analysis {

// Long computations call such a function between their steps and give up if it returns true.
using Interrupted = std::function<bool()>;

// The problem `base` with other weights of its residuals. The sum of the weights must be 1.
class ReweightedProblem final : public opt::DeviationProblem {
 public:
  ReweightedProblem(opt::DeviationProblem const& base, std::vector<double> weights);
  std::size_t dimension() const override { return base_.dimension(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return weights_; }
  void residuals(opt::Points const& points, std::span<double> values) const override {
    base_.residuals(points, values);
  }
  void residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const override {
    base_.residual_rows(points, stride, rows);
  }
  DeviationProblem const* outline() const override { return outline_.get(); }
  std::vector<double> on_outline(std::span<double const> weights) const override { return base_.on_outline(weights); }

 private:
  opt::DeviationProblem const& base_;
  std::vector<double> weights_;
  std::unique_ptr<ReweightedProblem> outline_;
};

// The problem `base` with one coordinate held at a value, so that a search varies the others.
class HeldCoordinateProblem final : public opt::DeviationProblem {
 public:
  HeldCoordinateProblem(opt::DeviationProblem const& base, std::size_t coordinate, double value);
  std::size_t dimension() const override { return base_.dimension() - 1; }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return base_.weights(); }
  void residuals(opt::Points const& points, std::span<double> values) const override;
  void residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const override;
  DeviationProblem const* outline() const override { return outline_.get(); }
  std::vector<double> on_outline(std::span<double const> weights) const override { return base_.on_outline(weights); }

 private:
  opt::Points with_held(opt::Points const& points) const;

  opt::DeviationProblem const& base_;
  std::size_t coordinate_;
  double value_;
  std::unique_ptr<HeldCoordinateProblem> outline_;
};

// Fits one set of parameters to several records. The value is the weighted mean of the records' objectives; the weights
// are `shares`, whose sum is 1. A record with share 0 is skipped. outline() is the same problem with fewer samples. It
// exists if every model on a record that is not skipped has such an outline.
class SeveralRecordsProblem final : public opt::DeviationProblem {
 public:
  SeveralRecordsProblem(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                        std::span<double const> shares);
  std::size_t dimension() const override { return box_.free_count(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return weights_; }
  void residuals(opt::Points const& points, std::span<double> values) const override;
  void residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const override;
  DeviationProblem const* outline() const override { return outline_.get(); }
  std::vector<double> on_outline(std::span<double const> weights) const override;

 private:
  explicit SeveralRecordsProblem(fit::SearchBox const& box) : box_(box) {}
  void add(fit::LawOnRecord const& model, double share);

  fit::SearchBox const& box_;
  std::vector<fit::LawOnRecord const*> models_;  // the law on each record whose share in the weighted mean is above 0
  std::vector<double> weights_;
  std::vector<fit::LawOnRecord> thinned_models_;  // the models on fewer samples; outline_ keeps references to them
  std::unique_ptr<SeveralRecordsProblem> outline_;
};

}  // namespace isolaw::analysis
