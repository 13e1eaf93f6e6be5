#include "isolaw/study/warnings.hpp"
#include "isolaw/study/conditions_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "isolaw/data/signals/copies.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/energy_fall.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;
using enum FindingKind;

class Collector {
 public:
  Collector(Summary const& summary, Scope const& scope) : summary_(summary), scope_(scope) {
    for (auto const& law : summary.laws)
      if (scope.covers(law)) laws_.push_back(&law);
    for (auto const& device : summary.devices)
      if (scope.covers_device(device.name)) devices_.push_back(&device);
  }

  std::vector<Finding> collect() && {
    missing();
    refused_devices();
    if (summary_.without_corrections) add(*summary_.without_corrections);
    copies();
    degradation();
    for (auto const* law : laws_) {
      refusals(*law);
      failures(*law);
      if (auto unfit = inadequacy(*law)) add(std::move(*unfit));
      if (law->runs_away) add(*law->runs_away);
      held(*law);
      prediction(*law);
      search(*law);
      parameters(*law);
      integration(*law);
    }
    prediction_not_asked();
    if (summary_.conditions_differ) add(*summary_.conditions_differ);
    if (summary_.conditions)
      for (auto& finding : conditions_findings(*summary_.conditions)) add(std::move(finding));
    if (!summary_.no_conditions.empty())
      add({.kind = FindingKind::conditions_not_compared, .words = {{"reason", summary_.no_conditions}}});
    outliers();
    records();
    std::ranges::stable_sort(all_, {}, &Finding::kind);
    return std::move(all_);
  }

 private:
  void add(Finding finding) { all_.push_back(std::move(finding)); }

  std::vector<DeviceFit const*> fits(LawResult const& law) const {
    std::vector<DeviceFit const*> found;
    for (auto const& fit : law.devices)
      if (scope_.covers_device(fit.device)) found.push_back(&fit);
    return found;
  }

  void missing() {
    if (summary_.missing_runs() > 0) {
      Finding finding{.kind = runs_missing,
                      .numbers = {{"runs", static_cast<double>(summary_.runs)},
                                  {"expected_runs", static_cast<double>(summary_.expected_runs)}}};
      if (summary_.part) {
        finding.numbers.push_back({"part", static_cast<double>(summary_.part->number)});
        finding.numbers.push_back({"parts", static_cast<double>(summary_.part->total)});
      }
      add(std::move(finding));
    } else if (summary_.missing_analyses() > 0) {
      add({.kind = analyses_missing,
           .numbers = {{"analyses", static_cast<double>(summary_.analyses)},
                       {"expected_analyses", static_cast<double>(summary_.expected_analyses)}}});
    }
  }

  void refused_devices() {
    for (auto const* device : devices_)
      if (device->status != "ok")
        add({.kind = device_refused, .devices = {device->name}, .words = {{"reason", device->message}}});
  }

  void copies() {
    for (auto& finding : shared_records(summary_))
      if (std::ranges::any_of(finding.devices, [&](auto const& name) { return scope_.covers_device(name); }))
        add(std::move(finding));
    if (summary_.devices.size() > data::most_compared)
      add({.kind = copies_not_sought, .numbers = {{"most", static_cast<double>(data::most_compared)}}});
  }

  bool is_given(std::string_view setting) const {
    auto const found = std::ranges::find(summary_.settings, setting, &Setting::key);
    return found != summary_.settings.end() && found->json != "\"all\"" && found->json != "\"\"";
  }

  // Warns if a device loses energy steadily through a block and no law in scope follows the loss.
  void degradation() {
    for (auto const* device : devices_) {
      EnergyFall const* nearest = nullptr;
      LawResult const* nearest_law = nullptr;
      bool followed = false;
      for (auto const* law : laws_) {
        auto const* fit = fit_of(*law, device->name);
        if (fit == nullptr || !fit->energy_fall) continue;
        followed = followed || follows(*fit->energy_fall);
        if (nearest != nullptr && fit->energy_fall->percent <= nearest->percent) continue;
        nearest = &*fit->energy_fall;
        nearest_law = law;
      }
      if (nearest == nullptr || followed) continue;
      add({.kind = energy_falls,
           .law = nearest_law->id,
           .devices = {device->name},
           .blocks = {nearest->block},
           .numbers = {{"measured_percent", nearest->measured_percent},
                       {"law_percent", std::max(0.0, nearest->percent)},
                       {"first_cycle", static_cast<double>(nearest->first_cycle)},
                       {"last_cycle", static_cast<double>(nearest->last_cycle)}},
           .words = {{laws_.size() == 1 ? "only_law" : "several_laws", "yes"},
                     {"fit_cycles", is_given("fit-cycles") ? "" : "open"}}});
    }
  }

  void refusals(LawResult const& law) {
    for (auto const* fit : fits(law)) {
      if (fit->refusal.empty()) continue;
      Finding finding{
          .kind = law_refused, .law = law.id, .devices = {fit->device}, .words = {{"reason", fit->refusal}}};
      finding.numbers = {{"others", static_cast<double>(std::ranges::count(law.devices, "ok", fit_status))}};
      add(std::move(finding));
    }
  }

  void failures(LawResult const& law) {
    double runs = 0.0, failed_of_law = 0.0, tried = 0.0, failed = 0.0;
    for (auto const* fit : fits(law)) {
      runs += fit->runs;
      failed_of_law += fit->failed_runs;
      tried += static_cast<double>(fit->evaluations);
      failed += static_cast<double>(fit->failed_evaluations);
    }
    for (auto const* fit : fits(law))
      if (fit->failed_runs > 0)
        add({.kind = runs_failed,
             .law = law.id,
             .devices = {fit->device},
             .numbers = {{"failed", static_cast<double>(fit->failed_runs)},
                         {"failed_of_law", failed_of_law},
                         {"runs_of_law", runs},
                         {"other_runs", runs - failed_of_law}},
             .words = {{"reason", fit->failure}}});
    if (failed > 0.0)
      add({.kind = evaluations_failed,
           .law = law.id,
           .numbers = {{"failed", failed}, {"tried", tried}, {"share", failed / tried}}});
  }

  void held(LawResult const& law) {
    if (scope_.device) return;
    if (auto const bounds = pinned(law); bounds.decides()) add(bounds.finding(law.id));
  }

  void prediction(LawResult const& law) {
    if (!law.prediction_holds()) add(prediction_of(summary_, law));
  }

  void search(LawResult const& law) {
    auto share = law.success_share;
    if (auto const found = fits(law); scope_.device && !found.empty()) share = found.front()->success_share;
    constexpr double enough_runs = 0.5;
    if (share && *share < enough_runs) add({.kind = searches_disagree, .law = law.id, .numbers = {{"share", *share}}});
    // If there are many runs, some may end at a worse objective. Two or three runs must all agree.
    constexpr int few_runs = 3;
    for (auto const* fit : fits(law))
      if (fit->runs <= few_runs && fit->runs_apart > found_within)
        add({.kind = runs_differ,
             .law = law.id,
             .devices = {fit->device},
             .numbers = {
                 {"apart", fit->runs_apart}, {"runs", static_cast<double>(fit->runs)}, {"more", 2.0 * fit->runs}}});
  }

  void parameters(LawResult const& law) {
    double fitted = 0.0, examined = 0.0;
    std::vector<Finding> open, bounds;
    auto const about = [&](std::vector<Finding>& list, FindingKind kind, std::string const& parameter,
                           std::vector<FindingWord> const& words) -> Finding& {
      auto const found = std::ranges::find_if(
          list, [&](Finding const& other) { return other.parameters.front() == parameter && other.words == words; });
      if (found != list.end()) return *found;
      return list.emplace_back(Finding{.kind = kind, .law = law.id, .parameters = {parameter}, .words = words});
    };
    for (auto const* fit : fits(law)) {
      fitted += fit_status(*fit) == "ok" ? 1.0 : 0.0;
      examined += fit->optimum ? 1.0 : 0.0;
      for (auto const& parameter : fit->parameters) {
        if (parameter.analysis && parameter.analysis->identifiability == analysis::Verdict::undetermined)
          about(open, not_determined, parameter.name, {{"reduced_form", law.reduced_form}})
              .devices.push_back(fit->device);
        if (parameter.at_bound != fit::AtBound::no)
          about(bounds, at_bound, parameter.name, {{"side", std::string(name(parameter.at_bound))}})
              .devices.push_back(fit->device);
      }
    }
    for (auto& finding : open) {
      auto const affected = static_cast<double>(finding.devices.size());
      if (affected < examined) finding.numbers = {{"affected", affected}, {"examined", examined}};
      add(std::move(finding));
    }
    for (auto& finding : bounds) {
      bool const all = fitted > 1.0 && static_cast<double>(finding.devices.size()) == fitted;
      if (all)
        finding.numbers = {{"all_devices", fitted}};
      else
        finding.words.push_back({"some", "yes"});
      if (auto set = set_beyond(law, finding.parameters.front(), finding.word("side")); !set.empty())
        finding.words.push_back({"set", std::move(set)});
      add(std::move(finding));
    }
    if (law.lot && !scope_.device)
      for (auto const& [parameter, side] : law.lot->at_bound)
        add({.kind = lot_law_at_bound,
             .law = law.id,
             .parameters = {parameter},
             .words = {{"side", std::string(name(side))}}});
  }

  // The option that moves the bound at which the parameter lies; empty if the bound is a physical limit.
  static std::string set_beyond(LawResult const& law, std::string const& parameter, std::string_view side) {
    auto const entry =
        std::ranges::find_if(laws::catalogue(), [&](auto const& each) { return each.info.id == law.id; });
    if (entry == laws::catalogue().end()) return {};
    auto const info = std::ranges::find(entry->parameters, parameter, &laws::ParameterInfo::name);
    if (info == entry->parameters.end()) return {};
    std::optional<laws::Interval> all;
    for (auto const& fit : law.devices)
      for (auto const& p : fit.parameters) {
        if (p.name != parameter || name(p.at_bound) != side) continue;
        auto const one = fit::interval_beyond(*info, laws::Interval{p.lower, p.upper}, p.at_bound);
        if (one && all) all = laws::Interval{std::min(all->lower, one->lower), std::max(all->upper, one->upper)};
        if (one && !all) all = one;
      }
    return all ? fmt::format("--set {}.{}={:.4g}:{:.4g}", law.id, parameter, all->lower, all->upper) : std::string();
  }

  void integration(LawResult const& law) {
    for (auto const* fit : fits(law)) {
      double const shift = std::abs(fit->integration_shift.value_or(0.0));
      if (shift <= large_integration_shift) continue;
      if (std::isfinite(shift))
        add({.kind = integration_coarse, .law = law.id, .devices = {fit->device}, .numbers = {{"shift", shift}}});
      else
        add({.kind = integration_not_finite, .law = law.id, .devices = {fit->device}});
    }
  }

  void prediction_not_asked() {
    if (laws_.empty()) return;
    bool const several_blocks = std::ranges::any_of(
        devices_, [](auto const* device) { return device->status == "ok" && device->properties.blocks.size() > 1; });
    bool const predicted = std::ranges::any_of(
        laws_, [](auto const* law) { return law->predicted_objective || law->larger_swings_objective; });
    if (several_blocks && !predicted) add({.kind = FindingKind::prediction_not_asked});
  }

  void outliers() {
    if (auto const& left_out = summary_.not_compared) add(*left_out);
    for (auto const& outlier : summary_.outliers) {
      bool const on_other_law = scope_.law && !outlier.law.empty() && outlier.law != *scope_.law;
      if (on_other_law || !scope_.covers_device(outlier.device)) continue;
      add({.kind = FindingKind::outlier,
           .law = outlier.law,
           .devices = {outlier.device},
           .numbers = {{"value", outlier.value}, {"median", outlier.median}, {"percent", outlier.percent}},
           .words = {{"property", outlier.property}, {"unit", outlier.unit}}});
    }
  }

  void records() {
    for (auto const* device : devices_)
      if (device->status == "ok")
        for (auto& finding : record_findings(summary_, *device)) add(std::move(finding));
  }

  static std::vector<Finding> record_findings(Summary const& summary, DeviceResult const& device);
  static std::vector<Finding> shared_records(Summary const& summary);
  friend std::vector<std::vector<Finding>> isolaw::study::device_warnings(Summary const& summary);

  Summary const& summary_;
  Scope const& scope_;
  std::vector<LawResult const*> laws_;
  std::vector<DeviceResult const*> devices_;
  std::vector<Finding> all_;
};

// If the measured stiffness is `ratio` times the design value, a mistake of the user may explain it, such as a wrong
// unit. Returns a question that asks the user about this mistake, or "" if no known mistake gives this ratio.
std::string_view mistake_of(double ratio) {
  struct Mistake {
    double ratio, within;
    std::string_view question;
  };
  constexpr Mistake mistakes[]{
      {2.0, 0.05, "Does the rig shear two devices, or is the force that of one of two? (--force-factor)"},
      {4.4482216, 0.1, "Are the forces in kip where kN is taken, or in kN where kip is taken? (--units force=UNIT)"},
      {9.9, 0.12, "Are the forces in tonf where kN is taken, or is a factor of 10 missing? (--units, --channel-scale)"},
      {25.4, 0.12, "Are the displacements in in where mm is taken, or in mm where in is taken? (--units disp=UNIT)"},
      {100.0, 0.15, "Is a factor of 100 missing, or are displacements in m where cm is taken? (--channel-scale)"},
      {1000.0, 0.15, "Are the forces in N where kN is taken, or the displacements in m where mm is? (--units)"}};
  for (auto const& each : mistakes)
    for (double const expected : {each.ratio, 1.0 / each.ratio})
      if (std::abs(ratio / expected - 1.0) <= each.within) return each.question;
  return {};
}

// Adds a finding for each value that suggests a wrong unit, judged by the device's design stiffness and its rubber.
void add_implausible(Summary const& summary, DeviceResult const& device, std::vector<Finding>& found) {
  auto const* cycle = counting_cycle(device.properties, device.acceptance.block);
  if (cycle == nullptr) return;
  if (auto const design = summary.acceptance.design.K_eff_kN_per_mm) {
    double const ratio = cycle->K_eff_kN_per_mm / *design;
    if (auto const question = mistake_of(ratio); !question.empty())
      found.push_back({.kind = stiffness_unlike_design,
                       .numbers = {{"K_eff_kN_per_mm", cycle->K_eff_kN_per_mm}, {"ratio", ratio}},
                       .words = {{"mistake", std::string(question)}}});
  }
  constexpr double largest_strain_percent = 600.0;
  if (!device.rubber_thickness_mm) return;
  double const strain_percent = 100.0 * cycle->amplitude_mm / *device.rubber_thickness_mm;
  if (strain_percent > largest_strain_percent)
    found.push_back({.kind = strain_implausible,
                     .numbers = {{"amplitude_mm", cycle->amplitude_mm}, {"strain_percent", strain_percent}}});
}

// The warnings about the record and the reasons why it has no cyclic properties. A reason that is also a warning is
// listed only once.
std::vector<Finding> Collector::record_findings(Summary const& summary, DeviceResult const& device) {
  auto found = device.raw.warnings;
  for (auto const& reason : device.properties.refusal)
    if (std::ranges::find(found, reason) == found.end()) found.push_back(reason);
  add_implausible(summary, device, found);
  for (auto& finding : found) finding.devices = {device.name};
  return found;
}

// Warns of devices that share a record (copies make parameters seem to scatter less) or a compression test.
std::vector<Finding> Collector::shared_records(Summary const& summary) {
  std::vector<Finding> found;
  auto const names_of = [](auto const& group) {
    Names names;
    for (auto const* device : group) names.push_back(device->name);
    return names;
  };
  for (auto const& group : devices_of_one_record(summary)) {
    auto& finding = found.emplace_back(Finding{.kind = same_record, .devices = names_of(group)});
    if (std::ranges::any_of(group, [&](auto const* d) { return !data::is_same_record(group.front()->raw, d->raw); }))
      finding.words = {{"altered", "yes"}};
    Names left_out;
    for (auto const* device : group)
      if (!device->counts()) left_out.push_back(device->name);
    if (group.front()->raw.size() > 0) finding.words.push_back({"left_out", enumerate(left_out)});
  }
  for (auto const& group : devices_of_one_compression(summary))
    found.push_back({.kind = same_compression_test,
                     .devices = names_of(group),
                     .numbers = {{"times", static_cast<double>(group.size())}}});
  return found;
}

}  // namespace

std::vector<Finding> warnings(Summary const& summary, Scope const& scope) {
  return Collector(summary, scope).collect();
}

std::vector<std::vector<Finding>> device_warnings(Summary const& summary) {
  auto const shared = Collector::shared_records(summary);
  std::vector<std::vector<Finding>> all;
  for (auto const& device : summary.devices) {
    auto& own = all.emplace_back(Collector::record_findings(summary, device));
    for (auto const& finding : shared)
      if (std::ranges::find(finding.devices, device.name) != finding.devices.end()) own.push_back(finding);
  }
  return all;
}

}  // namespace isolaw::study
