// Tests figures: their data, how names of devices are quoted so that they never run as commands, and the drawings by
// gnuplot.
#include <expat.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/figure_script.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/figures/gnuplot.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/page/page_data.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/law_look.hpp"
#include "isolaw/study/spoken.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

std::map<std::string, Figure> figures_of(Summary const& summary, FigureChoice choice = FigureChoice::lot) {
  std::map<std::string, Figure> by_name;
  for_each_figure(summary, choice, [&](Figure const& figure) { by_name[figure.name] = figure; });
  return by_name;
}

using Row = std::vector<std::string>;
using Blocks = std::vector<std::vector<Row>>;

// Splits a line into words and quoted words as gnuplot does.
Row cells(std::string const& line) {
  Row row;
  for (std::size_t i = 0; i < line.size();) {
    auto const end = line[i] == '"' ? line.find('"', i + 1) : std::min(line.find(' ', i), line.size());
    row.push_back(line[i] == '"' ? line.substr(i + 1, end - i - 1) : line.substr(i, end - i));
    i = end + (line[i] == '"' ? 2 : 1);
  }
  return row;
}

Blocks blocks(std::string const& data) {
  Blocks table{{}};
  std::istringstream lines(data);
  int empty = 0;
  for (std::string line; std::getline(lines, line);) {
    empty = line.empty() ? empty + 1 : 0;
    if (empty == 2) table.emplace_back();
    if (!line.empty() && line.front() != '#') table.back().push_back(cells(line));
  }
  return table;
}

double value(std::string const& cell) {
  return std::stod(cell);
}

TEST(Gnuplot, StringsEndWhereTheyEnd) {
  EXPECT_EQ(gnuplot_string("D1"), "'D1'");
  EXPECT_EQ(gnuplot_string("it's"), "'it''s'");
  EXPECT_EQ(gnuplot_string("a\n'; system 'x'"), "'a\\n''; system ''x'''");
  EXPECT_EQ(gnuplot_string("`x` @y {z} \\"), "'`x` @y {z} \\'");
}

TEST(Gnuplot, LabelsRaiseExponentsAndPrintTheRest) {
  EXPECT_EQ(gnuplot_label("K_1 (N/m^3)"), "'K\\_1 (N/m^{3})'");
  EXPECT_EQ(gnuplot_label("beta (1/mm^n)"), "'beta (1/mm^{n})'");
  EXPECT_EQ(gnuplot_label("a9 (10^-6 N/cm^3)"), "'a9 (10^{-6} N/cm^{3})'");
}

TEST(Gnuplot, DataKeepOneRowToALine) {
  DataTable table;
  table.comment("two\nlines").row("say \"x\"\n# \\n", 0.1, std::optional<double>());
  EXPECT_EQ(table.take(), "# two\\nlines\n\"say 'x'\\\\n# \\\\n\" 0.1 NaN\n");
}

TEST(FileStems, AreSafeAndDifferent) {
  auto const stems = file_stems({"D1", "d1", "../x", "a/b", "a b", "", ".hidden", std::string(300, 'x'), "é\n"});
  EXPECT_EQ(stems[0], "D1");
  EXPECT_EQ(stems[1], "d1_2");  // where file names ignore case, "D1" and "d1" would be one file
  EXPECT_EQ(stems[2], "_._x");
  std::set<std::string> different;
  for (auto const& stem : stems) {
    EXPECT_EQ(stem.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-"),
              std::string::npos);
    EXPECT_NE(stem.front(), '.');
    EXPECT_LE(stem.size(), 64u);
    EXPECT_TRUE(different.insert(stem).second) << stem;
  }
}

TEST(FileStems, AnInventedNumberTakesNoName) {
  auto const stems = file_stems({"a", "a", "a_2"});
  EXPECT_EQ(std::set<std::string>(stems.begin(), stems.end()).size(), 3u);
}

TEST(FileStems, AnEndingMakesNoOtherName) {
  auto const stems = file_stems({"a_abe", "a", "b", "B_Abe-y0", "b_x"}, {"abe", "abe-y0"});
  EXPECT_EQ(stems, (std::vector<std::string>{"a_abe", "a_2", "b", "B_Abe-y0_2", "b_x"}));
}

// For the laws of the published study, the figure has the values of this campaign and the printed ones of the study, in
// separate blocks of data.
TEST(Figures, OfThePublishedStudyHaveItsPrintedValues) {
  auto const figures = figures_of(fixture::lot(3, 7));
  auto const objective = blocks(figures.at("published_objective").data);
  ASSERT_EQ(objective.size(), 14u) << "seven laws, here and published";
  ASSERT_EQ(objective[0].size(), 3u);
  ASSERT_EQ(objective[1].size(), 10u);
  EXPECT_EQ(objective[1][0][1], "P1");
  EXPECT_EQ(value(objective[1][0][2]), 0.11);
  EXPECT_EQ(value(objective[1][0][3]), 0.00524);
  EXPECT_NEAR(value(objective[1][0][4]), 0.00524 / 0.11, 1e-12);

  auto const bilinear = blocks(figures.at("published_parameters_bilinear").data);
  ASSERT_EQ(bilinear.size(), 6u) << "three parameters";
  EXPECT_EQ(value(bilinear[0][0][2]), value(blocks(figures.at("parameters_bilinear").data)[0][0][2]));
  EXPECT_NEAR(value(bilinear[0][0][4]), value(bilinear[0][0][3]) / value(bilinear[0][0][2]), 1e-12);
  auto const& yield = bilinear[5];
  ASSERT_EQ(yield.size(), 10u);
  EXPECT_EQ(value(yield[2][2]), 52.2);
  EXPECT_NEAR(value(yield[2][4]), 3.61 / 52.2, 1e-12);
  double mean = 0.0;
  for (auto const& row : yield) mean += value(row[2]) / 10.0;
  EXPECT_NEAR(value(yield[2][5]), 100.0 * (52.2 / mean - 1.0), 1e-9);
  EXPECT_TRUE(figures.contains("published_parameters_abe"));
  EXPECT_TRUE(figures.contains("published_parameters_abe-y0"));
}

TEST(Figures, OfThePublishedStudyNeedTwoOfItsLaws) {
  auto summary = fixture::lot(3, 1);
  for (auto const& [name, figure] : figures_of(summary)) EXPECT_FALSE(name.starts_with("published")) << name;
  summary = fixture::lot(3, 2);
  summary.laws[1].id = "power-masing";
  for (auto const& [name, figure] : figures_of(summary)) EXPECT_FALSE(name.starts_with("published")) << name;
}

// By default a campaign draws the loops of all laws on one device, and each law's objective on each device against the
// law's mean (Figs. 5 and 7 of the paper).
TEST(Figures, LoopsOfAllLawsAndEachDeviceAgainstTheMeanAreDrawnByDefault) {
  auto const summary = fixture::lot(3, 7);
  auto const figures = figures_of(summary);
  auto const is_of_loops = [](auto const& one) { return one.first.starts_with("loops_"); };
  ASSERT_EQ(std::ranges::count_if(figures, is_of_loops), 1);
  auto const& loops = std::ranges::find_if(figures, is_of_loops)->second;
  for (auto const& law : summary.laws)
    EXPECT_NE(loops.script.find("'" + display_name(law)), std::string::npos) << law.id << " has no panel";
  EXPECT_TRUE(figures.contains("objective_by_device"));
}

TEST(FigureChoice, IsOneOfThree) {
  EXPECT_EQ(figure_choice("all"), FigureChoice::all);
  EXPECT_THROW(figure_choice("some"), Error);
}

TEST(Figures, FrontHoldsEveryLawAndTheFrontInOrder) {
  auto const summary = fixture::lot(3, 7);
  auto const data = blocks(figures_of(summary).at("front").data);
  ASSERT_EQ(data.size(), 3u);
  ASSERT_EQ(data[0].size(), summary.laws.size());
  for (std::size_t i = 0; i < summary.laws.size(); ++i) {
    auto const& law = summary.laws[i];
    EXPECT_EQ(data[0][i][0], law.id);
    EXPECT_EQ(value(data[0][i][1]), *law.beta);
    EXPECT_EQ(value(data[0][i][2]), *law.objective.mean);
    EXPECT_EQ(data[0][i][3], law.on_front ? "1" : "0");
    EXPECT_EQ(data[0][i][4], law.on_front ? "filled" : "open");
  }
  Row front;
  for (auto const& row : data[1]) front.push_back(row[0]);
  EXPECT_EQ(front, (Row{"bilinear", "vaiana", "abe", "jankowski"}));  // the laws on the front, by rising beta
  Row published, its_front;
  for (auto const& row : data[2]) {
    published.push_back(row[0]);
    if (row[3] == "1") its_front.push_back(row[0]);
  }
  EXPECT_EQ(published, (Row{"1", "2", "3", "4", "5", "6"}));
  EXPECT_EQ(its_front, (Row{"1", "2", "3", "5"}));
  EXPECT_NEAR(value(data[2][1][1]), 0.3030, 5e-5);
  EXPECT_NEAR(value(data[2][1][2]), 0.079, 1e-12);
}

TEST(Figures, ALawThatDoesNotDescribeTheDevicesIsCrossedAndLeavesItsPlace) {
  auto summary = fixture::lot(3, 2);
  // The first law alone is on the front. Then its stiffness errors make it inadequate, and the second law takes its
  // place.
  summary.laws[0].objective.mean = 0.05;
  summary.laws[1].on_front = false;
  EXPECT_EQ(blocks(figures_of(summary).at("front").data)[0][1][4], "open");
  for (auto& fit : summary.laws[0].devices) fit.K_eff_error_percent = 60.0;
  auto const figure = figures_of(summary).at("front");
  EXPECT_EQ(blocks(figure.data)[0][0][4], "cross");
  EXPECT_EQ(blocks(figure.data)[0][1][4], "filled");
  EXPECT_NE(figure.script.find("title 'not adequate'"), std::string::npos);
}

TEST(Figures, LawsHaveTheColoursAndMarkersOfThePageAndItsOrder) {
  auto const summary = fixture::lot(3, 7);
  auto const page = html(summary);
  auto const figure = figures_of(summary).at("objective");
  auto const data = nlohmann::json::parse(page_data_json(summary));
  ASSERT_EQ(data["symbols"].size(), law_look_count);
  for (std::size_t i = 0; i < law_look_count; ++i) {
    EXPECT_EQ(data["symbols"][i], law_looks[i].symbol);
    EXPECT_NE(page.find(fmt::format("--law-{}: {};", i + 1, law_looks[i].colour)), std::string::npos);
    EXPECT_NE(figure.script.find(fmt::format("set style line {} lc rgb '{}' lw 1.2 pt {} ", i + 1, law_looks[i].colour,
                                             law_looks[i].point)),
              std::string::npos);
  }
  // Laws are drawn in the order of rising objective. Each keeps its own style.
  std::size_t at = figure.script.find("set xrange");
  std::size_t drawn = figure.script.find("set multiplot");
  for (std::size_t const law : data["by_objective"]) {
    at = figure.script.find(law_tic(display_name(summary.laws[law])), at);
    EXPECT_NE(at, std::string::npos) << summary.laws[law].id;
    drawn = figure.script.find(fmt::format("with points ls {}", law + 1), drawn);
    EXPECT_NE(drawn, std::string::npos) << summary.laws[law].id;
  }
}

TEST(Figures, FrontsOfAnalysesAreThereWithThem) {
  auto summary = fixture::lot();
  EXPECT_FALSE(figures_of(summary).contains("front_converged"));
  EXPECT_FALSE(figures_of(summary).contains("front_left_out"));
  summary.laws[0].objective_converged = 0.12;
  summary.laws[0].beta_converged = 0.3;
  summary.laws[0].loo_objective = 0.2;
  auto const figures = figures_of(summary);
  EXPECT_EQ(blocks(figures.at("front_converged").data)[0],
            (std::vector<Row>{{"bilinear", "0.3", "0.12", "0", "open"}}));
  EXPECT_EQ(blocks(figures.at("front_left_out").data)[0], (std::vector<Row>{{"bilinear", "0.2", "0.12", "0", "open"}}));
}

TEST(Figures, ObjectiveOfEveryDeviceAndGapsWhereThereIsNone) {
  auto summary = fixture::lot();
  auto& refused = summary.laws[1].devices[1];
  refused = DeviceFit{};
  refused.device = "D2";
  refused.refusal = "not for it";
  auto const data = blocks(figures_of(summary).at("objective").data);
  ASSERT_EQ(data.size(), 3u);
  auto const order = by_objective(summary);
  for (std::size_t place = 0; place < 3; ++place) {
    auto const law = order[place];
    ASSERT_EQ(data[place].size(), 3u);  // a device that could not be read is not drawn
    for (std::size_t d = 0; d < 3; ++d) {
      auto const& row = data[place][d];
      auto const& objective = summary.laws[law].devices[d].objective;
      EXPECT_EQ(row[1], summary.devices[d].name);
      if (!objective.mean) {
        EXPECT_EQ(Row(row.begin() + 2, row.end()), (Row{"NaN", "NaN", "NaN"}));
        continue;
      }
      double const mean = *summary.laws[law].objective.mean;
      EXPECT_EQ(value(row[2]), *objective.mean);
      EXPECT_EQ(value(row[3]), *objective.std);
      EXPECT_NEAR(value(row[4]), 100.0 * (*objective.mean / mean - 1.0), 1e-9);
    }
  }
}

TEST(Figures, AxesHaveALengthWhereDevicesAgreeToSixDigits) {
  auto summary = fixture::lot();
  for (std::size_t d = 0; d < 3; ++d)
    summary.laws[0].devices[d].objective = {0.03 + 1.6e-8 * static_cast<double>(d), {}, {}};
  summary.laws[0].objective.mean = 0.03;
  auto const script = figures_of(summary).at("objective_by_device").script;
  std::size_t axes = 0;
  for (auto at = script.find("set yrange ["); at != std::string::npos;
       at = script.find("set yrange [", at + 1), ++axes) {
    auto const low = at + 12, colon = script.find(':', low), end = script.find(']', low);
    EXPECT_NE(script.substr(low, colon - low), script.substr(colon + 1, end - colon - 1));
  }
  EXPECT_EQ(axes, 3u);
}

TEST(Figures, ParametersPanelByPanel) {
  auto summary = fixture::lot();
  summary.laws[0].devices[0].parameters[1].free = false;  // K2 is fixed, so it has no panel
  auto const figure = figures_of(summary).at("parameters_bilinear");
  auto const data = blocks(figure.data);
  ASSERT_EQ(data.size(), 2u);
  for (std::size_t d = 0; d < 3; ++d) {
    auto const& parameter = summary.laws[0].devices[d].parameters[0];
    EXPECT_EQ(value(data[0][d][2]), *parameter.value.mean);
    EXPECT_EQ(value(data[0][d][3]), *parameter.value.std);
    EXPECT_EQ(value(data[0][d][4]), *parameter.percent_of_lot);
    EXPECT_EQ(value(data[1][d][2]), *summary.laws[0].devices[d].parameters[2].value.mean);
  }
  EXPECT_NE(figure.script.find("{/:Italic K}_{1} (kN/mm)"), std::string::npos);
  EXPECT_EQ(figure.script.find("{/:Italic K}_{2} (kN/mm)"), std::string::npos);
}

TEST(Figures, LargeValuesAreDrawnInPowersOfTenWithTheirUnit) {
  auto const figure = figures_of(fixture::lot()).at("parameters_vaiana");
  EXPECT_NE(figure.script.find("'{/:Italic k}_{b+} (10^{3} N/m)'"), std::string::npos);
  EXPECT_NE(figure.script.find("($3/1000)"), std::string::npos);
}

TEST(Figures, ConvergenceIsMedianAndRangeAndKeepsWhatEarlyEndsFound) {
  auto summary = fixture::lot();
  summary.laws[0].devices[0].histories = {{0.5, 0.2, 0.1}, {0.4}, {0.9, 0.3, 0.3}, {}};
  auto const data = blocks(figures_of(summary).at("convergence_bilinear").data);
  ASSERT_EQ(data.size(), 1u);
  EXPECT_EQ(data[0],
            (std::vector<Row>{{"1", "0.5", "0.4", "0.9"}, {"2", "0.3", "0.2", "0.4"}, {"3", "0.3", "0.1", "0.4"}}));
  EXPECT_FALSE(figures_of(summary).contains("convergence_vaiana"));
}

TEST(Figures, ManyDevicesConvergeInOnePanel) {
  auto summary = fixture::lot(20, 1);
  for (auto& fit : summary.laws[0].devices) fit.histories = {{0.5, 0.2}, {0.4, 0.3}};
  summary.laws[0].devices[3].histories = {{0.9, 0.1}};
  auto const figure = figures_of(summary).at("convergence_bilinear");
  auto const data = blocks(figure.data);
  ASSERT_EQ(data.size(), 21u);  // the last block holds the range over all devices
  EXPECT_EQ(Row(data.back()[0].begin() + 2, data.back()[0].end()), (Row{"0.4", "0.9"}));
  EXPECT_EQ(Row(data.back()[1].begin() + 2, data.back()[1].end()), (Row{"0.1", "0.3"}));
  EXPECT_EQ(figure.script.find("multiplot"), std::string::npos);
}

TEST(Figures, PropertiesWithDesignValueAndLimits) {
  auto summary = fixture::lot();
  auto const with_rules = blocks(figures_of(summary).at("properties").data);
  ASSERT_EQ(with_rules.size(), 2u);
  EXPECT_EQ(value(with_rules[0][0][4]), 0.6);
  EXPECT_EQ(value(with_rules[1][0][4]), 18.0);
  for (auto const& limit : summary.acceptance.rules.limits)
    if (limit.quantity == rules::Quantity::K_eff && limit.scope == rules::Scope::each && limit.upper_percent) {
      EXPECT_NEAR(value(with_rules[0][0][6]), 0.6 * (1.0 + *limit.upper_percent / 100.0), 1e-12);
    }
  add_acceptance(summary, {}, {}, std::nullopt);
  auto const without = blocks(figures_of(summary).at("properties").data);
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_EQ(value(without[0][d][2]), summary.devices[d].properties.reported->K_eff_kN_per_mm);
  EXPECT_EQ(without[0][0][4], "NaN");
}

TEST(Figures, LoopsAndRecordsOfEveryDevice) {
  auto summary = fixture::lot();
  auto const figures = figures_of(summary, FigureChoice::all);
  auto const& record = summary.devices[1].record;
  auto const& fit = summary.laws[2].devices[1];
  auto const loops = blocks(figures.at("loops_D2_hwang-wu").data);
  ASSERT_EQ(loops[0].size(), record.size());
  for (std::size_t i : {std::size_t{0}, record.size() / 2, record.size() - 1}) {
    EXPECT_EQ(value(loops[0][i][0]), record.time_s[i]);
    EXPECT_EQ(value(loops[0][i][1]), record.disp_mm[i]);
    EXPECT_EQ(value(loops[0][i][2]), record.force_kN[i]);
    EXPECT_EQ(value(loops[0][i][3]), fit.force_kN[i]);
    EXPECT_EQ(value(loops[0][i][4]), record.force_kN[i] - fit.force_kN[i]);
  }
  auto const cleaned = blocks(figures.at("record_D2").data);
  ASSERT_EQ(cleaned.size(), 2u);
  EXPECT_EQ(value(cleaned[0][7][1]), summary.devices[1].raw.disp_mm[7]);
  EXPECT_EQ(value(cleaned[1][7][1]), record.disp_mm[7]);
  EXPECT_EQ(std::ranges::count_if(figures, [](auto const& named) { return named.first.starts_with("loops_"); }), 9 + 3);
}

TEST(Figures, LoopsOfAllLawsOfTheDeviceThatStandsForTheLotAlone) {
  auto summary = fixture::lot();
  auto& refused = summary.laws[1].devices[1];
  refused = DeviceFit{};
  refused.device = "D2";
  refused.refusal = "it's not for this record";
  auto const of_lot = figures_of(summary);
  auto const& figure = of_lot.at("loops_D2");
  EXPECT_FALSE(of_lot.contains("loops_D1"));
  auto const data = blocks(figure.data);
  auto const& record = summary.devices[1].record;
  ASSERT_EQ(data[0].size(), record.size());
  ASSERT_EQ(by_objective(summary), (std::vector<std::size_t>{1, 2, 0}));
  for (std::size_t const i : {std::size_t{0}, record.size() / 2, record.size() - 1}) {
    EXPECT_EQ(value(data[0][i][1]), record.disp_mm[i]);
    EXPECT_EQ(value(data[0][i][2]), record.force_kN[i]);
    EXPECT_EQ(data[0][i][3], "NaN");
    EXPECT_EQ(value(data[0][i][4]), summary.laws[2].devices[1].force_kN[i]);
    EXPECT_EQ(value(data[0][i][5]), summary.laws[0].devices[1].force_kN[i]);
  }
  EXPECT_NE(figure.script.find("refused: it''s not for this"), std::string::npos);
  // Loops are drawn for the device nearest to the mean of the lot. If it has no record, the next nearest is drawn.
  summary.devices[1].record = {};
  EXPECT_TRUE(figures_of(summary).contains("loops_D1"));
  EXPECT_FALSE(figures_of(summary).contains("loops_D2"));
}

TEST(Figures, ALawThatRunsAwayLeavesTheOthersTheirScale) {
  auto summary = fixture::lot();
  auto const highest = [&] {
    auto const script = figures_of(summary).at("loops_D2").script;
    auto const from = script.find(':', script.find("set yrange [")) + 1;
    return std::stod(script.substr(from, script.find(']', from) - from));
  };
  double const peak = std::ranges::max(summary.devices[1].record.force_kN);
  for (double& f : summary.laws[1].devices[1].force_kN) f *= 1e4;
  EXPECT_LT(highest(), 2.5 * peak);
}

// --- drawings by gnuplot ---

// These are names that a script, a shell, gnuplot's markup or a file system could misread.
std::vector<std::string> const hostile{"it's `touch drawn_by_a_name`; set output", "a/b\\c\n\"d\"  #e",
                                       "</text><script>alert(1)</script> _^@&~{}"};

Summary hostile_lot() {
  auto summary = fixture::lot();
  for (std::size_t d = 0; d < hostile.size(); ++d) {
    summary.devices[d].name = hostile[d];
    for (auto& law : summary.laws) {
      law.devices[d].device = hostile[d];
      law.devices[d].histories = {{0.5, 0.2}, {0.4, 0.3}};
    }
  }
  return summary;
}

std::string content(fs::path const& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string without_spaces(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\t'; });
  return text;
}

// Returns the text of an SVG file; throws if the file is not well-formed XML.
std::string text_of_svg(std::string const& svg) {
  std::string text;
  auto* parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &text);
  XML_SetCharacterDataHandler(parser, [](void* to, char const* from, int length) {
    static_cast<std::string*>(to)->append(from, static_cast<std::size_t>(length));
  });
  bool const is_xml = XML_Parse(parser, svg.data(), static_cast<int>(svg.size()), 1) == XML_STATUS_OK;
  XML_ParserFree(parser);
  if (!is_xml) throw std::runtime_error("not well-formed: " + svg.substr(0, 200));
  return text;
}

class Drawn : public testing::Test {
 protected:
  Drawn() : dir_(fs::temp_directory_path() / ("isolaw-figures-test-" + std::to_string(::getpid()))) {
    fs::remove_all(dir_);
  }
  ~Drawn() override {
    fs::remove_all(dir_);
    ::unsetenv("ISOLAW_GNUPLOT");
  }

  // A report is complete without gnuplot, so drawings are tested only where gnuplot is installed. `./isolaw.sh test`
  // installs it.
  static bool has_gnuplot() { return run_gnuplot({}, fs::temp_directory_path(), std::chrono::seconds(20)).started; }
  static void hide_gnuplot() { ::setenv("ISOLAW_GNUPLOT", "/nonexistent/gnuplot", 1); }

  fs::path figure(std::string const& name) const { return dir_ / "figures" / name; }
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (auto const& entry : fs::directory_iterator(dir_ / "figures"))
      files[entry.path().filename().string()] = content(entry.path());
    return files;
  }

  fs::path dir_;
};

TEST_F(Drawn, EveryFigureTwice) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  auto const summary = hostile_lot();
  auto const outcome = write_figures(summary, FigureChoice::all, dir_);
  EXPECT_EQ(outcome.reason, "");
  EXPECT_EQ(outcome.drawn, outcome.figures);
  auto const figures = figures_of(summary, FigureChoice::all);
  EXPECT_EQ(outcome.figures, figures.size());
  EXPECT_EQ(contents().size(), 4 * figures.size());
  for (auto const& [name, _] : figures) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(text_of_svg(content(figure(name + ".svg"))));
    EXPECT_TRUE(content(figure(name + ".pdf")).starts_with("%PDF"));
  }
  EXPECT_FALSE(fs::exists("drawn_by_a_name"));
}

TEST_F(Drawn, NamesArePrintedAsTheyAre) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  auto const summary = hostile_lot();
  write_figures(summary, FigureChoice::lot, dir_);
  auto const front = text_of_svg(content(figure("front.svg")));
  for (auto const& law : summary.laws) EXPECT_NE(front.find(display_name(law)), std::string::npos) << law.id;
  auto const convergence = text_of_svg(content(figure("convergence_bilinear.svg")));
  EXPECT_NE(convergence.find("it's `touch drawn_by_a_nam"), std::string::npos);
  EXPECT_NE(convergence.find("a/b\\c\\n\"d\"  #e"), std::string::npos);
}

TEST_F(Drawn, SameSummarySameBytes) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  write_figures(hostile_lot(), FigureChoice::lot, dir_);
  auto const first = contents();
  fs::remove_all(dir_);
  write_figures(hostile_lot(), FigureChoice::lot, dir_);
  EXPECT_EQ(contents(), first);
}

TEST_F(Drawn, AScriptByHandGivesTheFigureAgain) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  write_figures(fixture::lot(), FigureChoice::lot, dir_);
  auto const before = without_spaces(text_of_svg(content(figure("objective.svg"))));
  fs::remove(figure("objective.svg"));
  fs::remove(figure("objective.pdf"));
  EXPECT_EQ(run_gnuplot({"objective.gp"}, dir_ / "figures", std::chrono::seconds(60)).reason, "");
  EXPECT_EQ(without_spaces(text_of_svg(content(figure("objective.svg")))),
            // Only the text is compared, because other bytes of an SVG depend on what gnuplot drew before in its
            // process.
            before);
  EXPECT_TRUE(content(figure("objective.pdf")).starts_with("%PDF"));
}

TEST_F(Drawn, AFaultInOneScriptLeavesTheOthers) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  fs::create_directories(dir_);
  write_file(dir_ / "bad.gp", "plot 'no such file.dat'\n");
  auto const end = run_gnuplot({"bad.gp"}, dir_, std::chrono::seconds(60));
  EXPECT_TRUE(end.started);
  EXPECT_NE(end.reason, "");
}

TEST_F(Drawn, TimeIsLimited) {
  if (!has_gnuplot()) GTEST_SKIP() << "gnuplot is not installed: nothing can be drawn";
  fs::create_directories(dir_);
  write_file(dir_ / "endless.gp", "while (1) { a = 1 }\n");
  EXPECT_EQ(run_gnuplot({"endless.gp"}, dir_, std::chrono::seconds(1)).reason, "takes longer than 1 s");
}

TEST_F(Drawn, WithoutGnuplotDataAndScriptsAreThere) {
  hide_gnuplot();
  auto const summary = fixture::lot();
  auto const outcome = write_figures(summary, FigureChoice::lot, dir_);
  EXPECT_TRUE(outcome.program_missing);
  EXPECT_EQ(outcome.drawn, 0u);
  auto const figures = figures_of(summary);
  EXPECT_EQ(contents().size(), 2 * figures.size());
  for (auto const& [name, one] : figures) {
    EXPECT_EQ(content(figure(name + ".dat")), one.data);
    EXPECT_EQ(content(figure(name + ".gp")), one.script);
  }
}

TEST_F(Drawn, NoDrawingOutlivesItsData) {
  hide_gnuplot();
  auto summary = fixture::lot();
  write_figures(summary, FigureChoice::lot, dir_);
  for (auto const* name : {"front.svg", "front.pdf", "properties.svg", "properties.pdf"})
    write_file(figure(name), "old");
  summary.laws[0].beta = 0.9;
  auto const outcome = write_figures(summary, FigureChoice::lot, dir_);
  EXPECT_FALSE(fs::exists(figure("front.svg")));
  EXPECT_FALSE(fs::exists(figure("front.pdf")));
  EXPECT_TRUE(fs::exists(figure("properties.svg")));  // the data of this drawing did not change, so the drawing stays
  EXPECT_EQ(outcome.drawn, 1u);
}

TEST_F(Drawn, OnlyOwnFiguresAreRemoved) {
  hide_gnuplot();
  write_figures(fixture::lot(3, 3), FigureChoice::lot, dir_);
  write_file(figure("mine.gp"), "plot x\n");
  write_file(figure("mine.pdf"), "mine");
  ASSERT_TRUE(fs::exists(figure("parameters_hwang-wu.gp")));
  write_figures(fixture::lot(3, 2), FigureChoice::lot, dir_);
  EXPECT_FALSE(fs::exists(figure("parameters_hwang-wu.gp")));
  EXPECT_FALSE(fs::exists(figure("parameters_hwang-wu.dat")));
  remove_figures(dir_);
  EXPECT_EQ(contents(), (std::map<std::string, std::string>{{"mine.gp", "plot x\n"}, {"mine.pdf", "mine"}}));
}

// With the choice `none`, figures that show other results than the report are removed, including those of single
// devices.
TEST_F(Drawn, NoneRemovesFiguresOfOtherResults) {
  hide_gnuplot();
  auto summary = fixture::lot(3, 2);
  write_figures(summary, FigureChoice::all, dir_);
  auto const before = contents();
  ASSERT_GT(before.size(), 30u);
  EXPECT_EQ(write_figures(summary, FigureChoice::none, dir_).removed, 0u);
  EXPECT_EQ(contents(), before);
  auto& fit = summary.laws[0].devices[0];
  for (auto& force : fit.force_kN) force *= 2.0;
  EXPECT_GT(write_figures(summary, FigureChoice::none, dir_).removed, 0u);
  auto const loops = [&](std::string const& device) {
    return figure(fmt::format("loops_{}_{}.dat", device, summary.laws[0].id));
  };
  EXPECT_FALSE(fs::exists(loops(fit.device)));
  EXPECT_TRUE(fs::exists(loops(summary.laws[0].devices[1].device)));
}

TEST_F(Drawn, NoneWritesNothing) {
  EXPECT_EQ(write_figures(fixture::lot(), FigureChoice::none, dir_).figures, 0u);
  EXPECT_FALSE(fs::exists(dir_));
}

}  // namespace
}  // namespace isolaw::render
