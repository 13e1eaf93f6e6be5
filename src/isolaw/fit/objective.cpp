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

// Adds the weight of each dropped sample to the kept samples before and after it, more to the nearer one. Weighted sums
// stay the same if dropped values lie on the lines between kept ones.
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

// The weights of the samples, with the sum 1 if the total is not 0. Samples that are not scored have none.
struct Weights {
  std::vector<double> weight;
  double total = 0.0;  // by time: the duration of the scored part
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
// By time an interval counts if both of its ends are scored. A record's own weights belong to samples, so a sample at
// the edge of the scored part keeps the half of the interval outside it.
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

// Refuses records without duration, with weights by which no scored sample counts, or with a constant force. For these
// the objective would be arbitrary.
void require_something_to_fit(laws::LawInfo const& law, data::FitRecord const& record) {
  auto const refuse = [&](std::string found, std::string allowed) {
    throw Error({.where = "law " + std::string(law.id), .found = std::move(found), .allowed = std::move(allowed)});
  };
  if (record.size() < 2) refuse("a record of " + counted(record.size(), "sample"), "a record of two samples or more");
  double const duration = time_weights(record).total;
  if (!(duration > 0.0 && std::isfinite(duration)))
    refuse(fmt::format("a record that lasts {} s", duration), "times that increase");
  auto const weights = weights_of(record);
  if (!(weights.total > 0.0 && std::isfinite(weights.total)))
    refuse("samples of which none counts with the weights asked for", "a part of the test in which the device swings");
  double largest = 0.0;
  for (double const force : scored_values(record, record.force_kN)) largest = std::max(largest, std::abs(force));
  double const spread = spread_of(record, record.force_kN, weights);
  // A standard deviation below 1e-12 of the largest force is only rounding.
  if (!(spread > 1e-12 * largest && std::isfinite(spread)))
    refuse(fmt::format("the measured force has a standard deviation of {} kN about its mean, its largest size is {} kN",
                       spread, largest),
           "a force that changes during the test");
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
  x_ = in_unit(law.info.traits.remembers ? laws::followed(motion.disp_mm, motion.dead_band_mm) : motion.disp_mm,
               law.info.length.in_record_units);
  v_ = in_unit(motion.vel_mm_s, law.info.length.in_record_units);
  path_ = path(refinement_);
}

LawOnMotion LawOnMotion::refined(int refinement) const {
  LawOnMotion result = *this;
  result.refinement_ = refinement;
  result.path_ = path(refinement);
  return result;
}

laws::Path LawOnMotion::path(int refinement) const {
  return turning_points_ == laws::TurningPoints::interpolated
             ? laws::make_path_with_turning_points(x_, v_, time_s_, refinement, law_->info.traits.remembers)
             : laws::make_path(x_, v_, refinement, law_->info.traits.remembers);
}

std::vector<std::size_t> LawOnMotion::outline() const {
  // Keeps more samples just after a reversal, where the loop bends most, because the bend decides which minimum a
  // descent finds. The distance between kept samples is a sixth of the distance from the reversal, at most 8 samples.
  // With every third sample instead, half as many descents find the best minimum of the law abe.
  constexpr std::size_t distance_per_gap = 6, widest_gap = 8;
  std::vector<std::size_t> samples;
  auto const reverses = [&](std::size_t i) {
    return i > 0 && i + 1 < x_.size() && (x_[i] - x_[i - 1]) * (x_[i + 1] - x_[i]) <= 0.0;
  };
  std::size_t last = 0, reversal = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (reverses(i)) reversal = i;
    bool const marked = i == reversal || i + 1 == x_.size() || reverses(i + 1);
    if (!marked && i - last < std::clamp<std::size_t>((i - reversal) / distance_per_gap, 1, widest_gap)) continue;
    samples.push_back(last = i);
  }
  return samples;
}

LawOnMotion LawOnMotion::at(std::span<std::size_t const> samples) const {
  LawOnMotion result = *this;
  result.time_s_ = at_samples(time_s_, samples);
  result.x_ = at_samples(x_, samples);
  result.v_ = at_samples(v_, samples);
  result.path_ = result.path(refinement_);
  return result;
}

void LawOnMotion::force_kN(std::span<double const> parameters, std::span<double> force) const {
  law_->evaluate(parameters, path_, integration_, force);
  for (double& f : force) f *= law_->info.force.in_record_units;
}

std::vector<double> LawOnMotion::force_kN(std::span<double const> parameters) const {
  std::vector<double> force(path_.samples());
  force_kN(parameters, force);
  return force;
}

LawOnRecord::LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration,
                         laws::TurningPoints turning_points, int refinement)
    : motion_(law, record, integration, turning_points, refinement) {
  require_something_to_fit(law.info, record);
  measured_ = in_unit(record.force_kN, law.info.force.in_record_units);
  auto const weights = weights_of(record);
  share_ = weight_ = weights.weight;
  spread_ = spread_of(record, measured_, weights);
  for (double& w : weight_) w /= spread_;
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
  result.weight_ = result.share_ = shared_among(kept, share_);
  for (double& w : result.weight_) w /= spread_;
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
  law().evaluate(parameters, motion_.path(), motion_.integration(), work);
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
  KernelRecord const record{motion_.path(), measured_, weight_};
  std::vector<double> block(dimension * wide_block);
  std::array<double, wide_block> sums{};
  for (std::size_t first = 0; first < count;) {
    std::size_t const left = count - first, width = left > 2 * narrow_block ? wide_block : narrow_block;
    std::size_t const used = std::min(left, width);
    std::array<bool, wide_block> usable{};
    for (std::size_t lane = 0; lane < width; ++lane) {
      candidate(lane < used ? first + lane : first, one);  // an incomplete block repeats its first candidate
      usable[lane] = std::ranges::all_of(one, [](double value) { return std::isfinite(value); });
      for (std::size_t p = 0; p < dimension; ++p) block[p * width + lane] = one[p];
    }
    {
      KernelTimer const timer;
      (width == wide_block ? code.wide : code.narrow)(block.data(), record, motion_.integration(), sums.data());
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
        law().evaluate(one, motion_.path(), motion_.integration(), force);
      }
      for (std::size_t j = 0; j < samples; ++j) rows[j * stride + i] = (measured_[j] - force[j]) / spread_;
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
    (wide ? code.residuals : code.narrow_residuals)(block.data(), motion_.path(), motion_.integration(),
                                                    measured_.data(), 1.0 / spread_, rows.data() + first, stride);
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
  auto const fine = motion_.path(shift_refinement * refinement());
  KernelTimer const timer;
  law().evaluate(parameters, fine, laws::Integration::converged, force);
  return std::abs(misfit(force) - here);
}

double objective_on(data::FitRecord const& record, std::span<double const> force_kN, std::vector<double> scored) {
  data::FitRecord part{.time_s = record.time_s,
                       .disp_mm = record.disp_mm,
                       .vel_mm_s = {},
                       .force_kN = record.force_kN,
                       .scored = std::move(scored),
                       .weights = record.weights,
                       .cleaning = {}};
  auto const weights = weights_of(part);
  double const spread = spread_of(part, part.force_kN, weights);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.weight.size(); ++i)
    if (part.is_scored(i)) sum += weights.weight[i] * std::abs(record.force_kN[i] - force_kN[i]);
  return weights.total > 0.0 && spread > 0.0 ? sum / spread : std::nan("");
}

IdentificationProblem::IdentificationProblem(LawOnRecord const& model, SearchBox const& box)
    : model_(model), box_(box), fewer_(model.outline()) {
  if (fewer_) outline_.reset(new IdentificationProblem(*fewer_, box, WithoutOutline()));
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
