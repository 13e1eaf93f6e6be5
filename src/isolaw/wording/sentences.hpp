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
std::string prediction_good(Group);
std::string prediction_fair(Group);
std::string prediction_unknown(Group);

// Answers: answers.cpp. Which law to take and why, how the laws compare.
std::string law_recommended(Group);
std::string no_law_recommended(Group);
std::string why_error(Group);
std::string why_simpler(Group);
std::string why_ties(Group);
std::string why_next(Group);
std::string why_closer_refused(Group);
std::string none_identified(Group);
std::string none_describes(Group);
std::string none_predicts(Group);
std::string none_on_every_device(Group);
std::string none_has_error(Group);
std::string none_left_out(Group);
std::string none_beside_one_device(Group);
std::string weak_prediction_fair(Group);
std::string weak_error(Group);
std::string weak_only_law(Group);
std::string weak_incomplete(Group);
std::string weak_search(Group);
std::string weak_bounds(Group);
std::string weak_open(Group);
std::string surer_finish(Group);
std::string surer_other_laws(Group);
std::string surer_fit_blocks(Group);
std::string surer_other_amplitude(Group);
std::string surer_further_test(Group);
std::string surer_more_devices(Group);
std::string surer_amplitude_between(Group);
std::string out_not_identified(Group);
std::string out_inadequate(Group);
std::string out_prediction(Group);
std::string out_partial(Group);
std::string out_unknown(Group);
std::string out_error(Group);
std::string not_in_opensees(Group);
std::string headline_only_law(Group);
std::string headline_best_of_both(Group);
std::string headline_most_accurate(Group);
std::string headline_scatter_by_box(Group);
std::string headline_choice(Group);
std::string headline_nearest(Group);
std::string role_best_of_both(Group);
std::string role_alone(Group);
std::string role_most_robust(Group);
std::string role_between(Group);
std::string role_dominated(Group);
std::string role_not_on_front(Group);
std::string role_not_identified(Group);
std::string role_least_error(Group);
std::string role_behind(Group);
std::string role_no_beta(Group);
std::string converged_front(Group);
std::string converged_beta(Group);
std::string converged_untested(Group);
std::string converged_prediction(Group);
std::string converged_no_prediction(Group);
std::string converged_determined(Group);

// Buildings: building.cpp.
std::string building_bounds_cover(Group);
std::string covering_factors(Group);
std::string building_bounds_cover_with(Group);
std::string building_law_or_lot(Group);
std::string building_no_draws(Group);
std::string displacement_beyond_tests(Group);
std::string bounds_not_monotonic(Group);
std::string bounds_cover_less(Group);
std::string springs_as_given(Group);
std::string building_runs_failed(Group);
std::string draws_too_few(Group);
std::string motions_too_few(Group);

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

}  // namespace isolaw::wording
