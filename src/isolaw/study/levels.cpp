#include "isolaw/study/levels.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/study/acceptance.hpp"

namespace isolaw::study {

std::vector<Level> levels_of(DeviceResult const& device) {
  auto const& properties = device.properties;
  auto const* reference = counting_cycle(properties, device.acceptance.block);
  auto const ratio = [](double value, double base) { return base != 0.0 ? std::optional(value / base) : std::nullopt; };
  std::vector<Level> levels;
  for (auto const& block : properties.blocks) {
    auto const* cycle = counting_cycle(properties, block.number);
    if (cycle == nullptr) continue;
    Level level{.block = block.number,
                .amplitude_mm = block.amplitude_mm,
                .frequency_Hz = block.frequency_Hz,
                .N_mean_kN = mean_load_kN(block),
                .cycle = cycle->number,
                .K_eff_kN_per_mm = cycle->K_eff_kN_per_mm,
                .damping_percent = cycle->damping_percent,
                .energy_kN_mm = cycle->energy_kN_mm,
                .K_1_kN_per_mm = cycle->K_1_kN_per_mm,
                .D_y_mm = cycle->D_y_mm,
                .F_y_kN = cycle->F_y_kN(),
                .K_d_kN_per_mm = cycle->K_d_kN_per_mm,
                .reference = block.number == device.acceptance.block};
    if (device.rubber_thickness_mm) level.strain_percent = 100.0 * block.amplitude_mm / *device.rubber_thickness_mm;
    if (reference != nullptr) {
      level.K_eff_ratio = ratio(cycle->K_eff_kN_per_mm, reference->K_eff_kN_per_mm);
      level.damping_ratio = ratio(cycle->damping_percent, reference->damping_percent);
    }
    levels.push_back(level);
  }
  return levels;
}

std::vector<data::Cycle> skeleton_of(DeviceResult const& device) {
  constexpr double same_amplitude = 0.05;
  std::vector<data::Block const*> blocks;
  for (auto const& block : device.properties.blocks)
    if (!block.counted().empty() && std::ranges::none_of(blocks, [&](auto const* other) {
          return std::abs(block.amplitude_mm - other->amplitude_mm) <= same_amplitude * other->amplitude_mm;
        }))
      blocks.push_back(&block);
  std::ranges::sort(blocks, {}, &data::Block::amplitude_mm);
  std::vector<data::Cycle> points;
  for (int const number : {1, 3})
    for (auto const* block : blocks)
      if (auto const* cycle = device.properties.find(block->number, number)) points.push_back(*cycle);
  return points;
}

Decay stiffness_decay(DeviceResult const& device, data::Cycle const& cycle) {
  if (!cycle.counts() || !cycle.damping()) return {};
  auto const over = [&](data::Cycle const& first) {
    return first.damping() ? std::optional(cycle.K_eff_kN_per_mm / first.K_eff_kN_per_mm) : std::nullopt;
  };
  auto const* const first_of_block = device.properties.find(cycle.block, 1);
  return {.in_block = first_of_block != nullptr ? over(*first_of_block) : std::nullopt,
          .in_test = over(*device.properties.counted().front())};
}

}  // namespace isolaw::study
