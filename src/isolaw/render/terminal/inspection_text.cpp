#include "isolaw/render/terminal/inspection_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

constexpr char const* no_vertical_stiffness =
    "vertical stiffness K_v: not known, a shear test under constant vertical load does not measure it (--vertical DEVICE=FILE names a compression test)";

template <class... Args>
void add(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

void print_list(std::string& text, char const* title, std::vector<std::string> const& lines) {
  if (lines.empty()) return;
  add(text, "\n{}\n", title);
  for (auto const& line : lines) add(text, "  {}\n", line);
}

void print_channel(std::string& text, char const* name, std::vector<double> const& values, ShownUnit const& shown) {
  if (values.empty()) return;
  auto const [least, largest] = std::ranges::minmax(values);
  add(text, "  {:<14}{:>12} to {:>10} {}\n", name, number_text(shown.factor * least),
      number_text(shown.factor * largest), shown.unit);
}

std::string number(std::optional<double> const& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

// Returns how many decimals a value of this size needs to have four significant digits.
int decimals_for(double size) {
  if (!(size > 0.0)) return 2;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 8);
}

void print_ratios(std::string& text, std::string_view name, data::Stability const& s) {
  if (s.ratio_to_third.empty()) return;
  add(text, "  {:<8} to cycle 3:", name);
  constexpr std::size_t shown = 12;
  for (std::size_t i = 0; i < std::min(shown, s.ratio_to_third.size()); ++i) add(text, " {:.3f}", s.ratio_to_third[i]);
  if (s.ratio_to_third.size() > shown) add(text, " ...");
  if (s.min_2_10) add(text, "; cycles 2-10: {:.3f} to {:.3f}", *s.min_2_10, *s.max_2_10);
  if (s.first_to_third) add(text, "; first to third {:.3f}", *s.first_to_third);
  text += '\n';
}

void print_block(std::string& text, UnitSystem const& units, DeviceResult const& device, data::Block const& block) {
  auto const length = shown_unit("mm", units), stiff = shown_unit("kN/mm", units), work = shown_unit("kN mm", units),
             force = shown_unit("kN", units), speed = shown_unit("mm/s", units);
  auto const counted = block.counted();
  add(text, "\nBlock {}: ", block.number);
  if (counted.empty())
    text += block.whole().empty() ? "no complete cycle"
            : block.fault.empty() ? "no cycle counts"
                                  : "no cycle counts, " + block.fault;
  else
    add(text, "{} cycle{} of {:.4g} {}", counted.size(), counted.size() == 1 ? "" : "s",
        length.factor * block.amplitude_mm, length.unit);
  if (block.frequency_Hz) add(text, " at {:.4g} Hz", *block.frequency_Hz);
  if (block.sweep_Hz) add(text, " in a sweep of {:.3g} to {:.3g} Hz", block.sweep_Hz->first, block.sweep_Hz->second);
  if (!block.waveform.empty()) add(text, ", {}", block.waveform);
  if (block.v_max_mm_s) add(text, ", v max {:.4g} {}", speed.factor * *block.v_max_mm_s, speed.unit);
  if (device.rubber_thickness_mm && !counted.empty())
    add(text, ", shear strain {:.3g} %", 100.0 * block.amplitude_mm / *device.rubber_thickness_mm);
  text += ", from raw values\n";
  bool const loads = std::ranges::any_of(block.cycles, [](auto const& c) { return c.N_mean_kN.has_value(); });
  add(text, "  {:>5} {:>9} {:>9} {:>9} {:>9} {:>10} {:>8} {:>9} {:>9}{}\n", "cycle", "amplitude", "K_eff", "K+", "K-",
      "energy", "damping", "Q_d", "K_d", loads ? "         N" : "");
  add(text, "  {:>5} {:>9} {:>9} {:>9} {:>9} {:>10} {:>8} {:>9} {:>9}{}\n", "", length.unit, stiff.unit, stiff.unit,
      stiff.unit, work.unit, "%", force.unit, stiff.unit, loads ? fmt::format("{:>10}", force.unit) : "");
  for (auto const& c : block.cycles) {
    int const stiffness = decimals_for(stiff.factor * std::abs(c.K_eff_kN_per_mm));
    auto const in = [](ShownUnit const& shown, std::optional<double> const& value, int decimals) {
      return number(value ? std::optional(shown.factor * *value) : value, decimals);
    };
    add(text, "  {:>5} {:>9} {:>9} {:>9} {:>9} {:>10} {:>8} {:>9} {:>9}", c.counts() ? fmt::to_string(c.number) : "-",
        in(length, c.amplitude_mm, length.decimals(2)), in(stiff, c.K_eff_kN_per_mm, stiffness),
        in(stiff, c.K_plus(), stiffness), in(stiff, c.K_minus(), stiffness), number_text(work.factor * c.energy_kN_mm),
        number(c.damping(), 2), number_text(force.factor * c.Q_d_kN), in(stiff, c.K_d_kN_per_mm, stiffness));
    if (loads) add(text, " {:>9}", in(force, c.N_mean_kN, force.decimals(1)));
    if (block.sweep_Hz && c.period_s && !c.partial) add(text, "  {:.3g} Hz", 1.0 / *c.period_s);
    if (c.half) text += "  half cycle, energy doubled";
    if (device.properties.is_reported(c)) text += "  reported";
    if (!c.counts()) add(text, "  not counted: {}", c.not_counted);
    text += '\n';
  }
  for (auto const& [name, row, property] : followed_properties)
    print_ratios(text, name, data::stability(block, property));
}

template <class Object, std::size_t count>
void print_table(std::string& text, UnitSystem const& units, std::string_view title,
                 std::array<Result<Object>, count> const& columns, std::vector<Object> const& rows) {
  if (rows.empty()) return;
  add(text, "\n{}\n", title);
  auto const line = [&](auto const& cell) {
    text += ' ';
    for (auto const& column : columns)
      add(text, " {:>{}}", cell(column), std::max<std::size_t>(column.unit.empty() ? 5 : 9, column.heading.size()));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  line([](auto const& column) { return std::string(column.heading); });
  line([&](auto const& column) { return column.unit == "-" ? std::string() : shown_unit(column.unit, units).unit; });
  for (auto const& row : rows)
    line([&](auto const& column) {
      auto const value = column.value(row);
      if (auto const* whole = std::get_if<int>(&value)) return fmt::to_string(*whole);
      auto const* number = std::get_if<double>(&value);
      if (number == nullptr) return std::string("-");
      auto const shown = shown_unit(column.unit, units);
      auto const& [decimals, significant] = column.printed;
      return decimals ? fmt::format("{:.{}f}", shown.factor * *number, shown.decimals(*decimals))
                      : number_text(shown.factor * *number, significant.value_or(4));
    });
}

void print_details(std::string& text, UnitSystem const& units, DeviceResult const& device) {
  print_table(text, units, "Skeleton curve: peaks of cycles 1 and 3 of each amplitude",
              columns(skeleton_results, {"block", "cycle", "d_plus_mm", "F_plus_kN", "d_minus_mm", "F_minus_kN"}),
              study::skeleton_of(device));
  print_table(text, units, "Bilinear loop of the same peaks, energy and Q_d, for the cycle that represents each block",
              columns(level_results, {"block", "cycle", "K_1_kN_per_mm", "K_d_kN_per_mm", "D_y_mm", "F_y_kN"}),
              study::levels_of(device));
  for (auto const& block : device.properties.blocks) {
    std::vector<CycleOf> cycles;
    for (auto const* cycle : block.counted()) cycles.push_back({*cycle, device});
    print_table(text, units, fmt::format("From cycle to cycle of block {}", block.number),
                columns(cycle_results, {"number", "work_kN_mm", "residual_plus_mm", "residual_minus_mm",
                                        "K_eff_in_block", "K_eff_in_test"}),
                cycles);
  }
}

void print_rule_set(std::string& text, LotAcceptance const& acceptance) {
  if (!acceptance.has_rules()) return;
  auto const& rules = acceptance.rules;
  add(text, "\nRules: {}, {}\n", printable(rules.title), printable(rules.edition));
  if (rules.verified())
    add(text, "  verified by {}\n", printable(rules.verified_by));
  else
    add(text, "  the limits of this set are not verified: deviations are information, no verdict\n");
}

void print_assessment(std::string& text, UnitSystem const& units, rules::Assessment const& a) {
  std::vector<std::string> parts;
  auto const [unit, factor] = shown_unit(a.unit, units);
  if (a.value) parts.push_back(fmt::format("{:.5g}{}{}", factor * *a.value, unit.empty() ? "" : " ", unit));
  if (a.nominal) parts.push_back(fmt::format("design {:.5g}", factor * *a.nominal));
  if (!a.deviation.empty()) parts.push_back(a.deviation);
  if (!a.limit.empty()) parts.push_back("limit " + printable(a.limit));
  if (!a.clause.empty()) parts.push_back(printable(a.clause));
  add(text, "  {:<13} {:<26} {}{}{}\n", rules::name(a.verdict), printable(a.quantity), fmt::join(parts, ", "),
      parts.empty() || a.reason.empty() ? "" : ": ", printable(a.reason));
}

std::size_t longest_name(Summary const& summary) {
  std::size_t longest = 6;
  for (auto const& device : summary.devices) longest = std::max(longest, printable(device.name).size());
  return std::min<std::size_t>(longest, 32);
}

std::string vertical_text(UnitSystem const& units, DeviceResult const& device) {
  auto const& test = device.vertical_test;
  if (!device.vertical) return "no vertical stiffness K_v, see the warnings";
  auto const file = test.file.empty() ? std::string()
                                      : fmt::format("; {}, sha256 {}", printable(test.file), test.sha256.substr(0, 16));
  auto const [unit, factor] = shown_unit("kN/mm", units);
  return fmt::format("vertical stiffness K_v: {:.5g} {}, {}{}", factor * device.vertical->K_v_kN_per_mm, unit,
                     device.vertical->description, file);
}

void print_vertical(std::string& text, UnitSystem const& units, DeviceResult const& device) {
  if (!device.vertical_test.is_given()) {
    if (device.acceptance.assessments.empty()) add(text, "\n{}\n", no_vertical_stiffness);
    return;
  }
  add(text, "\n{}\n", vertical_text(units, device));
  print_list(text, "Recognised in the vertical test", wording::remarks(device.vertical_test.recognised, units));
  if (!device.vertical) return;
  for (auto const& turned : device.vertical->reversed_signals) add(text, "  {}\n", turned);
  auto loadings = device.vertical->loadings_kN_per_mm;
  auto const [unit, factor] = shown_unit("kN/mm", units);
  for (auto& loading : loadings) loading *= factor;
  if (loadings.size() > 1) add(text, "  K_v of each loading: {:.5g} {}\n", fmt::join(loadings, ", "), unit);
}

void print_verticals(std::string& text, Summary const& summary) {
  bool const any = std::ranges::any_of(summary.devices, [](auto const& d) { return d.vertical_test.is_given(); });
  if (!any) {
    add(text, "\n{}\n", no_vertical_stiffness);
    return;
  }
  text += "\nVertical tests\n";
  auto const width = longest_name(summary);
  for (auto const& device : summary.devices)
    add(text, "  {:<{}}  {}\n", printable(device.name), width,
        device.vertical_test.is_given() ? vertical_text(summary.units(), device) : std::string("none"));
}

void print_device_in_full(std::string& text, UnitSystem const& units, DeviceResult const& device) {
  auto const& acceptance = device.acceptance;
  add(text, "{}: {}, sha256 {}\n", printable(device.file), counted(device.raw.size(), "sample"),
      device.sha256.substr(0, 16));
  print_list(text, "Recognised", wording::remarks(device.raw.recognised, units));
  print_list(text, "Corrected, as asked for", wording::remarks(device.raw.corrections, units));
  text += "\nChannels\n";
  print_channel(text, "time", device.raw.time_s, {"s"});
  print_channel(text, "displacement", device.raw.disp_mm, shown_unit("mm", units));
  print_channel(text, "force", device.raw.force_kN, shown_unit("kN", units));
  print_channel(text, "vertical load", device.raw.load_kN, shown_unit("kN", units));
  for (auto const& block : device.properties.blocks) print_block(text, units, device, block);
  auto const& refusal = device.properties.refusal;
  if (!refusal.empty()) add(text, "\nNo cyclic properties: {}\n", wording::reasons(refusal, units));
  if (!acceptance.assessments.empty()) {
    add(text, "\nAssessed on block {}, {}\n", *acceptance.block, acceptance.choice);
    for (auto const& assessment : acceptance.assessments) print_assessment(text, units, assessment);
    add(text, "  device: {}\n", device_verdict(acceptance).text());
  }
  print_vertical(text, units, device);
  auto warnings = device.raw.warnings;
  std::erase_if(warnings, [&](auto const& each) { return std::ranges::find(refusal, each) != refusal.end(); });
  print_list(text, "Warnings", wording::remarks(warnings, units));
  print_list(text, "Notes", wording::remarks(device.notes, units));
}

void print_devices(std::string& text, Summary const& summary) {
  auto const& units = summary.units();
  auto const length = shown_unit("mm", units), stiff = shown_unit("kN/mm", units), work = shown_unit("kN mm", units);
  auto const width = longest_name(summary);
  add(text, "\n{:<{}} {:>5} {:>5} {:>9} {:>9} {:>10} {:>8}  {}\n", "device", width, "block", "cycle", "amplitude",
      "K_eff", "energy", "damping", summary.acceptance.has_rules() ? "verdict" : "");
  add(text, "{:<{}} {:>5} {:>5} {:>9} {:>9} {:>10} {:>8}\n", "", width, "", "", length.unit, stiff.unit, work.unit,
      "%");
  for (auto const& device : summary.devices) {
    auto const& acceptance = device.acceptance;
    add(text, "{:<{}} ", printable(device.name), width);
    auto const* cycle = counting_cycle(device.properties, acceptance.block);
    if (device.status != "ok")
      add(text, "refused: {}\n", on_one_line(device.message));
    else if (cycle == nullptr)
      add(text, "no cyclic properties: {}\n",
          acceptance.withheld.empty() ? wording::reasons(device.properties.refusal, units) : acceptance.withheld);
    else
      add(text, "{:>5} {:>5} {:>9.{}f} {:>9.{}f} {:>10} {:>8}  {}\n", cycle->block, cycle->number,
          length.factor * cycle->amplitude_mm, length.decimals(2), stiff.factor * cycle->K_eff_kN_per_mm,
          stiff.decimals(4), number_text(work.factor * cycle->energy_kN_mm), number(cycle->damping(), 2),
          summary.acceptance.has_rules() ? device_verdict(acceptance).text() : "");
  }
}

void print_quantities(std::string& text, UnitSystem const& units, rules::LotView const& lot) {
  add(text, "\n{:<9} {:<6} {:>3} {:>10} {:>7} {:>10} {:>10} {:>10} {:>8} {:>8}\n", "lot", "unit", "n", "mean", "CoV %",
      "min", "max", "design", "mean %", "worst %");
  auto const percent = [](std::optional<double> const& v) { return v ? fmt::format("{:+.1f}", *v) : "-"; };
  for (auto const& q : lot.quantities) {
    auto const shown = shown_unit(q.unit, units);
    auto const significant = [&](std::optional<double> const& v) {
      return v ? number_text(shown.factor * *v) : std::string("-");
    };
    add(text, "{:<9} {:<6} {:>3} {:>10} {:>7} {:>10} {:>10} {:>10} {:>8} {:>8}\n", rules::name(q.quantity), shown.unit,
        q.count, significant(q.mean), number(q.cov_percent, 2), significant(q.min), significant(q.max),
        significant(q.nominal), percent(q.mean_deviation_percent), percent(q.worst_deviation_percent));
  }
  for (auto const& q : lot.quantities)
    for (auto const& outlier : q.outliers)
      add(text, "outlier: {}: {} {} {}, {}\n", printable(outlier.device), rules::name(q.quantity),
          number_text(shown_unit(q.unit, units).factor * outlier.value), shown_unit(q.unit, units).unit,
          outlier.reason);
}

void print_factors(std::string& text, UnitSystem const& units, rules::LotView const& lot) {
  bool const any = std::ranges::any_of(lot.quantities, [](auto const& q) { return !q.bounds.empty(); });
  if (!any) return;
  add(text, "\nProperty modification factors\n  {:<9} {:<28} {:>7} {:>7} {:>10} {:>10}\n", "property", "source", "min",
      "max", "lower", "upper");
  for (auto const& q : lot.quantities)
    for (auto const& b : q.bounds) {
      auto const [unit, factor] = shown_unit(q.unit, units);
      add(text, "  {:<9} {:<28} {:>7} {:>7.3f} {:>10} {:>10} {}", rules::name(q.quantity), b.source,
          b.no_lower.empty() ? fmt::format("{:.3f}", b.combined.min) : "-", b.combined.max,
          b.no_lower.empty() ? number_text(factor * b.lower) : "-", number_text(factor * b.upper), unit);
      if (!b.no_lower.empty()) add(text, "  {} (k = {:.4g})", b.no_lower, *q.tolerance_factor);
      text += '\n';
    }
  add(text, "  lambda_test, of these the part of the test's cycles, over the mean of the first three:\n");
  for (auto const& q : lot.quantities)
    if (auto const& t = q.test_factors)
      add(text, "  {:<9} {:.3f} (cycle {} of {}) to {:.3f} (cycle {} of {})\n", rules::name(q.quantity), t->min,
          t->min_cycle, printable(q.test_min_device), t->max, t->max_cycle, printable(q.test_max_device));
}

void print_warnings(std::string& text, Summary const& summary) {
  std::vector<std::string> lines;
  auto findings = study::warnings(summary);
  std::erase_if(findings, [](Finding const& finding) { return finding.kind == FindingKind::device_refused; });
  for (auto const& sentence : wording::sentences(findings, wording::in_report, summary.units()))
    lines.push_back(printable(sentence));
  print_list(text, "Warnings", lines);
}

void print_lot_verdicts(std::string& text, UnitSystem const& units, LotAcceptance const& acceptance) {
  if (!acceptance.has_rules()) return;
  text += "\nLot\n";
  print_assessment(text, units, acceptance.lot.sample);
  for (auto const& q : acceptance.lot.quantities)
    for (auto const& limit : q.mean_limits) print_assessment(text, units, limit);
}

void print_lot(std::string& text, Summary const& summary) {
  auto const& lot = summary.acceptance.lot;
  print_quantities(text, summary.units(), lot);
  print_lot_verdicts(text, summary.units(), summary.acceptance);
  print_factors(text, summary.units(), lot);
  if (!lot.note.empty()) add(text, "\n{}\n", lot.note);
  if (auto const mean = mean_analysis(summary.acceptance); !mean.sentence.empty()) add(text, "\n{}\n", mean.sentence);
}

}  // namespace

std::string inspection_text(Summary const& summary, bool details) {
  auto text = study::capitalised(overall_verdict(summary).text()) + "\n\n";
  if (summary.devices.size() == 1) {
    print_device_in_full(text, summary.units(), summary.devices.front());
    if (details) print_details(text, summary.units(), summary.devices.front());
    if (summary.without_corrections)
      print_list(text, "Verdict without corrections", {wording::remark(*summary.without_corrections, summary.units())});
    print_rule_set(text, summary.acceptance);
    print_lot_verdicts(text, summary.units(), summary.acceptance);
    if (summary.acceptance.has_rules() && !summary.acceptance.lot.note.empty())
      add(text, "\n{}\n", summary.acceptance.lot.note);
    return text;
  }
  add(text, "{}: {}\n", printable(summary.title), counted(summary.devices.size(), "device"));
  print_rule_set(text, summary.acceptance);
  print_devices(text, summary);
  if (details)
    for (auto const& device : summary.devices) {
      add(text, "\n{}\n", printable(device.name));
      print_details(text, summary.units(), device);
    }
  print_lot(text, summary);
  print_verticals(text, summary);
  print_warnings(text, summary);
  return text;
}

}  // namespace isolaw::render
