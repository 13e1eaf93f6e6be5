// The descriptions of results against the page that documents them.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "isolaw/study/cycle_results.hpp"

namespace isolaw::study {
namespace {

// The rows of the table under a heading, cell by cell.
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
    auto const& [key, unit, heading, meaning, of, digits] = results[i];
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

TEST(Results, AreDocumentedInTheirOrderWithTheirUnitsAndMeaning) {
  auto const law = documented("`laws[]`"), lot = documented("`laws[].lot`"), fit = documented("`laws[].devices[]`");
  auto const parameter = documented("`laws[].devices[].parameters`");
  expect_documented(law_results, law);
  EXPECT_EQ(law.size(), std::size(law_results));
  expect_documented(lot_law_results, lot);
  EXPECT_EQ(lot.size(), std::size(lot_law_results));
  expect_documented(fit_results, fit);
  EXPECT_EQ(fit.size(), std::size(fit_results));
  auto const cycle = documented("`blocks[].cycles[]`", "inspection-json.md");
  expect_documented(cycle_results, cycle);
  EXPECT_EQ(cycle.size(), std::size(cycle_results));
  expect_documented(parameter_results, parameter);
  expect_documented(analysis_results, parameter, std::size(parameter_results));
  EXPECT_EQ(parameter.size(), std::size(parameter_results) + std::size(analysis_results));
}

TEST(Results, UndefinedIsNoValue) {
  EXPECT_TRUE(std::holds_alternative<std::monostate>(columns(law_results, {"beta"})[0].of(LawResult{})));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(columns(parameter_results, {"tied_to"})[0].of(ParameterFit{})));
  ParameterFit fit;
  fit.at_bound = "upper";
  EXPECT_EQ(std::get<std::string_view>(columns(parameter_results, {"at_bound"})[0].of(fit)), "upper");
}

}  // namespace
}  // namespace isolaw::study
