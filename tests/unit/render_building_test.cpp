// Tests all output about a building: building.json and its documentation, the page, and tables and figures for print.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/render/figures/building_figures.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/tables/building_tables.hpp"
#include "page_data.hpp"
#include "unit/building_study_fixture.hpp"

namespace isolaw::render {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::vector<std::string> keys_of(Json const& object) {
  std::vector<std::string> names;
  for (auto const& [name, value] : object.items()) names.push_back(name);
  return names;
}

// Returns the first cells of the table rows under a heading of docs/building-json.md.
std::vector<std::string> documented_keys(std::string const& heading) {
  std::ifstream page(ISOLAW_SOURCE_DIR "/docs/building-json.md");
  std::vector<std::string> keys;
  bool within = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## ")) within = line == "## " + heading;
    if (within && line.starts_with("| `")) keys.push_back(line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

struct Case {
  building::Study study;
  building::Answers answers;
};

Case const& usual_case() {
  static auto const usual = [] {
    Case of{.study = building::usual_study(0.07, 60, 3), .answers = {}};
    of.study.file.settings.title = "Bau </script> <b>1</b>";
    of.study.file.bearings[0] = {.at = of.study.file.bearings[0].at, .kind = building::BearingKind::lot, .device = {}};
    auto const file = fs::temp_directory_path() / fmt::format("isolaw-render-building-{}.sqlite", ::getpid());
    fs::remove(file);
    building::RunStore store(file, building::properties_of(of.study), true);
    building::run_all(of.study, store, 1);
    of.answers = building::answer(of.study, store);
    fs::remove(file);
    return of;
  }();
  return usual;
}

TEST(BuildingJson, keys_are_documented_in_their_order) {
  auto const& [study, answers] = usual_case();
  auto const json = Json::parse(building_json(study, answers));
  EXPECT_EQ(keys_of(json), documented_keys("Top level"));
  auto const& law = json["laws"][0];
  EXPECT_EQ(keys_of(law), documented_keys("`laws[]`"));
  EXPECT_EQ(keys_of(law["quantities"]["isolator_mm"]), documented_keys("`laws[].quantities`"));
  auto coverage = documented_keys("`laws[].coverage`");
  EXPECT_EQ(keys_of(law["coverage"]["of"]["shear_over_weight"]), coverage);
  coverage.emplace_back("of");
  EXPECT_EQ(keys_of(law["coverage"]), coverage);
  EXPECT_EQ(keys_of(law["checked"][1]), documented_keys("`laws[].checked[]`"));
  EXPECT_EQ(keys_of(law["histories"][1]), documented_keys("`laws[].histories[]`"));
  EXPECT_EQ(law["quantities"].size(), json["quantities"].size());
  EXPECT_EQ(json["verdict"], wording::paragraph(answers.verdict));
  EXPECT_EQ(json["plan"]["bearings"].size(), 6u);
  EXPECT_EQ(json["plan"]["bearings"][0]["is"], "lot");
  EXPECT_EQ(json["plan"]["bearings"][1]["is"], "draw");
  EXPECT_EQ(json["plan"]["bearings"][5]["x_m"], study.file.bearings[5].at.x_mm / 1e3);
  EXPECT_EQ(law["quantities"]["isolator_mm"]["p50"].get<double>(), answers.laws[0].distributions[0].fractiles[1]);
}

TEST(BuildingPage, holds_the_same_numbers_and_no_markup_of_the_input) {
  auto const& [study, answers] = usual_case();
  auto const page = building_html(study, answers);
  EXPECT_EQ(page.find("<b>1</b>"), std::string::npos);
  auto const data = page_data(page);
  EXPECT_EQ(data["title"], study.file.settings.title);
  EXPECT_EQ(data["verdict"]["said"][0], wording::paragraph(answers.verdict));
  EXPECT_EQ(data["laws"][0]["histories"], Json::parse(building_json(study, answers))["laws"][0]["histories"]);
  EXPECT_FALSE(data["symbols"].empty());
  EXPECT_FALSE(asked_in(page).has_value());
}

TEST(BuildingTables, have_a_row_for_every_quantity) {
  auto const& [study, answers] = usual_case();
  auto const lines = [](std::string const& text) { return std::count(text.begin(), text.end(), '\n'); };
  auto const rows = static_cast<std::ptrdiff_t>(building::quantities().size());
  auto const csv = building_csv(study, answers);
  EXPECT_EQ(lines(csv), 1 + rows);
  EXPECT_EQ(csv.find("law,quantity,unit,lower bound,nominal,upper bound,16 %"), 0u) << csv;
  EXPECT_TRUE(contains(csv, "\nbilinear,isolator_mm,mm,"));
  // Three quantities come from differences between bearings. They have no bounds, because all bearings are alike in the
  // bound analyses.
  EXPECT_EQ(lines(coverage_csv(study, answers)), 1 + rows - 3);
  EXPECT_EQ(lines(building_checks_csv(study, answers)), 1 + 2);
  auto const tex = building_tex(study, answers);
  EXPECT_TRUE(contains(tex, "\\begin{tabular}") && contains(tex, "bearing displacement (mm) & $")) << tex;
  EXPECT_TRUE(contains(tex, "Bounds cover ")) << tex;
}

TEST(BuildingFigures, are_drawn_of_the_draws) {
  auto const figures = building_figures(usual_case().answers, record_units);
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].name, "building_histograms");
  EXPECT_EQ(figures[1].name, "building_variance");
  double percent = 0.0;
  std::istringstream data(figures[0].data.substr(0, figures[0].data.find("\n\n\n")));
  for (std::string line; std::getline(data, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream cells(line);
    double at = 0.0, width = 0.0, share = 0.0;
    cells >> at >> width >> share;
    percent += share;
  }
  EXPECT_NEAR(percent, 100.0, 1e-6);
  auto const dir = fs::temp_directory_path() / fmt::format("isolaw-building-figures-{}", ::getpid());
  fs::remove_all(dir);
  auto const outcome = write_building_figures(usual_case().answers, record_units, dir);
  EXPECT_EQ(outcome.figures, 2u);
  if (!outcome.program_missing) {
    EXPECT_EQ(outcome.drawn, 2u) << outcome.reason;
  }
  EXPECT_TRUE(fs::exists(dir / "figures" / "building_variance.dat"));
  fs::remove_all(dir);
}

}  // namespace
}  // namespace isolaw::render
