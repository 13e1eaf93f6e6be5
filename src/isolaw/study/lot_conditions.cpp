#include "isolaw/study/lot_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isolaw::study {
namespace {

data::Block const* counting_block(DeviceResult const& device) {
  auto const& blocks = device.properties.blocks;
  if (counting_cycle(device.properties, device.acceptance.block) == nullptr) return nullptr;
  auto const found = std::ranges::find(blocks, *device.acceptance.block, &data::Block::number);
  return found == blocks.end() ? nullptr : &*found;
}

double largest_before(data::Properties const& properties, data::Block const& block) {
  double largest = 0.0;
  for (auto const& other : properties.blocks)
    if (other.number < block.number) largest = std::max(largest, other.amplitude_mm);
  return largest;
}

}  // namespace

std::optional<Finding> conditions_differ(Summary const& summary) {
  constexpr double alike_C = 2.0, alike_percent = 10.0, alike_amplitude_percent = 5.0;
  std::vector<double> temperatures, frequencies, loads, amplitudes, earlier;
  for (auto const& device : summary.devices) {
    auto const* block = counting_block(device);
    if (block == nullptr || !device.acceptance.copy_of.empty()) continue;
    if (device.temperature_C) temperatures.push_back(*device.temperature_C);
    if (block->frequency_Hz) frequencies.push_back(*block->frequency_Hz);
    if (auto const load = mean_load_kN(*block)) loads.push_back(*load);
    amplitudes.push_back(block->amplitude_mm);
    earlier.push_back(largest_before(device.properties, *block));
  }
  Finding found{.kind = FindingKind::conditions_differ};
  auto const compare = [&](std::vector<double> const& values, std::string const& unit, double allowed) {
    if (values.size() < 2) return;
    auto const [least, largest] = std::ranges::minmax(values);
    if (largest - least <= allowed) return;
    found.numbers.push_back({"least_" + unit, least});
    found.numbers.push_back({"largest_" + unit, largest});
  };
  auto const part = [](std::vector<double> const& values, std::optional<double> tolerance_percent, double otherwise) {
    if (values.empty()) return 0.0;
    double const percent = tolerance_percent ? 2.0 * *tolerance_percent : otherwise;
    return percent / 100.0 * std::abs(std::ranges::max(values, {}, [](double v) { return std::abs(v); }));
  };
  auto const& test = summary.acceptance.rules.test;
  double const alike_mm = part(amplitudes, test.displacement_tolerance_percent, alike_amplitude_percent);
  compare(temperatures, "C", alike_C);
  compare(frequencies, "Hz", part(frequencies, test.frequency_tolerance_percent, alike_percent));
  compare(loads, "kN", part(loads, test.load_tolerance_percent, alike_percent));
  compare(amplitudes, "mm", alike_mm);
  compare(earlier, "earlier_mm", alike_mm);
  return found.numbers.empty() ? std::nullopt : std::optional(std::move(found));
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
