#include "isolaw/wording/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {
namespace {

template <class T>
void add_once(std::vector<T>& all, std::vector<T> const& more) {
  for (auto const& each : more)
    if (std::ranges::find(all, each) == all.end()) all.push_back(each);
}

bool belongs(Finding const& finding, Finding const& first, unsigned grouping) {
  if (finding.kind != first.kind || (grouping & each_alone) != 0) return false;
  if (finding.word("part") != first.word("part")) return false;
  return ((grouping & by_law) == 0 || finding.law == first.law) &&
         ((grouping & by_device) == 0 || finding.devices == first.devices) &&
         ((grouping & by_words) == 0 || finding.words == first.words);
}

std::string subject_of(Group group, std::size_t most_names) {
  std::vector<std::string> names;
  switch (row(group.front().kind).subject) {
    case Subject::none:
      return {};
    case Subject::devices:
      names = devices_of(group);
      break;
    case Subject::law:
      for (auto const& finding : group) add_once(names, {law_name(finding)});
      break;
  }
  return names.empty() ? std::string() : enumerate(names, most_names) + ": ";
}

}  // namespace

std::string_view name(Severity severity) {
  constexpr std::string_view names[]{"note", "caution", "serious"};
  return names[static_cast<std::size_t>(severity)];
}

std::span<Row const> rows() {
  using enum FindingKind;
  using enum Severity;
  using enum Subject;
  static constexpr std::string_view records = "Look at the records", laws = "Do not rely on these laws",
                                    search = "Search longer or in finer steps",
                                    parameters = "Fix parameters, widen their boxes, or test more",
                                    go_on = "Continue the campaign", nothing = "",
                                    keep_blocks = "Keep blocks of the tests from the fit";
  static constexpr unsigned everywhere = in_report | with_law | with_building, reports = in_report,
                            on_its_own = anywhere;
  // Of a record: what anyone who uses its numbers must know, and what is worth knowing, shown beside the record alone.
  constexpr auto warning = [](FindingKind kind, std::string_view key, Severity severity, unsigned grouping,
                              std::string (*text)(Group)) {
    return Row{kind, key, "record", severity, records, grouping, everywhere | on_certificate, devices, text};
  };
  constexpr auto of_record = [](FindingKind kind, std::string_view key, std::string (*text)(Group)) {
    return Row{kind, key, "record", note, records, each_alone, anywhere, devices, text};
  };
  // In the order of FindingKind.
  static constexpr Row table[]{
      // [campaign]
      {runs_missing, "runs-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
       wording::runs_missing},
      {analyses_missing, "analyses-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
       wording::analyses_missing},
      {device_refused, "device-refused", "refused", serious, records, each_alone, reports, none,
       wording::device_refused},
      {rule_set_not_kept_by_device, "rule-set-not-kept-by-device", "rule set", serious, records, each_alone,
       with_law | with_building, none, wording::rule_set_not_kept_by_device},
      {rule_set_not_kept_by_lot, "rule-set-not-kept-by-lot", "rule set", serious, records, each_alone,
       with_law | with_building, none, wording::rule_set_not_kept_by_lot},
      {devices_not_in_lot_law, "devices-not-in-lot-law", "refused", caution, records, each_alone,
       with_law | with_building, none, wording::devices_not_in_lot_law},
      {same_record, "same-record", "copies", serious, records, each_alone, everywhere | on_certificate, none,
       wording::same_record},
      {same_compression_test, "same-compression-test", "copies", serious, records, each_alone,
       everywhere | on_certificate, none, wording::same_compression_test},
      {energy_falls, "energy-falls", "degradation", caution, records, each_alone, everywhere, devices,
       wording::energy_falls},
      {law_refused, "law-refused", "law not identified", serious, laws, by_law | by_words, everywhere, Subject::none,
       wording::law_refused},
      {runs_failed, "runs-failed", "failed runs", caution, search, by_law, everywhere, law, wording::runs_failed},
      {evaluations_failed, "evaluations-failed", "failed evaluations", note, search, by_law, reports, law,
       wording::evaluations_failed},
      {law_inadequate, "law-inadequate", "not adequate", serious, laws, each_alone, everywhere, none,
       wording::law_inadequate},
      {held_by_box, "held-by-box", "at bound", caution, parameters, each_alone, everywhere, law, wording::held_by_box},
      {prediction_poor, "prediction-poor", "prediction", serious, laws, each_alone, everywhere, law,
       wording::prediction_poor},
      {prediction_unusable, "prediction-unusable", "prediction", serious, laws, each_alone, everywhere, law,
       wording::prediction_unusable},
      {searches_disagree, "searches-disagree", "search", caution, search, by_words, everywhere, law,
       wording::searches_disagree},
      {not_determined, "not-determined", "undetermined", caution, parameters, by_law, everywhere, law,
       wording::not_determined},
      {prediction_not_asked, "prediction-not-asked", "not predicted", note, keep_blocks, one_sentence, everywhere, none,
       wording::prediction_not_asked},
      {outlier, "outlier", "outlier", caution, records, by_device, everywhere, none, wording::outlier},
      {at_bound, "at-bound", "at bound", caution, parameters, by_law, everywhere, law, wording::at_bound},
      {lot_law_at_bound, "lot-law-at-bound", "at bound", caution, parameters, by_law, everywhere, law,
       wording::lot_law_at_bound},
      {integration_coarse, "integration-coarse", "integration", caution, search, by_law, everywhere, law,
       wording::integration_coarse},
      {integration_not_finite, "integration-not-finite", "integration", serious, search, by_law, everywhere, law,
       wording::integration_not_finite},
      {prediction_good, "prediction-good", "prediction", note, nothing, each_alone, on_its_own, law,
       wording::prediction_good},
      {prediction_fair, "prediction-fair", "prediction", note, nothing, each_alone, on_its_own, law,
       wording::prediction_fair},
      {prediction_unknown, "prediction-unknown", "prediction", note, keep_blocks, each_alone, on_its_own, law,
       wording::prediction_unknown},
      // [answers]
      {law_recommended, "law-recommended", "answer", note, nothing, each_alone, on_its_own, none,
       wording::law_recommended},
      {no_law_recommended, "no-law-recommended", "answer", note, nothing, each_alone, on_its_own, none,
       wording::no_law_recommended},
      {why_error, "why-error", "reason", note, nothing, each_alone, on_its_own, none, wording::why_error},
      {why_simpler, "why-simpler", "reason", note, nothing, each_alone, on_its_own, none, wording::why_simpler},
      {why_ties, "why-ties", "reason", note, nothing, each_alone, on_its_own, none, wording::why_ties},
      {why_next, "why-next", "reason", note, nothing, each_alone, on_its_own, none, wording::why_next},
      {why_closer_refused, "why-closer-refused", "reason", note, nothing, each_alone, on_its_own, none,
       wording::why_closer_refused},
      {none_identified, "none-identified", "reason", note, nothing, each_alone, on_its_own, none,
       wording::none_identified},
      {none_describes, "none-describes", "reason", note, nothing, each_alone, on_its_own, none,
       wording::none_describes},
      {none_predicts, "none-predicts", "reason", note, nothing, each_alone, on_its_own, none, wording::none_predicts},
      {none_on_every_device, "none-on-every-device", "reason", note, nothing, each_alone, on_its_own, none,
       wording::none_on_every_device},
      {none_has_error, "none-has-error", "reason", note, nothing, each_alone, on_its_own, none,
       wording::none_has_error},
      {none_left_out, "none-left-out", "reason", note, nothing, each_alone, on_its_own, none, wording::none_left_out},
      {none_beside_one_device, "none-beside-one-device", "reason", note, nothing, each_alone, on_its_own, none,
       wording::none_beside_one_device},
      {weak_prediction_fair, "weak-prediction-fair", "confidence", caution, nothing, each_alone, on_its_own, none,
       wording::weak_prediction_fair},
      {weak_error, "weak-error", "confidence", caution, nothing, each_alone, on_its_own, none, wording::weak_error},
      {weak_only_law, "weak-only-law", "confidence", caution, nothing, each_alone, on_its_own, none,
       wording::weak_only_law},
      {weak_incomplete, "weak-incomplete", "confidence", caution, nothing, each_alone, on_its_own, none,
       wording::weak_incomplete},
      {weak_search, "weak-search", "confidence", caution, nothing, each_alone, on_its_own, none, wording::weak_search},
      {weak_bounds, "weak-bounds", "confidence", caution, nothing, each_alone, on_its_own, none, wording::weak_bounds},
      {weak_open, "weak-open", "confidence", caution, nothing, each_alone, on_its_own, none, wording::weak_open},
      {surer_finish, "surer-finish", "advice", note, nothing, each_alone, on_its_own, none, wording::surer_finish},
      {surer_other_laws, "surer-other-laws", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_other_laws},
      {surer_fit_blocks, "surer-fit-blocks", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_fit_blocks},
      {surer_other_amplitude, "surer-other-amplitude", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_other_amplitude},
      {surer_further_test, "surer-further-test", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_further_test},
      {surer_more_devices, "surer-more-devices", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_more_devices},
      {surer_amplitude_between, "surer-amplitude-between", "advice", note, nothing, each_alone, on_its_own, none,
       wording::surer_amplitude_between},
      {out_not_identified, "out-not-identified", "standing", note, nothing, each_alone, on_its_own, none,
       wording::out_not_identified},
      {out_inadequate, "out-inadequate", "standing", note, nothing, each_alone, on_its_own, none,
       wording::out_inadequate},
      {out_prediction, "out-prediction", "standing", note, nothing, each_alone, on_its_own, none,
       wording::out_prediction},
      {out_partial, "out-partial", "standing", note, nothing, each_alone, on_its_own, none, wording::out_partial},
      {out_unknown, "out-unknown", "standing", note, nothing, each_alone, on_its_own, none, wording::out_unknown},
      {out_error, "out-error", "standing", note, nothing, each_alone, on_its_own, none, wording::out_error},
      {not_in_opensees, "not-in-opensees", "answer", note, nothing, each_alone, on_its_own, none,
       wording::not_in_opensees},
      {headline_only_law, "headline-only-law", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_only_law},
      {headline_best_of_both, "headline-best-of-both", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_best_of_both},
      {headline_most_accurate, "headline-most-accurate", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_most_accurate},
      {headline_scatter_by_box, "headline-scatter-by-box", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_scatter_by_box},
      {headline_choice, "headline-choice", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_choice},
      {headline_nearest, "headline-nearest", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::headline_nearest},
      {role_best_of_both, "role-best-of-both", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_best_of_both},
      {role_alone, "role-alone", "comparison", note, nothing, each_alone, on_its_own, none, wording::role_alone},
      {role_most_robust, "role-most-robust", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_most_robust},
      {role_between, "role-between", "comparison", note, nothing, each_alone, on_its_own, none, wording::role_between},
      {role_dominated, "role-dominated", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_dominated},
      {role_not_on_front, "role-not-on-front", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_not_on_front},
      {role_not_identified, "role-not-identified", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_not_identified},
      {role_least_error, "role-least-error", "comparison", note, nothing, each_alone, on_its_own, none,
       wording::role_least_error},
      {role_behind, "role-behind", "comparison", note, nothing, each_alone, on_its_own, none, wording::role_behind},
      {role_no_beta, "role-no-beta", "comparison", note, nothing, each_alone, on_its_own, none, wording::role_no_beta},
      {converged_front, "converged-front", "best fits", note, nothing, each_alone, on_its_own, none,
       wording::converged_front},
      {converged_beta, "converged-beta", "best fits", note, nothing, one_sentence, on_its_own, none,
       wording::converged_beta},
      {converged_untested, "converged-untested", "best fits", note, nothing, each_alone, on_its_own, none,
       wording::converged_untested},
      {converged_prediction, "converged-prediction", "best fits", note, nothing, each_alone, on_its_own, none,
       wording::converged_prediction},
      {converged_no_prediction, "converged-no-prediction", "best fits", note, nothing, each_alone, on_its_own, none,
       wording::converged_no_prediction},
      {converged_determined, "converged-determined", "best fits", note, nothing, one_sentence, on_its_own, none,
       wording::converged_determined},
      // [building]
      {building_bounds_cover, "building-bounds-cover", "answer", note, nothing, each_alone, on_its_own, none,
       wording::building_bounds_cover},
      {covering_factors, "covering-factors", "answer", note, nothing, each_alone, on_its_own, none,
       wording::covering_factors},
      {building_bounds_cover_with, "building-bounds-cover-with", "answer", note, nothing, each_alone, on_its_own, none,
       wording::building_bounds_cover_with},
      {building_law_or_lot, "building-law-or-lot", "answer", note, nothing, each_alone, on_its_own, none,
       wording::building_law_or_lot},
      {building_no_draws, "building-no-draws", "answer", note, nothing, each_alone, on_its_own, none,
       wording::building_no_draws},
      {displacement_beyond_tests, "displacement-beyond-tests", "extrapolation", serious, "Test to that displacement",
       each_alone, with_building, law, wording::displacement_beyond_tests},
      {bounds_not_monotonic, "bounds-not-monotonic", "bounds", caution, "Ignore the share for this quantity",
       each_alone, with_building, law, wording::bounds_not_monotonic},
      {bounds_cover_less, "bounds-cover-less", "bounds", caution, "Widen the factors for these quantities", by_law,
       with_building, law, wording::bounds_cover_less},
      {springs_as_given, "springs-as-given", "two directions", caution,
       "Fit springs: isolaw calibrate --bidirectional springs", each_alone, with_building, law,
       wording::springs_as_given},
      {building_runs_failed, "building-runs-failed", "failed runs", serious, "Look at the runs", each_alone,
       with_building, law, wording::building_runs_failed},
      {draws_too_few, "draws-too-few", "not complete", serious, "Draw more buildings", each_alone, with_building, none,
       wording::draws_too_few},
      {motions_too_few, "motions-too-few", "motions", caution, "Use more motions", each_alone, with_building, none,
       wording::motions_too_few},
      // [records]
      warning(no_cyclic_properties, "no-cyclic-properties", serious, by_words, wording::no_cyclic_properties),
      warning(signal_clipped, "signal-clipped", serious, by_words, wording::signal_clipped),
      warning(signal_stuck, "signal-stuck", serious, by_words, wording::signal_stuck),
      warning(signal_without_sign, "signal-without-sign", serious, by_words, wording::signal_without_sign),
      warning(signal_interrupted, "signal-interrupted", serious, by_words, wording::signal_interrupted),
      warning(signal_spike, "signal-spike", serious, by_words, wording::signal_spike),
      warning(cycle_gives_energy, "cycle-gives-energy", serious, one_sentence, wording::cycle_gives_energy),
      warning(cycle_not_stiff, "cycle-not-stiff", serious, one_sentence, wording::cycle_not_stiff),
      warning(not_cyclic, "not-cyclic", serious, one_sentence, wording::not_cyclic),
      warning(no_complete_cycle, "no-complete-cycle", serious, one_sentence, wording::no_complete_cycle),
      warning(no_cycle_counts, "no-cycle-counts", serious, one_sentence, wording::no_cycle_counts),
      warning(samples_too_few, "samples-too-few", serious, one_sentence, wording::samples_too_few),
      warning(vertical_test_refused, "vertical-test-refused", serious, by_words, wording::vertical_test_refused),
      warning(units_implausible, "units-implausible", serious, by_words, wording::units_implausible),
      warning(vertical_stiffness_implausible, "vertical-stiffness-implausible", serious, by_words,
              wording::vertical_stiffness_implausible),
      warning(vertical_softer_than_expected, "vertical-softer-than-expected", serious, one_sentence,
              wording::vertical_softer_than_expected),
      warning(time_in_days, "time-in-days", serious, one_sentence, wording::time_in_days),
      warning(about_acceleration, "about-acceleration", serious, by_words, wording::about_acceleration),
      warning(cycle_unlike_neighbours, "cycle-unlike-neighbours", caution, one_sentence,
              wording::cycle_unlike_neighbours),
      warning(force_late, "force-late", caution, by_words, wording::force_late),
      warning(friction_in_force, "friction-in-force", caution, one_sentence, wording::friction_in_force),
      warning(samples_few, "samples-few", caution, one_sentence, wording::samples_few),
      warning(time_uneven, "time-uneven", caution, one_sentence, wording::time_uneven),
      warning(time_jumps, "time-jumps", caution, one_sentence, wording::time_jumps),
      warning(noise, "noise", caution, one_sentence, wording::noise),
      warning(drift, "drift", caution, by_words, wording::drift),
      warning(loop_open, "loop-open", caution, one_sentence, wording::loop_open),
      warning(speed_off, "speed-off", caution, by_words, wording::speed_off),
      warning(off_centre, "off-centre", caution, by_words, wording::off_centre),
      warning(starts_off_zero, "starts-off-zero", caution, one_sentence, wording::starts_off_zero),
      warning(several_amplitudes, "several-amplitudes", caution, one_sentence, wording::several_amplitudes),
      warning(damping_undefined, "damping-undefined", caution, one_sentence, wording::damping_undefined),
      warning(average_too_wide, "average-too-wide", caution, one_sentence, wording::average_too_wide),
      warning(shared_time_short, "shared-time-short", caution, by_words, wording::shared_time_short),
      warning(channel_interpolated, "channel-interpolated", caution, by_words, wording::channel_interpolated),
      warning(axis_taken_for_channel, "axis-taken-for-channel", caution, by_words, wording::axis_taken_for_channel),
      warning(unit_overridden, "unit-overridden", caution, by_words, wording::unit_overridden),
      warning(loads_ambiguous, "loads-ambiguous", caution, by_words, wording::loads_ambiguous),
      warning(load_unit_unclear, "load-unit-unclear", caution, by_words, wording::load_unit_unclear),
      warning(velocity_unused, "velocity-unused", caution, by_words, wording::velocity_unused),
      of_record(samples_per_cycle, "samples-per-cycle", wording::samples_per_cycle),
      of_record(force_early, "force-early", wording::force_early),
      of_record(jump_of_force, "jump-of-force", wording::jump_of_force),
      of_record(rig_friction, "rig-friction", wording::rig_friction),
      of_record(moving_mass, "moving-mass", wording::moving_mass),
      of_record(stands_still, "stands-still", wording::stands_still),
      of_record(cut_off_zero, "cut-off-zero", wording::cut_off_zero),
      of_record(largest_speed, "largest-speed", wording::largest_speed),
      of_record(average_over_samples, "average-over-samples", wording::average_over_samples),
      of_record(file_format, "file-format", wording::stated),
      of_record(header_found, "header-found", wording::stated),
      of_record(column_taken, "column-taken", wording::stated),
      of_record(columns_unused, "columns-unused", wording::stated),
      of_record(units_given, "units-given", wording::stated),
      of_record(time_scale, "time-scale", wording::stated),
      of_record(no_time_column, "no-time-column", wording::no_time_column),
      of_record(rows_read, "rows-read", wording::stated),
      of_record(test_chosen, "test-chosen", wording::stated),
      of_record(file_joined, "file-joined", wording::stated),
      of_record(force_flipped, "force-flipped", wording::force_flipped),
      of_record(spikes_repaired, "spikes-repaired", wording::spikes_repaired),
      of_record(skew_removed, "skew-removed", wording::skew_removed),
      of_record(friction_removed, "friction-removed", wording::friction_removed),
      of_record(inertia_removed, "inertia-removed", wording::inertia_removed),
      of_record(force_multiplied, "force-multiplied", wording::force_multiplied),
      of_record(centred, "centred", wording::centred),
      of_record(smoothed, "smoothed", wording::smoothed),
      of_record(not_smoothed, "not-smoothed", wording::not_smoothed),
      of_record(scored_in_part, "scored-in-part", wording::scored_in_part),
      of_record(all_samples_kept, "all-samples-kept", wording::all_samples_kept),
      of_record(velocity_computed, "velocity-computed", wording::velocity_computed),
      of_record(no_velocity, "no-velocity", wording::no_velocity),
      of_record(samples_thinned, "samples-thinned", wording::samples_thinned),
  };
  static_assert(
      [] {
        for (std::size_t i = 0; i < std::size(table); ++i)
          if (table[i].kind != static_cast<FindingKind>(i)) return false;
        return true;
      }(),
      "a row for each kind, in the order of FindingKind");
  return table;
}
Row const& row(FindingKind kind) {
  return rows()[static_cast<std::size_t>(kind)];
}
Row const* find_row(std::string_view key) {
  auto const found = std::ranges::find(rows(), key, &Row::key);
  return found == rows().end() ? nullptr : &*found;
}

std::string remark(Group group) {
  auto const part = group.front().word("part");
  return (part.empty() ? std::string() : std::string(part) + ": ") + row(group.front().kind).text(group);
}
std::string remark(Finding const& finding) {
  return remark(Group(&finding, 1));
}
std::string sentence(Group group, std::size_t most_names) {
  return subject_of(group, most_names) + remark(group);
}
std::string sentence(Finding const& finding) {
  return sentence(Group(&finding, 1));
}

std::vector<std::string> remarks(std::vector<Finding> const& findings) {
  std::vector<std::string> all;
  for (auto const& finding : findings) all.push_back(remark(finding));
  return all;
}
std::string reasons(std::vector<Finding> const& findings) {
  std::string text;
  for (auto const& finding : findings) text += text.empty() ? remark(finding) : " " + capitalised(remark(finding));
  return text;
}

std::vector<std::vector<Finding>> grouped(std::vector<Finding> const& findings, unsigned place) {
  std::vector<std::vector<Finding>> groups;
  for (auto const& finding : findings) {
    auto const& about = row(finding.kind);
    if (place != anywhere && (about.appears & place) == 0) continue;
    auto const group = std::ranges::find_if(
        groups, [&](auto const& other) { return belongs(finding, other.front(), about.grouping); });
    if (group == groups.end())
      groups.push_back({finding});
    else if (std::ranges::find(*group, finding) == group->end())
      group->push_back(finding);
  }
  std::ranges::stable_sort(groups, {}, [](auto const& group) { return group.front().kind; });
  return groups;
}

std::vector<std::string> sentences(std::vector<Finding> const& findings, unsigned place) {
  std::vector<std::string> all;
  for (auto const& group : grouped(findings, place)) all.push_back(sentence(group));
  return all;
}

std::string paragraph(std::vector<Finding> const& findings, std::string_view between, bool with_subject) {
  std::string text;
  for (auto const& finding : findings) {
    if (!text.empty()) text += between;
    text += with_subject ? sentence(finding) : remark(finding);
  }
  return text;
}

std::vector<std::string> devices_of(Group group) {
  std::vector<std::string> all;
  for (auto const& finding : group) add_once(all, finding.devices);
  return all;
}
std::vector<std::string> parameters_of(Group group) {
  std::vector<std::string> all;
  for (auto const& finding : group) add_once(all, finding.parameters);
  return all;
}
std::vector<int> blocks_of(Group group) {
  std::vector<int> all;
  for (auto const& finding : group) add_once(all, finding.blocks);
  return all;
}

}  // namespace isolaw::wording
