#include "isolaw/analysis/one_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/work_ahead.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::analysis {
namespace {

std::vector<double> expanded(fit::SearchBox const& box, std::span<double const> point) {
  std::vector<double> parameters(box.parameters.size());
  box.expand(point, parameters);
  return parameters;
}

OneLaw judged(std::span<fit::LawOnRecord const* const> models, std::vector<double> parameters) {
  OneLaw result;
  result.parameters = std::move(parameters);
  std::vector<double> work;
  for (auto const* model : models) result.objectives.push_back(model->objective(result.parameters, work));
  for (double const objective : result.objectives) {
    result.mean += objective / static_cast<double>(models.size());
    result.worst = std::max(result.worst, objective);
  }
  result.evaluations = static_cast<int>(models.size());
  return result;
}

std::vector<double> equal_shares(std::size_t devices) {
  return std::vector<double>(devices, 1.0 / static_cast<double>(devices));
}

// The median of each coordinate. If the number of points is even, it is the larger of the two middle values.
std::vector<double> median_point(std::span<std::vector<double> const> points) {
  std::vector<double> medians(points.front().size());
  std::vector<double> values(points.size());
  for (std::size_t k = 0; k < medians.size(); ++k) {
    for (std::size_t d = 0; d < points.size(); ++d) values[d] = points[d][k];
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    medians[k] = values[values.size() / 2];
  }
  return medians;
}

// Starts of the search without `device`: the fit to all devices, and the three optima of other devices that have the
// smallest mean objective over all devices except `device`.
std::vector<std::vector<double>> starts_without(SeveralRecordsProblem const& problem, fit::SearchBox const& box,
                                                std::span<double const> parameters_of_all,
                                                std::span<std::vector<double> const> optima, std::size_t device) {
  constexpr std::size_t most_optima = 3;
  std::vector<std::vector<double>> starts{box.contract(parameters_of_all)};
  opt::Points points(problem.dimension(), optima.size());
  for (std::size_t d = 0; d < optima.size(); ++d) std::ranges::copy(box.contract(optima[d]), points[d].begin());
  std::vector<double> values(optima.size());
  problem.evaluate(points, values);
  std::vector<std::size_t> order;
  for (std::size_t d = 0; d < optima.size(); ++d)
    if (d != device) order.push_back(d);
  std::ranges::stable_sort(order, {}, [&](std::size_t d) { return values[d]; });
  for (std::size_t i = 0; i < std::min(most_optima, order.size()); ++i)
    starts.emplace_back(points[order[i]].begin(), points[order[i]].end());
  return starts;
}

}  // namespace

fit::SearchBox common_box(std::span<fit::SearchBox const* const> boxes) {
  auto result = *boxes.front();
  for (auto const* box : boxes)
    for (std::size_t i = 0; i < result.parameters.size(); ++i) {
      auto& p = result.parameters[i];
      auto const& q = box->parameters[i];
      if (p.free != q.free || p.tied_to != q.tied_to || (!p.free && p.value != q.value))
        throw Error({.where = fmt::format("the law of the lot, parameter {}", p.name),
                     .found = "fixed or tied differently on different devices",
                     .allowed = "the same parameters free, and the others alike, on all devices"});
      p.lower = std::min(p.lower, q.lower);
      p.upper = std::max(p.upper, q.upper);
      if (p.scale != q.scale) p.scale = laws::Scale::linear;
    }
  return result;
}

std::optional<OneLaw> least_mean(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                 std::span<std::vector<double> const> optima, Interrupted const& interrupted) {
  if (box.free_count() == 0) return judged(models, expanded(box, {}));
  constexpr std::size_t most_starts = 12;
  SeveralRecordsProblem const problem(models, box, equal_shares(models.size()));
  std::vector<std::vector<double>> points;
  for (auto const& optimum : optima) points.push_back(box.contract(optimum));
  std::vector<std::vector<double>> starts{median_point(points)};
  std::size_t const used = std::min(most_starts, points.size());
  for (std::size_t i = 0; i < used; ++i) starts.push_back(points[i * points.size() / used]);

  opt::BestPoint best;
  int evaluations = 0;
  std::vector<opt::BestPoint> ends(starts.size());
  WorkAhead descents(starts.size(), [&](std::size_t i) { ends[i] = opt::descend(problem, starts[i], 1.0); });
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (interrupted && interrupted()) return std::nullopt;
    descents.need(i);
    evaluations += ends[i].evaluations;
    if (ends[i].best_value < best.best_value) best = std::move(ends[i]);
  }
  if (!best.usable()) return std::nullopt;
  auto result = judged(models, expanded(box, best.best));
  result.evaluations += evaluations * static_cast<int>(models.size());
  return result;
}

std::optional<LeastWorst> least_worst(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                      OneLaw const& mean, Interrupted const& interrupted) {
  constexpr int rounds = 40;
  constexpr double near = 1e-3;
  LeastWorst best{.law = mean, .bound = mean.mean};
  best.law.evaluations = 0;
  if (box.free_count() == 0 || models.size() < 2) return best;
  auto shares = equal_shares(models.size());
  auto current = mean;
  double pull = 4.0;
  int evaluations = 0;
  for (int round = 0; round < rounds && best.law.worst > best.bound * (1.0 + near); ++round) {
    if (interrupted && interrupted()) return std::nullopt;
    double sum = 0.0;
    for (std::size_t d = 0; d < shares.size(); ++d)
      sum += shares[d] *= std::exp(pull * (current.objectives[d] / current.worst - 1.0));
    for (double& share : shares) share /= sum;
    // Keeps a small share for every device, so that a device that was fitted well can gain weight again.
    for (double& share : shares) share = 0.999 * share + 0.001 / static_cast<double>(shares.size());
    SeveralRecordsProblem const problem(models, box, shares);
    auto const found = opt::descend(problem, box.contract(current.parameters), 0.3);
    evaluations += found.evaluations * static_cast<int>(models.size());
    if (!found.usable()) break;
    current = judged(models, expanded(box, found.best));
    evaluations += current.evaluations;
    best.bound = std::max(best.bound, found.best_value);
    if (current.worst < best.law.worst)
      best.law = current;
    else
      pull *= 0.7;
  }
  best.bound = std::min(best.bound, best.law.worst);
  best.law.evaluations = evaluations;
  return best;
}

std::optional<LeftOutFit> leave_out(std::span<fit::LawOnRecord const* const> models, fit::SearchBox const& box,
                                    std::span<double const> parameters_of_all,
                                    std::span<std::vector<double> const> optima, std::size_t device) {
  LeftOutFit result;
  result.parameters.assign(parameters_of_all.begin(), parameters_of_all.end());
  std::vector<double> shares(models.size(), 1.0 / static_cast<double>(models.size() - 1));
  shares[device] = 0.0;
  if (box.free_count() > 0) {
    SeveralRecordsProblem const problem(models, box, shares);
    opt::BestPoint best;
    int evaluations = 0;
    for (auto const& start : starts_without(problem, box, parameters_of_all, optima, device)) {
      auto found = opt::descend(problem, start, 0.3);
      evaluations += found.evaluations;
      if (found.best_value < best.best_value) best = std::move(found);
    }
    result.evaluations = (evaluations + static_cast<int>(optima.size())) * static_cast<int>(models.size() - 1);
    if (!best.usable()) return std::nullopt;
    result.parameters = expanded(box, best.best);
  }
  std::vector<double> work;
  result.objective = models[device]->objective(result.parameters, work);
  ++result.evaluations;
  return result;
}

}  // namespace isolaw::analysis
