#include "isolaw/app/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/check.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::app {

void say_drawn(render::FigureOutcome const& outcome, std::filesystem::path const& directory, std::string_view again) {
  auto const folder = shown(directory / "figures");
  if (outcome.removed > 0)
    say("figures: {} in {} showed other results than these reports and {} removed; --figures lot draws them again\n",
        outcome.removed, folder, outcome.removed == 1 ? "is" : "are");
  if (outcome.program_missing)
    say("figures: {} not drawn, {}; try: install gnuplot (Debian: gnuplot-nox) and {}, or gnuplot NAME.gp in {}, which holds data and scripts\n",
        outcome.figures - outcome.drawn, printable(outcome.reason), again, folder);
  else if (outcome.drawn < outcome.figures)
    say("figures: {} of {} not drawn: {}; data and scripts are in {}\n", outcome.figures - outcome.drawn,
        outcome.figures, printable(outcome.reason), folder);
}

void draw_figures(study::Summary const& summary, render::FigureChoice choice, std::filesystem::path const& directory) {
  say_drawn(render::write_figures(summary, choice, directory), directory, "isolaw report");
}

void print(study::Summary const& summary, std::filesystem::path const& directory, PrintOptions how,
           std::string_view profile) {
  if (how.json) {
    app::print(render::summary_json(summary, profile));
    return;
  }
  int const width = std::min(terminal_width(StandardStream::output), 120);
  auto text = how.details ? render::ranking(summary, width)
                          : render::answer(summary, shown(directory), shown(how.campaign.value_or(directory)), width);
  if (auto const verdicts = study::verdict_summary(summary); !verdicts.empty()) text += "\n" + verdicts;
  app::print(text);
}

int exit_code(study::Summary const& summary) {
  for (auto const& device : summary.devices)
    if (device.status != "ok" || !device.vertical_test.refusal.empty()) return exit_with_refusals;
  for (auto const& law : summary.laws)
    for (auto const& fit : law.devices)
      if (!fit.refusal.empty() || fit.failed_runs > 0) return exit_with_refusals;
  return study::conditions_refused(summary) || study::acceptance_failed(summary) ? exit_with_refusals : exit_done;
}

int report(ReportArguments const& arguments) {
  auto const& directory = arguments.directory;
  auto const figures = render::figure_choice(arguments.figures);
  auto contents = campaign::Store::read(directory / store_name);
  apply(arguments.acceptance, contents.acceptance);
  auto const summary = study::build_summary(contents);
  // Prints the results even if the files cannot be written, for example because the store is on a read-only disk.
  std::optional<Error> not_written;
  try {
    render::write_outputs(summary, arguments.out.value_or(directory));
    draw_figures(summary, figures, arguments.out.value_or(directory));
  } catch (Error const& error) {
    not_written = error;
  }
  print(summary, arguments.out.value_or(directory),
        {.json = arguments.json, .details = arguments.details, .campaign = directory});
  if (!contents.complete() || contents.part) say("the campaign is not complete: {}\n", what_is_missing(summary));
  if (not_written) throw *not_written;
  return contents.complete() ? exit_code(summary) : exit_with_refusals;
}

}  // namespace isolaw::app
