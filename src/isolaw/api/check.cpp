#include "isolaw/api/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/sqlite.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw {
namespace {

bool holds(std::filesystem::path const& file, std::string_view text) {
  std::error_code unknown;
  if (std::filesystem::file_size(file, unknown) != text.size() || unknown) return false;
  std::string there(text.size(), '\0');
  std::ifstream(file, std::ios::binary).read(there.data(), static_cast<std::streamsize>(there.size()));
  return there == text;
}

// The number of runs added to the store since the reports in `directory` were written; 0 if summary.json does not say.
std::size_t runs_since(std::filesystem::path const& directory, std::size_t missing_runs) {
  try {
    auto const text =
        read_file(directory / "summary.json",
                  {.largest_bytes = std::uintmax_t{1} << 30, .allowed = "a summary of isolaw", .when_too_large = {}});
    auto const missing_then = render::missing_runs_in(text).value_or(0);
    return missing_then > missing_runs ? missing_then - missing_runs : 0;
  } catch (Error const&) {
    return 0;
  }
}

// After `isolaw report --rules ...`, report.html states other rules than the store. `contents` and `summary` then get
// the rules of report.html. Returns false if report.html states the same rules or none, or cannot be read.
bool hold_to_what_the_page_states(std::filesystem::path const& directory, campaign::Contents& contents,
                                  study::Summary& summary) {
  auto const stored = contents.acceptance;
  try {
    auto const stated = render::asked_in(
        read_file(directory / "report.html",
                  {.largest_bytes = std::uintmax_t{1} << 30, .allowed = "a page of isolaw", .when_too_large = {}}));
    if (!stated || *stated == stored) return false;
    contents.acceptance = *stated;
    summary = study::build_summary(contents);
    return true;
  } catch (Error const&) {
    contents.acceptance = stored;
    return false;
  }
}

struct Outputs {
  std::size_t compared = 0;
  std::vector<std::string> other;  // names of files that differ from what the store gives
};

Outputs compare_outputs(std::filesystem::path const& directory, study::Summary const& summary) {
  Outputs found;
  auto texts = render::output_texts(summary);
  std::ranges::move(render::figure_data(summary), std::back_inserter(texts));
  for (auto const& [name, text] : texts) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(directory / name, unknown)) continue;
    ++found.compared;
    if (!holds(directory / name, text)) found.other.push_back(name);
  }
  return found;
}

CheckedBuilding checked_building(std::filesystem::path const& file) {
  if (auto faults = campaign::sqlite::integrity(file); !faults.empty()) return {.faults = std::move(faults)};
  auto checked = building::check_runs(file);
  return {.runs = checked.runs, .expected_runs = checked.expected, .faults = std::move(checked.faults)};
}

CheckedCampaign checked_campaign(std::filesystem::path const& directory) {
  auto const file = directory / store_name;
  CheckedCampaign result{.check = campaign::check(file), .missing = {}, .made_by = {}};
  auto contents = campaign::Store::read(file);
  auto summary = study::build_summary(contents);
  bool const other_rules = hold_to_what_the_page_states(directory, contents, summary);
  auto const outputs = compare_outputs(directory, summary);
  result.compared_files = outputs.compared;
  result.other_rules = other_rules && outputs.compared > 0;
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) result.missing = what_is_missing(summary);
  if (!outputs.other.empty()) result.runs_since = runs_since(directory, summary.missing_runs());
  if (result.runs_since > 0) result.outdated_files = outputs.other.size();
  auto& check = result.check;
  if (result.runs_since == 0)
    for (auto const& name : outputs.other)
      (check.of_another_build ? check.differences : check.faults)
          .push_back(fmt::format("{} is not what the store gives; isolaw report {} writes it again", name,
                                 printable(directory.string())));
  if (check.of_another_build) result.made_by = campaign::text(std::span(contents.makers));
  return result;
}

}  // namespace

std::string what_is_missing(study::Summary const& summary) {
  auto const runs = summary.missing_runs();
  if (summary.part)
    return fmt::format("this is part {} of {}, {} of its {} runs; isolaw merge OUT PARTS... joins the parts",
                       summary.part->number, summary.part->total, summary.runs, summary.expected_here);
  return fmt::format("{} {} are missing; repeat the last calibrate command to continue",
                     runs > 0 ? runs : summary.missing_analyses(), runs > 0 ? "runs" : "analyses");
}

CheckedDirectory check_directory(std::filesystem::path const& directory) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(directory, unknown)) {
    auto const shown = printable(directory.string());
    throw Error({.where = shown,
                 .found = "a file",
                 .allowed = "the directory of a campaign or of the analysis of a building",
                 .advice = fmt::format("isolaw inspect {0}, or isolaw conditions {0}", shown)});
  }
  CheckedDirectory result;
  auto const of_building = directory / building_store_name;
  if (std::filesystem::exists(of_building, unknown)) result.building = checked_building(of_building);
  if (!result.building || std::filesystem::exists(directory / store_name, unknown))
    result.campaign = checked_campaign(directory);
  return result;
}

}  // namespace isolaw
