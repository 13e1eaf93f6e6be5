#include "isolaw/rules/assess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "isolaw/base/words.hpp"

namespace isolaw::rules {
namespace {

constexpr double slack = 1e-12;  // relative to the bound; a thousand times the rounding error of a product

bool is_at_least(double value, double bound) {
  return value >= bound - slack * std::abs(bound);
}
bool is_at_most(double value, double bound) {
  return value <= bound + slack * std::abs(bound);
}

std::string missing_design(Quantity quantity) {
  return fmt::format("no design value: give {}=... among the design values", name(quantity));
}

Assessment compared(DerivedValue const& derived, Quantity quantity, Design const& design) {
  Assessment result;
  result.quantity = derived.label;
  result.property = quantity;
  result.side = derived.side;
  result.formula = derived.formula;
  result.value = derived.value;
  result.unit = unit(quantity);
  result.nominal = design.value(quantity);
  if (result.value && result.nominal)
    result.deviation_percent = 100.0 * (*result.value - *result.nominal) / *result.nominal;
  return result;
}

void assess_limit(RuleSet const& rules, Limit const& limit, BlockValues const& block, Design const& design,
                  std::vector<std::string> const& unmet, std::vector<Assessment>& out) {
  for (auto const& derived : derive(rules, limit.quantity, block)) {
    auto result = compared(derived, limit.quantity, design);
    // K_v comes from the compression test, for which the unmet conditions of the shear test do not matter.
    hold_to(result, rules, limit, derived.reason, limit.quantity == Quantity::K_v ? std::vector<std::string>() : unmet);
    out.push_back(std::move(result));
  }
}

std::string_view measure_text(Measure measure) {
  static constexpr std::array<std::string_view, 3> texts{"lowest over highest", "largest change from the first",
                                                         "largest loss from the first"};
  return texts.at(static_cast<std::size_t>(measure));
}

// The ratio, change or loss of a property over the limit's cycles; nullopt if a cycle is missing or its value is not
// positive.
std::optional<double> measured(StabilityLimit const& limit, BlockValues const& block) {
  double first = 0.0, lowest = 0.0, highest = 0.0;
  for (int number = limit.first; number <= limit.last; ++number) {
    auto const* cycle = block.find(number);
    double const value = cycle == nullptr ? 0.0 : peak_to_peak(*cycle, limit.quantity);
    if (!std::isfinite(value) || value <= 0.0) return std::nullopt;
    if (number == limit.first) first = lowest = highest = value;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  if (limit.measure == Measure::min_over_max) return lowest / highest;
  double const loss = 100.0 * (1.0 - lowest / first), gain = 100.0 * (highest / first - 1.0);
  return limit.measure == Measure::loss_from_first ? loss : std::max(loss, gain);
}

Assessment assess_stability(RuleSet const& rules, StabilityLimit const& limit, BlockValues const& block,
                            std::vector<std::string> const& unmet) {
  bool const is_ratio = limit.measure == Measure::min_over_max;
  Assessment result;
  result.quantity = fmt::format("{} over cycles", name(limit.quantity));
  result.property = limit.quantity;
  result.subject = Subject::cycles;
  result.clause = limit.clause;
  result.formula = fmt::format("{} of cycles {} to {}", measure_text(limit.measure), limit.first, limit.last);
  result.unit = is_ratio ? "" : "%";
  result.limit = is_ratio ? fmt::format("{:g} or more", limit.bound) : fmt::format("{:g} % or less", limit.bound);
  result.value = measured(limit, block);
  if (result.value)
    give_verdict(result, rules,
                 is_ratio ? is_at_least(*result.value, limit.bound) : is_at_most(*result.value, limit.bound), unmet);
  else
    result.reason = fmt::format("cycles {} to {} needed; block {} holds {} counted", limit.first, limit.last,
                                block.number, block.cycles.size());
  return result;
}

void assess_load(RuleSet const& rules, LoadVariation const& limit, Design const& design,
                 std::optional<LoadPair> const& loads, std::vector<std::string> const& unmet,
                 std::vector<Assessment>& out) {
  for (auto const quantity : {Quantity::K_eff, Quantity::damping}) {
    Assessment result;
    result.quantity = fmt::format("{} over vertical load", name(quantity));
    result.property = quantity;
    result.subject = Subject::loads;
    result.clause = limit.clause;
    result.formula = "(value at the largest load - value at the smallest)/design value";
    result.unit = "%";
    result.limit = fmt::format("{:g} % or less", limit.largest_percent);
    auto const nominal = design.value(quantity);
    auto const at_largest = loads ? device_value(rules, quantity, loads->largest) : std::nullopt;
    auto const at_smallest = loads ? device_value(rules, quantity, loads->smallest) : std::nullopt;
    if (!loads) {
      result.reason = "needs the same test at the largest and at the smallest vertical load";
    } else if (!at_largest || !at_smallest) {
      result.reason = "the cycles that count are missing at one of the loads";
    } else if (!nominal) {
      result.reason = missing_design(quantity);
    } else {
      result.value = 100.0 * std::abs(*at_largest - *at_smallest) / *nominal;
      give_verdict(result, rules, is_at_most(*result.value, limit.largest_percent), unmet);
    }
    out.push_back(std::move(result));
  }
}

// The unmet conditions for limits on ratios of cycles. Ratios are not compared with a design value, so the test may
// have any amplitude.
std::vector<std::string> unmet_of_ratios(RuleSet rules, BlockValues const& block, Design const& design) {
  rules.test.displacement_tolerance_percent.reset();
  return unmet_conditions(rules, block, design);
}

// The unmet conditions for a pair of tests that deliberately run at other vertical loads than the design load.
std::vector<std::string> unmet_of_pair(RuleSet rules, LoadPair const& loads, Design const& design) {
  rules.test.load_tolerance_percent.reset();
  auto unmet = unmet_conditions(rules, loads.largest, design);
  for (auto& text : unmet_conditions(rules, loads.smallest, design)) unmet.push_back(std::move(text));
  return unmet;
}

}  // namespace

std::string_view name(Verdict verdict) {
  static constexpr std::array<std::string_view, 4> names{"pass", "fail", "information", "not assessed"};
  return names.at(static_cast<std::size_t>(verdict));
}

bool is_within(double value, double nominal, std::optional<double> lower_percent, std::optional<double> upper_percent) {
  // nominal (100 + 20) / 100 has fewer rounding errors than nominal (1 + 20/100). The slack covers those that remain.
  auto const bound = [&](double percent) { return nominal * (100.0 + percent) / 100.0; };
  if (!std::isfinite(value)) return false;
  if (lower_percent && !is_at_least(value, bound(*lower_percent))) return false;
  return !upper_percent || is_at_most(value, bound(*upper_percent));
}

std::string limit_text(std::optional<double> lower_percent, std::optional<double> upper_percent) {
  if (lower_percent && upper_percent) return fmt::format("from {:+g} % to {:+g} %", *lower_percent, *upper_percent);
  if (lower_percent) return fmt::format("at least {:+g} %", *lower_percent);
  return upper_percent ? fmt::format("at most {:+g} %", *upper_percent) : "";
}

std::string deviation_text(double deviation_percent, std::optional<double> lower_percent,
                           std::optional<double> upper_percent) {
  // Adds decimals until the text is on the value's side of each limit. A value within the slack is on the limit.
  auto const on_this_side = [&](double shown, std::optional<double> bound, double sign) {
    if (!bound) return true;
    double const over = sign * (deviation_percent - *bound);
    bool const is_over = over > slack * (100.0 + std::abs(*bound));
    return is_over == (sign * (shown - *bound) > 0.0);
  };
  for (int decimals = 1;; ++decimals) {
    auto text = fmt::format("{:+.{}f}", deviation_percent, decimals);
    double const shown = number_in<double>(text).value_or(0.0);
    if (decimals == 12 || (on_this_side(shown, lower_percent, -1.0) && on_this_side(shown, upper_percent, 1.0)))
      return text + " %";
  }
}

std::string_view name(Subject subject) {
  static constexpr std::array<std::string_view, 5> names{"device", "cycles", "loads", "lot", "sample"};
  return names.at(static_cast<std::size_t>(subject));
}

bool is_of(Assessment const& assessment, Quantity property) {
  return assessment.property == property && assessment.subject == Subject::device;
}

std::string same_record_as(std::string_view device) {
  return fmt::format("the same record as {}", device);
}

void withhold_verdicts(std::vector<Assessment>& assessments, std::string_view reason) {
  for (auto& a : assessments) {
    bool const judged = a.verdict == Verdict::pass || a.verdict == Verdict::fail;
    if (!judged || a.property == Quantity::K_v) continue;  // K_v comes from a compression test
    a.verdict = Verdict::not_assessed;
    a.reason = reason;
  }
}

void give_verdict(Assessment& assessment, RuleSet const& rules, bool holds, std::vector<std::string> const& unmet) {
  if (!rules.verified()) {
    assessment.verdict = Verdict::information;
    assessment.reason = fmt::format("the limits of {} are not verified", rules.id);
    if (!unmet.empty()) assessment.reason += "; " + joined(unmet, "; ");
  } else if (!unmet.empty()) {
    assessment.reason = joined(unmet, "; ");
  } else {
    assessment.verdict = holds ? Verdict::pass : Verdict::fail;
  }
}

void hold_to(Assessment& assessment, RuleSet const& rules, Limit const& limit, std::string_view without,
             std::vector<std::string> const& unmet) {
  auto const &lower = limit.lower_percent, &upper = limit.upper_percent;
  assessment.clause = limit.clause;
  assessment.limit = limit_text(lower, upper);
  assessment.lower_percent = lower;
  assessment.upper_percent = upper;
  if (assessment.deviation_percent) assessment.deviation = deviation_text(*assessment.deviation_percent, lower, upper);
  if (!assessment.value)
    assessment.reason = without;
  else if (!assessment.nominal)
    assessment.reason = missing_design(limit.quantity);
  else
    give_verdict(assessment, rules, is_within(*assessment.value, *assessment.nominal, lower, upper), unmet);
}

std::vector<Assessment> assess(RuleSet const& rules, BlockValues const& block, Design const& design,
                               std::optional<LoadPair> const& loads) {
  auto const unmet = unmet_conditions(rules, block, design);
  std::vector<Assessment> out;
  for (auto const& limit : rules.limits)
    if (limit.scope == Scope::each) assess_limit(rules, limit, block, design, unmet, out);
  auto const unmet_of_cycles = unmet_of_ratios(rules, block, design);
  for (auto const& limit : rules.stability) out.push_back(assess_stability(rules, limit, block, unmet_of_cycles));
  if (rules.load_variation)
    assess_load(rules, *rules.load_variation, design, loads,
                loads ? unmet_of_pair(rules, *loads, design) : std::vector<std::string>(), out);
  std::vector<Quantity> without_limit(measured_quantities().begin(), measured_quantities().end());
  without_limit.push_back(Quantity::K_v);
  for (auto const quantity : without_limit) {
    // K_v is always listed, so that a missing compression test is seen.
    bool const asked = design.value(quantity) || quantity == Quantity::K_v;
    bool const limited = std::ranges::any_of(
        rules.limits, [&](Limit const& limit) { return limit.quantity == quantity && limit.scope == Scope::each; });
    if (limited || !asked) continue;
    for (auto const& derived : derive(rules, quantity, block)) {
      auto result = compared(derived, quantity, design);
      if (result.deviation_percent) result.deviation = deviation_text(*result.deviation_percent, {}, {});
      result.verdict = derived.value ? Verdict::information : Verdict::not_assessed;
      result.reason = derived.value ? fmt::format("{} has no limit for a device", rules.id) : derived.reason;
      out.push_back(std::move(result));
    }
  }
  return out;
}

}  // namespace isolaw::rules
