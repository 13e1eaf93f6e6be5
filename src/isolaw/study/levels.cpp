#include "isolaw/study/levels.hpp"

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

}  // namespace isolaw::study
