// The properties of a cycle as results: inspection.json, the data of the page and tables/cycles.csv are written from
// these rows; docs/inspection-json.md is checked against them.
#pragma once

#include "isolaw/study/results.hpp"

namespace isolaw::study {

// A cycle and the device whose rubber gives its strain.
struct CycleOf {
  data::Cycle const& cycle;
  DeviceResult const& device;
};

template <auto member>
Value of_cycle(CycleOf const& of) {
  return get<member>(of.cycle);
}

inline constexpr Result<CycleOf> cycle_results[]{
    {"number", "", "cycle", "among the counted cycles of the block, from 1; 0 for one that does not count",
     of_cycle<&data::Cycle::number>},
    {"counts", "", "counts", "it counts", of_cycle<&data::Cycle::counts>},
    {"partial", "", "", "less than a cycle: the record starts or ends within it, a pre-load, half a cycle",
     of_cycle<&data::Cycle::partial>},
    {"reason", "", "why not", "why it does not count; empty otherwise", of_cycle<&data::Cycle::not_counted>},
    {"first", "", "first sample", "where it starts, as a sample number from 0; cuts lie between samples",
     of_cycle<&data::Cycle::first>},
    {"last", "", "last sample", "where it ends, the same", of_cycle<&data::Cycle::last>},
    {"amplitude_mm", "mm", "amplitude", "D", of_cycle<&data::Cycle::amplitude_mm>},
    {"d_plus_mm", "mm", "d+", "largest displacement", of_cycle<&data::Cycle::d_plus_mm>},
    {"d_minus_mm", "mm", "d-", "smallest displacement", of_cycle<&data::Cycle::d_minus_mm>},
    {"F_plus_kN", "kN", "F+", "force at d+", of_cycle<&data::Cycle::F_plus_kN>},
    {"F_minus_kN", "kN", "F-", "force at d-", of_cycle<&data::Cycle::F_minus_kN>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "peak to peak", of_cycle<&data::Cycle::K_eff_kN_per_mm>},
    {"K_plus_kN_per_mm", "kN/mm", "K+", "of the positive side", of_cycle<&data::Cycle::K_plus>},
    {"K_minus_kN_per_mm", "kN/mm", "K-", "of the negative side", of_cycle<&data::Cycle::K_minus>},
    {"energy_kN_mm", "kN mm", "energy", "of the closed loop", of_cycle<&data::Cycle::energy_kN_mm>},
    {"damping_percent", "%", "damping", "equivalent viscous damping", of_cycle<&data::Cycle::damping_percent>},
    {"Q_d_kN", "kN", "Q_d", "characteristic strength", of_cycle<&data::Cycle::Q_d_kN>},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yielding", of_cycle<&data::Cycle::K_d_kN_per_mm>},
    {"D_y_mm", "mm", "D_y", "yield displacement of the bilinear loop of the same energy",
     of_cycle<&data::Cycle::D_y_mm>},
    {"K_1_kN_per_mm", "kN/mm", "K_1", "its first stiffness", of_cycle<&data::Cycle::K_1_kN_per_mm>},
    {"period_s", "s", "period", "from cut to cut without rests and holds", of_cycle<&data::Cycle::period_s>},
    {"v_max_mm_s", "mm/s", "v max", "largest velocity", of_cycle<&data::Cycle::v_max_mm_s>},
    {"N_mean_kN", "kN", "N mean", "vertical load, mean", of_cycle<&data::Cycle::N_mean_kN>},
    {"N_min_kN", "kN", "N min", "vertical load, least", of_cycle<&data::Cycle::N_min_kN>},
    {"N_max_kN", "kN", "N max", "vertical load, largest", of_cycle<&data::Cycle::N_max_kN>},
    {"closure_mm", "mm", "closure", "displacement at the end less that at the start, before the loop is closed",
     of_cycle<&data::Cycle::closure_mm>},
    {"closure_kN", "kN", "closure", "the same of the force", of_cycle<&data::Cycle::closure_kN>},
    {"strain_percent", "%", "strain", "shear strain",
     [](CycleOf const& of) {
       auto const& thickness = of.device.rubber_thickness_mm;
       return thickness ? Value(data::strains(of.cycle, *thickness, 1.0).shear_strain_percent) : Value();
     }},
    {"G_MPa", "MPa", "G", "shear modulus",
     [](CycleOf const& of) {
       auto const &thickness = of.device.rubber_thickness_mm, &area = of.device.rubber_area_mm2;
       return thickness && area ? Value(data::strains(of.cycle, *thickness, *area).G_MPa) : Value();
     }},
};

// The properties that are followed from cycle to cycle of a block, by their short names.
struct FollowedProperty {
  std::string_view name;
  double data::Cycle::*of;
};
inline constexpr FollowedProperty followed_properties[]{{"K_eff", &data::Cycle::K_eff_kN_per_mm},
                                                        {"energy", &data::Cycle::energy_kN_mm},
                                                        {"damping", &data::Cycle::damping_percent}};

}  // namespace isolaw::study
