#include "isolaw/study/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isolaw/base/words.hpp"
#include "isolaw/study/lot_conditions.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

rules::BlockValues values_of(data::Block const& block, AssessedTest const& test) {
  rules::BlockValues values{.number = block.number,
                            .amplitude_mm = block.amplitude_mm,
                            .frequency_Hz = block.frequency_Hz,
                            .load_mean_kN = mean_load_kN(block),
                            .sweep_Hz = block.sweep_Hz,
                            .vertical = test.vertical};
  if (test.rubber_thickness_mm) values.shear_strain_percent = 100.0 * block.amplitude_mm / *test.rubber_thickness_mm;
  for (auto const* cycle : block.counted()) values.cycles.push_back(*cycle);
  return values;
}

std::optional<double> mean_load(std::vector<data::Cycle const*> const& cycles) {
  double sum = 0.0;
  int count = 0;
  for (auto const* cycle : cycles)
    if (cycle->N_mean_kN) sum += *cycle->N_mean_kN, ++count;
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

data::Block const* find_block(data::Properties const& properties, std::optional<int> number) {
  auto const found = std::ranges::find_if(properties.blocks, [&](auto const& block) { return block.number == number; });
  return found == properties.blocks.end() ? nullptr : &*found;
}

std::optional<rules::LoadPair> load_pair(AssessedTest const& test, data::Block const& counted) {
  constexpr double same_amplitude = 0.05, other_load = 0.10;
  data::Block const *largest = nullptr, *smallest = nullptr;
  for (auto const& block : test.properties->blocks) {
    auto const load = mean_load_kN(block);
    if (!load || std::abs(block.amplitude_mm / counted.amplitude_mm - 1.0) > same_amplitude) continue;
    if (largest == nullptr || *load > *mean_load_kN(*largest)) largest = &block;
    if (smallest == nullptr || *load < *mean_load_kN(*smallest)) smallest = &block;
  }
  if (largest == nullptr || *mean_load_kN(*largest) <= (1.0 + other_load) * *mean_load_kN(*smallest))
    return std::nullopt;
  return rules::LoadPair{.largest = values_of(*largest, test), .smallest = values_of(*smallest, test)};
}

// A faulty block may have a larger amplitude than the chosen one. If it were sound, the verdict would rest on it.
// Therefore the largest such block is chosen instead.
void choose_faulty(data::Properties const& properties, DeviceAcceptance& chosen) {
  for (auto const& block : properties.blocks)
    if (!block.fault.empty() &&
        block.amplitude_mm > (1.0 + data::same_nominal) * find_block(properties, chosen.block)->amplitude_mm)
      chosen.block = block.number;
}

// Chooses the block of a record that is assessed. With a rule set this may be a faulty block. The device then cannot
// pass (why_withheld()).
DeviceAcceptance choose_block(data::Properties const& properties, rules::Design const& design, bool has_rules) {
  DeviceAcceptance chosen;
  if (!properties.reported) {
    chosen.choice = wording::reasons(properties.refusal);
    return chosen;
  }
  chosen.block = properties.reported->block;
  if (properties.blocks.size() == 1) {
    chosen.choice = "the only block";
    return chosen;
  }
  chosen.choice = "the block of the largest amplitude; a design displacement would choose another (--design disp=...)";
  if (!design.disp_mm) {
    if (has_rules) choose_faulty(properties, chosen);
    return chosen;
  }
  data::Block const* nearest = nullptr;
  auto const off = [&](data::Block const& block) { return std::abs(block.amplitude_mm - *design.disp_mm); };
  auto const load_off = [&](data::Block const& block) {
    auto const load = mean_load(block.whole());
    if (!design.load_kN) return 0.0;
    return load ? std::abs(*load - *design.load_kN) : std::numeric_limits<double>::infinity();
  };
  for (auto const& block : properties.blocks) {
    if (block.counted().empty() && (block.fault.empty() || !has_rules)) continue;
    double const farther = nearest == nullptr ? 0.0 : off(block) - off(*nearest);
    bool const same = nearest != nullptr && std::abs(farther) <= data::same_nominal * *design.disp_mm &&
                      load_off(block) != load_off(*nearest);
    if (nearest == nullptr || (same ? load_off(block) < load_off(*nearest) : farther < 0.0)) nearest = &block;
  }
  chosen.block = nearest->number;
  chosen.choice = fmt::format("the block nearest to the design displacement of {:g} mm", *design.disp_mm);
  return chosen;
}

std::string why_withheld(data::Properties const& properties, data::Block const& block) {
  if (!block.fault.empty()) return fmt::format("block {} is faulty: {}", block.number, block.fault);
  auto const& failure = properties.failure;
  if (!failure) return {};
  return fmt::format("{} has lost {:.0f} % of the force", failure->word("where"), 100.0 - failure->number("percent"));
}

// Replaces every pass by "not assessed" with `reason`, except on K_v, which comes from another test. A missing value
// gets this reason too. A fail stays, since the fault of the test may be its cause: a loss of force may exceed a limit
// on the change from cycle to cycle.
void withhold_passes(std::vector<rules::Assessment>& assessments, std::string const& reason) {
  for (auto& a : assessments) {
    bool const without = a.verdict == rules::Verdict::not_assessed && !a.value && a.subject != rules::Subject::loads;
    if (a.property == rules::Quantity::K_v || !(a.verdict == rules::Verdict::pass || without)) continue;
    a.verdict = rules::Verdict::not_assessed;
    a.reason = reason;
  }
}

}  // namespace

std::optional<double> mean_load_kN(data::Block const& block) {
  return mean_load(block.counted());
}

bool any_failed(std::vector<rules::Assessment> const& assessments) {
  return std::ranges::any_of(assessments, [](auto const& a) { return a.verdict == rules::Verdict::fail; });
}

bool lot_failed(LotAcceptance const& acceptance) {
  auto const& lot = acceptance.lot;
  return lot.sample.verdict == rules::Verdict::fail ||
         std::ranges::any_of(lot.quantities, [](auto const& quantity) { return any_failed(quantity.mean_limits); });
}

std::vector<DesignValue> design_values(rules::Design const& design) {
  std::vector<DesignValue> values;
  for (auto const& [name, unit, member] : rules::design_names)
    if (auto const value = design.*member) values.push_back({std::string(name), *value, std::string(unit)});
  return values;
}

MeanAnalysis mean_analysis(LotAcceptance const& acceptance) {
  MeanAnalysis result;
  std::vector<std::string> parts;
  std::string open;
  for (auto const& quantity : acceptance.lot.quantities) {
    if (!quantity.largest_from_mean_percent || quantity.quantity == rules::Quantity::K_v) continue;
    parts.push_back(fmt::format("{} {:.1f} %", rules::name(quantity.quantity), *quantity.largest_from_mean_percent));
    if (quantity.mean_analysis_permitted)
      result.permitted = result.permitted.value_or(true) && *quantity.mean_analysis_permitted;
    if (open.empty()) open = quantity.mean_analysis_open;
  }
  if (parts.empty() && !acceptance.conditions_forbid_mean) return result;
  if (!open.empty() && result.permitted.value_or(true)) result.permitted.reset();
  bool const only_conditions_forbid = acceptance.conditions_forbid_mean && result.permitted.value_or(true);
  if (acceptance.conditions_forbid_mean) result.permitted = false;
  if (!parts.empty()) result.sentence = "Largest deviation of a device from the lot's mean: " + joined(parts) + ".";
  if (!result.permitted && open.empty()) return result;
  if (!parts.empty()) result.sentence += ' ';
  if (result.permitted)
    result.sentence +=
        *result.permitted
            ? "As far as the variability within the supply goes, an analysis with mean properties is permitted; ageing, temperature and the other effects add to it."
        : only_conditions_forbid
            ? "An analysis with mean properties alone is not permitted, because the properties change too much over the design conditions: upper and lower bounds are needed."
            : "An analysis with mean properties alone is not permitted: upper and lower bounds are needed.";
  else
    result.sentence += "Whether an analysis with mean properties is permitted cannot be said: " + open + ".";
  return result;
}

data::Cycle const* counting_cycle(data::Properties const& properties, std::optional<int> block) {
  auto const* found = find_block(properties, block);
  if (found == nullptr) return nullptr;
  auto const counted = found->counted();
  return counted.empty() ? nullptr : counted[std::min<std::size_t>(counted.size(), 3) - 1];
}

LotAcceptance assess_lot(rules::RuleSet const& rules, rules::Design const& design, std::optional<int> lot_size,
                         std::vector<AssessedTest> const& tests, std::vector<DeviceAcceptance>& devices,
                         campaign::Alike const& alike) {
  LotAcceptance result{.rules = rules, .design = design, .lot = {}};
  devices.clear();
  std::vector<rules::DeviceValues> measured;
  for (auto const& test : tests) {
    auto device = choose_block(*test.properties, design, result.has_rules());
    device.copy_of = test.copy_of;
    if (auto const* block = find_block(*test.properties, device.block)) {
      auto const values = values_of(*block, test);
      if (result.has_rules()) device.assessments = rules::assess(rules, values, design, load_pair(test, *block));
      if (!test.copy_of.empty()) rules::withhold_verdicts(device.assessments, rules::same_record_as(test.copy_of));
      device.withheld = why_withheld(*test.properties, *block);
      if (!device.withheld.empty()) withhold_passes(device.assessments, device.withheld);
      if (!values.cycles.empty()) measured.push_back({.name = test.device, .block = values, .copy_of = test.copy_of});
    }
    devices.push_back(std::move(device));
  }
  std::vector<double> amplitudes;
  for (auto const& one : measured) amplitudes.push_back(one.block.amplitude_mm);
  auto const usual = usual_amplitude(std::move(amplitudes), rules, alike);
  for (auto& one : measured) one.at_usual_amplitude = usual.has(one.block.amplitude_mm);
  result.lot = rules::lot_view(rules, measured, design, lot_size);
  return result;
}

}  // namespace isolaw::study
