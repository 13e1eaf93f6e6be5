// The rows (results.hpp) from which inspection.json, the page and cycles.csv print the properties of cycles and blocks
// and the error budget. A test compares docs/inspection-json.md with these rows.
#pragma once

#include "isolaw/study/levels.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

// A cycle and its device, whose rubber thickness turns the cycle's amplitude into a shear strain.
struct CycleOf {
  data::Cycle const& cycle;
  DeviceResult const& device;
};

template <auto member>
Value of_cycle(CycleOf const& row) {
  return get<member>(row.cycle);
}

inline constexpr Result<CycleOf> cycle_results[]{
    {"number", "", "cycle", "number of the cycle among the counted cycles of its block, from 1; 0 if it does not count",
     of_cycle<&data::Cycle::number>},
    {"counts", "", "counts", "true: the cycle counts", of_cycle<&data::Cycle::counts>},
    {"partial", "", "",
     "true: the cycle is not whole. It is cut off by the start or end of the record, or it is a pre-load or half a cycle",
     of_cycle<&data::Cycle::partial>},
    {"half", "", "half cycle",
     "true: the cycle is a swing that belongs to no full cycle and counts because you asked for it (`half-cycles`). Its energy is twice that of the swing, its period twice the duration of the swing",
     of_cycle<&data::Cycle::half>},
    {"reason", "", "why not", "why the cycle does not count; empty if it counts", of_cycle<&data::Cycle::not_counted>},
    {"first", "", "first sample",
     "sample at which the cycle starts, counted from 0. It is no whole number if the start lies between two samples",
     of_cycle<&data::Cycle::first>},
    {"last", "", "last sample",
     "sample at which the cycle ends, counted from 0. It is no whole number if the end lies between two samples",
     of_cycle<&data::Cycle::last>},
    {"amplitude_mm", "mm", "amplitude",
     "amplitude D: half the distance between the largest and the smallest displacement",
     of_cycle<&data::Cycle::amplitude_mm>, decimals(1)},
    {"d_plus_mm", "mm", "d+", "largest displacement", of_cycle<&data::Cycle::d_plus_mm>, decimals(1)},
    {"d_minus_mm", "mm", "d-", "smallest displacement", of_cycle<&data::Cycle::d_minus_mm>, decimals(1)},
    {"F_plus_kN", "kN", "F+", "force at d+", of_cycle<&data::Cycle::F_plus_kN>, decimals(1)},
    {"F_minus_kN", "kN", "F-", "force at d-", of_cycle<&data::Cycle::F_minus_kN>, decimals(1)},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff",
     "effective stiffness: the force at d+ minus the force at d-, divided by d+ minus d-",
     of_cycle<&data::Cycle::K_eff_kN_per_mm>, significant(4)},
    {"K_plus_kN_per_mm", "kN/mm", "K+", "stiffness of the positive side: F+ divided by d+",
     of_cycle<&data::Cycle::K_plus>, significant(4)},
    {"K_minus_kN_per_mm", "kN/mm", "K-", "stiffness of the negative side: F- divided by d-",
     of_cycle<&data::Cycle::K_minus>, significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "dissipated energy: the area of the loop after it is closed by a straight line",
     of_cycle<&data::Cycle::energy_kN_mm>, decimals(0)},
    {"damping_percent", "%", "damping", "equivalent viscous damping: energy / (2 π K_eff D²)",
     of_cycle<&data::Cycle::damping>, decimals(2)},
    {"Q_d_kN", "kN", "Q_d",
     "characteristic strength: half the difference between the two forces of the loop at zero displacement",
     of_cycle<&data::Cycle::Q_d_kN>, decimals(1)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yielding: K_eff - Q_d / D",
     of_cycle<&data::Cycle::K_d_kN_per_mm>, significant(3)},
    {"D_y_mm", "mm", "D_y", "yield displacement of the bilinear loop with the Q_d, K_d and energy of this cycle",
     of_cycle<&data::Cycle::D_y_mm>, decimals(2)},
    {"K_1_kN_per_mm", "kN/mm", "K_1",
     "stiffness before yielding of the bilinear loop with the Q_d, K_d and energy of this cycle",
     of_cycle<&data::Cycle::K_1_kN_per_mm>, significant(3)},
    {"F_y_kN", "kN", "F_y", "force at D_y of the bilinear loop with the Q_d, K_d and energy of this cycle",
     of_cycle<&data::Cycle::F_y_kN>, decimals(1)},
    {"residual_plus_mm", "mm", "residual +", "displacement at which the force first comes back to zero after d+",
     of_cycle<&data::Cycle::residual_plus_mm>, decimals(1)},
    {"residual_minus_mm", "mm", "residual -", "displacement at which the force first comes back to zero after d-",
     of_cycle<&data::Cycle::residual_minus_mm>, decimals(1)},
    {"work_kN_mm", "kN mm", "energy so far",
     "work of the force from the first sample of the record to the end of the cycle",
     of_cycle<&data::Cycle::work_kN_mm>, decimals(0)},
    {"K_eff_in_block", "-", "K_eff to first of block",
     "K_eff of this cycle divided by K_eff of the first counted cycle of the block",
     [](CycleOf const& row) { return study::value_of(stiffness_decay(row.device, row.cycle).in_block); }, decimals(3)},
    {"K_eff_in_test", "-", "K_eff to first",
     "K_eff of this cycle divided by K_eff of the first counted cycle of the record",
     [](CycleOf const& row) { return study::value_of(stiffness_decay(row.device, row.cycle).in_test); }, decimals(3)},
    {"period_s", "s", "period",
     "time from start to end of the cycle, without the time in which the device stands still",
     of_cycle<&data::Cycle::period_s>, significant(3)},
    {"v_max_mm_s", "mm/s", "v max",
     "largest speed in the cycle: the steepest slope of the displacement over a twenty-fifth of the cycle",
     of_cycle<&data::Cycle::v_max_mm_s>, significant(3)},
    {"N_mean_kN", "kN", "N mean", "mean vertical load in the cycle", of_cycle<&data::Cycle::N_mean_kN>, decimals(0)},
    {"N_min_kN", "kN", "N min", "smallest vertical load in the cycle", of_cycle<&data::Cycle::N_min_kN>, decimals(0)},
    {"N_max_kN", "kN", "N max", "largest vertical load in the cycle", of_cycle<&data::Cycle::N_max_kN>, decimals(0)},
    {"closure_mm", "mm", "closure", "displacement at the end of the cycle minus that at its start",
     of_cycle<&data::Cycle::closure_mm>, significant(2)},
    {"closure_kN", "kN", "closure", "force at the end of the cycle minus that at its start",
     of_cycle<&data::Cycle::closure_kN>, significant(2)},
    {"strain_percent", "%", "strain", "shear strain: D divided by the total thickness of the rubber",
     [](CycleOf const& row) {
       auto const& thickness = row.device.rubber_thickness_mm;
       return thickness ? Value(data::strains(row.cycle, *thickness, 1.0).shear_strain_percent) : Value();
     },
     decimals(0)},
    {"G_MPa", "MPa", "G",
     "shear modulus of the rubber: K_eff times the total thickness of the rubber, divided by its area",
     [](CycleOf const& row) {
       auto const &thickness = row.device.rubber_thickness_mm, &area = row.device.rubber_area_mm2;
       return thickness && area ? Value(data::strains(row.cycle, *thickness, *area).G_MPa) : Value();
     },
     significant(3)},
};

inline constexpr Result<data::Block> block_results[]{
    {"number", "", "block", "number of the block, from 1", get<&data::Block::number>},
    {"amplitude_mm", "mm", "amplitude", "median of the amplitudes of the counted cycles",
     get<&data::Block::amplitude_mm>, decimals(1)},
    {"frequency_Hz", "Hz", "frequency", "1 divided by the median period of the counted cycles",
     get<&data::Block::frequency_Hz>, significant(2)},
    {"waveform", "", "waveform",
     "form of the motion over time in the middle counted cycle; empty if the record has no time",
     get<&data::Block::waveform>},
    {"v_max_mm_s", "mm/s", "v max", "median over the counted cycles of their largest speed",
     get<&data::Block::v_max_mm_s>, significant(3)},
    {"cycles", "", "", "all cycles in order, also those that do not count", nested<data::Block>},
    {"stability", "", "", "`K_eff`, `energy`, `damping`: how much each of them changes over the counted cycles",
     nested<data::Block>},
};

inline constexpr Result<data::Stability> stability_results[]{
    {"ratio_to_third", "", "", "value in each counted cycle divided by the value in cycle 3", nested<data::Stability>},
    {"min_2_10", "-", "least of cycles 2-10",
     "smallest ratio to cycle 3 in the cycles 2 to 10, or in as many of them as there are",
     get<&data::Stability::min_2_10>},
    {"max_2_10", "-", "largest of cycles 2-10", "largest ratio to cycle 3 in the cycles 2 to 10",
     get<&data::Stability::max_2_10>},
    {"min_1_10", "-", "least of cycles 1-10", "smallest ratio to cycle 3 in the cycles 1 to 10",
     get<&data::Stability::min_1_10>},
    {"max_1_10", "-", "largest of cycles 1-10", "largest ratio to cycle 3 in the cycles 1 to 10",
     get<&data::Stability::max_1_10>},
    {"least_to_largest_2_10", "-", "least to largest of cycles 2-10",
     "smallest value in cycles 2 to 10 divided by the largest", get<&data::Stability::least_to_largest_2_10>},
    {"least_to_largest_1_10", "-", "least to largest of cycles 1-10",
     "smallest value in cycles 1 to 10 divided by the largest", get<&data::Stability::least_to_largest_1_10>},
    {"first_to_third", "-", "first to third", "scragging ratio: value in cycle 1 divided by the value in cycle 3",
     get<&data::Stability::first_to_third>, decimals(2)},
    {"first_to_mean_1_3", "-", "first to mean of cycles 1-3",
     "value in cycle 1 divided by the mean of the first three cycles", get<&data::Stability::first_to_mean_1_3>},
};

inline constexpr Result<Level> level_results[]{
    {"block", "", "block", "number of the block", get<&Level::block>},
    {"amplitude_mm", "mm", "amplitude", "amplitude of the block", get<&Level::amplitude_mm>, decimals(1)},
    {"strain_percent", "%", "strain", "shear strain: amplitude divided by the total thickness of the rubber",
     get<&Level::strain_percent>, decimals(0)},
    {"frequency_Hz", "Hz", "frequency", "frequency of the block", get<&Level::frequency_Hz>, significant(2)},
    {"N_mean_kN", "kN", "N mean", "mean vertical load over the counted cycles of the block", get<&Level::N_mean_kN>,
     decimals(0)},
    {"cycle", "", "cycle",
     "number of the cycle from which the values below are: 3, or that of the last counted cycle if there are fewer",
     get<&Level::cycle>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "effective stiffness in the cycle `cycle`", get<&Level::K_eff_kN_per_mm>,
     significant(4)},
    {"damping_percent", "%", "damping", "equivalent viscous damping in the cycle `cycle`", get<&Level::damping_percent>,
     decimals(2)},
    {"energy_kN_mm", "kN mm", "energy", "energy dissipated in the cycle `cycle`", get<&Level::energy_kN_mm>,
     decimals(0)},
    {"K_1_kN_per_mm", "kN/mm", "K_1",
     "stiffness before yielding of the bilinear loop with the Q_d, K_d and energy of the cycle `cycle`",
     get<&Level::K_1_kN_per_mm>, significant(3)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yielding: K_eff - Q_d / D", get<&Level::K_d_kN_per_mm>,
     significant(3)},
    {"D_y_mm", "mm", "D_y", "yield displacement of the bilinear loop with the Q_d, K_d and energy of the cycle `cycle`",
     get<&Level::D_y_mm>, decimals(2)},
    {"F_y_kN", "kN", "F_y", "force at D_y of the bilinear loop with the Q_d, K_d and energy of the cycle `cycle`",
     get<&Level::F_y_kN>, decimals(1)},
    {"K_eff_ratio", "-", "K_eff to the reference", "K_eff of this block divided by K_eff of the counting block",
     get<&Level::K_eff_ratio>, decimals(3)},
    {"damping_ratio", "-", "damping to the reference", "damping of this block divided by damping of the counting block",
     get<&Level::damping_ratio>, decimals(3)},
    {"reference", "", "reference", "true: this is the counting block", get<&Level::reference>},
};

inline constexpr Result<data::Cycle> skeleton_results[]{
    {"block", "", "block", "number of the block", get<&data::Cycle::block>},
    {"cycle", "", "cycle", "number of the counted cycle whose peaks these are: 1 or 3", get<&data::Cycle::number>},
    {"d_plus_mm", "mm", "d+", "largest displacement of the cycle", get<&data::Cycle::d_plus_mm>, decimals(1)},
    {"F_plus_kN", "kN", "F+", "force at d+", get<&data::Cycle::F_plus_kN>, decimals(1)},
    {"d_minus_mm", "mm", "d-", "smallest displacement of the cycle", get<&data::Cycle::d_minus_mm>, decimals(1)},
    {"F_minus_kN", "kN", "F-", "force at d-", get<&data::Cycle::F_minus_kN>, decimals(1)},
};

template <auto... members>
Value of_vertical(DeviceResult const& device) {
  return device.vertical ? get<members...>(*device.vertical) : Value();
}

inline constexpr Result<DeviceResult> vertical_results[]{
    {"K_v_kN_per_mm", "kN/mm", "K_v", "vertical stiffness", of_vertical<&data::VerticalStiffness::K_v_kN_per_mm>,
     significant(4)},
    {"how", "", "how",
     "how K_v was found: from which loads of which loading it is computed, or that the laboratory states it",
     of_vertical<&data::VerticalStiffness::description>},
    {"low_kN", "kN", "from load", "vertical load at the lower end of the secant; compression is positive",
     [](DeviceResult const& device) {
       return device.vertical && device.vertical->loads ? Value(device.vertical->loads->low_kN) : Value();
     },
     significant(4)},
    {"high_kN", "kN", "to load", "vertical load at the upper end of the secant",
     [](DeviceResult const& device) {
       return device.vertical && device.vertical->loads ? Value(device.vertical->loads->high_kN) : Value();
     },
     significant(4)},
    {"disp_low_mm", "mm", "from displacement", "vertical displacement at `low_kN`",
     of_vertical<&data::VerticalStiffness::disp_low_mm>, decimals(3)},
    {"disp_high_mm", "mm", "to displacement", "vertical displacement at `high_kN`",
     of_vertical<&data::VerticalStiffness::disp_high_mm>, decimals(3)},
    {"loading", "", "loading", "number of the loading that is used, from 1",
     of_vertical<&data::VerticalStiffness::loading>},
    {"loadings_kN_per_mm", "", "", "stiffness in every loading that reaches the largest load, in kN/mm",
     nested<DeviceResult>},
    {"file", "", "file", "record of the compression test; empty if the laboratory only states the stiffness",
     get<&DeviceResult::vertical_test, &data::VerticalTest::file>},
    {"sha256", "", "sha256", "SHA-256 hash of this file",
     get<&DeviceResult::vertical_test, &data::VerticalTest::sha256>},
    {"recognised", "", "", "how the record was read: one sentence for each decision", nested<DeviceResult>},
    {"refusal", "", "no stiffness", "why the compression test gives no stiffness; empty otherwise",
     get<&DeviceResult::vertical_test, &data::VerticalTest::refusal>},
};

inline constexpr Result<data::Effect> effect_results[]{
    {"effect", "", "effect", "name of the effect, such as `\"skew\"`", get<&data::Effect::effect>},
    {"value", own_unit, "value", "size of the effect", get<&data::Effect::value>},
    {"unit", "", "unit", "unit of `value` and `limit`", get<&data::Effect::unit>},
    {"limit", own_unit, "limit", "the limit of this effect; isolaw warns if the effect is beyond it",
     get<&data::Effect::limit>},
    {"exceeds", "", "exceeds", "true: the effect is beyond its limit, and a warning says so",
     get<&data::Effect::exceeds>},
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
