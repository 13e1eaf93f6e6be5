#include "isolaw/conditions/contrast.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "isolaw/num/statistics.hpp"

namespace isolaw::conditions {
namespace {

using OfDevice = std::map<std::string, std::vector<double>, std::less<>>;

OfDevice by_device(std::span<Sample const> samples) {
  OfDevice values;
  for (auto const& sample : samples) values[sample.device].push_back(sample.ln);
  return values;
}

double condition_of(Effect effect, Condition const& condition) {
  switch (effect) {
    case Effect::temperature:
      return condition.temperature_C.value_or(0.0);
    case Effect::rate:
      return condition.frequency_Hz.value_or(0.0);
    case Effect::load:
      return condition.load_kN.value_or(0.0);
    default:
      return 0.0;
  }
}

Condition with_value(Effect effect, double value) {  // conditions of which only that of the effect is known
  Condition condition;
  (effect == Effect::temperature ? condition.temperature_C
   : effect == Effect::rate      ? condition.frequency_Hz
                                 : condition.load_kN) = value;
  return condition;
}

double sum_of_squares(std::vector<double> const& values) {
  auto const of = num::moments(values);
  return of.std * of.std * static_cast<double>(of.count - 1);
}

}  // namespace

std::string_view name(Status status) {
  switch (status) {
    case Status::shown:
      return "shown";
    case Status::interpolated:
      return "interpolated";
    case Status::extrapolated:
      return "extrapolated";
    case Status::unpaired:
      return "unpaired";
    case Status::scaled:
      return "scaled";
    case Status::assumed:
      return "assumed";
    case Status::not_covered:
      return "not covered";
  }
  return "";
}

std::string_view name(Lack lack) {
  switch (lack) {
    case Lack::no_test:
      return "no-test";
    case Lack::no_design:
      return "no-design";
    case Lack::too_far:
      return "too-far";
    case Lack::no_level:
      return "no-level";
    case Lack::no_energy:
      return "no-energy";
    case Lack::too_long:
      return "too-long";
    case Lack::no_new_device:
      return "no-new-device";
    case Lack::no_rest:
      return "no-rest";
    case Lack::no_cycle:
      return "no-cycle";
    case Lack::unknown_scatter:
      return "unknown-scatter";
  }
  return "";
}

std::string_view name(About about) {
  switch (about) {
    case About::mean:
      return "mean";
    case About::device:
      return "device";
    case About::system:
      return "system";
    case About::prototypes:
      return "prototypes";
  }
  return "";
}

double Level::mean() const {
  return num::moments(lns()).mean;
}

double Level::std() const {
  return ratios.empty() ? 0.0 : num::moments(lns()).std;
}

std::vector<double> Level::lns() const {
  std::vector<double> values;
  for (auto const& ratio : ratios) values.push_back(ratio.ln);
  return values;
}

double Factor::lambda() const {
  return std::exp(ln);
}

std::optional<double> half_width(Factor const& factor, About about, int installed) {
  bool const from_one = factor.devices < 2 && factor.status != Status::unpaired;
  if (!factor.se || (from_one && about != About::mean)) return std::nullopt;
  // The standard error is that of the mean over the devices. The scatter of a single device is sqrt(D) times as large.
  double const D = factor.devices, scatter = *factor.se * std::sqrt(D), N = installed;
  double width = *factor.se;
  if (about == About::device) width = scatter * std::sqrt(1.0 + 1.0 / D);
  if (about == About::system) width = scatter * std::sqrt(std::max(0.0, 1.0 / D - 1.0 / N));
  if (about == About::prototypes) width = scatter * std::sqrt(1.0 / D + 1.0 / N);
  return std::hypot(num::student_97_5(*factor.df) * width, factor.line_error, factor.drift);
}

std::optional<Interval> interval(Factor const& factor, About about, int installed) {
  auto const half = half_width(factor, about, installed);
  if (!half) return std::nullopt;
  return Interval{.low = std::exp(factor.ln - *half), .high = std::exp(factor.ln + *half)};
}

Response::Response(Effect effect, std::span<Sample const> reference, std::span<Sample const> others,
                   Condition const& reference_condition, Tolerance const& tolerance, Status strongest)
    : effect_(effect), tolerance_(tolerance), strongest_(strongest) {
  auto const at_reference = by_device(reference);
  std::vector<double> lot;
  for (auto const& [device, values] : at_reference) lot.push_back(num::moments(values).mean);
  double const lot_std = lot.empty() ? 0.0 : num::moments(lot).std;
  std::vector<Sample> sorted(others.begin(), others.end());
  std::ranges::stable_sort(sorted, {}, [&](Sample const& sample) {
    auto const& ageing = sample.condition.ageing;
    return effect == Effect::ageing && ageing ? std::pair(ageing->at_C, ageing->days)
                                              : std::pair(condition_of(effect, sample.condition), 0.0);
  });
  // A test joins a level if its condition agrees with that of the level's first test.
  std::vector<std::vector<Sample>> clusters;
  for (auto const& sample : sorted) {
    auto const same = std::ranges::find_if(clusters, [&](auto const& cluster) {
      return agree_in(effect, sample.condition, cluster.front().condition, tolerance);
    });
    if (same != clusters.end())
      same->push_back(sample);
    else
      clusters.push_back({sample});
  }
  for (auto const& tests : clusters) {
    Level level{.ageing = effect == Effect::ageing ? tests.front().condition.ageing : std::nullopt,
                .tests = static_cast<int>(tests.size())};
    // The level lies at the mean of the tests of devices with a reference test or, without any, of all tests.
    std::vector<double> at, at_unpaired;
    for (auto const& test : tests)
      (at_reference.contains(test.device) ? at : at_unpaired).push_back(condition_of(effect, test.condition));
    level.at = num::moments(at.empty() ? at_unpaired : at).mean;
    for (auto const& [device, values] : by_device(tests)) {
      auto const own = at_reference.find(device);
      if (own == at_reference.end()) {
        if (std::ranges::find(unpaired_, device) == unpaired_.end()) unpaired_.push_back(device);
        continue;
      }
      level.ratios.push_back({.device = device, .ln = num::moments(values).mean - num::moments(own->second).mean});
      auto const [first, last] = std::pair(own->second.front(), own->second.back());
      if (own->second.size() > 1) drift_ = std::max(drift_.value_or(0.0), std::abs(last - first) / 2.0);
      double const a = static_cast<double>(values.size()), b = static_cast<double>(own->second.size());
      if (a + b > 2.0) {
        double const pooled = std::sqrt((sum_of_squares(values) + sum_of_squares(own->second)) / (a + b - 2.0));
        if (pooled > 0.0) {
          level.replicate_se = pooled * std::sqrt(1.0 / a + 1.0 / b);
          level.replicate_df = a + b - 2.0;
        }
      }
    }
    if (level.ratios.size() != 1) level.replicate_se = level.replicate_df = std::nullopt;
    if (level.ratios.empty()) {
      if (at_reference.empty()) continue;
      level.unpaired_factor = unpaired_factors_.size();
      unpaired_factors_.push_back(unpaired_factor(tests, reference, lot_std, static_cast<int>(lot.size())));
    }
    levels_.push_back(std::move(level));
  }

  if (at_reference.empty()) return;
  Level own{
      .at = condition_of(effect, reference_condition), .reference = true, .tests = static_cast<int>(reference.size())};
  for (auto const& [device, values] : at_reference) own.ratios.push_back({.device = device, .ln = 0.0});
  if (effect == Effect::ageing) {
    levels_.insert(levels_.begin(), std::move(own));
    return;
  }
  levels_.insert(std::ranges::find_if(levels_, [&](Level const& level) { return level.at > own.at; }), std::move(own));
  auto const inner = paired_levels();
  for (std::size_t i = 1; i + 1 < inner.size(); ++i) {
    // Only devices that were tested at the level and on both sides of it are compared.
    std::vector<double> errors;
    for (auto const& ratio : inner[i]->ratios)
      if (auto const line = line_of(ratio.device, inner[i]->at, inner[i]); line && !line->beyond)
        errors.push_back(line->ln - ratio.ln);
    if (!errors.empty()) line_error_ = std::max(line_error_.value_or(0.0), std::abs(num::moments(errors).mean));
  }
}

std::vector<Level const*> Response::paired_levels() const {
  std::vector<Level const*> paired;
  for (auto const& level : levels_)
    if (!level.unpaired_factor) paired.push_back(&level);
  return paired;
}

double Response::abscissa(double condition) const {
  if (effect_ == Effect::rate) return std::log(condition);
  return effect_ == Effect::load ? condition * condition : condition;
}

Factor Response::factor_of(Level const& level) const {
  if (level.unpaired_factor) {
    auto factor = unpaired_factors_[*level.unpaired_factor];
    factor.at = level.at, factor.status = std::max(factor.status, strongest_);
    return factor;
  }
  Factor factor{.at = level.at,
                .ln = level.mean(),
                .status = level.reference ? Status::shown : strongest_,
                .devices = static_cast<int>(level.ratios.size()),
                .std = level.std()};
  if (level.reference) {
    factor.se = 0.0, factor.df = 1.0, factor.std = 0.0, factor.devices = 0;
    return factor;
  }
  factor.drift = drift_.value_or(0.0);
  if (level.ratios.size() > 1) {
    factor.se = factor.std / std::sqrt(static_cast<double>(level.ratios.size()));
    factor.df = static_cast<double>(level.ratios.size() - 1);
  } else {
    factor.se = level.replicate_se, factor.df = level.replicate_df;
  }
  return factor;
}

std::optional<Response::Line> Response::line_of(std::string_view device, double condition,
                                                Level const* left_out) const {
  std::vector<std::pair<Level const*, double>> own;
  for (auto const* level : paired_levels())
    if (auto const ratio = std::ranges::find(level->ratios, device, &DeviceRatio::device);
        level != left_out && ratio != level->ratios.end())
      own.emplace_back(level, ratio->ln);
  if (own.size() < 2) return std::nullopt;
  auto const above = std::ranges::find_if(own, [&](auto const& each) { return each.first->at > condition; });
  bool const beyond = above == own.begin() || above == own.end();
  auto const last = above == own.begin() ? std::next(above) : above == own.end() ? std::prev(above) : above;
  auto const& [second, ln_second] = *last;
  auto const& [first, ln_first] = *std::prev(last);
  double const share = (abscissa(condition) - abscissa(first->at)) / (abscissa(second->at) - abscissa(first->at));
  return Line{.device = device,
              .first = first,
              .second = second,
              .ln = ln_first + share * (ln_second - ln_first),
              .beyond = beyond};
}

bool Response::is_at(Level const& level, Condition const& test) const {
  auto there = with_value(effect_, level.at);
  there.ageing = level.ageing;
  return agree_in(effect_, test, there, tolerance_);
}

Level const* Response::level_at(double condition, bool only_paired) const {
  auto const asked = with_value(effect_, condition);
  std::vector<Level const*> near;
  for (auto const& level : levels_)
    if (is_at(level, asked) && !(only_paired && level.unpaired_factor)) near.push_back(&level);
  if (near.empty()) return nullptr;
  return *std::ranges::min_element(
      near, {}, [&](Level const* level) { return std::abs(abscissa(level->at) - abscissa(condition)); });
}

std::vector<Response::Line> Response::lines_at(double condition) const {
  auto const paired = paired_levels();
  if (paired.size() < 2) return {};
  bool const is_between = condition > paired.front()->at && condition < paired.back()->at;
  auto const* outermost = condition < paired.front()->at ? paired.front() : paired.back();
  if (!is_between) {
    double const edge = outermost->at;
    constexpr double most_K = 10.0, most_times = 2.0, most_of_load = 0.2, rounding = 1e-9;
    double const beyond = effect_ == Effect::temperature ? std::abs(condition - edge) / most_K
                          : effect_ == Effect::rate      ? std::abs(std::log(condition / edge)) / std::log(most_times)
                                                         : std::abs(condition - edge) / (most_of_load * std::abs(edge));
    if (!(beyond <= 1.0 + rounding)) return {};
  }
  std::vector<Line> lines;
  // Every device with a ratio has a reference test, so the reference level lists all these devices.
  for (auto const& ratio : std::ranges::find_if(levels_, &Level::reference)->ratios)
    if (auto const line = line_of(ratio.device, condition, nullptr);
        line && (is_between ? !line->beyond : line->first == outermost || line->second == outermost))
      lines.push_back(*line);
  return lines;
}

Level const* Response::paired_level_at(Condition const& test) const {
  if (effect_ != Effect::ageing) return level_at(condition_of(effect_, test), true);
  auto const found =
      std::ranges::find_if(levels_, [&](Level const& level) { return !level.unpaired_factor && is_at(level, test); });
  return found == levels_.end() ? nullptr : &*found;
}

std::vector<Level const*> Response::behind(std::string_view device, Condition const& test) const {
  if (auto const* level = paired_level_at(test)) return {level};
  if (effect_ == Effect::ageing) return {};
  auto const lines = lines_at(condition_of(effect_, test));
  auto const own = std::ranges::find(lines, device, &Line::device);
  if (own == lines.end()) return {};
  return {own->first, own->second};
}

Factor Response::at(double condition) const {
  return at(condition, false);
}

Factor Response::at(double condition, bool only_paired) const {
  if (auto const* level = level_at(condition, only_paired)) return factor_of(*level);
  auto const lines = lines_at(condition);
  if (lines.empty()) return Factor::not_covered(levels_.size() < 2 ? Lack::no_test : Lack::too_far);
  std::vector<double> values;
  for (auto const& line : lines) values.push_back(line.ln);
  auto const of = num::moments(values);
  auto const status = lines.front().beyond ? Status::extrapolated : Status::interpolated;
  Factor factor{.at = condition,
                .ln = of.mean,
                .status = std::max(status, strongest_),
                .devices = static_cast<int>(values.size()),
                .std = of.std,
                .line_error = line_error_.value_or(0.0),
                .drift = drift_.value_or(0.0)};
  if (values.size() > 1) {
    factor.se = of.std / std::sqrt(static_cast<double>(values.size()));
    factor.df = static_cast<double>(values.size() - 1);
  }
  return factor;
}

Factor Response::at(Ageing const& ageing) const {
  auto const level =
      std::ranges::find_if(levels_, [&](Level const& each) { return each.ageing && agrees(*each.ageing, ageing); });
  return level == levels_.end() ? Factor::not_covered(Lack::no_level) : factor_of(*level);
}

Factor Response::paired_at(Condition const& test) const {
  if (effect_ != Effect::ageing) return at(condition_of(effect_, test), true);
  auto const* level = paired_level_at(test);
  return level == nullptr ? Factor::not_covered(levels_.size() < 2 ? Lack::no_test : Lack::no_level)
                          : factor_of(*level);
}

Response::Extremes Response::over(double low, double high) const {
  std::vector<Factor> all;
  for (auto const& level : levels_)
    if (level.reference || (level.at >= low && level.at <= high)) all.push_back(factor_of(level));
  std::optional<Factor> lacking;
  for (double const end : {low, high}) {
    auto factor = at(end);
    factor.at = end;
    if (factor.status == Status::not_covered && !lacking) lacking = factor;
    all.push_back(factor);
  }
  std::erase_if(all, [](Factor const& factor) { return factor.status == Status::not_covered; });
  if (all.empty()) return {.max = *lacking, .min = *lacking};
  auto const [min, max] = std::ranges::minmax_element(all, {}, &Factor::ln);
  if (!lacking) return {.max = *max, .min = *min};
  auto known_max = *lacking, known_min = *lacking;
  known_max.ln = max->ln, known_min.ln = min->ln;
  return {.max = known_max, .min = known_min};
}

bool Response::is_reference(double condition) const {
  auto const own = std::ranges::find_if(levels_, &Level::reference);
  return own != levels_.end() && is_at(*own, with_value(effect_, condition));
}

Response Response::of_device(std::string_view device) const {
  auto own = *this;
  for (auto& level : own.levels_)
    std::erase_if(level.ratios, [&](DeviceRatio const& ratio) { return ratio.device != device; });
  std::erase_if(own.levels_, [](Level const& level) { return level.ratios.empty(); });
  return own;
}

Factor unpaired_factor(std::span<Sample const> level, std::span<Sample const> reference, double lot_std,
                       int lot_devices) {
  if (lot_devices < 2) return Factor::not_covered(Lack::unknown_scatter);
  std::vector<double> there, here;
  for (auto const& [device, values] : by_device(level)) there.push_back(num::moments(values).mean);
  for (auto const& [device, values] : by_device(reference)) here.push_back(num::moments(values).mean);
  Factor factor{.ln = num::moments(there).mean - num::moments(here).mean,
                .status = Status::unpaired,
                .devices = static_cast<int>(there.size()),
                .std = lot_std};
  factor.se = lot_std * std::sqrt(1.0 / static_cast<double>(there.size()) + 1.0 / static_cast<double>(here.size()));
  factor.df = lot_devices - 1.0;
  return factor;
}

}  // namespace isolaw::conditions
