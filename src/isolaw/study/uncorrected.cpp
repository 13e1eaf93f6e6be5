#include "isolaw/study/uncorrected.hpp"

#include <algorithm>
#include <string>

#include "isolaw/study/lot_conditions.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

// A verdict for a sentence, with the reasons of a failure: "fail: K_eff +23.0 %".
std::string text_of(DeviceAcceptance const& acceptance) {
  auto const verdict = device_verdict(acceptance);
  return verdict.verdict == rules::Verdict::fail ? verdict.text() : std::string(name(verdict.verdict));
}

Finding values_of(DeviceResult const& device, DeviceAcceptance const& acceptance, bool has_rules) {
  Finding finding{.kind = FindingKind::values_uncorrected, .devices = {device.name}};
  if (!device.uncorrected) {
    finding.kind = FindingKind::uncorrected_not_known;
    return finding;
  }
  auto const* without = counting_cycle(*device.uncorrected, acceptance.block);
  auto const* with = counting_cycle(device.properties, device.acceptance.block);
  if (without == nullptr) {
    finding.kind = FindingKind::uncorrected_without_properties;
    finding.words.push_back({"reason", wording::reasons(device.uncorrected->refusal)});
    return finding;
  }
  auto const add = [&](std::string const& name, std::optional<double> value, std::optional<double> now) {
    if (value && now) finding.numbers.insert(finding.numbers.end(), {{name, *value}, {"now_" + name, *now}});
  };
  add("K_eff_kN_per_mm", without->K_eff_kN_per_mm, with->K_eff_kN_per_mm);
  add("energy_kN_mm", without->energy_kN_mm, with->energy_kN_mm);
  add("damping_percent", without->damping(), with->damping());
  if (!has_rules) return finding;
  auto const then = text_of(acceptance), now = text_of(device.acceptance);
  if (then == now)
    finding.words = {{"verdict_same", "yes"}};
  else
    finding.words = {{"verdict", then}, {"now_verdict", now}};
  return finding;
}

}  // namespace

void add_uncorrected(Summary& summary, std::vector<AssessedTest> tests) {
  summary.without_corrections.reset();
  auto const is_corrected = [](DeviceResult const& device) {
    return device.status == "ok" && data::is_corrected(device.raw);
  };
  if (std::ranges::none_of(summary.devices, is_corrected)) return;
  Summary without;
  without.title = summary.title;
  without.conditions_differ = summary.conditions_differ;
  without.conditions = summary.conditions;
  for (std::size_t d = 0; d < tests.size(); ++d) {
    auto const& device = summary.devices[d];
    if (device.uncorrected && device.status == "ok") tests[d].properties = &*device.uncorrected;
    auto& as_read = without.devices.emplace_back();
    as_read.name = device.name;
    as_read.status = device.status;
    as_read.message = device.message;
    as_read.properties = *tests[d].properties;
  }
  auto const& acceptance = summary.acceptance;
  std::vector<DeviceAcceptance> devices;
  without.acceptance =
      assess_lot(acceptance.rules, acceptance.design, acceptance.lot.lot_size, tests, devices, summary.asked.alike);
  if (without.conditions_differ) withhold_lot_verdicts(without.acceptance);
  std::vector<std::string> corrected;
  bool all_are_known = true;
  for (std::size_t d = 0; d < devices.size(); ++d) {
    auto& device = summary.devices[d];
    if (is_corrected(device)) {
      corrected.push_back(device.name);
      all_are_known = all_are_known && device.uncorrected;
      if (counting_cycle(device.properties, device.acceptance.block) != nullptr)
        device.raw.warnings.push_back(values_of(device, devices[d], summary.acceptance.has_rules()));
      auto const verdict = [](DeviceAcceptance const& of_device) { return device_verdict(of_device).verdict; };
      device.acceptance.as_corrected = device.uncorrected && verdict(device.acceptance) == rules::Verdict::pass &&
                                       verdict(devices[d]) != rules::Verdict::pass;
    }
    without.devices[d].acceptance = std::move(devices[d]);
  }
  auto const now = overall_verdict(summary), then = overall_verdict(without);
  if (!all_are_known || (now.word.empty() && then.word.empty())) return;
  bool const same = now.word == then.word;
  summary.without_corrections =
      Finding{.kind = same ? FindingKind::verdict_without_corrections_same : FindingKind::verdict_rests_on_corrections,
              .devices = corrected,
              .words = {{"now", now.word}, {"verdict", then.word}, {"sentence", then.sentence}}};
}

}  // namespace isolaw::study
