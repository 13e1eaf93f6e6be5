#include "isolaw/render/write.hpp"

#include <string>
#include <system_error>

#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/tables/building_tables.hpp"
#include "isolaw/render/tables/conditions_tables.hpp"
#include "isolaw/render/tables/latex_tables.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/terminal/inspection_text.hpp"

namespace isolaw::render {
namespace {

namespace fs = std::filesystem;

struct Output {
  char const* name;
  std::string (*text)(Summary const&);
};
constexpr Output outputs[] = {
    {"summary.json", summary_json},
    {"tables/parameters.csv", parameters_csv},
    {"tables/objective.csv", objective_csv},
    {"tables/robustness.csv", robustness_csv},
    {"tables/converged.csv", converged_csv},
    {"tables/identifiability.csv", identifiability_csv},
    {"tables/lot_law.csv", lot_law_csv},
    {"tables/prediction.csv", prediction_csv},
    {"tables/cycles.csv", cycles_csv},
    {"tables/tests.csv", tests_csv},
    {"tables/levels.csv", levels_csv},
    {"tables/vertical.csv", vertical_csv},
    {"tables/lot.csv", lot_csv},
    {"tables/lambda.csv", lambda_csv},
    {"tables/table_a5.csv", table_a5_csv},
    {"tables/table_a5.tex", table_a5_tex},
    {"tables/robustness.tex", robustness_tex},
    {"tables/front.csv", front_csv},
    {"tables/front.tex", front_tex},
    {"report.html", html},
};

// A file that is written only if the lot file has a table [conditions].
struct ConditionsOutput {
  char const* name;
  std::string (*text)(ConditionsResult const&, UnitSystem const&);
};
constexpr ConditionsOutput conditions_outputs[] = {
    {"tables/conditions.csv", conditions_csv},
    {"tables/observations.csv", observations_csv},
    {"tables/conditions.tex", conditions_tex},
};

struct BuildingOutput {
  char const* name;
  std::string (*text)(building::Study const&, building::Answers const&);
};
constexpr BuildingOutput building_outputs[] = {
    {"building.json", building_json},      {"tables/building.csv", building_csv},
    {"tables/coverage.csv", coverage_csv}, {"tables/checks.csv", building_checks_csv},
    {"tables/building.tex", building_tex}, {"building.html", building_html},
};

void remove_output(fs::path const& file) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
}

void add_conditions(Summary const& summary, std::vector<std::pair<std::string, std::string>>& texts) {
  if (!summary.conditions) return;
  for (auto const& [name, text] : conditions_outputs)
    texts.emplace_back(name, text(*summary.conditions, summary.units()));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> output_texts(Summary const& summary) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (auto const& [name, text] : outputs) texts.emplace_back(name, text(summary));
  add_conditions(summary, texts);
  return texts;
}

void remove_outputs(fs::path const& dir) {
  for (auto const& output : outputs) remove_output(dir / output.name);
  for (auto const& output : conditions_outputs) remove_output(dir / output.name);
  remove_output(dir / "run.json");
  remove_figures(dir);
}

void remove_building_outputs(fs::path const& dir) {
  for (auto const& output : building_outputs) remove_output(dir / output.name);
  remove_figures(dir);
}

void write_outputs(Summary const& summary, fs::path const& dir) {
  make_folder(dir / "tables");
  for (auto const& [name, text] : output_texts(summary)) write_file(dir / name, text);
}

void write_inspection(Summary const& summary, fs::path const& dir) {
  make_folder(dir / "tables");
  std::vector<std::pair<std::string, std::string>> texts{
      {"inspection.json", inspection_json(summary)}, {"tables/cycles.csv", cycles_csv(summary)},
      {"tables/tests.csv", tests_csv(summary)},      {"tables/vertical.csv", vertical_csv(summary)},
      {"tables/levels.csv", levels_csv(summary)},    {"tables/lot.csv", lot_csv(summary)},
      {"tables/lambda.csv", lambda_csv(summary)},    {"inspection.html", html(summary)}};
  add_conditions(summary, texts);
  for (auto const& [name, text] : texts) write_file(dir / name, text);
}

void write_conditions_outputs(ConditionsResult const& result, UnitSystem const& units, fs::path const& dir) {
  make_folder(dir / "tables");
  write_file(dir / "conditions.json", conditions_json(result));
  for (auto const& [name, text] : conditions_outputs) write_file(dir / name, text(result, units));
}

void write_building_outputs(building::Study const& study, building::Answers const& answers, fs::path const& dir) {
  make_folder(dir / "tables");
  std::vector<std::pair<std::string, std::string>> texts;
  for (auto const& [name, text] : building_outputs) texts.emplace_back(name, text(study, answers));
  for (auto const& [name, text] : texts) write_file(dir / name, text);
}

void remove_leftovers(fs::path const& dir) {
  for (auto const& folder : {dir, dir / "tables", dir / "figures"}) remove_unfinished_files(folder);
}

}  // namespace isolaw::render
