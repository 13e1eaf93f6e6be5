#include "isolaw/api/export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "isolaw/api/calibrate.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/building/plausibility.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/programs/model_text.hpp"
#include "isolaw/programs/text.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw {
namespace {

using programs::Target;

void require_suited(ExportOptions const& options, Target const& target) {
  if (!target.needs_building && (!options.model.empty() || !options.seed.empty()))
    throw Error(
        {.where =
             "--" + std::string(options.model.empty() ? options.seed.begin()->first : options.model.begin()->first),
         .found = fmt::format("is given with --to {}", options.to),
         .allowed = "a target that writes a whole model: " + joined(programs::targets_where(&Target::needs_building))});
  if (options.name && !target.is_named)
    throw Error({.where = "--name",
                 .found = fmt::format("is given with --to {}", options.to),
                 .allowed = "a target whose file has a name: " + joined(programs::targets_where(&Target::is_named))});
  if (options.name) programs::require_export_name(*options.name);
  if (!options.motions.empty() && !target.refits)
    throw Error({.where = "--motion",
                 .found = fmt::format("is given with --to {}, which writes the law itself", options.to),
                 .allowed = "a target that may re-fit the law: " + joined(programs::targets_where(&Target::refits))});
}

}  // namespace

ExportedLaw export_law(campaign::Contents contents, ExportOptions const& options) {
  auto const& target = programs::find_target(options.to);
  require_suited(options, target);
  auto const& units = find_unit_system(options.units ? *options.units : std::string(contents.acceptance.report_units));
  lay_over(campaign::acceptance_table(), options.acceptance, contents.acceptance);
  complete_acceptance(contents.acceptance);
  ExportedLaw result;
  if (!options.acceptance.empty())
    for (auto const& remark : remarks_on_design(contents.acceptance)) result.doubts.push_back(to_string(remark));
  auto const summary = study::build_summary(contents);
  auto subject = programs::make_subject(contents, summary, options.law, options.device, units);
  subject.name = options.name.value_or("");
  if (target.needs_building) {
    programs::ModelOptions model;
    lay_over(programs::model_table(), options.model, model);
    if (!options.seed.empty() && model.draws == 0)
      throw Error({.where = "--seed", .found = "is given without draws", .allowed = "with --draws N, which it seeds"});
    auto settings = contents.settings;
    campaign::apply(options.seed, settings);
    subject.model = programs::make_model(model, contents, summary, options.law, options.device, settings.seed);
  }
  std::vector<Finding> about_motions;
  for (auto& motion : building::read_motions(options.motions, options.stated)) {
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
  auto exported = programs::write_export(subject, target, units, options.anyway);
  auto const warn = [&](std::string const& sentence) { result.doubts.push_back("warning: " + printable(sentence)); };
  std::ranges::move(wording::lines(subject.doubts.findings, wording::with_law, units),
                    std::back_inserter(result.doubts));
  std::ranges::for_each(subject.beyond_tests, warn);
  if (subject.model) std::ranges::for_each(programs::model_cautions(subject, units), warn);
  std::ranges::for_each(exported.cautions, warn);
  std::ranges::copy(exported.responses, std::back_inserter(about_motions));
  std::ranges::move(wording::lines(about_motions, wording::anywhere, units), std::back_inserter(result.doubts));
  for (auto const& objection : exported.overridden_objections)
    result.doubts.push_back(printable(study::override_warning(objection)));
  result.text = std::move(exported.text);
  return result;
}

}  // namespace isolaw
