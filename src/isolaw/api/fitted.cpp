#include "isolaw/api/fitted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

double largest(std::vector<double> const& values) {
  double found = 0.0;
  for (double const value : values) found = std::max(found, std::abs(value));
  return found;
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

std::vector<std::string> beyond_what_is_known(laws::LawEntry const& law, FittedLaw const& as_fitted,
                                              data::FitRecord const& motion) {
  std::vector<std::string> lines;
  auto const add_beyond = [&](double reached, double fitted, double tested, std::string_view unit) {
    constexpr double beyond = 1.02;
    auto const add = [&](double known, std::string_view what, std::string_view so) {
      lines.push_back(
          fmt::format("the history reaches {:.4g} {}, {} {:.4g} {}{}", reached, unit, what, known, unit, so));
    };
    bool const is_part = tested > beyond * fitted;
    if (is_part && fitted > 0.0 && reached > beyond * fitted) add(fitted, "what the law was fitted to", "");
    if (tested > 0.0 && reached > beyond * tested) add(tested, "the test", ": beyond it nothing was measured");
  };
  auto const& [tested, fitted] = as_fitted.ranges;
  add_beyond(largest(motion.disp_mm), fitted.disp_mm, tested.disp_mm, "mm");
  if (!law.info.traits.rate_independent)
    add_beyond(largest(motion.vel_mm_s), fitted.vel_mm_s.value_or(0.0), tested.vel_mm_s.value_or(0.0), "mm/s");
  return lines;
}

std::vector<std::string> cautions(laws::LawEntry const& law, FittedLaw const& as_fitted,
                                  data::FitRecord const& motion) {
  auto lines = beyond_what_is_known(law, as_fitted, motion);
  constexpr double at_zero = 1e-6;  // share of the largest displacement that counts as zero
  if (double const x = motion.disp_mm.front(); std::abs(x) > at_zero * largest(motion.disp_mm))
    lines.push_back(fmt::format(
        "the motion starts at {:.4g} mm: the device is taken as virgin there, its force as if it had come there without history; an analysis program starts at 0: put a path from 0 in front to compare",
        x));
  return lines;
}

}  // namespace isolaw
