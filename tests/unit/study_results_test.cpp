// Tests that the descriptions of results in the code are those of docs/summary-json.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "isolaw/study/acceptance_results.hpp"
#include "isolaw/study/building_results.hpp"
#include "isolaw/study/conditions_results.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/study/published_results.hpp"
#include "isolaw/study/value_doubts.hpp"

namespace isolaw::study {
namespace {

// Returns the cells of each row of the table that stands under `heading` in a file of docs/.
std::vector<std::vector<std::string>> documented(std::string const& heading,
                                                 std::string const& file = "summary-json.md") {
  std::ifstream page(ISOLAW_SOURCE_DIR "/docs/" + file);
  std::vector<std::vector<std::string>> rows;
  bool within = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) within = line == "## " + heading;
    if (!within || !line.starts_with("| `")) continue;
    auto& row = rows.emplace_back();
    for (std::size_t at = 2; at < line.size();) {
      auto const end = line.find(" |", at);
      row.push_back(line.substr(at, end - at));
      at = end == std::string::npos ? line.size() : end + 3;
    }
  }
  return rows;
}

template <class Of, std::size_t count>
void expect_documented(Result<Of> const (&results)[count], std::vector<std::vector<std::string>> const& rows,
                       std::size_t first = 0) {
  ASSERT_GE(rows.size(), first + count);
  for (std::size_t i = 0; i < count; ++i) {
    auto const& [key, unit, heading, meaning, of, printed, digits] = results[i];
    auto const& row = rows[first + i];
    ASSERT_GE(row.size(), 3u);
    EXPECT_EQ(row[0], "`" + std::string(key) + "`");
    EXPECT_EQ(row[2], meaning) << key;
    bool const has_unit = !unit.empty() && unit != own_unit && row[1] != "object";
    if (has_unit) {
      EXPECT_EQ(row[1], "number, " + std::string(unit)) << key;
    }
  }
}

template <class Of, std::size_t count>
void expect_all_documented(Result<Of> const (&results)[count], std::vector<std::vector<std::string>> const& rows) {
  expect_documented(results, rows);
  EXPECT_EQ(rows.size(), count);
}

// The description of an object must name every member of the object.
template <class Of, std::size_t count, class Whole>
void expect_members(Result<Of> const (&results)[count], Result<Whole> const& whole) {
  for (auto const& row : results)
    EXPECT_NE(whole.meaning.find("`" + std::string(row.key) + "`"), std::string_view::npos) << row.key;
}

TEST(Results, AreDocumentedInTheirOrderWithTheirUnitsAndMeaning) {
  auto const parameter = documented("`laws[].devices[].parameters`");
  expect_all_documented(law_results, documented("`laws[]`"));
  expect_all_documented(lot_law_results, documented("`laws[].lot`"));
  expect_all_documented(fit_results, documented("`laws[].devices[]`"));
  expect_all_documented(outlier_results, documented("`outliers[]`"));
  expect_all_documented(published_law_results, documented("`published.laws[]`"));
  expect_all_documented(published_statement_results, documented("`published.statements[]`"));
  expect_members(score_results, columns(fit_results, {"blocks"})[0]);
  expect_members(test_results, columns(fit_results, {"tests"})[0]);
  expect_members(interval_results, columns(fit_results, {"intervals"})[0]);
  expect_documented(parameter_results, parameter);
  expect_documented(analysis_results, parameter, std::size(parameter_results));
  EXPECT_EQ(parameter.size(), std::size(parameter_results) + std::size(analysis_results));
}

TEST(Results, OfRecordsAreDocumentedInTheirOrderWithTheirUnitsAndMeaning) {
  auto const of = [](std::string const& heading) { return documented(heading, "inspection-json.md"); };
  expect_all_documented(verdict_results, of("`result`"));
  expect_members(remark_results, columns(verdict_results, {"failing"})[0]);
  expect_members(requirement_results, columns(verdict_results, {"requirements"})[0]);
  expect_all_documented(doubt_results, of("`doubts[]`"));
  expect_all_documented(effect_results, of("`effects[]`"));
  expect_all_documented(block_results, of("`blocks[]`"));
  expect_all_documented(cycle_results, of("`blocks[].cycles[]`"));
  expect_all_documented(stability_results, of("`blocks[].stability.K_eff`, `.energy`, `.damping`"));
  expect_all_documented(level_results, of("`levels[]`"));
  expect_all_documented(vertical_results, of("`vertical`"));
  expect_all_documented(assessment_results, of("An assessment"));
  expect_all_documented(quantity_results, of("`assessment.lot.quantities[]`"));
  expect_all_documented(factor_results, of("`assessment.lot.factors[]`"));
  expect_members(test_factor_results, columns(quantity_results, {"lambda_test"})[0]);
  expect_all_documented(lot_outlier_results, of("`assessment.lot.outliers[]`"));
}

TEST(Results, OfBuildingsAreDocumentedInTheirOrderWithTheirUnitsAndMeaning) {
  auto const of = [](std::string const& heading) { return documented(heading, "building-json.md"); };
  expect_all_documented(answer_results, of("`laws[]`"));
  expect_all_documented(distribution_results, of("`laws[].quantities`"));
  expect_all_documented(coverage_results, of("`laws[].coverage`"));
  expect_all_documented(judged_results, of("`laws[].limits[]`"));
  expect_all_documented(checked_results, of("`laws[].checked[]`"));
  expect_all_documented(history_results, of("`laws[].histories[]`"));
}

TEST(Results, OfConditionsAreDocumentedInTheirOrderWithTheirUnitsAndMeaning) {
  expect_all_documented(conditions_test_results, documented("`tests[]`", "conditions.md"));
  expect_all_documented(conditions_level_results, documented("`levels[]`", "conditions.md"));
  expect_all_documented(conditions_factor_results, documented("`levels[].factor`", "conditions.md"));
  expect_all_documented(conditions_cycle_results, documented("`tests[].cycles[]`", "conditions.md"));
  expect_all_documented(bound_law_results, documented("`bound_laws[].lower`", "conditions.md"));
  expect_all_documented(at_reference_results, documented("`at_reference[]`", "conditions.md"));
  expect_all_documented(converting_factor_results, documented("`at_reference[].factors[]`", "conditions.md"));
  expect_all_documented(planned_test_results, documented("`plan[]`", "conditions.md"));
}

TEST(Results, HaveAHeadingForEachCell) {
  auto const texts = [](auto const& row) {
    std::vector<std::string> of;
    for (auto const& heading : headings(row)) of.push_back(heading.text());
    return of;
  };
  EXPECT_EQ(texts(columns(analysis_results, {"open_range"})[0]),
            (std::vector<std::string>{"open range lower", "open range upper"}));
  EXPECT_EQ(texts(columns(fit_results, {"objective"})[0]),
            (std::vector<std::string>{"mean OF [-]", "std OF [-]", "best OF [-]"}));
  EXPECT_EQ(texts(columns(cycle_results, {"D_y_mm"})[0]), std::vector<std::string>{"D_y [mm]"});
}

// The page looks up a property of the lot among the properties of the devices' cycles by its heading. The lot and the
// cycles must therefore use the same headings.
TEST(Results, OfALotsPropertiesAreNamedAsThoseOfCycles) {
  for (auto const quantity : rules::measured_quantities())
    EXPECT_EQ(std::ranges::count(cycle_results, rules::name(quantity), &Result<CycleOf>::heading), 1)
        << rules::name(quantity);
  for (auto const& followed : followed_properties)
    EXPECT_EQ(std::ranges::find(cycle_results, followed.key, &Result<CycleOf>::key)->heading, followed.name);
}

TEST(Results, UndefinedIsNoValue) {
  EXPECT_TRUE(std::holds_alternative<std::monostate>(columns(law_results, {"beta"})[0].value(LawResult{})));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(columns(parameter_results, {"tied_to"})[0].value(ParameterFit{})));
  ParameterFit fit;
  fit.at_bound = fit::AtBound::upper;
  EXPECT_EQ(std::get<std::string_view>(columns(parameter_results, {"at_bound"})[0].value(fit)), "upper");
}

}  // namespace
}  // namespace isolaw::study
