// A finding is whatever the program has to say besides numbers: a warning, a doubt, an answer, a piece of advice. It
// consists of fields, from which the module `wording` makes a sentence for printing. No code reads a sentence back.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw {

// The kinds have the same order as the rows of the table in wording/rows.cpp, which is also the order in which findings
// are shown. Words in brackets name the parts of that table. Within a part, serious findings mostly come first.
// clang-format off
enum class FindingKind {
  // [campaign]
  runs_missing, analyses_missing, device_refused, rule_set_not_kept_by_device, rule_set_not_kept_by_lot,
  verdict_rests_on_corrections, devices_not_in_lot_law, same_record, copies_not_sought, same_compression_test,
  stiffness_unlike_design, strain_implausible, energy_falls, law_refused, runs_failed,
  evaluations_failed, law_inadequate, law_runs_away, law_faulty, held_by_box, prediction_poor, prediction_unusable, searches_disagree, runs_differ,
  not_determined, prediction_not_asked, outlier, not_compared, at_bound, lot_law_at_bound, integration_coarse,
  integration_not_finite, laws_disagree, prediction_good, prediction_fair, prediction_larger_swings,
  prediction_unknown, verdict_without_corrections_same, conditions_differ,
  // [conditions] The effects of temperature, rate, load, ageing and history (study/conditions_findings.hpp).
  conditions_not_compared, condition_test_refused, condition_test_unlike, condition_test_doubt, tests_show_no_effect, devices_disagree, condition_load_unlike, condition_name_differs, stiffer_when_warm, order_lacks_tests, bounds_rest_on_doubts, histories_differ, interval_of_one_device, effect_left_out, effect_not_covered, effect_assumed, dependence_not_kept, dependence_judged, mean_properties_judged, design_bound, chamber_too_short,
  line_not_checked, drift_not_checked, rest_not_stated, short_rest, ageing_stands_for, conditions_stated,
  // [answers]
  law_recommended, law_errors, no_law_recommended, law_shown_up_to, why_next, why_better_refused, none_identified, none_describes,
  none_predicts, none_on_every_device, none_for_a_building, none_energy, weak_prediction_fair, weak_error,
  weak_larger_swings, weak_other_blocks, weak_cycle_stiffness, weak_cycle_energy, weak_cycle_damping,
  weak_stiffness_beyond, weak_damping_beyond, weak_far_beyond, weak_one_sided, weak_only_law, weak_incomplete, weak_search,
  weak_bounds, weak_open, weak_conditions, surer_finish, surer_other_laws, surer_both_sides, surer_design, surer_fit_blocks, surer_other_amplitude,
  surer_further_test, surer_more_devices, surer_amplitude_between, out_not_identified, out_prediction,
  out_partial, out_runs_away, not_in_opensees, headline_only_law, headline_best_of_both,
  headline_most_accurate, headline_scatter_by_box, headline_choice, headline_nearest, role_best_of_both, role_alone,
  role_most_robust, role_between, role_dominated, role_not_on_front, role_not_identified, role_least_error,
  role_behind, role_no_beta, converged_front, converged_beta, converged_untested, converged_prediction,
  converged_no_prediction, converged_determined,
  // [building]
  building_holds, building_holds_with, building_law_failed, building_reach, building_scatter, building_most_moved, building_bounds_cover, covering_factors, building_bounds_cover_with, building_law_or_lot, building_no_draws,
  displacement_beyond_tests, bounds_not_monotonic, bounds_cover_less, springs_as_given, unequal_sides, building_runs_failed,
  draws_collapsed, draws_too_few, motions_too_few,
  ground_zero_removed, ground_padded, ground_too_strong, ground_off_zero, ground_keeps_moving, period_implausible, energy_error_large, draws_off_reference, rotation_large,
  // [exports] How a building's response changes if another program's material replaces the law (programs/response.hpp).
  refit_response_off, refit_response,
  // [records] Signals that cannot be true, and other reasons why there are no cyclic properties.
  no_cyclic_properties, signal_clipped, signal_stuck, signal_without_sign, signal_wraps,
  signal_interrupted, signal_spike,
  cycle_gives_energy, cycle_not_stiff, not_cyclic, no_complete_cycle, no_cycle_counts, samples_too_few,
  vertical_test_refused,
  // Doubts about the values in a record.
  units_implausible, motion_implausible, force_beyond_load, vertical_stiffness_implausible, vertical_softer_than_expected, time_in_days,
  about_acceleration, force_lost, cycle_unlike_neighbours, stiffness_rises, force_late, lag_grows, friction_in_force, samples_few,
  time_uneven, time_jumps, noise, hum, drift, offset_steps, loop_open, speed_off, frequency_sweeps, off_centre,
  gain_of_one_side, starts_off_zero, several_amplitudes, damping_undefined,
  average_too_wide, tests_state_differently, shared_time_short, channel_interpolated, axis_taken_for_channel, unit_overridden,
  loads_ambiguous, load_unit_unclear, velocity_unused, direction_unread,
  values_uncorrected, uncorrected_without_properties, uncorrected_not_known,
  // Notes: numbers of a record that the reader should know.
  viscous_device, sliding_device, samples_per_cycle, force_early, jump_of_force, rig_friction, moving_mass, stands_still, cut_off_zero,
  largest_speed, average_over_samples, largest_swings,
  // How the record was read. The finding has a word "text" with the description.
  file_format, header_found, column_taken, columns_unused, units_given, time_scale, no_time_column, rows_read,
  test_chosen, file_joined, force_flipped, half_cycles_count,
  // Corrections of a record, and steps to prepare it for fitting.
  spikes_repaired, skew_removed, friction_removed, inertia_removed, force_multiplied, centred, smoothed,
  not_smoothed, scored_in_part, faulty_not_scored, failed_not_scored, all_samples_kept, velocity_computed, no_velocity,
  samples_thinned, samples_weighed,
  // Conditions under which a device's damping would have another value (study/value_doubts.hpp).
  if_late_force_is_moved, if_force_is_early, if_jump_is_of_rig, if_rig_rubs,
  // [conditions] The bound laws over the design conditions (study/design_bounds.hpp).
  bound_law, no_bound_laws,
};
// clang-format on

struct FindingNumber {
  std::string name;  // includes the unit: "offset_mm"
  double value = 0.0;

  bool operator==(FindingNumber const&) const = default;
};

struct FindingWord {
  std::string name, text;

  bool operator==(FindingWord const&) const = default;
};

struct Finding {
  FindingKind kind = {};
  std::string law = {};  // the law's id; empty if the finding is about no single law
  std::vector<std::string> other_laws = {};
  std::vector<std::string> devices = {}, parameters = {};
  std::vector<int> blocks = {};
  std::vector<FindingNumber> numbers = {};
  std::vector<FindingWord> words = {};

  bool operator==(Finding const&) const = default;

  double number(std::string_view name, double fallback = 0.0) const {
    auto const found = std::ranges::find(numbers, name, &FindingNumber::name);
    return found == numbers.end() ? fallback : found->value;
  }
  bool has_number(std::string_view name) const {
    return std::ranges::find(numbers, name, &FindingNumber::name) != numbers.end();
  }
  std::string_view word(std::string_view name) const {  // empty if there is no such word
    auto const found = std::ranges::find(words, name, &FindingWord::name);
    return found == words.end() ? std::string_view() : found->text;
  }
};

}  // namespace isolaw
