#include <cstdio>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::app {

int export_law(ExportArguments const& a) {
  auto const& target = programs::find_target(a.to);
  auto const& units = a.units ? programs::find_unit_system(*a.units) : programs::unit_systems[0];
  auto contents = campaign::Store::read(a.directory / "campaign.sqlite");
  apply(a.acceptance, contents.acceptance);
  auto const subject = programs::make_subject(contents, study::build_summary(contents), a.law, a.device, units);
  auto const made = programs::write_export(subject, target, units, a.anyway);
  for (auto const& warning : subject.doubts.warnings) say("warning: {}\n", printable(warning));
  for (auto const& sentence : subject.beyond) say("warning: {}\n", printable(sentence));
  for (auto const& objection : made.let_through) say("{}\n", printable(study::let_through(objection)));
  if (!a.out) {
    std::fwrite(made.text.data(), 1, made.text.size(), stdout);
    return exit_done;
  }
  write_output(*a.out, made.text, {});
  say("{}\n", shown(*a.out));
  return exit_done;
}

}  // namespace isolaw::app
