#include "isolaw/campaign/merge.hpp"

#include <fmt/format.h>

#include <map>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/campaign_work.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw::app {

int merge(MergeArguments const& arguments, std::vector<std::string> const& command_line) {
  CampaignWork work(command_line);
  auto const figures = render::figure_choice(arguments.figures);
  fit::instruction_set();
  auto const& directory = arguments.directory;
  std::vector<std::filesystem::path> parts;
  for (auto const& part : arguments.parts) {
    std::error_code unknown;
    bool const is_file = std::filesystem::is_regular_file(part, unknown);
    parts.push_back(is_file ? part : part / store_name);
    if (std::filesystem::equivalent(parts.back(), directory / store_name, unknown))
      throw Error({.where = part.string(),
                   .found = "is the directory that is merged into",
                   .allowed = "the directories of parts",
                   .advice = "isolaw merge OUT PARTS..., OUT first"});
  }
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / store_name;
  render::remove_leftovers(directory);
  bool any = false;
  std::map<int, std::size_t> missing;  // by part
  auto const merged =
      campaign::merge(file, parts,
                      {.before_replacing = [&] { render::remove_outputs(directory); },
                       .missing =
                           [&](campaign::MissingRun const& run) {
                             if (!std::exchange(any, true)) app::print("part,device,law,run");
                             ++missing[run.part];
                             app::print(fmt::format("{},{},{},{}", run.part > 0 ? std::to_string(run.part) : "",
                                                    render::csv_cell(run.device), run.law, run.number));
                           },
                       .fresh = arguments.fresh});
  for (auto const& part : merged.absent) say("{}: not there\n", printable(part));
  say("{} copied{} to {}\n", counted(merged.added, "run"),
      merged.there > 0 ? fmt::format(", {} there already", merged.there) : "", shown(file));
  if (merged.missing > 0) {
    std::vector<std::string> of_parts;
    for (auto const& [part, runs] : missing)
      if (part > 0) of_parts.push_back(fmt::format("{}/{} ({})", part, merged.parts, counted(runs, "run")));
    constexpr std::size_t shown_parts = 20;
    auto const more = of_parts.size() > shown_parts ? of_parts.size() - shown_parts : 0;
    of_parts.resize(of_parts.size() - more);
    say("not complete: {} {} missing, named on standard output{}{}{}\n"
        "compute or copy what is missing, then again: isolaw merge {} PARTS...\n",
        counted(merged.missing, "run"), merged.missing == 1 ? "is" : "are", of_parts.empty() ? "" : ", of part ",
        joined(of_parts), more > 0 ? fmt::format(" and {} more", more) : "", shown(directory));
    return exit_with_refusals;
  }
  if (arguments.copy_only) return exit_done;
  auto contents = campaign::Store::read(file);
  return work.finish(
      contents,
      {.directory = directory, .jobs = arguments.jobs.value_or(0), .figures = figures, .json = arguments.json});
}

}  // namespace isolaw::app
