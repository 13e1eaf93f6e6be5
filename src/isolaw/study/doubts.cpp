#include "isolaw/study/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/recommendation.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {

Finding prediction_of(Summary const& summary, LawResult const& law) {
  if (!law.prediction_grade && law.larger_swings_objective) {
    Finding finding{.kind = FindingKind::prediction_larger_swings,
                    .law = law.id,
                    .numbers = {{"predicted", *law.larger_swings_objective}}};
    // Equally good fits have a range of errors. It is stated if its lower end is below this share of its upper end.
    constexpr double visible = 0.9;
    if (*law.larger_swings_least < visible * *law.larger_swings_objective)
      finding.numbers.push_back({"least", *law.larger_swings_least});
    return finding;
  }
  if (!law.prediction_grade) return {.kind = FindingKind::prediction_unknown, .law = law.id};
  constexpr FindingKind kinds[]{FindingKind::prediction_good, FindingKind::prediction_fair,
                                FindingKind::prediction_poor, FindingKind::prediction_unusable};
  Finding finding{.kind = kinds[static_cast<std::size_t>(*law.prediction_grade)],
                  .law = law.id,
                  .numbers = {{"predicted_objective", *law.predicted_objective},
                              {"worst_predicted", *law.worst_predicted},
                              {"fitted_objective", *law.fitted_objective}}};
  if (!law.prediction_unusable()) return finding;
  auto const how = collapse(*law.fitted_objective, *law.predicted_objective, *law.worst_predicted);
  bool const exact = how == Collapse::much_worse && !(*law.fitted_objective > 0.0);
  finding.words = {{"collapse", exact ? "far_from_exact" : std::string(name(how))}};
  if (!exact) finding.numbers.push_back({"times_as_far", *law.predicted_objective / *law.fitted_objective});
  if (auto const mm = largest_displacement(summary, law)) finding.numbers.push_back({"fitted_to_mm", *mm});
  return finding;
}

Doubts doubts(Summary const& summary, std::string_view law_id, std::optional<std::string_view> device) {
  auto const& law = *std::ranges::find(summary.laws, law_id, &LawResult::id);
  Doubts result{.findings = {}, .prediction = prediction_of(summary, law), .objection = {}};
  if (auto against = verdict_against(summary, device)) result.findings.push_back(std::move(*against));
  if (!device) {
    Finding left_out{.kind = FindingKind::devices_not_in_lot_law,
                     .numbers = {{"lot_devices", static_cast<double>(summary.devices.size())}}};
    for (auto const& one : summary.devices)
      if (one.status != "ok") left_out.devices.push_back(one.name);
    if (!left_out.devices.empty()) result.findings.push_back(std::move(left_out));
  }
  for (auto& warning : warnings(summary, {.law = law_id, .device = device})) {
    // The law was not fitted to a refused device, and the finding devices_not_in_lot_law names this device already.
    if (warning.kind != FindingKind::device_refused) result.findings.push_back(std::move(warning));
  }
  if (auto const advice = recommendation(summary)) {
    if (!advice->law) result.findings.push_back(advice->answer.front());
    for (auto const& standing : advice->standings)
      if (summary.laws[standing.law].id == law_id)
        result.findings.insert(result.findings.end(), standing.doubts.begin(), standing.doubts.end());
    if (advice->spread) result.findings.push_back(finding_of(*advice->spread));
  }
  for (auto const& fault : law.faults_inside)
    if (device ? std::ranges::find(fault.devices, *device) != fault.devices.end() : fault.devices.empty())
      result.objection = fault;
  if (law.prediction_unusable()) result.objection = result.prediction;
  return result;
}

std::string law_and_device_text(std::string_view law, std::optional<std::string_view> device) {
  return fmt::format("law {}, {}", law, device ? fmt::format("device '{}'", *device) : std::string("the lot"));
}

void require_no_objection(Doubts const& doubts, std::string const& where, bool anyway) {
  if (doubts.objection && !anyway)
    throw Error({.where = where,
                 .found = wording::remark(*doubts.objection),
                 .allowed = "a law whose forces are possible and that predicts",
                 .advice = "another law, or --anyway"});
}

std::string override_warning(std::string_view objection) {
  return fmt::format("warning: taken because of --anyway, although {}", objection);
}

std::string part_text(std::string_view part) {
  return part.empty() ? std::string("the whole tests") : fmt::format("{} of the tests alone", part);
}

}  // namespace isolaw::study
