#include "isolaw/render/terminal/conditions_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/runs.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/study/conditions_findings.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

using conditions::Factor;
using conditions::Status;

template <class... Args>
void append(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

// Returns a factor as text. If the tests cover only a part of the design range of an effect, the effect counts as not
// covered. The factor that the tests show is then written after ">" or "<", and the bounds include it.
std::string factor_text(Factor const& factor) {
  if (factor.status != Status::not_covered) return fmt::format("{:.3f}", factor.lambda());
  return factor.ln == 0.0 ? "-" : fmt::format("{}{:.3f}", factor.ln > 0.0 ? ">" : "<", factor.lambda());
}

std::string interval_text(std::optional<conditions::Interval> const& interval) {
  return interval ? fmt::format("{:.3f} to {:.3f}", interval->low, interval->high) : "no interval";
}

std::string status_text(Factor const& factor) {
  auto const word = std::string(study::status_word(factor));
  if (factor.devices == 0) return word;
  return fmt::format("{} on {}", word, counted(static_cast<std::size_t>(factor.devices), "device"));
}

std::string reference_text(study::ConditionsResult const& result) {
  auto const& from = result.stated.reference;
  auto text = fmt::format("{:g} C", from.temperature_C);
  if (from.frequency_Hz) append(text, ", {:g} Hz", *from.frequency_Hz);
  if (from.load_kN) append(text, ", {:g} kN", *from.load_kN);
  if (from.strain_percent) append(text, ", strain {:g} %", *from.strain_percent);
  if (from.disp_mm) append(text, ", {:g} mm", *from.disp_mm);
  if (from.first_cycle == from.last_cycle)
    append(text, ", cycle {}", from.first_cycle);
  else
    append(text, ", mean of cycles {} to {}", from.first_cycle, from.last_cycle);
  return text;
}

std::vector<std::string> names_of(std::vector<conditions::Effect> const& effects) {
  std::vector<std::string> names;
  for (auto const effect : effects) names.emplace_back(name(effect));
  return names;
}

std::string bound_text(conditions::Combined const& all, std::string_view at_end) {
  if (!all.complete())
    return fmt::format("{} {:.3f}, NOT COVERED: {}", at_end, all.factor, joined(names_of(all.not_covered)));
  auto text = fmt::format("{:.3f}", all.factor);
  if (all.interval) append(text, " ({}, 95 %)", interval_text(all.interval));
  append(text, ", {}", name(all.status));
  if (all.status == Status::shown || all.status == Status::interpolated) return text;
  append(text, "; {:.0f} % of it rests on tests at such conditions or between them", 100.0 * all.share_shown);
  return text;
}

// Returns whether the property is shown briefly. Without --details, the text then has its bounds, but not the effects
// that were combined to the bounds.
bool is_short(rules::Quantity quantity) {
  return quantity == rules::Quantity::Q_d || quantity == rules::Quantity::K_d;
}

std::string combination_text(study::ConditionsResult const& result) {
  auto const& how = result.combination;
  if (how.rules.empty()) return "the product of all effects";
  using conditions::Form;
  auto text = how.form == Form::each      ? fmt::format("the product of all effects, each adjusted by {:g}", how.adjust)
              : how.form == Form::product ? fmt::format("the product of all effects, adjusted by {:g}", how.adjust)
              : how.form == Form::sum
                  ? fmt::format("the sum of all effects with a margin of {:g}", how.margin)
                  : fmt::format("the environment's effects adjusted by {:g}, times those of tests", how.adjust);
  append(text, ", as {} says{}", how.rules, how.verified ? "" : " (not verified)");
  return text;
}

std::string value_text(double value) {
  constexpr double large = 1000.0;
  return value < large ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

// Adds the value under the reference conditions and the bounds, in the unit of the property.
void add_values(std::string& text, study::BoundRow const& row) {
  if (row.devices == 0) return;
  auto const unit = rules::unit(row.quantity);
  append(text, "  at reference {} {}, mean of {}", value_text(row.value_at_reference), unit,
         counted(static_cast<std::size_t>(row.devices), "device"));
  if (row.min.complete() && row.max.complete())
    append(text, ": {} to {} {}", value_text(row.min.factor * row.value_at_reference),
           value_text(row.max.factor * row.value_at_reference), unit);
  text += '\n';
}

void add_bounds(std::string& text, study::ConditionsResult const& result, bool details) {
  if (result.bounds.empty()) {
    text +=
        "\nNo range of conditions is stated for the design, so there are no bounds: add design = { ... } to "
        "[conditions].\n";
    return;
  }
  append(text, "\nBounds over the design conditions: factors on the value at reference, {}\n",
         combination_text(result));
  std::vector<std::string> alone;
  for (auto const& row : result.bounds) {
    for (auto const* side : {&row.max, &row.min})
      for (auto& effect : names_of(side->without_interval))
        if (std::ranges::find(alone, effect) == alone.end()) alone.push_back(std::move(effect));
    append(text, "\n{}\n  upper  {}\n  lower  {}\n", rules::name(row.quantity), bound_text(row.max, "at least"),
           bound_text(row.min, "at most"));
    add_values(text, row);
    if (is_short(row.quantity) && !details) continue;
    append(text, "    {:<12} {:>7}  {:<28} {:>8}\n", "effect", "largest", "", "smallest");
    for (auto const& of : result.design)
      if (of.quantity == row.quantity)
        append(text, "    {:<12} {:>7}  {:<28} {:>8}  {}\n", name(of.effect), factor_text(of.max), status_text(of.max),
               factor_text(of.min), status_text(of.min));
  }
  if (!alone.empty())
    append(text, "\nThe bounds have no interval, because {} {} none: a single device shows {}, or too few.\n",
           joined(alone), alone.size() == 1 ? "has" : "have", alone.size() == 1 ? "it" : "them");
}

std::string devices_text(std::vector<conditions::DeviceRatio> const& ratios) {
  constexpr std::size_t most_named = 4;
  if (ratios.size() > most_named) return fmt::format("{} devices", ratios.size());
  std::vector<std::string> names;
  for (auto const& ratio : ratios) names.push_back(ratio.device);
  return printable(joined(names));
}

void add_levels(std::string& text, study::ConditionsResult const& result, bool details) {
  text += "\nFactors at the tested levels, with 95 % intervals of the mean and of one further device\n";
  append(text, "  {:<8} {:<12} {:<16} {:>7}  {:<15} {:<15} {}\n", "property", "effect", "level", "factor", "mean",
         "one device", "tested on");
  for (auto const& row : result.levels) {
    if (!details && row.quantity != rules::Quantity::K_eff && row.quantity != rules::Quantity::damping) continue;
    using conditions::About;
    auto const about = [&](About what) {
      auto const found = interval(row.factor, what);
      return found ? interval_text(found) : std::string("-");
    };
    append(text, "  {:<8} {:<12} {:<16} {:>7}  {:<15} {:<15} {}\n", rules::name(row.quantity), name(row.effect),
           row.level, factor_text(row.factor), about(About::mean), about(About::device), devices_text(row.ratios));
  }
}

std::string number(std::optional<double> const& value) {
  return value ? fmt::format("{:.6g}", *value) : "-";
}

std::string ageing_text(std::optional<conditions::Ageing> const& ageing) {
  return ageing ? fmt::format("{:.4g} d at {:g} C", ageing->days, ageing->at_C) : "";
}

std::string condition_text(conditions::Condition const& at) {
  auto text = fmt::format("{} C", number(at.temperature_C));
  if (at.frequency_Hz) append(text, ", {:.4g} Hz", *at.frequency_Hz);
  if (at.load_kN) append(text, ", {:.5g} kN", *at.load_kN);
  if (at.ageing) append(text, ", aged {}", ageing_text(at.ageing));
  return text;
}

// Returns the reason why a value under the reference conditions, or its interval, is missing. Returns "" if both exist.
std::string why_not(study::AtReferenceRow const& row) {
  if (!row.not_comparable.empty())
    return fmt::format("no value at reference, because the test cannot be compared: {}", row.not_comparable);
  for (auto const& each : row.factors)
    if (row.obstacle == each.effect)
      return fmt::format("no value at reference, because the factor of {} is {}", name(each.effect),
                         name(each.factor.status));
  if (!row.measured) return "no value was measured";
  std::vector<std::string_view> alone;
  for (auto const& each : row.factors)
    if (!half_width(each.factor, conditions::About::device)) alone.push_back(name(each.effect));
  if (alone.empty()) return {};
  return fmt::format("no interval, because too few devices show {}", joined(alone));
}

// Adds a table of one test, with a column for each property.
void add_values_of_test(std::string& text, std::span<study::AtReferenceRow const> rows) {
  auto const& first = rows.front();
  append(text, "\n{}, test {}: {}\n  {:<12}", printable(first.device), printable(first.test),
         condition_text(first.condition), "");
  for (auto const& row : rows)
    append(text, " {:>15}", fmt::format("{}, {}", rules::name(row.quantity), rules::unit(row.quantity)));
  append(text, "\n  {:<12}", "measured");
  for (auto const& row : rows) append(text, " {:>15}", row.measured ? value_text(*row.measured) : "-");
  for (std::size_t i = 0; i < first.factors.size(); ++i) {
    auto const& factor = first.factors[i];
    append(text, "\n  {:<12}", name(factor.effect));
    for (auto const& row : rows)
      append(text, " {:>15}", row.factors.empty() ? "-" : factor_text(row.factors[i].factor));
    append(text, "  {}, {}", status_text(factor.factor), counted(factor.records.size(), "record"));
  }
  append(text, "\n  {:<12}", "at reference");
  for (auto const& row : rows) append(text, " {:>15}", row.at_reference ? value_text(*row.at_reference) : "-");
  if (std::ranges::any_of(rows, [](auto const& row) { return row.interval.has_value(); })) {
    append(text, "\n  {:<12}", "95 %");
    for (auto const& row : rows)
      append(text, " {:>15}",
             row.interval ? value_text(row.interval->low) + " to " + value_text(row.interval->high) : "-");
  }
  text += '\n';
  if (auto const why = why_not(first); !why.empty()) append(text, "  There is {}.\n", why);
}

std::string now_text(conditions::Status status, int devices) {
  if (status == Status::not_covered || status == Status::assumed) return std::string(name(status));
  return fmt::format("{} on {}", name(status), counted(static_cast<std::size_t>(devices), "device"));
}

std::string_view sentence(study::NoPlan why) {
  switch (why) {
    case study::NoPlan::no_condition:
      return "the design of [conditions] does not state its condition";
    case study::NoPlan::no_reference:
      return "the reference of [conditions] does not state this condition";
    case study::NoPlan::no_energy:
      return "no activation energy is stated, so it is not known how long an oven stands for the years of the design";
    case study::NoPlan::no_oven:
      return "no ageing test shows the temperature of the oven; aged = { days = 14, at-C = 70 } in the design states one";
    case study::NoPlan::no_such_test:
      return "isolaw knows no test that shows it";
  }
  return "";
}

void add_tests(std::string& text, study::ConditionsResult const& result) {
  text += "\nTests; temperature, ageing, rest and order are as stated, not measured\n";
  append(text, "  {:<10} {:<14} {:>5} {:>6} {:>7} {:>8} {:>7} {:<17} {:<18} {:>9} {:>9}\n", "device", "test", "order",
         "T, C", "f, Hz", "N, kN", "strain", "cycle is", "used as", "K_eff", "damping");
  for (auto const& test : result.tests) {
    auto const& at = test.condition;
    append(text, "  {:<10} {:<14} {:>5} {:>6} {:>7} {:>8} {:>7} {:<17} {:<18} {:>9} {:>9}\n", printable(test.device),
           printable(test.test), test.order, number(at.temperature_C), number(at.frequency_Hz), number(at.load_kN),
           number(at.strain_percent), test.history ? name(*test.history) : "-",
           test.effect && test.role == study::TestRole::effect ? name(*test.effect) : name(test.role),
           number(test.K_eff_kN_per_mm), number(test.damping_percent));
  }
}

void add_at_reference(std::string& text, study::ConditionsResult const& result) {
  auto const& rows = result.at_reference;
  text += rows.empty() ? "\nThe acceptance tests of all devices were made under reference conditions.\n"
                       : "\nAcceptance tests under other conditions: a value at reference is the measured one divided "
                         "by the factors\n";
  each_run(
      std::span(rows), [](study::AtReferenceRow const& row) { return std::tie(row.device, row.block); },
      [&](auto of_test) { add_values_of_test(text, of_test); });
}

void add_plan(std::string& text, study::ConditionsResult const& result) {
  auto const& plan = result.plan;
  auto const wanted = counted(static_cast<std::size_t>(plan.devices), "device");
  if (result.design.empty()) {
    text += "\nNo condition is stated for the design, so no test is missing: add design = { ... } to [conditions].\n";
    return;
  }
  append(text, "\nTests that are missing until {} every end of the design conditions\n",
         plan.devices == 1 ? "1 device shows" : wanted + " show");
  if (!plan.tests.empty())
    append(text, "  {:<12} {:<10} {:>6} {:>7} {:>7} {:<15} {:>7} {:>7}  {:<26} {}\n", "effect", "device", "T, C",
           "f, Hz", "N, kN", "aged", "rest, h", "cycles", "now", "after");
  for (auto const& test : plan.tests) {
    auto const& at = test.condition;
    append(text, "  {:<12} {:<10} {:>6} {:>7} {:>7} {:<15} {:>7} {:>7}  {:<26} {}\n",
           test.is_reference ? "reference" : name(test.effect), printable(test.device), number(at.temperature_C),
           number(at.frequency_Hz), number(at.load_kN), at.ageing ? ageing_text(at.ageing) : "-", number(test.rest_h),
           test.cycles, now_text(test.before, test.devices_before), now_text(test.after, test.devices_after));
  }
  text += '\n';
  for (auto const& each : plan.unplanned) append(text, "No test of {}: {}.\n", name(each.effect), sentence(each.why));
  if (plan.tests.empty())
    text += plan.unplanned.empty() ? "No test is missing.\n" : "No other test is missing.\n";
  else
    append(text, "{}. The ageing of a device comes last, since no later test of it can be at reference.\n",
           counted(plan.tests.size(), "test"));
  auto const turned = plan.turn_assumed_into_shown();
  if (turned > 0)
    append(text, "{} of them {} an assumed factor into a shown one.\n", turned, turned == 1 ? "turns" : "turn");
  else
    text += "No factor is assumed, so none turns from assumed into shown.\n";
}
// Returns the title, and a line about the reference conditions to which all numbers are compared.
std::string heading(study::ConditionsResult const& result) {
  std::string text;
  std::set<std::string> devices;
  std::set<std::pair<std::string, std::string>> tests;
  for (auto const& test : result.tests) devices.insert(test.device), tests.insert({test.device, test.test});
  append(text, "{}{}{} of {}\nReference: {}\n", printable(result.title), result.title.empty() ? "" : ": ",
         counted(tests.size(), "test"), counted(devices.size(), "device"), reference_text(result));
  return text;
}

}  // namespace

std::string conditions_text(study::ConditionsResult const& result, bool details) {
  auto text = heading(result);
  add_bounds(text, result, details);
  add_levels(text, result, details);
  if (!result.recovery.empty()) {
    text += "\nRecovery: share of the loss in the first cycles that comes back\n";
    for (auto const& row : result.recovery)
      append(text, "  after {:g} h: {:.2f} on {}\n", row.rest_h, row.share,
             counted(static_cast<std::size_t>(row.devices), "device"));
  }
  text += '\n';
  auto findings = study::conditions_findings(result);
  // The table of bounds already shows what findings of the kind design_bound say.
  std::erase_if(findings, [](Finding const& finding) { return finding.kind == FindingKind::design_bound; });
  for (auto const& line : wording::lines(findings)) append(text, "{}\n", line);
  if (details) add_tests(text, result);
  return text;
}

std::string conditions_text(study::ConditionsResult const& result, ConditionsSections const& sections) {
  auto text = heading(result);
  if (sections.at_reference) add_at_reference(text, result);
  if (sections.plan) add_plan(text, result);
  auto findings = study::conditions_findings(result);
  std::erase_if(findings, [](Finding const& finding) { return finding.kind != FindingKind::condition_test_refused; });
  for (auto const& line : wording::lines(findings)) append(text, "{}\n", line);
  return text;
}

}  // namespace isolaw::render
