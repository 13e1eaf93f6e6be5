#include "isolaw/study/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "isolaw/base/error.hpp"
#include "isolaw/base/number_text.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::study {
namespace {

// The summary of this law and these devices alone; of records no more than warnings are made from that are not made
// from the whole.
Summary part_of(Summary const& summary, LawResult const& law, std::optional<std::string_view> device) {
  Summary part;
  part.runs = summary.runs;
  part.expected_runs = summary.expected_runs;
  part.analyses = summary.analyses;
  part.expected_analyses = summary.expected_analyses;
  part.settings = summary.settings;
  part.laws.push_back(law);
  auto& own = part.laws.front();
  if (device) {
    own.lot.reset();
    std::erase_if(own.devices, [&](DeviceFit const& fit) { return fit.device != *device; });
    if (!own.devices.empty()) {
      own.success_share = own.devices.front().success_share;
      own.success_reference = own.devices.front().success_reference;
    }
  }
  for (auto const& fit : own.devices) {
    auto const& whole = *std::ranges::find(summary.devices, fit.device, &DeviceResult::name);
    auto& brief = part.devices.emplace_back();
    brief.name = whole.name;
    brief.status = whole.status;
    brief.message = whole.message;
    brief.properties = whole.properties;
    brief.raw.warnings = whole.raw.warnings;
    for (auto const& outlier : summary.outliers)
      if (outlier.device == fit.device && (outlier.law.empty() || outlier.law == law.id))
        part.outliers.push_back(outlier);
  }
  return part;
}

std::string prediction_of(LawResult const& law) {
  if (!law.prediction_grade) return "not asked for: no block of the tests was kept from the fit";
  auto const why = collapse(*law.fitted_objective, *law.predicted_objective, *law.worst_predicted);
  return fmt::format("{}: objective {} on the blocks it was not fitted to ({} at worst), {} on those it was{}",
                     name(*law.prediction_grade), number_text(*law.predicted_objective, 3),
                     number_text(*law.worst_predicted, 3), number_text(*law.fitted_objective, 3),
                     why.empty() ? "" : "; it collapses: " + why);
}

// Devices whose records say nothing to the law of the lot.
std::string left_out_of_lot(Summary const& summary) {
  std::vector<std::string> names;
  for (auto const& device : summary.devices)
    if (device.status != "ok") names.push_back(device.name);
  if (names.empty()) return {};
  return fmt::format("{} of the lot's {} devices {} refused, and no part of its law: {}", names.size(),
                     summary.devices.size(), names.size() == 1 ? "is" : "are", enumerate(names));
}

}  // namespace

Doubts doubts(Summary const& summary, std::string_view law, std::optional<std::string_view> device) {
  auto const& whole = *std::ranges::find(summary.laws, law, &LawResult::id);
  // How the search went on its way there says nothing against what it found.
  constexpr std::array<std::string_view, 1> passed_over{"failed evaluations"};
  Doubts made;
  if (auto against = verdict_against(summary, device); !against.empty()) made.warnings.push_back(std::move(against));
  if (!device)
    if (auto left_out = left_out_of_lot(summary); !left_out.empty()) made.warnings.push_back(std::move(left_out));
  for (auto& warning : warnings(summary, part_of(summary, whole, device)))
    if (std::ranges::find(passed_over, warning.topic) == passed_over.end())
      made.warnings.push_back(std::move(warning.sentence));
  made.prediction = prediction_of(whole);
  if (whole.prediction_unusable()) made.objection = "its prediction is " + made.prediction;
  return made;
}

std::string whose(std::string_view law, std::optional<std::string_view> device) {
  return fmt::format("law {}, {}", law, device ? fmt::format("device '{}'", *device) : std::string("the lot"));
}

void require_taken(Doubts const& doubts, std::string const& where, bool anyway) {
  if (!doubts.objection.empty() && !anyway)
    throw Error({.where = where,
                 .found = doubts.objection,
                 .allowed = "a law that predicts",
                 .advice = "another law, or --anyway"});
}

std::string let_through(std::string_view objection) {
  return fmt::format("let through: {}", objection);
}

std::string part_text(std::string_view part) {
  return part.empty() ? std::string("the whole tests") : fmt::format("{} of the tests alone", part);
}

}  // namespace isolaw::study
