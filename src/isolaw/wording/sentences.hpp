// The functions that the rows of the table point to. Each gets the findings of one group and returns what is said of
// them without the subject: it continues "device-01: " or "Bouc-Wen: " where the row begins with one.
#pragma once

#include <string>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

// Campaigns: campaign.cpp.
std::string runs_missing(Group);
std::string analyses_missing(Group);
std::string device_refused(Group);
std::string rule_set_not_kept_by_device(Group);
std::string rule_set_not_kept_by_lot(Group);
std::string devices_not_in_lot_law(Group);
std::string same_record(Group);
std::string same_compression_test(Group);
std::string energy_falls(Group);
std::string law_refused(Group);
std::string runs_failed(Group);
std::string evaluations_failed(Group);
std::string law_inadequate(Group);
std::string held_by_box(Group);
std::string prediction_poor(Group);
std::string prediction_unusable(Group);
std::string searches_disagree(Group);
std::string not_determined(Group);
std::string prediction_not_asked(Group);
std::string outlier(Group);
std::string at_bound(Group);
std::string lot_law_at_bound(Group);
std::string integration_coarse(Group);
std::string integration_not_finite(Group);

// Signals of records, and why they have no cyclic properties: signals.cpp.
std::string no_cyclic_properties(Group);
std::string signal_clipped(Group);
std::string signal_stuck(Group);
std::string signal_without_sign(Group);
std::string signal_interrupted(Group);
std::string signal_spike(Group);
std::string cycle_gives_energy(Group);
std::string cycle_not_stiff(Group);
std::string not_cyclic(Group);
std::string no_complete_cycle(Group);
std::string no_cycle_counts(Group);
std::string samples_too_few(Group);
std::string cycle_unlike_neighbours(Group);
std::string force_late(Group);
std::string friction_in_force(Group);
std::string samples_few(Group);
std::string time_uneven(Group);
std::string time_jumps(Group);
std::string noise(Group);
std::string drift(Group);
std::string loop_open(Group);
std::string speed_off(Group);
std::string off_centre(Group);
std::string starts_off_zero(Group);
std::string several_amplitudes(Group);
std::string damping_undefined(Group);
std::string average_too_wide(Group);
std::string samples_per_cycle(Group);
std::string force_early(Group);
std::string jump_of_force(Group);
std::string rig_friction(Group);
std::string moving_mass(Group);
std::string stands_still(Group);
std::string cut_off_zero(Group);
std::string largest_speed(Group);
std::string average_over_samples(Group);

// How records were read, and what was done to them: records.cpp.
std::string vertical_test_refused(Group);
std::string units_implausible(Group);
std::string vertical_stiffness_implausible(Group);
std::string vertical_softer_than_expected(Group);
std::string time_in_days(Group);
std::string about_acceleration(Group);
std::string shared_time_short(Group);
std::string channel_interpolated(Group);
std::string axis_taken_for_channel(Group);
std::string unit_overridden(Group);
std::string loads_ambiguous(Group);
std::string load_unit_unclear(Group);
std::string velocity_unused(Group);
std::string stated(Group);  // what the word "text" says
std::string no_time_column(Group);
std::string force_flipped(Group);
std::string spikes_repaired(Group);
std::string skew_removed(Group);
std::string friction_removed(Group);
std::string inertia_removed(Group);
std::string force_multiplied(Group);
std::string centred(Group);
std::string smoothed(Group);
std::string not_smoothed(Group);
std::string scored_in_part(Group);
std::string all_samples_kept(Group);
std::string velocity_computed(Group);
std::string no_velocity(Group);
std::string samples_thinned(Group);
std::string if_late_force_is_moved(Group);
std::string if_force_is_early(Group);
std::string if_jump_is_of_rig(Group);
std::string if_rig_rubs(Group);

}  // namespace isolaw::wording
