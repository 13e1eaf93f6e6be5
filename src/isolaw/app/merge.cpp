#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "isolaw/api/merge.hpp"
#include "isolaw/app/campaign_work.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw::app {

void tell_merged(campaign::MergeResult const& merged, std::filesystem::path const& directory,
                 std::string const& store) {
  for (auto const& part : merged.absent) say("{}: not there\n", printable(part));
  if (!merged.lost.empty()) say("{}\n", printable(merged.lost));
  say("{}{} copied{} to {}\n", counted(merged.added, "run"),
      merged.analyses > 0 ? fmt::format(" and {} analyses", merged.analyses) : "",
      merged.already_there > 0 ? fmt::format(", {} there already", merged.already_there) : "",
      shown(directory / store));
  if (merged.missing > 0)
    say("not complete: {}; listed on standard output\n"
        "compute or copy what is missing, then repeat: isolaw merge {} PARTS...\n",
        missing_text(merged), shown(directory));
}

int merge(MergeArguments const& arguments, std::vector<std::string> const& command_line) {
  if (merges_buildings(arguments)) {
    if (arguments.part)
      throw Error(
          {.where = "--part", .found = "is given for parts of a building study, whose merge has no analyses to share"});
    return merge_buildings(arguments);
  }
  auto const share = arguments.part ? std::optional(campaign::parse_part(*arguments.part)) : std::nullopt;
  if (share && (arguments.json || arguments.copy_only))
    throw Error({.where = arguments.json ? "--json" : "--copy-only",
                 .found = "a part computes only a share of the analyses and has no summary",
                 .advice = "isolaw merge of all parts without --part"});
  CampaignWork work(command_line);
  auto const figures = render::figure_choice(arguments.figures);
  fit::instruction_set();
  auto const& directory = arguments.directory;
  for (auto const& part : arguments.parts) store_of_part(part, directory);
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / store_name;
  bool any = false;
  auto const merged = merge_runs(lock, directory, arguments.parts,
                                 {.fresh = arguments.fresh, .missing = [&](campaign::MissingRun const& run) {
                                    if (!std::exchange(any, true)) app::print("part,device,law,run");
                                    app::print(fmt::format("{},{},{},{}", run.part > 0 ? std::to_string(run.part) : "",
                                                           render::csv_cell(run.device), run.law, run.number));
                                  }});
  tell_merged(merged, directory, store_name);
  if (merged.missing > 0) return exit_with_refusals;
  int const named = merged.absent.empty() ? exit_done : exit_with_refusals;
  if (arguments.copy_only) return named;
  auto contents = campaign::Store::read(file);
  int const finished = work.finish(contents, {.directory = directory,
                                              .jobs = arguments.jobs.value_or(0),
                                              .share = share,
                                              .figures = figures,
                                              .json = arguments.json,
                                              .details = arguments.details});
  return std::max(named, finished);
}

}  // namespace isolaw::app
