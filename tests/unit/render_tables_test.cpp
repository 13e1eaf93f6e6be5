// Tests the CSV tables cell by cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/render/tables/tables.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// Returns the rows of a CSV table (RFC 4180).
Rows read(std::string_view text) {
  Rows rows{{""}};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char const c = text[i];
    if (quoted) {
      if (c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
        rows.back().back() += '"';
        ++i;
      } else if (c == '"') {
        quoted = false;
      } else {
        rows.back().back() += c;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      rows.back().emplace_back();
    } else if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
      ++i;
      rows.push_back({""});
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();  // the empty row after the last line break
  return rows;
}

void expect_rectangular(Rows const& rows) {
  for (auto const& row : rows) EXPECT_EQ(row.size(), rows.front().size()) << row.front();
}

TEST(CsvCell, FormulasAreDisarmedAndNumbersAreNot) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("@cmd"), "'@cmd");
  EXPECT_EQ(csv_cell("-cmd"), "'-cmd");
  EXPECT_EQ(csv_cell("+cmd|x"), "'+cmd|x");
  EXPECT_EQ(csv_cell("-1.5e3"), "-1.5e3");
  EXPECT_EQ(csv_cell("+2"), "+2");
  EXPECT_EQ(csv_cell("D 1"), "D 1");
  EXPECT_EQ(csv_cell("-"), "-");  // as the unit of a number without dimension this cell must stay as it is
}

TEST(CsvCell, QuotesWhatNeedsThem) {
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("say \"x\""), "\"say \"\"x\"\"\"");
  EXPECT_EQ(csv_cell("=a,b\n"), "\"'=a,b\n\"");
}

TEST(Tables, ParametersInTheLayoutOfTableA5) {
  auto summary = fixture::lot();
  auto& fit = summary.laws[0].devices[0];
  fit.objective = {0.11, 0.00524, 0.1};
  fit.parameters[0].value = {1.6, 0.07, 1.61};
  fit.parameters[0].at_bound = fit::AtBound::lower;
  summary.laws[0].devices[2].parameters[0].at_bound = fit::AtBound::upper;
  for (std::size_t d = 0; d < 3; ++d)
    summary.laws[0].devices[d].parameters[0].percent_of_lot = -4.0 * static_cast<double>(d);
  auto const rows = read(parameters_csv(summary));
  expect_rectangular(rows);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"law", "quantity", "unit", "lower bound", "upper bound", "calibrated",
                                               "D1 mean", "D1 std", "D2 mean", "D2 std", "D3 mean", "D3 std",
                                               "Delta_n [-]", "best at bound"}));
  EXPECT_EQ((std::vector<std::string>(rows[1].begin(), rows[1].begin() + 8)),
            (std::vector<std::string>{"bilinear", "OF", "-", "", "", "", "0.11", "0.00524"}));
  EXPECT_EQ((std::vector<std::string>(rows[2].begin(), rows[2].begin() + 8)),
            (std::vector<std::string>{"bilinear", "K1", "kN/mm", "1", "1.9", "yes", "1.6", "0.07"}));
  EXPECT_EQ(rows[2][12], "0.08");
  EXPECT_EQ(rows[2].back(), "D1 lower; D3 upper");
  EXPECT_EQ(rows.size(), 1u + (1u + 3u) + (1u + 5u) + (1u + 3u));
}

TEST(Tables, BoundsScaledFromEachRecordAreNotShownAsOne) {
  auto summary = fixture::lot();
  summary.laws[0].devices[1].parameters[0].upper = 2.5;
  auto const rows = read(parameters_csv(summary));
  EXPECT_EQ(rows[2][3], "1");
  EXPECT_EQ(rows[2][4], "per device");
}

TEST(Tables, DeviceWithoutTheLawLeavesItsCellsEmpty) {
  auto summary = fixture::lot();
  summary.laws[0].devices.erase(summary.laws[0].devices.begin());
  auto const rows = read(parameters_csv(summary));
  expect_rectangular(rows);
  EXPECT_EQ(rows[1][6], "");
  EXPECT_NE(rows[1][8], "");
}

TEST(Tables, Objective) {
  auto summary = fixture::lot();
  auto& fit = summary.laws[1].devices[0];
  fit.objective = {0.09, std::nullopt, 0.08};
  fit.K_eff_error_percent = -1.25;
  fit.integration_shift = 2e-5;
  fit.failed_runs = 1;
  fit.evaluations = 100000;
  fit.failed_evaluations = 250;
  fit.failure = "=infinite, force";
  auto const rows = read(objective_csv(summary));
  expect_rectangular(rows);
  EXPECT_EQ(rows[0][2], "mean OF [-]");
  EXPECT_EQ(rows[0][9], "K_eff error [%]");
  auto const found = std::ranges::find_if(rows, [](auto const& r) { return r[0] == "vaiana" && r[1] == "D1"; });
  ASSERT_NE(found, rows.end());
  auto const& row = *found;
  EXPECT_EQ((std::vector<std::string>(row.begin(), row.begin() + 10)),
            (std::vector<std::string>{"vaiana", "D1", "0.09", "", "0.08", "20", "1", "100000", "250", "-1.25"}));
  EXPECT_EQ(row[12], "2e-05");
  EXPECT_EQ(row[13], "ok");
  EXPECT_EQ(row[14], "'=infinite, force");
  EXPECT_EQ(rows[0].back(), "missing runs");
}

TEST(Tables, ObjectiveByTimeWhereSamplesHaveOtherWeights) {
  auto summary = fixture::lot();
  summary.laws[1].devices[0].objective_by_time = 0.125;
  auto const rows = read(objective_csv(summary));
  expect_rectangular(rows);
  EXPECT_EQ(rows[0].back(), "OF by time [-]");
  auto const found = std::ranges::find_if(rows, [](auto const& r) { return r[0] == "vaiana" && r[1] == "D1"; });
  ASSERT_NE(found, rows.end());
  EXPECT_EQ(found->back(), "0.125");
  EXPECT_EQ(std::ranges::count(rows, "", [](auto const& r) { return r.back(); }), std::ssize(rows) - 2);
}

TEST(Tables, Robustness) {
  auto summary = fixture::lot();
  summary.laws[2].beta = std::nullopt;
  summary.laws[2].on_front = false;
  summary.laws[2].beta_note = "mean of a9 near zero";
  auto const rows = read(robustness_csv(summary));
  expect_rectangular(rows);
  EXPECT_EQ(rows[1], (std::vector<std::string>{"bilinear", "0.137", "0.0125", "0.12878", "0.1421", "yes", ""}));
  EXPECT_EQ(rows[3][4], "");
  EXPECT_EQ(rows[3][6], "mean of a9 near zero");
}

TEST(Tables, PropertiesWithARefusedDevice) {
  auto const rows = read(cycles_csv(fixture::lot()));
  expect_rectangular(rows);
  ASSERT_EQ(rows.size(), 1u + 3u * 3u + 1u);
  auto const column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(rows[0], name) - rows[0].begin());
  };
  EXPECT_EQ(rows[1][0], "D1");
  EXPECT_EQ(rows[1][column("reported")], "no");
  EXPECT_EQ(rows[3][column("block")], "1");
  EXPECT_EQ(rows[3][column("cycle")], "3");
  EXPECT_EQ(rows[3][column("counts")], "yes");
  EXPECT_EQ(rows[3][column("reported")], "yes");
  EXPECT_EQ(rows[3][column("strain [%]")], "100");  // the amplitude of 208 mm equals the rubber thickness
  EXPECT_EQ(rows[3][column("G [MPa]")], "");        // the rubber area is not given
  EXPECT_EQ(rows[10][0], fixture::nasty_name);
  EXPECT_EQ(rows[10][2], "");
  EXPECT_EQ(rows[10].back(), "line 7: not a number: \"<script>alert(2)</script>\"");
}

TEST(LotLaw, PopulationOfTheReducedFormHasNoCellsForTheRedundantParameter) {
  auto summary = fixture::analysed(fixture::lot());
  auto& law = summary.laws[1];
  auto& population = *law.population;
  population.covariance.assign(population.names.size(), std::vector<double>(population.names.size(), 0.01));
  auto const redundant = population.names[1];
  for (auto* vector : {&population.medians, &population.relative_std}) vector->erase(vector->begin() + 1);
  population.names.erase(population.names.begin() + 1);
  auto const rows = read(lot_law_csv(summary));
  expect_rectangular(rows);
  std::size_t found = 0;
  for (auto const& row : rows) {
    if (row[0] != law.id) continue;
    auto const place = std::ranges::find(population.names, row[1]) - population.names.begin();
    if (row[1] == redundant) {
      EXPECT_EQ(row[6], "");
      EXPECT_EQ(row[7], "");
    } else {
      EXPECT_NEAR(std::stod(row[6]), population.medians[static_cast<std::size_t>(place)],
                  1e-5 * std::abs(std::stod(row[6])));
      EXPECT_EQ(row[7].empty(), std::isnan(population.relative_std[static_cast<std::size_t>(place)]));
    }
    ++found;
  }
  EXPECT_EQ(found, law.devices.front().parameters.size());
}

}  // namespace
}  // namespace isolaw::render
