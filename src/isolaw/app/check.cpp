#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/check.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/sqlite.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/page/html.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::app {
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
// the rules of report.html. Returns false if it states no other rules or cannot be read.
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
  int compared = 0;
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

int check_building(std::filesystem::path const& file) {
  building::CheckedRuns checked;
  checked.faults = campaign::sqlite::integrity(file);
  if (checked.faults.empty()) checked = building::check_runs(file);
  fmt::print("{}: {}\n  {} of {} analyses of a building, compared with the hashes that were stored with them\n",
             shown(file), checked.faults.empty() ? "sound" : fmt::format("{} fault(s)", checked.faults.size()),
             checked.runs, checked.expected);
  for (auto const& fault : checked.faults) fmt::print("  fault: {}\n", fault);
  return checked.faults.empty() ? exit_done : exit_with_refusals;
}

}  // namespace

int check(std::filesystem::path const& directory) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(directory, unknown))
    throw Error({.where = shown(directory),
                 .found = "a file",
                 .allowed = "the directory of a campaign or of the analysis of a building",
                 .advice = fmt::format("isolaw inspect {0}, or isolaw conditions {0}", shown(directory))});
  int of_building = exit_done;
  if (auto const file = directory / building_store_name; std::filesystem::exists(file, unknown)) {
    of_building = check_building(file);
    if (!std::filesystem::exists(directory / store_name, unknown)) return of_building;
  }
  auto const file = directory / store_name;
  auto result = campaign::check(file);
  auto contents = campaign::Store::read(file);
  auto summary = study::build_summary(contents);
  bool const other_rules = hold_to_what_the_page_states(directory, contents, summary);
  auto const outputs = compare_outputs(directory, summary);
  auto const since = outputs.other.empty() ? 0 : runs_since(directory, summary.missing_runs());
  if (since == 0)
    for (auto const& name : outputs.other)
      (result.of_another_build ? result.differences : result.faults)
          .push_back(
              fmt::format("{} is not what the store gives; isolaw report {} writes it again", name, shown(directory)));
  fmt::print("{}: {}\n", shown(file),
             !result.faults.empty()       ? fmt::format("{} fault(s)", result.faults.size())
             : result.differences.empty() ? "sound"
                                          : fmt::format("sound, but for {} difference(s)", result.differences.size()));
  fmt::print("  {}, {} on {}, {} of {} runs", counted(result.devices, "device"), counted(result.searches, "law"),
             result.devices == 1 ? "it" : "them", result.runs, result.expected_runs);
  fmt::print("{}\n", result.expected_analyses > 0
                         ? fmt::format(", {} of {} analyses", result.analyses, result.expected_analyses)
                         : std::string());
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0)
    fmt::print("  not complete: {}\n", what_is_missing(summary));
  fmt::print("  records cleaned and objectives computed again: largest relative difference {:.2g}\n",
             result.largest_difference);
  if (outputs.compared > 0) fmt::print("  {} files beside it compared with what the store gives\n", outputs.compared);
  if (other_rules && outputs.compared > 0)
    fmt::print(
        "  they were written with other rules, design values or lot size than the store holds; the comparison uses theirs\n");
  if (since > 0)
    fmt::print("  out of date: {} of them, written before the last {} runs; isolaw report {} writes them again\n",
               outputs.other.size(), since, shown(directory));
  if (result.of_another_build)
    fmt::print("  computed by isolaw {}; this is {}, whose numbers may differ\n",
               campaign::text(std::span(contents.makers)), campaign::text(campaign::this_maker()));
  for (auto const& fault : result.faults) fmt::print("  fault: {}\n", fault);
  for (auto const& difference : result.differences) fmt::print("  difference: {}\n", difference);
  bool const sound = result.faults.empty() && result.differences.empty() && since == 0;
  return sound ? of_building : exit_with_refusals;
}

}  // namespace isolaw::app
