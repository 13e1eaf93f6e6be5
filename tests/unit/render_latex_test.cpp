// Tests tables in LaTeX: numbers, escaping, and that every row has as many cells as its table has columns.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/study/front_view.hpp"
#include "isolaw/study/spoken.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

std::vector<std::string> lines(std::string const& text) {
  std::vector<std::string> rows;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) rows.push_back(line);
  return rows;
}

std::size_t count(std::string_view part, std::string_view text) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

// Counts the separators of cells: each & without a backslash before it.
std::size_t separators(std::string const& line) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (line[i] == '\\')
      ++i;
    else if (line[i] == '&')
      ++found;
  return found;
}

bool is_row(std::string const& line) {
  return line.ends_with("\\\\") || line.ends_with("\\\\*");
}

// Every { must be closed and every $ paired. Characters after a backslash do not count.
void expect_balanced(std::string const& text) {
  int depth = 0, dollars = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
      continue;
    }
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    dollars += text[i] == '$' ? 1 : 0;
    ASSERT_GE(depth, 0) << text.substr(0, i);
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(dollars % 2, 0);
}

TEST(Latex, NumbersKeepFourDigits) {
  EXPECT_EQ(latex_number(1.6), "$1.600$");
  EXPECT_EQ(latex_number(0.0791), "$0.07910$");
  EXPECT_EQ(latex_number(232000.0), "$2.320\\times10^{5}$");
  EXPECT_EQ(latex_number(-2.5e-6), "$-2.500\\times10^{-6}$");
  EXPECT_EQ(latex_number(5.24e-3, 2), "$0.0052$");
  EXPECT_EQ(latex_number(1234.0), "$1234$");
  EXPECT_EQ(latex_number(0.0), "$0$");
  EXPECT_EQ(latex_number(std::nullopt), "--");
}

TEST(Latex, NothingOfANameIsACommand) {
  EXPECT_EQ(latex_text("a&b%c$d#e_f{g}"), "a\\&b\\%c\\$d\\#e\\_f\\{g\\}");
  EXPECT_EQ(latex_text("\\input{x}"), "\\textbackslash{}input\\{x\\}");
  EXPECT_EQ(latex_text("~^"), "\\textasciitilde{}\\textasciicircum{}");
  EXPECT_EQ(latex_text("a--b ''"), "a-{}-b '{}'");
  EXPECT_EQ(latex_text("bouc-wen"), "bouc-wen");
  EXPECT_EQ(latex_text("[x]*"), "{[}x{]}{*}");
  EXPECT_EQ(latex_text("line\nbreak"), "line\\textbackslash{}nbreak");
  EXPECT_EQ(latex_text("Ljubljana č é μ"), "Ljubljana č é $\\mu$");
  EXPECT_EQ(latex_text("装置"), "(U+88C5)(U+7F6E)");
}

TEST(Latex, Units) {
  EXPECT_EQ(latex_unit("N/m^3"), "N/m$^{3}$");
  EXPECT_EQ(latex_unit("kN/mm"), "kN/mm");
  EXPECT_EQ(latex_unit("-"), "");
}

TEST(Latex, TableA5HasMeanStdAndBestOfEveryDevice) {
  auto summary = fixture::lot();
  auto& fit = summary.laws[0].devices[0];
  fit.objective = {0.11, 0.00524, 0.1};
  fit.parameters[0].value = {1.6, 0.07, 1.61};
  auto const tex = table_a5_tex(summary);
  expect_balanced(tex);
  EXPECT_NE(tex.find("Bilinear & $\\mathit{OF}$ & $0.1100$ & $0.0052$ & $0.1000$ & "), std::string::npos) << tex;
  EXPECT_NE(tex.find(" & $K_{1}$ (kN/mm) & $1.600$ & $0.070$ & $1.610$ & "), std::string::npos);
  EXPECT_NE(tex.find("\\usepackage{booktabs,longtable}"), std::string::npos);
}

TEST(Latex, TableA5StatesLargeValuesInAPowerOfTen) {
  auto summary = fixture::lot();
  auto& value = summary.laws[1].devices[1].parameters[0].value;
  value = {437000.0, 1720.0, 440000.0};
  auto const tex = table_a5_tex(summary);
  EXPECT_NE(tex.find(" & $k_{b+}$ ($10^{5}$ N/m) & "), std::string::npos);
  EXPECT_NE(tex.find(" & $4.370$ & $0.017$ & $4.400$"), std::string::npos);
}

TEST(Latex, RowsHaveAsManyCellsAsTheTableHasColumns) {
  for (int const devices : {1, 2, 4, 7}) {
    auto summary = fixture::lot(devices);
    summary.laws[1].devices[0] = DeviceFit{};  // a device without a fit still has a row
    summary.laws[1].devices[0].device = "D1";
    auto const tex = table_a5_tex(summary);
    auto const of_columns = tex.find("ll*{");
    ASSERT_NE(of_columns, std::string::npos);
    auto const columns = 2 + std::stoul(tex.substr(of_columns + 4));
    for (auto const& line : lines(tex)) {
      if (!is_row(line) || line.find("caption") != std::string::npos || line.find("continued") != std::string::npos)
        continue;
      // A heading over three columns has two separators fewer than three cells.
      EXPECT_EQ(separators(line) + 2 * count("\\multicolumn{3}", line) + 1, columns) << line;
    }
  }
}

TEST(Latex, HostileNamesLeaveTheTablesWhole) {
  auto summary = fixture::lot();
  summary.devices[0].name = "}\\end{longtable} & $ \\\\ %";
  for (auto& law : summary.laws) law.devices[0].device = summary.devices[0].name;
  auto const tex = table_a5_tex(summary);
  expect_balanced(tex);
  EXPECT_EQ(count("\\end{longtable}", tex), 1u);
  EXPECT_NE(tex.find("\\}\\textbackslash{}end\\{longtable\\} \\& \\$ \\textbackslash{}\\textbackslash{} \\%"),
            std::string::npos);
}

TEST(Latex, LongNamesTakeFewerDevicesSideBySide) {
  auto summary = fixture::lot(4);
  EXPECT_NE(table_a5_tex(summary).find("ll*{9}"), std::string::npos);
  summary.devices[3].name = std::string(200, 'W');
  EXPECT_NE(table_a5_tex(summary).find("ll*{6}"), std::string::npos);
}

TEST(Latex, NothingToTabulate) {
  auto const tex = table_a5_tex(Summary{});
  for (auto const& line : lines(tex)) EXPECT_TRUE(line.starts_with("%")) << line;
}

TEST(Latex, RobustnessAndFront) {
  auto const summary = fixture::lot(3, 7);
  auto const robustness = robustness_tex(summary);
  expect_balanced(robustness);
  for (auto const& law : summary.laws)
    EXPECT_NE(robustness.find("\n" + display_name(law) + " & "), std::string::npos) << law.id;
  EXPECT_NE(robustness.find("Bilinear & $0.1370$ & $0.01250$ & $0.1288$ & $0.1421$ & yes \\\\"), std::string::npos);
  auto const front = front_tex(summary);
  expect_balanced(front);
  EXPECT_NE(front.find("Jankowski & $0.07900$ & $0.3030$ & yes & -- \\\\"), std::string::npos);
  EXPECT_NE(front.find("Bouc-Wen & $0.08900$ & $0.2171$ & no & Vaiana \\\\"), std::string::npos) << front;
  for (auto const* tex : {&robustness, &front})
    for (auto const& line : lines(*tex))
      if (is_row(line) && line.find("multicolumn") == std::string::npos) {
        EXPECT_EQ(separators(line), tex == &front ? 4u : 5u) << line;
      }
}

TEST(Front, DominatedByThoseOnIt) {
  std::vector<FrontPoint> const points{
      {"a", 1.0, 3.0, true}, {"b", 2.0, 2.0, true}, {"c", 2.0, 4.0, false}, {"d", 3.0, 5.0, false}};
  EXPECT_EQ(dominating(points, points[0]), std::vector<std::string>{});
  EXPECT_EQ(dominating(points, points[2]), (std::vector<std::string>{"a", "b"}));
  // The point c dominates d too, but c is not on the front.
  EXPECT_EQ(dominating(points, points[3]), (std::vector<std::string>{"a", "b"}));
}

TEST(Front, CsvIsSortedByAccuracy) {
  auto const rows = lines(front_csv(fixture::lot(3, 4)));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[1], "mean of the runs,jankowski,0.079,0.303,yes,\r");
  EXPECT_EQ(rows[2], "mean of the runs,vaiana,0.088,0.2164,yes,\r");
  EXPECT_EQ(rows[3], "mean of the runs,hwang-wu,0.117,0.3341,no,\"jankowski, vaiana\"\r");
  EXPECT_EQ(rows[4], "mean of the runs,bilinear,0.137,0.1421,yes,\r");
}

TEST(TableA5, ThePapersNameWhereItIsAnotherOne) {
  auto summary = fixture::lot();
  for (auto& fit : summary.laws[0].devices)
    if (fit.parameters.size() > 2) fit.parameters[2].paper_name = "F_y";
  auto const rows = lines(table_a5_csv(summary));
  EXPECT_TRUE(rows[3].starts_with("bilinear,K2,kN/mm,yes,,")) << rows[3];
  EXPECT_TRUE(rows[4].starts_with("bilinear,xy,mm,yes,F_y,")) << rows[4];
  auto const tex = table_a5_tex(summary);
  EXPECT_NE(tex.find(" & $x_{y}$ (mm), paper: $F_{y}$ & "), std::string::npos);
  EXPECT_EQ(count("paper: ", tex), count(" & $x_{y}$ (mm)", tex));
  expect_balanced(tex);
}

TEST(TableA5, CsvHasTheBestToo) {
  auto summary = fixture::lot();
  summary.laws[0].devices[0].parameters[0].value = {1.6, 0.07, 1.61};
  auto const rows = lines(table_a5_csv(summary));
  EXPECT_EQ(
      rows[0],
      "law,quantity,unit,calibrated,in the paper,D1 mean,D1 std,D1 best,D2 mean,D2 std,D2 best,D3 mean,D3 std,D3 best\r");
  EXPECT_TRUE(rows[1].starts_with("bilinear,OF,-,,,")) << rows[1];
  EXPECT_TRUE(rows[2].starts_with("bilinear,K1,kN/mm,yes,,1.6,0.07,1.61,")) << rows[2];
}

}  // namespace
}  // namespace isolaw::render
