#include "isolaw/study/building_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/design_bounds.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/draws.hpp"
#include "isolaw/study/recommendation.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {

namespace {

std::vector<Finding> doubts_of(Summary const& summary, std::string_view law,
                               std::vector<building::BearingPlace> const& bearings) {
  std::vector<Finding> all;
  auto const add = [&](Doubts doubts) {
    if (doubts.objection) doubts.findings.push_back(std::move(*doubts.objection));
    for (auto& finding : doubts.findings)
      if (std::ranges::find(all, finding) == all.end()) all.push_back(std::move(finding));
  };
  add(doubts(summary, law, std::nullopt));
  for (auto const& bearing : bearings)
    if (bearing.kind == building::BearingKind::device &&
        std::ranges::find(summary.devices, bearing.device, &DeviceResult::name) != summary.devices.end())
      add(doubts(summary, law, bearing.device));
  return all;
}

building::LawSource source_of(campaign::Contents const& contents, Summary const& summary, std::string_view law_id,
                              std::string_view place) {
  auto const& entry = laws::find_law(law_id);
  auto const where = fmt::format("{}, law {}", place, law_id);
  auto const law = std::ranges::find(summary.laws, law_id, &LawResult::id);
  if (law == summary.laws.end())
    throw Error({.where = where,
                 .found = "the law is not in this campaign",
                 .allowed = joined(contents.settings.laws),
                 .advice = fmt::format("isolaw calibrate ... --laws {}", law_id)});
  building::LawSource source;
  source.law = law_id;
  for (std::size_t d = 0; d < contents.devices.size(); ++d)
    if (auto const* analysis = contents.analysis_of(d, law_id); analysis != nullptr) {
      for (double const x : contents.devices[d].record.disp_mm)
        source.tested_mm = std::max(source.tested_mm, std::abs(x));
      source.devices.emplace(contents.devices[d].name, analysis->determination.optimum);
    }
  // If only one device was analysed (copies of records do not count), there is no law of the lot. The device's
  // parameters then represent the lot.
  auto const is_analysed = [](DeviceFit const& fit) { return fit.counts && fit.optimum; };
  if (law->lot)
    source.lot = law->lot->parameters;
  else if (std::ranges::count_if(law->devices, is_analysed) == 1)
    source.lot = source.devices.at(std::ranges::find_if(law->devices, is_analysed)->device);
  if (source.lot.empty())
    throw Error({.where = where,
                 .found = "no analysis was made",
                 .allowed = "a law that was analysed",
                 .advice = "isolaw calibrate ... --analysis full"});
  source.place.assign(source.lot.size(), std::nullopt);
  source.median = source.lot;
  if (!law->population || !law->population->has_covariance()) {
    if (law->population) source.population.note = law->population->note;
    return source;
  }
  source.population = *law->population;
  auto const columns = columns_of(*law, entry);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    source.place[i] = columns[i].place;
    source.median[i] = columns[i].place ? source.population.medians[*columns[i].place] : columns[i].value;
  }
  source.limits = limits_of(source.population, entry);
  return source;
}

// A bearing may be modelled by horizontal springs in several directions, each of which follows the law. This function
// replaces the law's parameters, on each device and on the lot, by those with which such springs fit the tests best. It
// returns nullopt if no device has an analysis of the law, or if one of the law's analyses has no such parameters.
std::optional<campaign::Contents> with_springs_of(campaign::Contents contents, std::string_view law) {
  bool any = false;
  for (auto& analysis : contents.device_analyses) {
    if (analysis.law != law) continue;
    if (!analysis.springs) return std::nullopt;
    analysis.determination.optimum = analysis.springs->parameters;
    any = true;
  }
  for (auto& analysis : contents.lot_analyses) {
    if (analysis.law != law || analysis.mean.parameters.empty()) continue;
    if (!analysis.springs) return std::nullopt;
    analysis.mean.parameters = analysis.springs->parameters;
  }
  return any ? std::optional(std::move(contents)) : std::nullopt;
}

// If the building file states no factors for a bound, takes those of the bound law over the design conditions.
void take_bounds(building::LawSource& source, Summary const& summary, building::Settings const& asked,
                 std::string_view where) {
  auto const bounds = design_bounds(summary, laws::find_law(source.law), source.lot);
  if (bounds.obstacle)
    throw Error({.where = fmt::format("{}, law {}", where, source.law),
                 .found = wording::remark(*bounds.obstacle),
                 .allowed = "a campaign whose tests cover all design conditions, or numbers for lower and upper"});
  auto const take = [&](std::string_view which, DesignBound const& bound,
                        std::optional<building::PartFactors> building::LawSource::*member) {
    building::PartFactors const factors{.elastic = bound.law.factors.a, .hysteretic = bound.law.factors.b};
    source.*member = factors;
    for (auto& springs : source.springs) springs.*member = factors;
    auto finding = about_bound(which, bound);
    finding.law = source.law;
    source.doubts.push_back(std::move(finding));
  };
  if (!asked.lower) take("lower", *bounds.lower, &building::LawSource::lower);
  if (!asked.upper) take("upper", *bounds.upper, &building::LawSource::upper);
}

// Throws Error if the building file states one factor for the elastic part of the force and another one for the
// hysteretic part, but the law's parameters can only scale both alike.
void require_one_factor(laws::LawEntry const& law, building::Settings const& asked, std::string_view where) {
  for (auto const& factors : {asked.lower, asked.upper})
    if (law.one_factor && factors && !factors->is_whole())
      throw Error({.where = fmt::format("{}, law {}", where, law.info.id),
                   .found =
                       "factors on the elastic and on the hysteretic part, and no parameters of this law change one "
                       "part alone",
                   .allowed = "one factor for lower and one for upper, or another law"});
}

}  // namespace

building::LawSource law_source(campaign::Contents const& contents, Summary const& summary, std::string_view law,
                               std::string_view where, building::BuildingFile const& file) {
  require_one_factor(laws::find_law(law), file.settings, where);
  auto source = source_of(contents, summary, law, where);
  bool const any_springs = std::ranges::any_of(file.motions, [&](building::Motion const& motion) {
    return building::coupling_under(motion, source) == building::Coupling::springs;
  });
  if (any_springs)
    if (auto const springs = with_springs_of(contents, law))
      source.springs = {source_of(*springs, build_summary(*springs), law, where)};
  source.doubts = doubts_of(summary, law, file.bearings);
  if (!file.settings.lower || !file.settings.upper) take_bounds(source, summary, file.settings, where);
  return source;
}

std::string recommended_law(Summary const& summary, std::string_view where) {
  if (auto const advice = recommendation(summary); advice && advice->law) return summary.laws[*advice->law].id;
  throw Error({.where = std::string(where),
               .found = "the campaign recommends no law",
               .allowed = "laws = [\"...\"] in the building file"});
}

}  // namespace isolaw::study
