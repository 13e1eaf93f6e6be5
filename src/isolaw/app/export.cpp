#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/building/plausibility.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/text.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::app {

int export_law(ExportArguments const& a) {
  using programs::Target;
  auto const& target = programs::find_target(a.to);
  if (!target.of_model && (!a.model.empty() || !a.seed.empty()))
    throw Error(
        {.where = "--" + std::string(a.model.empty() ? a.seed.begin()->first : a.model.begin()->first),
         .found = fmt::format("is given with --to {}", a.to),
         .allowed = "a target that writes a whole model: " + joined(programs::targets_where(&Target::of_model))});
  if (a.name && !target.is_named)
    throw Error({.where = "--name",
                 .found = fmt::format("is given with --to {}", a.to),
                 .allowed = "a target whose file has a name: " + joined(programs::targets_where(&Target::is_named))});
  if (a.name) programs::require_export_name(*a.name);
  if (!a.motions.empty() && !target.refits)
    throw Error({.where = "--motion",
                 .found = fmt::format("is given with --to {}, which writes the law itself", a.to),
                 .allowed = "a target that may re-fit the law: " + joined(programs::targets_where(&Target::refits))});
  auto contents = campaign::Store::read(a.directory / "campaign.sqlite");
  auto const& units = find_unit_system(a.units ? *a.units : std::string(contents.acceptance.report_units));
  apply(a.acceptance, contents.acceptance);
  auto const summary = study::build_summary(contents);
  auto subject = programs::make_subject(contents, summary, a.law, a.device, units);
  subject.name = a.name.value_or("");
  if (target.of_model) {
    programs::ModelOptions options;
    lay_over(programs::model_table(), a.model, options);
    if (!a.seed.empty() && options.draws == 0)
      throw Error({.where = "--seed", .found = "is given without draws", .allowed = "with --draws N, which it seeds"});
    auto settings = contents.settings;
    campaign::apply(a.seed, settings);
    subject.model = programs::make_model(options, contents, summary, a.law, a.device, settings.seed);
  }
  std::vector<Finding> about_motions;
  for (auto& motion : building::read_motions(a.motions, a.stated)) {
    if (!motion.y_mm_s2.empty())
      throw Error({.where = "--motion",
                   .found = "two components of " + printable(motion.name),
                   .allowed = "motions along one direction: the law is compared along one",
                   .advice = "a --motion for each component"});
    std::ranges::move(building::motion_doubts(motion), std::back_inserter(about_motions));
    subject.motions.push_back({.file = std::move(motion.name),
                               .step_s = motion.step_s,
                               .acceleration_mm_s2 = std::move(motion.x_mm_s2),
                               .recognised = {}});
  }
  auto const exported = programs::write_export(subject, target, units, a.anyway);
  for (auto const& line : wording::lines(subject.doubts.findings, wording::with_law, units)) say("{}\n", line);
  for (auto const& sentence : subject.beyond) say("warning: {}\n", printable(sentence));
  if (subject.model)
    for (auto const& caution : programs::model_cautions(subject, units)) say("warning: {}\n", printable(caution));
  for (auto const& caution : exported.cautions) say("warning: {}\n", printable(caution));
  std::ranges::copy(exported.responses, std::back_inserter(about_motions));
  for (auto const& line : wording::lines(about_motions, wording::anywhere, units)) say("{}\n", line);
  for (auto const& objection : exported.let_through) say("{}\n", printable(study::let_through(objection)));
  std::vector<std::filesystem::path> inputs(a.motions.begin(), a.motions.end());
  for (auto const* key : {"layout", "ground-motion", "ground-motion-y"})
    if (auto const given = a.model.find(key); given != a.model.end()) inputs.emplace_back(text_of(given->second));
  if (!a.out) {
    std::fwrite(exported.text.data(), 1, exported.text.size(), stdout);
    return exit_done;
  }
  write_output(*a.out, exported.text, inputs);
  say("{}\n", shown(*a.out));
  return exit_done;
}

}  // namespace isolaw::app
