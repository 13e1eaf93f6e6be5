// `isolaw conditions`: how the properties of devices change with temperature, rate, load, ageing and history.
#include "isolaw/study/conditions.hpp"

#include <algorithm>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/render/figures/conditions_figures.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/terminal/conditions_text.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw::app {

int conditions(ConditionsArguments const& arguments) {
  if (arguments.out && std::filesystem::exists(*arguments.out) && !std::filesystem::is_directory(*arguments.out))
    throw Error({.where = "--out", .found = shown(*arguments.out) + " is a file", .allowed = "a directory"});
  auto const lot = lot_of_file(arguments.lot, {.allow_outside = arguments.allow_outside, .other_out = true});
  if (!lot.conditions)
    throw Error({.where = shown(arguments.lot),
                 .found = "the lot file has no table [conditions]",
                 .allowed = "[conditions] with a reference, and [[device.test]] tables with temperature-C and order",
                 .advice = "isolaw example DIR --conditions writes a lot that has them"});
  auto const result = study::build_conditions(campaign::observe_tests(lot), lot.title, lot.acceptance);
  print(arguments.json ? render::conditions_json(result) : render::conditions_text(result, arguments.details));
  if (arguments.out) {
    auto const& units = find_unit_system(lot.acceptance.report_units);
    render::write_conditions_outputs(result, units, *arguments.out);
    say("written: {}\n", shown(*arguments.out / "conditions.json"));
    say_drawn(render::add_figures(render::conditions_figures(result, units), *arguments.out), *arguments.out,
              "the same command");
  }
  bool const fails = std::ranges::any_of(
      result.dependence, [](study::DependenceRow const& row) { return row.verdict() == rules::Verdict::fail; });
  return result.refused.empty() && !fails ? exit_done : exit_with_refusals;
}

}  // namespace isolaw::app
