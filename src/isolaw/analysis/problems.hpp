// Problems made of other problems: other weights, one coordinate held, several records at once.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::analysis {

// Asked between the parts of long work; once it says yes, that work is given up.
using Interrupted = std::function<bool()>;

// The same residuals with other weights, which must sum to 1.
class Reweighted final : public opt::DeviationProblem {
 public:
  Reweighted(opt::DeviationProblem const& base, std::vector<double> weights)
      : base_(base), weights_(std::move(weights)) {}
  std::size_t dimension() const override { return base_.dimension(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return weights_; }
  void residuals(opt::Points const& points, std::span<double> values) const override {
    base_.residuals(points, values);
  }

 private:
  opt::DeviationProblem const& base_;
  std::vector<double> weights_;
};

// The problem of the other coordinates where one of them is held.
class Held final : public opt::DeviationProblem {
 public:
  Held(opt::DeviationProblem const& base, std::size_t coordinate, double value)
      : base_(base), coordinate_(coordinate), value_(value) {}
  std::size_t dimension() const override { return base_.dimension() - 1; }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return base_.weights(); }
  void residuals(opt::Points const& points, std::span<double> values) const override;

 private:
  opt::Points with_held(opt::Points const& points) const;

  opt::DeviationProblem const& base_;
  std::size_t coordinate_;
  double value_;
};

// One parameter vector for several records: the weighted mean of their objectives. `shares` sum to 1; a record whose
// share is 0 is not computed.
class Joint final : public opt::DeviationProblem {
 public:
  Joint(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box, std::span<double const> shares);
  std::size_t dimension() const override { return box_.free_count(); }
  void evaluate(opt::Points const& points, std::span<double> values) const override;
  std::span<double const> weights() const override { return weights_; }
  void residuals(opt::Points const& points, std::span<double> values) const override;

 private:
  fit::SearchBox const& box_;
  std::vector<fit::LawOnRecord const*> models_;  // those with a share
  std::vector<double> weights_;
};

}  // namespace isolaw::analysis
