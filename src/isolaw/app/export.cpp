#include <cstdio>
#include <fstream>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
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
  auto const text = target.write(subject, units);
  if (!a.out) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
  }
  std::ofstream file(*a.out, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.flush())
    throw Error(
        {.where = a.out->string(), .found = "cannot be written", .allowed = "a file in a directory that exists"});
  say("{}\n", shown(*a.out));
  return exit_done;
}

}  // namespace isolaw::app
