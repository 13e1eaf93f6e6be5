#include <fmt/format.h>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/check.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"

namespace isolaw::app {
namespace {

void print_building(std::filesystem::path const& file, CheckedBuilding const& checked) {
  fmt::print("{}: {}\n  {} of {} analyses of a building, compared with the hashes that were stored with them\n",
             shown(file), checked.is_sound() ? "sound" : fmt::format("{} fault(s)", checked.faults.size()),
             checked.runs, checked.expected_runs);
  for (auto const& fault : checked.faults) fmt::print("  fault: {}\n", fault);
}

void print_campaign(std::filesystem::path const& directory, CheckedCampaign const& checked) {
  auto const& result = checked.check;
  fmt::print("{}: {}\n", shown(directory / store_name),
             !result.faults.empty()       ? fmt::format("{} fault(s)", result.faults.size())
             : result.differences.empty() ? "sound"
                                          : fmt::format("sound, but for {} difference(s)", result.differences.size()));
  fmt::print("  {}, {} on {}, {} of {} runs", counted(result.devices, "device"), counted(result.searches, "law"),
             result.devices == 1 ? "it" : "them", result.runs, result.expected_runs);
  fmt::print("{}\n", result.expected_analyses > 0
                         ? fmt::format(", {} of {} analyses", result.analyses, result.expected_analyses)
                         : std::string());
  if (!checked.missing.empty()) fmt::print("  not complete: {}\n", checked.missing);
  fmt::print("  records cleaned and objectives computed again: largest relative difference {:.2g}\n",
             result.largest_difference);
  if (checked.compared_files > 0)
    fmt::print("  {} files beside it compared with what the store gives\n", checked.compared_files);
  if (checked.other_rules)
    fmt::print(
        "  they were written with other rules, design values or lot size than the store holds; the comparison uses theirs\n");
  if (checked.runs_since > 0)
    fmt::print("  out of date: {} of them, written before the last {} runs; isolaw report {} writes them again\n",
               checked.outdated_files, checked.runs_since, shown(directory));
  if (result.of_another_build)
    fmt::print("  computed by isolaw {}; this is {}, whose numbers may differ\n", checked.made_by,
               campaign::text(campaign::this_maker()));
  for (auto const& fault : result.faults) fmt::print("  fault: {}\n", fault);
  for (auto const& difference : result.differences) fmt::print("  difference: {}\n", difference);
}

}  // namespace

int check(std::filesystem::path const& directory) {
  auto const checked = check_directory(directory);
  if (checked.building) print_building(directory / building_store_name, *checked.building);
  if (checked.campaign) print_campaign(directory, *checked.campaign);
  return checked.is_sound() ? exit_done : exit_with_refusals;
}

}  // namespace isolaw::app
