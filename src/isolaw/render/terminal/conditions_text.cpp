#include "isolaw/render/terminal/conditions_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "isolaw/base/printable.hpp"
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

std::string factor_text(Factor const& factor) {
  return factor.status == Status::not_covered ? "-" : fmt::format("{:.3f}", factor.lambda());
}

std::string interval_text(std::optional<conditions::Interval> const& interval) {
  return interval ? fmt::format("{:.3f} to {:.3f}", interval->low, interval->high) : "no interval";
}

std::string status_text(Factor const& factor) {
  if (factor.status == Status::not_covered) return "NOT COVERED";
  if (factor.status == Status::assumed) return "ASSUMED";
  // No device was compared: this is the reference condition itself, with the factor 1.
  if (factor.devices == 0) return "reference";
  return fmt::format("{} on {}", name(factor.status), counted(static_cast<std::size_t>(factor.devices), "device"));
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

// For these properties the text without --details has the bounds, but not the effects that make up the bounds.
bool is_short(rules::Quantity quantity) {
  return quantity == rules::Quantity::Q_d || quantity == rules::Quantity::K_d;
}

std::string combination_text(study::ConditionsResult const& result) {
  auto const& how = result.combined;
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

void add_tests(std::string& text, study::ConditionsResult const& result) {
  text += "\nTests; temperature, ageing, rest and order are as stated, not measured\n";
  append(text, "  {:<10} {:<14} {:>5} {:>6} {:>7} {:>8} {:>7} {:<17} {:<18} {:>9} {:>9}\n", "device", "test", "order",
         "T, C", "f, Hz", "N, kN", "strain", "cycle is", "used as", "K_eff", "damping");
  auto const number = [](std::optional<double> const& value) { return value ? fmt::format("{:.6g}", *value) : "-"; };
  for (auto const& test : result.tests) {
    auto const& at = test.condition;
    append(text, "  {:<10} {:<14} {:>5} {:>6} {:>7} {:>8} {:>7} {:<17} {:<18} {:>9} {:>9}\n", printable(test.device),
           printable(test.test), test.order, number(at.temperature_C), number(at.frequency_Hz), number(at.load_kN),
           number(at.strain_percent), test.history ? name(*test.history) : "-",
           test.effect && test.role == study::TestRole::effect ? name(*test.effect) : name(test.role),
           number(test.K_eff_kN_per_mm), number(test.damping_percent));
  }
}

}  // namespace

std::string conditions_text(study::ConditionsResult const& result, bool details) {
  std::string text;
  std::set<std::string> devices;
  std::set<std::pair<std::string, std::string>> tests;
  for (auto const& test : result.tests) devices.insert(test.device), tests.insert({test.device, test.test});
  append(text, "{}{}{} of {}\nReference: {}\n", printable(result.title), result.title.empty() ? "" : ": ",
         counted(tests.size(), "test"), counted(devices.size(), "device"), reference_text(result));
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
  // The table of bounds says this already.
  std::erase_if(findings, [](Finding const& finding) { return finding.kind == FindingKind::design_bound; });
  for (auto const& line : wording::lines(findings)) append(text, "{}\n", line);
  auto const unused = std::ranges::count_if(result.tests, [](study::ConditionsTest const& test) {
    return test.role != study::TestRole::reference && test.role != study::TestRole::effect;
  });
  if (unused > 0 && !details)
    append(text, "{} {} no effect; --details says why.\n", counted(static_cast<std::size_t>(unused), "test"),
           unused == 1 ? "shows" : "show");
  if (details) add_tests(text, result);
  return text;
}

}  // namespace isolaw::render
