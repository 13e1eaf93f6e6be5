#include "isolaw/rules/lot_view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "isolaw/base/error.hpp"
#include "isolaw/base/number_text.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/num/tolerance_factor.hpp"

namespace isolaw::rules {
namespace {

constexpr double normal_95 = 1.6448536269514722;  // quantile of the normal distribution for a one-sided 95 %
constexpr double property_error = 0.005;          // relative error of a property that one record gives

struct Values {
  std::vector<std::string> names;
  std::vector<double> values;
  std::vector<std::string> devices_without_value;
  std::vector<std::string> usual_names, other_names;  // see DeviceValues::at_usual_amplitude
  std::vector<double> usual_values;
};

std::size_t without_copies(std::span<DeviceValues const> devices) {
  return static_cast<std::size_t>(std::ranges::count_if(devices, &std::string::empty, &DeviceValues::copy_of));
}

Values collect(RuleSet const& rules, Quantity quantity, std::span<DeviceValues const> devices) {
  Values collected;
  for (auto const& device : devices) {
    // A copied shear record does not affect the compression test, which gives K_v.
    if (quantity != Quantity::K_v && !device.copy_of.empty()) continue;
    if (auto const value = device_value(rules, quantity, device.block)) {
      collected.names.push_back(device.name);
      collected.values.push_back(*value);
      bool const usual = device.at_usual_amplitude || quantity == Quantity::K_v;
      (usual ? collected.usual_names : collected.other_names).push_back(device.name);
      if (usual) collected.usual_values.push_back(*value);
    } else {
      collected.devices_without_value.push_back(device.name);
    }
  }
  return collected;
}

std::string no_lower_bound(double half_width_percent) {
  return fmt::format("too few devices for a lower bound: {:.0f} % of the mean below it is no positive value",
                     half_width_percent);
}

}  // namespace

std::string_view name(BoundScope scope) {
  return scope == BoundScope::contract ? "contract" : scope == BoundScope::device ? "device" : "system";
}

namespace {

void describe_spread(Values const& found, LotQuantity& view) {
  auto const moments = num::moments(found.values);
  auto const [low, high] = std::ranges::minmax_element(found.values);
  auto const device = [&](auto it) { return found.names[static_cast<std::size_t>(it - found.values.begin())]; };
  view.mean = moments.mean;
  view.min = *low;
  view.max = *high;
  view.min_device = device(low);
  view.max_device = device(high);
  if (found.values.size() < 2) return;
  view.largest_from_mean_percent = 100.0 * std::max(*high / moments.mean - 1.0, 1.0 - *low / moments.mean);
  view.std = moments.std;
  view.cov_percent = 100.0 * moments.std / moments.mean;
  // A bound below 0 becomes nullopt, because the quantity is positive and such a bound would say nothing.
  auto const below_mean = [&](double factor) -> std::optional<double> {
    double const value = moments.mean - factor * moments.std;
    if (value > 0.0) return value;
    if (view.no_lower.empty()) view.no_lower = no_lower_bound(factor * *view.cov_percent);
    return std::nullopt;
  };
  view.fractile_5 = below_mean(normal_95);
  view.fractile_95 = moments.mean + normal_95 * moments.std;
  view.tolerance_factor = num::tolerance_factor(found.values.size());
  view.tolerance_low = below_mean(*view.tolerance_factor);
  view.tolerance_high = moments.mean + *view.tolerance_factor * moments.std;
}

void compare_with_design(Design const& design, LotQuantity& view) {
  view.nominal = design.value(view.quantity);
  if (!view.nominal || !view.mean) return;
  auto const deviation = [&](double value) { return 100.0 * (value - *view.nominal) / *view.nominal; };
  view.mean_deviation_percent = deviation(*view.mean);
  double const low = deviation(*view.min), high = deviation(*view.max);
  bool const below = std::abs(low) > std::abs(high);
  view.worst_deviation_percent = below ? low : high;
  view.worst_device = below ? view.min_device : view.max_device;
}

std::string unmet_sample(RuleSet const& rules, LotView const& lot, LotQuantity const& view) {
  if (rules.sample && !lot.required) return "size of the lot not known: give it, so that the sample can be judged";
  if (lot.required && view.count < static_cast<std::size_t>(*lot.required))
    return fmt::format("{} devices with this property, {} required", view.count, *lot.required);
  return {};
}

// Reasons why a property of the lot gets no verdict: small sample, no value, copied record, other test conditions.
std::vector<std::string> unmet_of_lot(RuleSet const& rules, LotView const& lot, LotQuantity const& view,
                                      std::span<DeviceValues const> devices, Design const& design) {
  std::vector<std::string> unmet;
  if (!lot.note.empty()) unmet.push_back(lot.note);
  if (auto sample = unmet_sample(rules, lot, view); !sample.empty()) unmet.push_back(std::move(sample));
  if (!view.devices_without_value.empty())
    unmet.push_back(fmt::format("no value of {}", fmt::join(view.devices_without_value, ", ")));
  if (view.quantity == Quantity::K_v) return unmet;  // the conditions below are those of the shear test
  for (auto const& device : devices)
    if (!device.copy_of.empty())
      unmet.push_back(fmt::format("{}: {}, left out of the mean", device.name, same_record_as(device.copy_of)));
  for (auto const& device : devices)
    for (auto const& text : unmet_conditions(rules, device.block, design)) {
      unmet.push_back(fmt::format("{}: {}", device.name, text));
      return unmet;  // names one device as an example, since a lot may have hundreds
    }
  return unmet;
}

void assess_mean(RuleSet const& rules, LotView const& lot, std::span<DeviceValues const> devices, Design const& design,
                 LotQuantity& view) {
  for (auto const& limit : rules.limits) {
    if (limit.quantity != view.quantity || limit.scope != Scope::mean) continue;
    Assessment assessment;
    assessment.quantity = fmt::format("{}, mean of {} devices", name(view.quantity), view.count);
    assessment.property = view.quantity;
    assessment.subject = Subject::lot;
    assessment.formula = "mean over the devices";
    assessment.value = view.mean;
    assessment.unit = view.unit;
    assessment.nominal = view.nominal;
    assessment.deviation_percent = view.mean_deviation_percent;
    hold_to(assessment, rules, limit, "no device has a value", unmet_of_lot(rules, lot, view, devices, design));
    view.mean_limits.push_back(std::move(assessment));
  }
}

void add_limit_of_each(RuleSet const& rules, LotQuantity& view) {
  for (auto const& [quantity, scope, lower, upper, clause] : rules.limits) {
    if (quantity != view.quantity || scope != Scope::each) continue;
    view.limit_individual = limit_text(lower, upper);
    view.lower_percent = lower;
    view.upper_percent = upper;
  }
}

void add_test_factors(std::span<DeviceValues const> devices, LotQuantity& view) {
  auto& extremes = view.test_factors;
  for (auto const& device : devices)
    if (auto const factors = test_factors(view.quantity, device.block)) {
      bool const first = !extremes;
      if (first) extremes = factors;
      if (first || factors->min < extremes->min) {
        extremes->min = factors->min, extremes->min_cycle = factors->min_cycle;
        view.test_min_device = device.name;
      }
      if (first || factors->max > extremes->max) {
        extremes->max = factors->max, extremes->max_cycle = factors->max_cycle;
        view.test_max_device = device.name;
      }
    }
}

// Adds bounds as factors lambda_spec on the design value, or on the devices' mean if there is no design value.
void add_bounds(RuleSet const& rules, std::optional<int> lot_size, LotQuantity& view) {
  if (!view.mean) return;
  double const base = view.nominal.value_or(*view.mean);
  auto const* given = rules.factors_of(view.quantity);
  FactorPair const environment =
      given == nullptr ? FactorPair{} : FactorPair{.min = given->environment_min, .max = given->environment_max};
  // max_not_below and min_not_above apply only to properties that have factors of their own in the set.
  auto const rule = given == nullptr ? FactorRule{} : rules.factors;
  auto const test = view.test_factors.value_or(TestFactors{}).pair();
  auto const add = [&](std::string source, BoundScope scope, FactorPair spec, std::string note) {
    std::string no_lower;
    if (spec.min <= 0.0) {
      no_lower = no_lower_bound(100.0 * (1.0 - spec.min * base / *view.mean));
      spec.min = std::numeric_limits<double>::quiet_NaN();
    }
    auto const combined = combine(rule, environment, test, spec);
    view.bounds.push_back({.source = std::move(source),
                           .scope = scope,
                           .spec = spec,
                           .combined = combined,
                           .lower = base * combined.min,
                           .upper = base * combined.max,
                           .note = std::move(note),
                           .no_lower = std::move(no_lower)});
  };
  auto const about_mean = [&](double half_width_percent) {
    double const centre = *view.mean / base;
    return FactorPair{.min = centre * (1.0 - half_width_percent / 100.0),
                      .max = centre * (1.0 + half_width_percent / 100.0)};
  };
  if (given != nullptr && given->spec_min)
    add("contract band", BoundScope::contract, {.min = *given->spec_min, .max = *given->spec_max},
        "as agreed in the rule set");
  if (!view.cov_percent) return;  // fewer than two tested devices have no spread
  add("observed", BoundScope::device, {.min = *view.min / base, .max = *view.max / base},
      "lowest and highest device tested");
  add("statistical, each device", BoundScope::device, about_mean(*view.tolerance_factor * *view.cov_percent),
      fmt::format("holds 95 % of the devices with confidence 95 %, k = {:.4g}; not for the system",
                  *view.tolerance_factor));
  view.bounds.back().is_tolerance = true;
  if (!lot_size) return;
  auto const tested = static_cast<int>(view.count);
  add("statistical, system", BoundScope::system,
      about_mean(system_half_width_percent(*view.cov_percent, *lot_size, tested)),
      fmt::format("mean of {} devices, {} of them tested, 95 %; the lot's mean and CoV taken as known", *lot_size,
                  tested));
  add("statistical, system predicted", BoundScope::system,
      about_mean(prediction_half_width_percent(*view.cov_percent, *lot_size, tested)),
      fmt::format("mean of {} devices predicted from {} tested, 95 %; mean and CoV estimated", *lot_size, tested));
}

// Two tested devices are enough to forbid an analysis with mean properties. Only a sample as large as the set requires
// can permit it.
void judge_mean_analysis(RuleSet const& rules, LotView const& lot, LotQuantity& view) {
  if (view.quantity == Quantity::K_v) return;  // the mean analysis is about shear only
  if (!rules.verified() || !rules.mean_analysis || view.count < 2) return;
  double const within = rules.mean_analysis->within_percent;
  bool const close =
      is_within(*view.min, *view.mean, -within, std::nullopt) && is_within(*view.max, *view.mean, std::nullopt, within);
  if (close) view.mean_analysis_open = unmet_sample(rules, lot, view);
  if (view.mean_analysis_open.empty()) view.mean_analysis_permitted = close;
}

LotQuantity quantity_view(RuleSet const& rules, LotView const& lot, Quantity quantity,
                          std::span<DeviceValues const> devices, Design const& design) {
  auto const found = collect(rules, quantity, devices);
  LotQuantity view;
  view.quantity = quantity;
  view.unit = unit(quantity);
  view.count = found.values.size();
  view.devices_without_value = found.devices_without_value;
  if (!found.values.empty()) describe_spread(found, view);
  compare_with_design(design, view);
  view.outliers = find_outliers(found.usual_names, found.usual_values);
  if (found.usual_values.size() < num::fewest_for_outliers)
    view.outlier_note = fmt::format("too few devices to name outliers: {}, at least {} needed",
                                    found.usual_values.size(), num::fewest_for_outliers);
  if (!found.other_names.empty() && found.values.size() >= num::fewest_for_outliers)
    view.outlier_note += fmt::format("{}not compared, as tested at another amplitude: {}",
                                     view.outlier_note.empty() ? "" : "; ", fmt::join(found.other_names, ", "));
  add_limit_of_each(rules, view);
  assess_mean(rules, lot, devices, design, view);
  add_test_factors(devices, view);
  add_bounds(rules, lot.lot_size, view);
  judge_mean_analysis(rules, lot, view);
  return view;
}

Assessment assess_sample(RuleSet const& rules, LotView const& lot) {
  Assessment assessment;
  assessment.quantity = "sample size";
  assessment.subject = Subject::sample;
  assessment.formula = "devices tested";
  assessment.value = static_cast<double>(lot.devices);
  assessment.unit = "devices";
  if (!rules.sample) {
    assessment.reason =
        rules.id.empty() ? "no rule set was asked for" : fmt::format("{} has no rule for the sample", rules.id);
    return assessment;
  }
  assessment.clause = rules.sample->clause;
  if (!lot.required) {
    assessment.reason = "size of the lot not known: give it, so that the sample can be judged";
    return assessment;
  }
  assessment.limit = fmt::format("{} or more of {}", *lot.required, *lot.lot_size);
  give_verdict(assessment, rules, lot.devices >= static_cast<std::size_t>(*lot.required), {});
  return assessment;
}

}  // namespace

std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<double const> values) {
  assert(names.size() == values.size());
  if (values.size() < num::fewest_for_outliers) return {};
  auto const [centre, scores] = num::modified_scores(values, property_error);
  std::vector<Outlier> outliers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const score = std::abs(scores[i]);
    if (!(score > num::outlying_score)) continue;
    outliers.push_back({.device = names[i],
                        .value = values[i],
                        .score = score,
                        .reason = fmt::format("{:.3g} % {} the median: modified z {:.1f}, above {}",
                                              100.0 * std::abs(values[i] - centre) / std::abs(centre),
                                              values[i] > centre ? "above" : "below", score, num::outlying_score)});
  }
  return outliers;
}

LotView lot_view(RuleSet const& rules, std::span<DeviceValues const> devices, Design const& design,
                 std::optional<int> lot_size) {
  if (lot_size && (*lot_size < 1 || static_cast<std::size_t>(*lot_size) < devices.size()))
    throw Error({.where = "--lot-size",
                 .found = fmt::format("{} with {} devices tested", *lot_size, devices.size()),
                 .allowed = "all devices of the lot, tested ones included"});
  LotView lot;
  lot.devices = without_copies(devices);
  lot.lot_size = lot_size;
  if (rules.sample && lot_size) lot.required = required_sample(*rules.sample, *lot_size);
  lot.sample = assess_sample(rules, lot);
  if (lot.devices == 1 && lot_size != 1)
    lot.note = "one device is no lot: no spread over devices, no verdict on their mean, no factors from them";
  for (auto const quantity : measured_quantities())
    lot.quantities.push_back(quantity_view(rules, lot, quantity, devices, design));
  bool const vertical =
      std::ranges::any_of(devices, [](auto const& device) { return device.block.vertical.K_v_kN_per_mm.has_value(); });
  bool const limited = std::ranges::any_of(
      rules.limits, [](Limit const& limit) { return limit.quantity == Quantity::K_v && limit.scope == Scope::mean; });
  if (vertical || limited) lot.quantities.push_back(quantity_view(rules, lot, Quantity::K_v, devices, design));
  return lot;
}

}  // namespace isolaw::rules
