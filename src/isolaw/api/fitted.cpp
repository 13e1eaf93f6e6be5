#include "isolaw/api/fitted.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/named_device.hpp"

namespace isolaw {
namespace {

void note_record(data::FitRecord const& record, FittedLaw& law) {
  law.dead_band_mm = std::max(law.dead_band_mm, record.dead_band_mm);
  law.ranges.add(record);
}

FittedLaw law_of_lot(campaign::Contents const& contents, std::string_view law, FittedLaw fitted) {
  auto const found = std::ranges::find(contents.lot_analyses, law, &campaign::LotAnalysis::law);
  if (found == contents.lot_analyses.end())
    throw Error({.where = fmt::format("law {}, lot", law),
                 .found = "the campaign holds no one law for the lot",
                 .allowed = "a campaign of two devices or more with --analysis full, which has finished",
                 .advice = "the name of a device: " + campaign::devices_to_name(contents)});
  fitted.parameters = found->mean.parameters;
  fitted.springs = found->springs;
  fitted.refinement = found->refinement;
  for (auto const device : found->devices) note_record(contents.devices[device].record, fitted);
  return fitted;
}

}  // namespace

FittedLaw fitted_law(campaign::Contents const& contents, std::string_view law, std::string_view device) {
  if (std::ranges::find(contents.settings.laws, law) == contents.settings.laws.end())
    throw Error({.where = fmt::format("law {}", law),
                 .found = "not in this campaign",
                 .allowed = joined(contents.settings.laws)});
  FittedLaw fitted{.parameters = {},
                   .integration = contents.settings.integration,
                   .turning_points = contents.settings.turning_points,
                   .part = contents.settings.clean.scored.text()};
  auto const index = campaign::named_device(contents, device);
  if (!index) return law_of_lot(contents, law, std::move(fitted));
  auto const* run = contents.best_run(*index, law);
  if (run == nullptr)
    throw Error({.where = fmt::format("device '{}', law {}", device, law),
                 .found = "no usable run",
                 .allowed = "a device that the law was fitted to"});
  fitted.parameters = run->parameters;
  fitted.refinement = run->refinement;
  note_record(contents.devices[*index].record, fitted);
  if (auto const* analysis = contents.analysis_of(*index, law)) fitted.springs = analysis->springs;
  return fitted;
}

}  // namespace isolaw
