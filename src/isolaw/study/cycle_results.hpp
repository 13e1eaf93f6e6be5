// The rows that inspection.json, the page and cycles.csv take from the properties of cycles and blocks and from the
// error budget. A test compares docs/inspection-json.md with them.
#pragma once

#include "isolaw/study/levels.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

// A cycle, and the device whose rubber thickness turns its amplitude into a shear strain.
struct CycleOf {
  data::Cycle const& cycle;
  DeviceResult const& device;
};

template <auto member>
Value of_cycle(CycleOf const& row) {
  return get<member>(row.cycle);
}

inline constexpr Result<CycleOf> cycle_results[]{
    {"number", "", "cycle", "number among the counted cycles of the block, from 1; 0 where it does not count",
     of_cycle<&data::Cycle::number>},
    {"counts", "", "counts", "the cycle counts", of_cycle<&data::Cycle::counts>},
    {"partial", "", "", "less than a whole cycle: cut by the record's start or end, a pre-load, half a cycle",
     of_cycle<&data::Cycle::partial>},
    {"half", "", "half cycle",
     "a swing that belongs to no full cycle, counted as asked for (`half-cycles`): its energy is twice that of the swing, its period twice its time",
     of_cycle<&data::Cycle::half>},
    {"reason", "", "why not", "why it does not count; empty otherwise", of_cycle<&data::Cycle::not_counted>},
    {"first", "", "first sample", "where it starts, as a sample number from 0; cuts lie between samples",
     of_cycle<&data::Cycle::first>},
    {"last", "", "last sample", "where it ends, likewise", of_cycle<&data::Cycle::last>},
    {"amplitude_mm", "mm", "amplitude", "D, half the range", of_cycle<&data::Cycle::amplitude_mm>, decimals(1)},
    {"d_plus_mm", "mm", "d+", "largest displacement", of_cycle<&data::Cycle::d_plus_mm>, decimals(1)},
    {"d_minus_mm", "mm", "d-", "smallest displacement", of_cycle<&data::Cycle::d_minus_mm>, decimals(1)},
    {"F_plus_kN", "kN", "F+", "force at d+", of_cycle<&data::Cycle::F_plus_kN>, decimals(1)},
    {"F_minus_kN", "kN", "F-", "force at d-", of_cycle<&data::Cycle::F_minus_kN>, decimals(1)},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "effective, peak to peak", of_cycle<&data::Cycle::K_eff_kN_per_mm>,
     significant(4)},
    {"K_plus_kN_per_mm", "kN/mm", "K+", "on the positive side", of_cycle<&data::Cycle::K_plus>, significant(4)},
    {"K_minus_kN_per_mm", "kN/mm", "K-", "on the negative side", of_cycle<&data::Cycle::K_minus>, significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "energy of the closed loop", of_cycle<&data::Cycle::energy_kN_mm>, decimals(0)},
    {"damping_percent", "%", "damping", "equivalent viscous damping; null where hardly any force is stiffness",
     of_cycle<&data::Cycle::damping>, decimals(2)},
    {"Q_d_kN", "kN", "Q_d", "characteristic strength", of_cycle<&data::Cycle::Q_d_kN>, decimals(1)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yielding", of_cycle<&data::Cycle::K_d_kN_per_mm>,
     significant(3)},
    {"D_y_mm", "mm", "D_y", "yield displacement of the bilinear loop of the same energy",
     of_cycle<&data::Cycle::D_y_mm>, decimals(2)},
    {"K_1_kN_per_mm", "kN/mm", "K_1", "its first stiffness", of_cycle<&data::Cycle::K_1_kN_per_mm>, significant(3)},
    {"F_y_kN", "kN", "F_y", "its force at D_y", of_cycle<&data::Cycle::F_y_kN>, decimals(1)},
    {"residual_plus_mm", "mm", "residual +", "displacement where the force comes to zero after d+",
     of_cycle<&data::Cycle::residual_plus_mm>, decimals(1)},
    {"residual_minus_mm", "mm", "residual -", "displacement where the force comes to zero after d-",
     of_cycle<&data::Cycle::residual_minus_mm>, decimals(1)},
    {"work_kN_mm", "kN mm", "energy so far", "work of the force from the first sample to the end of the cycle",
     of_cycle<&data::Cycle::work_kN_mm>, decimals(0)},
    {"K_eff_in_block", "-", "K_eff to first of block", "K_eff over that of the first counted cycle of the block",
     [](CycleOf const& row) { return study::value_of(stiffness_decay(row.device, row.cycle).in_block); }, decimals(3)},
    {"K_eff_in_test", "-", "K_eff to first", "K_eff over that of the first counted cycle of the record",
     [](CycleOf const& row) { return study::value_of(stiffness_decay(row.device, row.cycle).in_test); }, decimals(3)},
    {"period_s", "s", "period", "from cut to cut without rests and holds", of_cycle<&data::Cycle::period_s>,
     significant(3)},
    {"v_max_mm_s", "mm/s", "v max", "largest velocity", of_cycle<&data::Cycle::v_max_mm_s>, significant(3)},
    {"N_mean_kN", "kN", "N mean", "vertical load, mean", of_cycle<&data::Cycle::N_mean_kN>, decimals(0)},
    {"N_min_kN", "kN", "N min", "vertical load, least", of_cycle<&data::Cycle::N_min_kN>, decimals(0)},
    {"N_max_kN", "kN", "N max", "vertical load, largest", of_cycle<&data::Cycle::N_max_kN>, decimals(0)},
    {"closure_mm", "mm", "closure", "displacement at the end less that at the start, before the loop is closed",
     of_cycle<&data::Cycle::closure_mm>, significant(2)},
    {"closure_kN", "kN", "closure", "the same for the force", of_cycle<&data::Cycle::closure_kN>, significant(2)},
    {"strain_percent", "%", "strain", "shear strain",
     [](CycleOf const& row) {
       auto const& thickness = row.device.rubber_thickness_mm;
       return thickness ? Value(data::strains(row.cycle, *thickness, 1.0).shear_strain_percent) : Value();
     },
     decimals(0)},
    {"G_MPa", "MPa", "G", "shear modulus",
     [](CycleOf const& row) {
       auto const &thickness = row.device.rubber_thickness_mm, &area = row.device.rubber_area_mm2;
       return thickness && area ? Value(data::strains(row.cycle, *thickness, *area).G_MPa) : Value();
     },
     significant(3)},
};

inline constexpr Result<data::Block> block_results[]{
    {"number", "", "block", "number of the block, from 1", get<&data::Block::number>},
    {"amplitude_mm", "mm", "amplitude", "median over the counted cycles", get<&data::Block::amplitude_mm>, decimals(1)},
    {"frequency_Hz", "Hz", "frequency", "one over the median period of the cycles that count",
     get<&data::Block::frequency_Hz>, significant(2)},
    {"waveform", "", "waveform", "of the middle cycle; empty without time", get<&data::Block::waveform>},
    {"v_max_mm_s", "mm/s", "v max", "median over the counted cycles", get<&data::Block::v_max_mm_s>, significant(3)},
    {"cycles", "", "", "all cycles in order, also those that do not count", nested<data::Block>},
    {"stability", "", "", "`K_eff`, `energy`, `damping`: how each changes over the counted cycles",
     nested<data::Block>},
};

inline constexpr Result<data::Stability> stability_results[]{
    {"ratio_to_third", "", "", "value in each counted cycle over that in cycle 3", nested<data::Stability>},
    {"min_2_10", "-", "least of cycles 2-10", "least of these ratios over cycles 2 to 10, or as many as there are",
     get<&data::Stability::min_2_10>},
    {"max_2_10", "-", "largest of cycles 2-10", "largest over these cycles", get<&data::Stability::max_2_10>},
    {"min_1_10", "-", "least of cycles 1-10", "least over cycles 1 to 10", get<&data::Stability::min_1_10>},
    {"max_1_10", "-", "largest of cycles 1-10", "largest over these cycles", get<&data::Stability::max_1_10>},
    {"least_to_largest_2_10", "-", "least to largest of cycles 2-10", "smallest over largest value of cycles 2 to 10",
     get<&data::Stability::least_to_largest_2_10>},
    {"least_to_largest_1_10", "-", "least to largest of cycles 1-10", "the same for cycles 1 to 10",
     get<&data::Stability::least_to_largest_1_10>},
    {"first_to_third", "-", "first to third", "scragging ratio", get<&data::Stability::first_to_third>, decimals(2)},
    {"first_to_mean_1_3", "-", "first to mean of cycles 1-3", "first cycle over the mean of the first three",
     get<&data::Stability::first_to_mean_1_3>},
};

inline constexpr Result<Level> level_results[]{
    {"block", "", "block", "block of the record", get<&Level::block>},
    {"amplitude_mm", "mm", "amplitude", "amplitude of the block", get<&Level::amplitude_mm>, decimals(1)},
    {"strain_percent", "%", "strain", "shear strain", get<&Level::strain_percent>, decimals(0)},
    {"frequency_Hz", "Hz", "frequency", "frequency of the block", get<&Level::frequency_Hz>, significant(2)},
    {"N_mean_kN", "kN", "N mean", "vertical load, mean over the counted cycles", get<&Level::N_mean_kN>, decimals(0)},
    {"cycle", "", "cycle", "cycle that has these values: the third that counts, or the last", get<&Level::cycle>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "in that cycle", get<&Level::K_eff_kN_per_mm>, significant(4)},
    {"damping_percent", "%", "damping", "in that cycle", get<&Level::damping_percent>, decimals(2)},
    {"energy_kN_mm", "kN mm", "energy", "in that cycle", get<&Level::energy_kN_mm>, decimals(0)},
    {"K_1_kN_per_mm", "kN/mm", "K_1", "of the bilinear loop of the same energy, before it yields",
     get<&Level::K_1_kN_per_mm>, significant(3)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "of that loop, after it yields", get<&Level::K_d_kN_per_mm>, significant(3)},
    {"D_y_mm", "mm", "D_y", "displacement at which that loop yields", get<&Level::D_y_mm>, decimals(2)},
    {"F_y_kN", "kN", "F_y", "force at which it yields", get<&Level::F_y_kN>, decimals(1)},
    {"K_eff_ratio", "-", "K_eff to the reference", "K_eff over that of the counting block", get<&Level::K_eff_ratio>,
     decimals(3)},
    {"damping_ratio", "-", "damping to the reference", "the same for damping", get<&Level::damping_ratio>, decimals(3)},
    {"reference", "", "reference", "this is the counting block itself", get<&Level::reference>},
};

inline constexpr Result<data::Cycle> skeleton_results[]{
    {"block", "", "block", "block of the record", get<&data::Cycle::block>},
    {"cycle", "", "cycle", "1 or 3: the counted cycle whose peaks these are", get<&data::Cycle::number>},
    {"d_plus_mm", "mm", "d+", "largest displacement", get<&data::Cycle::d_plus_mm>, decimals(1)},
    {"F_plus_kN", "kN", "F+", "force at d+", get<&data::Cycle::F_plus_kN>, decimals(1)},
    {"d_minus_mm", "mm", "d-", "smallest displacement", get<&data::Cycle::d_minus_mm>, decimals(1)},
    {"F_minus_kN", "kN", "F-", "force at d-", get<&data::Cycle::F_minus_kN>, decimals(1)},
};

template <auto... members>
Value of_vertical(DeviceResult const& device) {
  return device.vertical ? get<members...>(*device.vertical) : Value();
}

inline constexpr Result<DeviceResult> vertical_results[]{
    {"K_v_kN_per_mm", "kN/mm", "K_v", "vertical stiffness", of_vertical<&data::VerticalStiffness::K_v_kN_per_mm>,
     significant(4)},
    {"how", "", "how", "between which loads of which loading K_v is taken, or that the laboratory states it",
     of_vertical<&data::VerticalStiffness::how>},
    {"low_kN", "kN", "from load", "vertical load where the secant begins, compression positive",
     [](DeviceResult const& device) {
       return device.vertical && device.vertical->loads ? Value(device.vertical->loads->low_kN) : Value();
     },
     significant(4)},
    {"high_kN", "kN", "to load", "vertical load where it ends",
     [](DeviceResult const& device) {
       return device.vertical && device.vertical->loads ? Value(device.vertical->loads->high_kN) : Value();
     },
     significant(4)},
    {"disp_low_mm", "mm", "from displacement", "vertical displacement at `low_kN`",
     of_vertical<&data::VerticalStiffness::disp_low_mm>, decimals(3)},
    {"disp_high_mm", "mm", "to displacement", "and at `high_kN`", of_vertical<&data::VerticalStiffness::disp_high_mm>,
     decimals(3)},
    {"loading", "", "loading", "which loading counts, from 1", of_vertical<&data::VerticalStiffness::loading>},
    {"loadings_kN_per_mm", "", "", "the stiffness in kN/mm of every loading that reaches the largest load",
     nested<DeviceResult>},
    {"file", "", "file", "record of the vertical test; empty where the laboratory only states the stiffness",
     get<&DeviceResult::vertical_test, &data::VerticalTest::file>},
    {"sha256", "", "sha256", "hash of that file", get<&DeviceResult::vertical_test, &data::VerticalTest::sha256>},
    {"recognised", "", "", "one sentence for each decision in reading", nested<DeviceResult>},
    {"refusal", "", "no stiffness", "why the test gives no stiffness; empty otherwise",
     get<&DeviceResult::vertical_test, &data::VerticalTest::refusal>},
};

inline constexpr Result<data::Effect> effect_results[]{
    {"effect", "", "effect", "what was assessed: `\"skew\"`", get<&data::Effect::effect>},
    {"value", own_unit, "value", "how large it is", get<&data::Effect::value>},
    {"unit", "", "unit", "unit of `value` and `limit`", get<&data::Effect::unit>},
    {"limit", own_unit, "limit", "the limit it should keep", get<&data::Effect::limit>},
    {"exceeds", "", "exceeds", "it exceeds its limit; a warning says so", get<&data::Effect::exceeds>},
};

// A property that is followed from cycle to cycle of a block, with its short name. `key` is its row in cycle_results.
struct FollowedProperty {
  std::string_view name, key;
  double data::Cycle::*value;
};
inline constexpr FollowedProperty followed_properties[]{{"K_eff", "K_eff_kN_per_mm", &data::Cycle::K_eff_kN_per_mm},
                                                        {"energy", "energy_kN_mm", &data::Cycle::energy_kN_mm},
                                                        {"damping", "damping_percent", &data::Cycle::damping_percent}};

}  // namespace isolaw::study
