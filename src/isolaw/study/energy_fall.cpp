#include "isolaw/study/energy_fall.hpp"

#include <cstddef>

namespace isolaw::study {

std::optional<EnergyFall> energy_fall(data::Properties const& measured, data::FitRecord const& record,
                                      std::vector<double> const& force_kN) {
  constexpr std::size_t least_cycles = 8, from = 2;
  constexpr double least_percent = 10.0, least_late = 0.25;
  std::optional<EnergyFall> worst;
  if (force_kN.size() != record.size() || !measured.refusal.empty()) return worst;
  for (auto const& block : measured.blocks) {
    auto const counted = block.counted();
    if (counted.size() < least_cycles) continue;
    auto const &first = *counted[from], &middle = *counted[(from + counted.size()) / 2], &last = *counted.back();
    double const lost = first.energy_kN_mm - last.energy_kN_mm;
    double const percent = 100.0 * lost / first.energy_kN_mm;
    bool const steady = middle.energy_kN_mm - last.energy_kN_mm >= least_late * lost &&
                        first.energy_kN_mm - middle.energy_kN_mm >= least_late * lost;
    if (!(percent >= least_percent) || !steady || (worst && worst->measured_percent >= percent)) continue;
    auto const of_law = [&](data::Cycle const& cycle) {
      return data::properties_on(cycle, record.disp_mm, force_kN).energy_kN_mm;
    };
    double const start = of_law(first);
    worst = EnergyFall{.block = block.number,
                       .first_cycle = first.number,
                       .last_cycle = last.number,
                       .measured_percent = percent,
                       .percent = start > 0.0 ? 100.0 * (1.0 - of_law(last) / start) : 0.0};
  }
  return worst;
}

bool follows(EnergyFall const& fall) {
  return fall.percent >= fall.measured_percent / 2.0;
}

}  // namespace isolaw::study
