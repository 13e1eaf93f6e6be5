// Implements `isolaw conditions`, which shows how the properties of devices change with temperature, rate, load, ageing
// and history.
#include "isolaw/study/conditions.hpp"

#include "isolaw/api/conditions.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/render/figures/conditions_figures.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/rules/measured_rules.hpp"
#include "isolaw/render/terminal/conditions_text.hpp"
#include "isolaw/render/write.hpp"

namespace isolaw::app {

int conditions(ConditionsArguments const& arguments) {
  if (arguments.out && std::filesystem::exists(*arguments.out) && !std::filesystem::is_directory(*arguments.out))
    throw Error({.where = "--out", .found = shown(*arguments.out) + " is a file", .allowed = "a directory"});
  if (arguments.devices && !arguments.plan && !arguments.json && !arguments.out)
    throw Error({.where = "--devices",
                 .found = "without --plan",
                 .allowed = "with --plan, --json or --out, which give the plan that it is for"});
  if (arguments.write_rules && std::filesystem::exists(*arguments.write_rules))
    throw Error({.where = "--write-rules",
                 .found = shown(*arguments.write_rules) + " exists, and somebody may have verified it",
                 .allowed = "a new file"});
  auto const [observed, title, acceptance] = conditions_source(arguments.lot, arguments.allow_outside);
  auto result = study::build_conditions(observed, title, acceptance);
  if (arguments.devices) result.plan = study::plan_tests(result, *arguments.devices);
  if (arguments.json)
    print(render::conditions_json(result));
  else if (arguments.plan || arguments.at_reference)
    print(render::conditions_text(result, {.at_reference = arguments.at_reference, .plan = arguments.plan}));
  else
    print(render::conditions_text(result, arguments.details));
  if (arguments.out) {
    auto const& units = find_unit_system(acceptance.report_units);
    render::write_conditions_outputs(result, units, *arguments.out);
    say("written: {}\n", shown(*arguments.out / "conditions.json"));
    say_drawn(render::add_figures(render::conditions_figures(result, units), *arguments.out), *arguments.out,
              "the same command");
  }
  if (arguments.write_rules) {
    auto const& file = *arguments.write_rules;
    write_file(file, render::measured_rules(result, file.stem().string()));
    say("written: {}\n", shown(file));
  }
  return result.refused.empty() && !study::dependence_failed(result) ? exit_done : exit_with_refusals;
}

}  // namespace isolaw::app
