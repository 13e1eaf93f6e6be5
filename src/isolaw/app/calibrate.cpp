#include <algorithm>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/app/campaign_work.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/fit/kernels.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::app {

int calibrate(CalibrateArguments const& arguments, std::vector<std::string> const& command_line) {
  CampaignWork work(command_line);
  auto const figures = render::figure_choice(arguments.figures);
  fit::instruction_set();  // throws early if this machine lacks the instruction set that the user chose
  auto const lot = lot_of(arguments);
  auto const part = arguments.part ? std::optional(campaign::parse_part(*arguments.part)) : std::nullopt;
  if (part && arguments.json)
    throw Error({.where = "--json", .found = "a part has no summary", .advice = "isolaw merge ... --json"});
  for (auto const& change : lot.settings.overrides)
    if (std::ranges::find(lot.settings.laws, change.law) == lot.settings.laws.end())
      say("--set {}: has no effect, {} is not among the laws of this campaign\n", change.text(), change.law);
  auto contents = campaign::prepare(lot);
  contents.part = part;
  for (auto const& device : contents.devices)
    if (!device.usable()) say("{}: refused\n  {}\n", device.name, device.refusal);
  for (auto const& device : contents.devices)
    if (!device.vertical.refusal.empty())
      say("{}: no vertical stiffness\n  {}\n", device.name, device.vertical.refusal);
  // If the rules or design values do not suit the lot, this throws before the search begins.
  if (lot.acceptance != campaign::Acceptance{}) study::build_summary(contents);

  auto const directory = output_directory(arguments, lot);
  make_directory(directory);
  DirectoryLock const lock(directory);
  auto const file = directory / store_name;
  render::remove_leftovers(directory);
  auto const [added, dropped_rules, kept, dropped, lost] = open_or_create(
      file, contents, arguments.fresh, is_of_lot_file(arguments) ? UnlistedVertical::drop : UnlistedVertical::keep);
  if (!lost.empty()) say("{}\n", printable(lost));
  if (!added.empty()) say("the campaign grows by {}\n", joined(added));
  if (!dropped_rules.empty())
    say("the tests are no longer checked against rule set {}; --rules {} checks them again, without another search\n",
        printable(dropped_rules), printable(dropped_rules));
  if (!kept.empty())
    say("the campaign keeps its compression tests: {}; to replace one: --vertical DEVICE=FILE\n",
        printable(joined(kept)));
  if (!dropped.empty())
    say("the lot file no longer names compression tests of {}; the campaign drops their K_v\n",
        printable(joined(dropped)));
  if (!contents.complete() && !contents.runs.empty())
    say("continuing: {} {} there already\n", counted(contents.runs.size(), "run"),
        contents.runs.size() == 1 ? "is" : "are");

  return work.finish(contents, {.directory = directory,
                                .jobs = lot.jobs.value_or(0),
                                .figures = figures,
                                .json = arguments.json,
                                .details = arguments.details});
}

}  // namespace isolaw::app
