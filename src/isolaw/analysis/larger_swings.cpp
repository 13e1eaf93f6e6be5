#include "isolaw/analysis/larger_swings.hpp"

#include <algorithm>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/work_ahead.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::analysis {
namespace {

constexpr std::size_t start_count = 8;

// Drops the samples after the last one whose weight is above 0. The law's forces up to that sample do not depend on
// later samples.
data::FitRecord up_to_last_weight(data::FitRecord record) {
  std::size_t size = record.size();
  while (size > 0 && record.weights[size - 1] == 0.0) --size;
  for (auto* values : {&record.time_s, &record.disp_mm, &record.vel_mm_s, &record.force_kN, &record.scored,
                       &record.weights, &record.block})
    if (!values->empty()) values->resize(size);
  return record;
}

}  // namespace

double mean_objective(std::span<fit::LawOnRecord const> models, std::span<double const> parameters) {
  std::vector<double> work;
  double sum = 0.0;
  for (auto const& model : models) sum += model.objective(parameters, work);
  return sum / static_cast<double>(models.size());
}

SwingModels swing_models(laws::LawEntry const& law, std::span<data::FitRecord const> tests,
                         data::SwingSizes const& sizes, laws::Integration integration,
                         laws::TurningPoints turning_points, int refinement) {
  SwingModels models;
  auto const add = [&](std::vector<fit::LawOnRecord>& to, data::FitRecord record, std::vector<double> const& weights) {
    if (weights.empty()) return;
    record.weights = weights;
    try {
      to.emplace_back(law, up_to_last_weight(std::move(record)), integration, turning_points, refinement);
    } catch (Error const&) {
      return;  // nothing to fit: the force is constant during these swings
    }
  };
  for (std::size_t t = 0; t < tests.size(); ++t) {
    add(models.small, tests[t], sizes.tests[t].small);
    add(models.large, tests[t], sizes.tests[t].large);
  }
  return models;
}

std::optional<LargerSwings> predict_larger_swings(SwingModels const& models, fit::SearchBox const& box,
                                                  num::Stream const& stream, Interrupted const& interrupted) {
  auto const judged = [&](std::span<double const> point) {
    LargerSwings end{.parameters = std::vector<double>(box.parameters.size())};
    box.expand(point, end.parameters);
    end.fitted = mean_objective(models.small, end.parameters);
    end.predicted = end.least_predicted = mean_objective(models.large, end.parameters);
    return end;
  };
  auto const tests = static_cast<int>(std::max(models.small.size(), models.large.size()));
  if (box.free_count() == 0) {
    auto result = judged({});
    result.evaluations = tests;
    return result;
  }
  std::vector<fit::LawOnRecord const*> small;
  for (auto const& model : models.small) small.push_back(&model);
  SeveralRecordsProblem const problem(small, box,
                                      std::vector<double>(small.size(), 1.0 / static_cast<double>(small.size())));
  num::Draws draws(stream, 0, 0);
  auto const points = opt::latin_hypercube(problem.dimension(), start_count, draws);
  std::vector<opt::BestPoint> found(start_count);
  WorkAhead descents(start_count, [&](std::size_t i) { found[i] = opt::descend(problem, points[i], 1.0); });
  std::vector<LargerSwings> ends;
  int evaluations = 0;
  for (std::size_t i = 0; i < start_count; ++i) {
    if (interrupted && interrupted()) return std::nullopt;
    descents.need(i);
    evaluations += (found[i].evaluations + 1) * tests;
    if (found[i].usable()) ends.push_back(judged(found[i].best));
  }
  if (ends.empty()) return std::nullopt;
  double const least = std::ranges::min(ends, {}, &LargerSwings::fitted).fitted;
  std::erase_if(ends, [&](auto const& end) { return !(end.fitted <= (1.0 + equally_good_fit) * least); });
  auto result = std::ranges::max(ends, {}, &LargerSwings::predicted);
  result.least_predicted = std::ranges::min(ends, {}, &LargerSwings::predicted).predicted;
  result.evaluations = evaluations;
  return result;
}

}  // namespace isolaw::analysis
