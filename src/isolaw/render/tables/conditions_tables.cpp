#include "isolaw/render/tables/conditions_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "isolaw/base/symbol.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/study/conditions_results.hpp"

namespace isolaw::render {
namespace {

constexpr std::string_view all_effects = "all together";

// The combined factor as one factor, without a number of devices.
conditions::Factor as_factor(conditions::Combined const& all) {
  conditions::Factor factor{.ln = std::log(all.factor), .status = all.status};
  if (all.interval) factor.se = all.se, factor.df = all.df;
  return factor;
}

// The columns of a test that an observation shows beside the values of its cycle.
constexpr auto of_test = columns(study::conditions_test_results,
                                 {"device", "test", "order", "block", "temperature_C", "frequency_Hz", "load_kN",
                                  "strain_percent", "aged_days", "aged_at_C", "rest_h", "role", "effect"});

std::string latex_factor(conditions::Factor const& factor) {
  if (factor.status == conditions::Status::not_covered) return "-- & NOT COVERED";
  auto const found = interval(factor, conditions::About::mean);
  auto const low = found ? fmt::format("{:.3f}", found->low) : "",
             high = found ? fmt::format("{:.3f}", found->high) : "";
  return fmt::format("{:.3f}{} & {}", factor.lambda(), low == high ? "" : fmt::format(" ({} to {})", low, high),
                     study::status_word(factor));
}

// A property's symbol, such as K_eff, or its name.
std::string latex_property(rules::Quantity quantity) {
  auto const name = rules::name(quantity);
  bool const is_symbol = name.find('_') != std::string_view::npos;
  return is_symbol ? latex_symbol(name) : latex_text(name);
}

}  // namespace

std::string conditions_csv(ConditionsResult const& result, UnitSystem const& units) {
  constexpr auto of_level =
      columns(study::conditions_level_results, {"quantity", "effect", "level", "at", "unit", "aged_days", "aged_at_C"});
  constexpr auto of_factor =
      columns(study::conditions_factor_results,
              {"lambda", "status", "devices", "line_error", "drift", "mean", "device", "system", "prototypes", "lack"});
  CsvTable table(units);
  table.head(of_level).head(of_factor).end_row();
  auto const factor_row = [&](conditions::Factor const& factor) {
    table.cells(of_factor, study::ConditionFactor{factor, result.installed}).end_row();
  };
  for (auto const& row : result.levels) {
    table.cells(of_level, row, study::unit_of(row.effect));
    factor_row(row.factor);
  }
  auto const design_row = [&](rules::Quantity quantity, std::string_view effect, std::string_view side,
                              conditions::Factor const& factor) {
    table.add(quantity, effect, side).empty(of_level.size() - 3);
    factor_row(factor);
  };
  constexpr std::string_view largest = "largest over the design", smallest = "smallest over the design";
  for (auto const& row : result.design) {
    design_row(row.quantity, name(row.effect), largest, row.max);
    design_row(row.quantity, name(row.effect), smallest, row.min);
  }
  for (auto const& row : result.bounds) {
    design_row(row.quantity, all_effects, largest, as_factor(row.max));
    design_row(row.quantity, all_effects, smallest, as_factor(row.min));
  }
  return table.take();
}

std::string observations_csv(ConditionsResult const& result, UnitSystem const& units) {
  constexpr auto of_cycle =
      columns(study::conditions_cycle_results,
              {"number", "history", "K_eff_kN_per_mm", "damping_percent", "energy_kN_mm", "Q_d_kN", "K_d_kN_per_mm"});
  CsvTable table(units);
  table.head(of_test).head(of_cycle).end_row();
  for (auto const& test : result.tests)
    for (auto const& cycle : test.cycles) table.cells(of_test, test).cells(of_cycle, cycle).end_row();
  return table.take();
}

std::string conditions_tex(ConditionsResult const& result, UnitSystem const&) {
  std::string text =
      "% Factors on the value at reference over the design conditions, with 95 % intervals of the mean.\n";
  text += "% Needs in the preamble: \\usepackage{booktabs}\n";
  text += "\\begin{tabular}{@{}llrlrl@{}}\n\\toprule\n";
  text += "Property & Effect & Largest & & Smallest & \\\\\n";
  auto const row = [&](std::string_view property, std::string_view effect, conditions::Factor const& max,
                       conditions::Factor const& min) {
    text += fmt::format("{} & {} & {} & {} \\\\\n", property, effect, latex_factor(max), latex_factor(min));
  };
  for (auto const& bound : result.bounds) {
    text += "\\midrule\n";
    auto property = latex_property(bound.quantity);
    for (auto const& of : result.design)
      if (of.quantity == bound.quantity) row(std::exchange(property, ""), name(of.effect), of.max, of.min);
    row("", all_effects, as_factor(bound.max), as_factor(bound.min));
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace isolaw::render
