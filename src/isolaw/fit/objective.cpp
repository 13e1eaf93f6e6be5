#include "isolaw/fit/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/fit/kernel_time.hpp"
#include "isolaw/num/row_kernels.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::fit {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> in_unit(std::vector<double> values, double unit) {
  for (double& v : values) v /= unit;
  return values;
}

std::vector<double> at_samples(std::vector<double> const& values, std::span<std::size_t const> samples) {
  std::vector<double> kept_values;
  if (values.empty()) return kept_values;
  kept_values.reserve(samples.size());
  for (std::size_t const i : samples) kept_values.push_back(values[i]);
  return kept_values;
}

// Divides the weight of each dropped sample between the kept samples before and after it; the nearer one gets more. A
// weighted sum stays the same if the values at dropped samples lie on straight lines between those at kept ones.
std::vector<double> shared_among(std::span<std::size_t const> kept, std::span<double const> shares) {
  std::vector<double> kept_shares(kept.size(), 0.0);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    kept_shares[k] += shares[kept[k]];
    if (k + 1 == kept.size()) break;
    auto const gap = static_cast<double>(kept[k + 1] - kept[k]);
    for (std::size_t i = kept[k] + 1; i < kept[k + 1]; ++i) {
      double const nearness = static_cast<double>(i - kept[k]) / gap;
      kept_shares[k] += (1.0 - nearness) * shares[i];
      kept_shares[k + 1] += nearness * shares[i];
    }
  }
  return kept_shares;
}

// The weights of the samples. Their sum is 1 if `total` is not 0. Samples that are not scored (FitRecord::scored) have
// the weight 0.
struct Weights {
  std::vector<double> weight;
  // Sum of the weights before they were scaled to the sum 1. For weights by time it is the duration [s] of the part
  // that is scored.
  double total = 0.0;
};
// Trapezoidal weights in time. Only intervals between two scored samples count.
Weights time_weights(data::FitRecord const& record) {
  auto const& t = record.time_s;
  Weights result{.weight = std::vector<double>(t.size(), 0.0)};
  for (std::size_t i = 1; i < t.size(); ++i) {
    if (!record.is_scored(i - 1) || !record.is_scored(i)) continue;
    result.weight[i - 1] += 0.5 * (t[i] - t[i - 1]);
    result.weight[i] += 0.5 * (t[i] - t[i - 1]);
    result.total += t[i] - t[i - 1];
  }
  // t.back() - t.front() is exact; a sum of many small intervals is not.
  if (record.scored.empty() && t.size() > 1) result.total = t.back() - t.front();
  for (double& w : result.weight) w /= result.total;
  return result;
}
// Uses time_weights() for a record without weights of its own. A record's own weights belong to samples, not to
// intervals: a sample at the edge of the scored part keeps all of its weight, although half of it may stand for the
// interval outside the scored part.
Weights weights_of(data::FitRecord const& record) {
  if (record.weights.empty()) return time_weights(record);
  Weights result{.weight = record.weights};
  for (std::size_t i = 0; i < result.weight.size(); ++i) {
    if (!record.is_scored(i)) result.weight[i] = 0.0;
    result.total += result.weight[i];
  }
  for (double& w : result.weight) w /= result.total;
  return result;
}

std::vector<double> scored_values(data::FitRecord const& record, std::vector<double> const& values) {
  if (record.scored.empty()) return values;
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (record.is_scored(i)) kept.push_back(values[i]);
  return kept;
}

// The standard deviation of the scored values, with the record's weights if it has any.
double spread_of(data::FitRecord const& record, std::vector<double> const& values, Weights const& weights) {
  if (record.weights.empty()) return num::population_std(scored_values(record, values));
  double mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) mean += weights.weight[i] * values[i];
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const off = values[i] - mean;
    variance += weights.weight[i] * off * off;
  }
  return std::sqrt(variance);
}

// Refuses tests of fewer than two samples or without duration, weights that are not finite, a constant force, and
// records in which no scored sample has a weight. For these the objective would be undefined or arbitrary. Returns the
// number of tests in which scored samples have a weight.
std::size_t require_something_to_fit(laws::LawInfo const& law, std::span<data::FitRecord const> tests) {
  std::size_t count = 0, number = 0;
  auto const refuse = [&](std::string found, std::string allowed) {
    auto where = "law " + std::string(law.id);
    if (number > 0 && tests.size() > 1) where += fmt::format(", test {} of {}", number, tests.size());
    throw Error({.where = std::move(where), .found = std::move(found), .allowed = std::move(allowed)});
  };
  for (auto const& test : tests) {
    ++number;
    if (test.size() < 2) refuse("a record of " + counted(test.size(), "sample"), "a record of two samples or more");
    auto whole = test;
    whole.scored.clear();
    double const duration = time_weights(whole).total;
    if (!(duration > 0.0 && std::isfinite(duration)))
      refuse(fmt::format("a record that lasts {} s", duration), "times that increase");
    auto const weights = weights_of(test);
    if (weights.total == 0.0) continue;
    ++count;
    if (!std::isfinite(weights.total)) refuse("weights that are not finite", "finite weights");
    double largest = 0.0;
    for (double const force : scored_values(test, test.force_kN)) largest = std::max(largest, std::abs(force));
    double const spread = spread_of(test, test.force_kN, weights);
    // A standard deviation below 1e-12 of the largest force is only rounding.
    if (!(spread > 1e-12 * largest && std::isfinite(spread)))
      refuse(
          fmt::format("the measured force has a standard deviation of {} kN about its mean, its largest size is {} kN",
                      spread, largest),
          "a force that changes during the test");
  }
  number = 0;  // the message of a refusal below names no single test
  if (count == 0)
    refuse("no sample that counts in the objective", "a part of the test in which time goes on and the device swings");
  return count;
}

std::string rate_independent_laws() {
  std::vector<std::string_view> ids;
  for (auto const& law : laws::catalogue())
    if (law.info.traits.rate_independent) ids.push_back(law.info.id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

LawOnMotion::LawOnMotion(laws::LawEntry const& law, data::FitRecord const& motion, laws::Integration integration,
                         laws::TurningPoints turning_points, int refinement)
    : law_(&law),
      integration_(integration),
      turning_points_(turning_points),
      refinement_(refinement),
      time_s_(motion.time_s) {
  if (!law.info.traits.rate_independent && !motion.has_time())
    throw Error({.where = "law " + std::string(law.info.id),
                 .found = "the record has no time channel, and this law depends on velocity",
                 .allowed = fmt::format("rate-independent laws ({}) without time", rate_independent_laws()),
                 .advice = "--dt SECONDS, the sampling interval of the test"});
  if (motion.size() == 0)
    throw Error({.where = "law " + std::string(law.info.id),
                 .found = "a history of 0 samples",
                 .allowed = "a history with samples"});
  x_ = motion.disp_mm;
  if (law.info.traits.remembers)
    for (auto const& range : data::test_ranges(motion.starts, motion.size()))
      std::ranges::copy(laws::followed(range.slice(motion.disp_mm), motion.dead_band_mm),
                        x_.begin() + static_cast<std::ptrdiff_t>(range.first));
  x_ = in_unit(std::move(x_), law.info.length.in_record_units);
  v_ = in_unit(motion.vel_mm_s, law.info.length.in_record_units);
  make_tests(data::test_ranges(motion.starts, motion.size()));
}

LawOnMotion LawOnMotion::refined(int refinement) const {
  std::vector<data::TestRange> ranges;
  for (auto const& test : tests_) ranges.push_back(test.samples);
  LawOnMotion result = *this;
  result.refinement_ = refinement;
  result.make_tests(ranges);
  return result;
}

void LawOnMotion::make_tests(std::span<data::TestRange const> ranges) {
  tests_.clear();
  for (auto const& range : ranges) {
    std::span<double const> const x = range.slice(x_), v = range.slice(v_), t = range.slice(time_s_);
    bool const remembers = law_->info.traits.remembers;
    tests_.push_back({range, turning_points_ == laws::TurningPoints::interpolated
                                 ? laws::make_path_with_turning_points(x, v, t, refinement_, remembers)
                                 : laws::make_path(x, v, refinement_, remembers)});
  }
}

std::vector<std::size_t> LawOnMotion::outline() const {
  // Keeps more samples just after a reversal, where the loop bends most, because the bend decides which minimum a
  // descent finds. The distance between kept samples is a sixth of the distance from the reversal, at most 8 samples.
  // With every third sample instead, half as many descents find the best minimum of the law abe.
  constexpr std::size_t distance_per_gap = 6, widest_gap = 8;
  std::vector<std::size_t> samples;
  for (auto const& [range, path] : tests_) {
    auto const reverses = [&, range = range](std::size_t i) {
      return i > range.first && i + 1 < range.end && (x_[i] - x_[i - 1]) * (x_[i + 1] - x_[i]) <= 0.0;
    };
    std::size_t last = range.first, reversal = range.first;
    for (std::size_t i = range.first; i < range.end; ++i) {
      if (reverses(i)) reversal = i;
      bool const marked = i == reversal || i + 1 == range.end || reverses(i + 1);
      if (!marked && i - last < std::clamp<std::size_t>((i - reversal) / distance_per_gap, 1, widest_gap)) continue;
      samples.push_back(last = i);
    }
  }
  return samples;
}

LawOnMotion LawOnMotion::at(std::span<std::size_t const> samples) const {
  LawOnMotion result = *this;
  result.time_s_ = at_samples(time_s_, samples);
  result.x_ = at_samples(x_, samples);
  result.v_ = at_samples(v_, samples);
  std::vector<data::TestRange> ranges;
  auto const place = [&](std::size_t sample) {
    return static_cast<std::size_t>(std::ranges::lower_bound(samples, sample) - samples.begin());
  };
  for (auto const& test : tests_) ranges.push_back({place(test.samples.first), place(test.samples.end)});
  result.make_tests(ranges);
  return result;
}

void LawOnMotion::evaluate(std::span<double const> parameters, std::span<double> force) const {
  for (auto const& test : tests_) law_->evaluate(parameters, test.path, integration_, test.samples.slice(force));
}

void LawOnMotion::force_kN(std::span<double const> parameters, std::span<double> force) const {
  evaluate(parameters, force);
  for (double& f : force) f *= law_->info.force.in_record_units;
}

std::vector<double> LawOnMotion::force_kN(std::span<double const> parameters) const {
  std::vector<double> force(x_.size());
  force_kN(parameters, force);
  return force;
}

LawOnRecord::LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration,
                         laws::TurningPoints turning_points, int refinement)
    : motion_(law, record, integration, turning_points, refinement) {
  auto const tests = data::tests_of(record);
  auto const count = static_cast<double>(require_something_to_fit(law.info, tests));
  measured_ = in_unit(record.force_kN, law.info.force.in_record_units);
  for (std::size_t t = 0; t < tests.size(); ++t) {
    auto const weights = weights_of(tests[t]);
    bool const counts = weights.total > 0.0;
    for (double const w : weights.weight) share_.push_back(counts ? w / count : 0.0);
    auto const range = motion_.tests()[t].samples.slice(measured_);
    spread_.push_back(counts ? spread_of(tests[t], std::vector(range.begin(), range.end()), weights) : 1.0);
  }
  weigh();
}

void LawOnRecord::weigh() {
  weight_ = share_;
  for (std::size_t t = 0; t < spread_.size(); ++t)
    for (double& w : motion_.tests()[t].samples.slice(std::span(weight_))) w /= spread_[t];
}

std::vector<double> LawOnRecord::spreads_kN() const {
  std::vector<double> spreads(samples());
  for (std::size_t t = 0; t < spread_.size(); ++t)
    std::ranges::fill(motion_.tests()[t].samples.slice(std::span(spreads)),
                      spread_[t] * law().info.force.in_record_units);
  return spreads;
}

LawOnRecord LawOnRecord::refined(int refinement) const {
  LawOnRecord result = *this;
  result.motion_ = motion_.refined(refinement);
  return result;
}

std::optional<LawOnRecord> LawOnRecord::outline() const {
  bool const steps_are_samples = motion_.integration() == laws::Integration::paper && law().info.traits.path_integrated;
  auto const kept = motion_.outline();
  if (steps_are_samples || 4 * kept.size() > 3 * samples()) return std::nullopt;
  LawOnRecord result = *this;
  result.motion_ = motion_.at(kept);
  result.measured_ = at_samples(measured_, kept);
  result.share_ = shared_among(kept, share_);
  result.weigh();
  return result;
}

std::vector<double> LawOnRecord::on_outline(std::span<double const> shares) const {
  return shared_among(motion_.outline(), shares);
}

double LawOnRecord::misfit(std::vector<double> const& force) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < measured_.size(); ++i) sum += weight_[i] * std::abs(measured_[i] - force[i]);
  return std::isfinite(sum) ? sum : infinite;
}

double LawOnRecord::objective(std::span<double const> parameters, std::vector<double>& work) const {
  work.resize(measured_.size());
  KernelTimer const timer;
  motion_.evaluate(parameters, work);
  return misfit(work);
}

void LawOnRecord::objectives(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                             std::span<double> values, InstructionSet set) const {
  std::size_t const dimension = law().parameters.size();
  std::vector<double> one(dimension);
  if (set == InstructionSet::scalar) {
    std::vector<double> force;
    for (std::size_t i = 0; i < count; ++i) {
      candidate(i, one);
      values[i] = objective(one, force);
    }
    return;
  }
  auto const code = kernel(set, law().index);
  std::vector<double> block(dimension * wide_block);
  std::array<double, wide_block> sums{}, of_test{};
  for (std::size_t first = 0; first < count;) {
    std::size_t const left = count - first, width = left > 2 * narrow_block ? wide_block : narrow_block;
    std::size_t const used = std::min(left, width);
    std::array<bool, wide_block> usable{};
    for (std::size_t lane = 0; lane < width; ++lane) {
      // Lanes without a candidate of their own repeat the first one of the block. Their results are not used.
      candidate(lane < used ? first + lane : first, one);
      usable[lane] = std::ranges::all_of(one, [](double value) { return std::isfinite(value); });
      for (std::size_t p = 0; p < dimension; ++p) block[p * width + lane] = one[p];
    }
    {
      KernelTimer const timer;
      sums.fill(0.0);
      for (auto const& test : motion_.tests()) {
        KernelRecord const record{test.path, test.samples.slice(measured_), test.samples.slice(weight_)};
        (width == wide_block ? code.wide : code.narrow)(block.data(), record, motion_.integration(), of_test.data());
        for (std::size_t lane = 0; lane < width; ++lane) sums[lane] += of_test[lane];
      }
    }
    for (std::size_t lane = 0; lane < used; ++lane)
      values[first + lane] = usable[lane] && std::isfinite(sums[lane]) ? sums[lane] : infinite;
    first += used;
  }
}

void LawOnRecord::residual_rows(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                                std::size_t stride, std::span<double> rows, InstructionSet set) const {
  std::size_t const dimension = law().parameters.size(), samples = measured_.size();
  std::vector<double> one(dimension);
  if (set == InstructionSet::scalar) {
    std::vector<double> force(samples);
    for (std::size_t i = 0; i < count; ++i) {
      candidate(i, one);
      {
        KernelTimer const timer;
        motion_.evaluate(one, force);
      }
      for (std::size_t t = 0; t < spread_.size(); ++t)
        for (auto j = motion_.tests()[t].samples.first; j < motion_.tests()[t].samples.end; ++j)
          rows[j * stride + i] = (measured_[j] - force[j]) / spread_[t];
    }
    for (std::size_t i = count; i < num::padded(count); ++i)
      for (std::size_t j = 0; j < samples; ++j) rows[j * stride + i] = 0.0;
    return;
  }
  auto const code = kernel(set, law().index);
  std::vector<double> block(dimension * residual_block);
  for (std::size_t first = 0; first < count;) {
    bool const wide = count - first > narrow_block;
    std::size_t const width = wide ? residual_block : narrow_block, used = std::min(count - first, width);
    for (std::size_t lane = 0; lane < width; ++lane) {
      candidate(lane < used ? first + lane : first, one);
      for (std::size_t p = 0; p < dimension; ++p) block[p * width + lane] = one[p];
    }
    KernelTimer const timer;
    for (std::size_t t = 0; t < spread_.size(); ++t) {
      auto const& [range, path] = motion_.tests()[t];
      (wide ? code.residuals : code.narrow_residuals)(block.data(), path, motion_.integration(),
                                                      range.slice(measured_).data(), 1.0 / spread_[t],
                                                      rows.data() + range.first * stride + first, stride);
    }
    first += used;
  }
}

void LawOnRecord::residuals(std::size_t count, std::function<void(std::size_t, std::span<double>)> const& candidate,
                            std::span<double> values, InstructionSet set) const {
  std::size_t const stride = num::padded(count), samples = measured_.size();
  std::vector<double> rows(stride * samples);
  residual_rows(count, candidate, stride, rows, set);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < samples; ++j) values[i * samples + j] = rows[j * stride + i];
}

double LawOnRecord::integration_shift(std::span<double const> parameters) const {
  if (!law().info.traits.path_integrated) return 0.0;
  std::vector<double> force;
  double const here = objective(parameters, force);
  auto const fine = motion_.refined(shift_refinement * refinement());
  KernelTimer const timer;
  for (auto const& test : fine.tests())
    law().evaluate(parameters, test.path, laws::Integration::converged, test.samples.slice(std::span(force)));
  return std::abs(misfit(force) - here);
}

double objective_on(data::FitRecord const& record, std::span<double const> force_kN, std::vector<double> scored) {
  auto part = record;
  part.scored = std::move(scored);
  double mean = 0.0, count = 0.0;
  auto const ranges = data::test_ranges(record.starts, record.size());
  auto const tests = data::tests_of(part);
  for (std::size_t t = 0; t < tests.size(); ++t) {
    auto const weights = weights_of(tests[t]);
    if (!(weights.total > 0.0)) continue;
    double const spread = spread_of(tests[t], tests[t].force_kN, weights);
    double sum = 0.0;
    auto const computed = ranges[t].slice(force_kN);
    for (std::size_t i = 0; i < weights.weight.size(); ++i)
      if (tests[t].is_scored(i)) sum += weights.weight[i] * std::abs(tests[t].force_kN[i] - computed[i]);
    mean += spread > 0.0 ? sum / spread : std::nan("");
    count += 1.0;
  }
  return count > 0.0 ? mean / count : std::nan("");
}

IdentificationProblem::IdentificationProblem(LawOnRecord const& model, SearchBox const& box)
    : model_(model), box_(box), thinned_model_(model.outline()) {
  if (thinned_model_) outline_.reset(new IdentificationProblem(*thinned_model_, box, WithoutOutline()));
}

void IdentificationProblem::evaluate(opt::Points const& points, std::span<double> values) const {
  model_.objectives(
      points.size(), [&](std::size_t i, std::span<double> parameters) { box_.expand(points[i], parameters); }, values);
}

void IdentificationProblem::residual_rows(opt::Points const& points, std::size_t stride, std::span<double> rows) const {
  model_.residual_rows(
      points.size(), [&](std::size_t i, std::span<double> parameters) { box_.expand(points[i], parameters); }, stride,
      rows);
}

void IdentificationProblem::residuals(opt::Points const& points, std::span<double> values) const {
  model_.residuals(
      points.size(), [&](std::size_t i, std::span<double> parameters) { box_.expand(points[i], parameters); }, values);
}

}  // namespace isolaw::fit
