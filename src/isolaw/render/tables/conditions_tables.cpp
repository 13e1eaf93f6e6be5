#include "isolaw/render/tables/conditions_tables.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "isolaw/base/symbol.hpp"
#include "isolaw/render/tables/csv.hpp"
#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/study/conditions_results.hpp"

namespace isolaw::render {
namespace {

constexpr std::string_view all_effects = "all together";

// The first columns of the table of observations, which describe the test. The columns with the values of the cycle
// follow them.
constexpr auto of_test = columns(study::conditions_test_results,
                                 {"device", "test", "order", "block", "temperature_C", "frequency_Hz", "load_kN",
                                  "strain_percent", "aged_days", "aged_at_C", "rest_h", "role", "effect"});

std::string latex_cells(double factor, std::optional<conditions::Interval> const& interval, std::string_view status) {
  auto const low = interval ? fmt::format("{:.3f}", interval->low) : "",
             high = interval ? fmt::format("{:.3f}", interval->high) : "";
  return fmt::format("{:.3f}{} & {}", factor, low == high ? "" : fmt::format(" ({} to {})", low, high), status);
}

std::string latex_cells(conditions::Factor const& factor) {
  if (factor.status == conditions::Status::not_covered) return "-- & NOT COVERED";
  return latex_cells(factor.lambda(), interval(factor, conditions::About::mean), study::status_word(factor));
}

// Returns the cells for the factor of all effects together. If the factor lacks an effect, `at_end` ("at least" or "at
// most") is written before it, because the complete factor can only be farther from 1.
std::string latex_cells(conditions::Combined const& all, std::string_view at_end) {
  if (!all.complete()) return fmt::format("{} {:.3f} & NOT COVERED", at_end, all.factor);
  return latex_cells(all.factor, all.interval, name(all.status));
}

// Returns the symbol of a property, such as K_eff, or its name if it has no symbol.
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
  // Adds the row of a bound for all effects together. It fills only the columns of the factor, its status and the
  // interval of the mean.
  auto const bound_row = [&](rules::Quantity quantity, std::string_view side, conditions::Combined const& all) {
    table.add(quantity, all_effects, side).empty(of_level.size() - 3);
    table.add(all.complete() ? std::optional(all.factor) : std::nullopt, name(all.status)).empty(3);
    table.add(all.interval ? study::Ends{all.interval->low, all.interval->high} : study::Ends{});
    table.add(study::Ends{}, study::Ends{}, study::Ends{}).empty(1).end_row();
  };
  for (auto const& row : result.bounds) {
    bound_row(row.quantity, largest, row.max);
    bound_row(row.quantity, smallest, row.min);
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
  auto const row = [&](std::string_view property, std::string_view effect, std::string_view max, std::string_view min) {
    text += fmt::format("{} & {} & {} & {} \\\\\n", property, effect, max, min);
  };
  for (auto const& bound : result.bounds) {
    text += "\\midrule\n";
    auto property = latex_property(bound.quantity);
    for (auto const& of : result.design)
      if (of.quantity == bound.quantity)
        row(std::exchange(property, ""), name(of.effect), latex_cells(of.max), latex_cells(of.min));
    row("", all_effects, latex_cells(bound.max, "at least"), latex_cells(bound.min, "at most"));
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace isolaw::render
