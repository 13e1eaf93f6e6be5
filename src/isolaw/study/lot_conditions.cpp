#include "isolaw/study/lot_conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/words.hpp"

namespace isolaw::study {
namespace {

data::Block const* counting_block(DeviceResult const& device) {
  auto const& blocks = device.properties.blocks;
  if (counting_cycle(device.properties, device.acceptance.block) == nullptr) return nullptr;
  auto const found = std::ranges::find(blocks, *device.acceptance.block, &data::Block::number);
  return found == blocks.end() ? nullptr : &*found;
}

// The motion before the counted cycles of a block. Larger cycles and more cycles make rubber softer.
struct Earlier {
  double largest_mm = 0.0;  // the largest amplitude
  double cycles = 0.0;      // number of whole cycles at least as large as the block, within the tolerance
};

Earlier before(data::Properties const& properties, data::Block const& block, double tolerance_percent) {
  Earlier earlier;
  double const least_mm = (1.0 - tolerance_percent / 100.0) * block.amplitude_mm;
  double const first = block.counted().front()->first;
  for (auto const& other : properties.blocks) {
    if (other.number < block.number) earlier.largest_mm = std::max(earlier.largest_mm, other.amplitude_mm);
    for (auto const& cycle : other.cycles)
      if (!cycle.partial && cycle.first < first && cycle.amplitude_mm >= least_mm) ++earlier.cycles;
  }
  return earlier;
}

struct Tolerance {
  double value = 0.0;
  std::string source;
};

std::string set_text(rules::RuleSet const& rules, std::string const& clause) {
  return clause.empty() ? "the rule set " + rules.id : fmt::format("the rule set {}, {}", rules.id, clause);
}

// Returns the first tolerance that is known, in the order of the list above conditions_differ() in the header.
Tolerance tolerance(rules::RuleSet const& rules, std::optional<double> own, std::optional<double> from_design,
                    std::optional<double> lot, double otherwise) {
  if (own) return {*own, set_text(rules, rules.same_condition.clause)};
  if (from_design) return {2.0 * *from_design, "twice that of " + set_text(rules, rules.test.clause)};
  if (lot) return {*lot, "as stated for this lot"};
  return {otherwise, "isolaw's own"};
}

Tolerance amplitude_tolerance(rules::RuleSet const& rules, campaign::Alike const& alike) {
  return tolerance(rules, rules.same_condition.amplitude_percent, rules.test.displacement_tolerance_percent,
                   alike.amplitude_percent, alike.own_amplitude_percent);
}

}  // namespace

std::optional<Finding> conditions_differ(Summary const& summary) {
  auto const amplitude = amplitude_tolerance(summary.acceptance.rules, summary.asked.alike);
  std::vector<double> temperatures, frequencies, loads, amplitudes, earlier, earlier_cycles;
  for (auto const& device : summary.devices) {
    auto const* block = counting_block(device);
    if (block == nullptr || !device.counts()) continue;
    if (device.temperature_C) temperatures.push_back(*device.temperature_C);
    if (block->frequency_Hz) frequencies.push_back(*block->frequency_Hz);
    if (auto const load = mean_load_kN(*block)) loads.push_back(*load);
    amplitudes.push_back(block->amplitude_mm);
    auto const history = before(device.properties, *block, amplitude.value);
    earlier.push_back(history.largest_mm);
    earlier_cycles.push_back(history.cycles);
  }
  Finding found{.kind = FindingKind::conditions_differ};
  std::vector<std::string> sources;
  auto const compare = [&](std::vector<double> const& values, std::string const& unit, Tolerance const& tolerance,
                           bool in_percent = true) {
    if (values.size() < 2) return;
    auto const [least, largest] = std::ranges::minmax(values);
    double const allowed =
        in_percent ? tolerance.value / 100.0 * std::max(std::abs(least), std::abs(largest)) : tolerance.value;
    if (largest - least <= allowed) return;
    found.numbers.insert(found.numbers.end(),
                         {{"least_" + unit, least}, {"largest_" + unit, largest}, {"allowed_" + unit, allowed}});
    if (std::ranges::find(sources, tolerance.source) == sources.end()) sources.push_back(tolerance.source);
  };
  auto const& rules = summary.acceptance.rules;
  auto const& test = rules.test;
  auto const& same = rules.same_condition;
  auto const& alike = summary.asked.alike;
  compare(temperatures, "C", tolerance(rules, same.temperature_C, {}, alike.temperature_C, alike.own_temperature_C),
          false);
  compare(frequencies, "Hz",
          tolerance(rules, same.frequency_percent, test.frequency_tolerance_percent, alike.frequency_percent,
                    alike.own_frequency_percent));
  compare(loads, "kN",
          tolerance(rules, same.load_percent, test.load_tolerance_percent, alike.load_percent, alike.own_load_percent));
  compare(amplitudes, "mm", amplitude);
  compare(earlier, "earlier_mm", amplitude);
  compare(earlier_cycles, "earlier_cycles",
          tolerance(rules, same.earlier_cycles, {}, alike.earlier_cycles, alike.own_earlier_cycles), false);
  if (found.numbers.empty()) return std::nullopt;
  found.words = {{"tolerances", joined(sources, "; ")}};
  return found;
}

bool UsualAmplitude::has(double amplitude_mm) const {
  return std::abs(amplitude_mm - mm) <= allowed_percent / 100.0 * std::max(amplitude_mm, mm);
}

UsualAmplitude usual_amplitude(std::vector<double> amplitudes_mm, rules::RuleSet const& rules,
                               campaign::Alike const& alike) {
  UsualAmplitude usual{.allowed_percent = amplitude_tolerance(rules, alike).value};
  if (amplitudes_mm.empty()) return usual;
  auto const middle = amplitudes_mm.begin() + static_cast<std::ptrdiff_t>((amplitudes_mm.size() - 1) / 2);
  std::ranges::nth_element(amplitudes_mm, middle);
  usual.mm = *middle;
  return usual;
}

void withhold_lot_verdicts(LotAcceptance& acceptance) {
  auto const withhold = [](rules::Assessment& assessment) {
    if (assessment.verdict != rules::Verdict::pass && assessment.verdict != rules::Verdict::fail) return;
    assessment.verdict = rules::Verdict::not_assessed;
    assessment.reason = "the devices were tested under different conditions";
  };
  withhold(acceptance.lot.sample);
  for (auto& quantity : acceptance.lot.quantities)
    for (auto& limit : quantity.mean_limits) withhold(limit);
}

}  // namespace isolaw::study
