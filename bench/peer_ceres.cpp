// Ceres minimises isolaw's residuals by Levenberg-Marquardt with bounds, from random starts. The objective is a mean of
// absolute values. Ceres needs a smooth function, so the residuals get a soft L1 loss, which rounds the corner of the
// absolute value at zero: over a wide range in a first pass, over a narrow one in a second pass. Ceres asks for
// residuals and derivatives one by one. Before that, isolaw computes all values for a step of Ceres in one batch.
#include <ceres/ceres.h>

#include <algorithm>
#include <memory>

#include "peers.hpp"

namespace isolaw::bench {
namespace {

constexpr double difference = 1e-6;

class Batch final : public ceres::EvaluationCallback {
 public:
  Batch(Watched const& problem, std::vector<double> const& x) : problem_(problem), x_(x) {}

  void PrepareForEvaluation(bool with_derivatives, bool is_new) override {
    std::size_t const n = problem_.dimension(), m = problem_.weights().size();
    if (!is_new && (has_derivatives_ || !with_derivatives)) return;
    std::size_t const count = with_derivatives ? n + 1 : 1;
    opt::Points points(n, count);
    for (std::size_t i = 0; i < count; ++i) std::ranges::copy(x_, points[i].begin());
    for (std::size_t k = 0; k + 1 < count; ++k) points[k + 1][k] += step(k);
    values_.resize(count * m);
    problem_.residuals(points, values_);
    has_derivatives_ = with_derivatives;
  }

  bool evaluate(std::size_t j, double* residual, double* derivatives) const {
    std::size_t const n = problem_.dimension(), m = problem_.weights().size();
    double const scale = problem_.weights()[j] * static_cast<double>(m);
    *residual = scale * values_[j];
    if (!std::isfinite(*residual)) return false;
    for (std::size_t k = 0; derivatives != nullptr && k < n; ++k) {
      double const slope = (values_[(k + 1) * m + j] - values_[j]) / step(k);
      derivatives[k] = std::isfinite(slope) ? scale * slope : 0.0;
    }
    return true;
  }

 private:
  double step(std::size_t k) const { return x_[k] > 0.5 ? -difference : difference; }

  Watched const& problem_;
  std::vector<double> const& x_;
  std::vector<double> values_;
  bool has_derivatives_ = false;
};

class OneResidual final : public ceres::CostFunction {
 public:
  OneResidual(Batch const& batch, std::size_t j, std::size_t n) : batch_(batch), j_(j) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<std::int32_t>(n));
  }
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    return batch_.evaluate(j_, residuals, jacobians != nullptr ? jacobians[0] : nullptr);
  }

 private:
  Batch const& batch_;
  std::size_t j_;
};

class Budget final : public ceres::IterationCallback {
 public:
  Budget(Watched const& problem, int most) : problem_(problem), most_(most) {}
  ceres::CallbackReturnType operator()(ceres::IterationSummary const&) override {
    return problem_.evaluations() >= most_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  Watched const& problem_;
  int most_;
};

void descend(Watched const& problem, std::vector<double>& x, double rounding, int budget) {
  Batch batch(problem, x);
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &batch;
  ceres::Problem sum(problem_options);
  auto const n = problem.dimension();
  for (std::size_t j = 0; j < problem.weights().size(); ++j)
    sum.AddResidualBlock(new OneResidual(batch, j, n), new ceres::SoftLOneLoss(rounding), x.data());
  for (int k = 0; k < static_cast<int>(n); ++k) {
    sum.SetParameterLowerBound(x.data(), k, 0.0);
    sum.SetParameterUpperBound(x.data(), k, 1.0);
  }
  Budget stop(problem, budget);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-8;  // bench/peers/optimum.py gives SciPy the same tolerance
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &sum, &summary);
}

}  // namespace

void search_by_ceres(Watched const& problem, std::uint64_t seed, int budget) {
  for (std::uint32_t start = 0; problem.evaluations() < budget; ++start) {
    num::Draws draws(num::Stream(seed), start, 0);
    std::vector<double> x(problem.dimension());
    for (double& coordinate : x) coordinate = draws.uniform();
    Watched here(problem);  // counts the evaluations of one start
    opt::Points one(problem.dimension(), 1);
    std::ranges::copy(x, one[0].begin());
    std::vector<double> residuals(problem.weights().size());
    here.residuals(one, residuals);
    if (!std::isfinite(here.best_value())) continue;
    for (double const rounding : {0.3, 0.01}) {
      descend(problem, x, rounding * here.best_value(), budget);
      std::ranges::copy(x, one[0].begin());
      here.residuals(one, residuals);
    }
  }
}

}  // namespace isolaw::bench
