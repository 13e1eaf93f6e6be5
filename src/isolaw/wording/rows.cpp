// The rows of the table of findings, in the order of FindingKind. Each text holds the finding's fields in braces (see
// wording/fill.hpp). Where the wording depends on the findings, a function of sentences.hpp makes the sentence.
#include <cstddef>
#include <iterator>

#include "isolaw/wording/sentences.hpp"

namespace isolaw::wording {
namespace {

using Sentence = std::string (*)(Group, UnitSystem const&);

constexpr Row campaign(FindingKind kind, std::string_view key, std::string_view topic, Severity severity,
                       std::string_view action, unsigned grouping, unsigned appearance, Subject subject,
                       std::string_view text) {
  return {kind, key, topic, severity, action, grouping, appearance, subject, text};
}
// A row for a finding that is part of an answer, such as the recommended law. It is printed only where code asks for
// this kind of finding.
constexpr Row answer(FindingKind kind, std::string_view key, std::string_view topic, std::string_view text,
                     unsigned grouping = each_alone) {
  return {kind, key, topic, Severity::note, "", grouping, anywhere, Subject::none, text};
}
// A row for a doubt about the recommended law. Exports and other outputs that take this law from the campaign repeat
// the doubt.
constexpr Row answer_doubt(FindingKind kind, std::string_view key, std::string_view text) {
  return {kind,
          key,
          "confidence",
          Severity::caution,
          "Test further before you rely on this law",
          each_alone,
          with_law | with_building,
          Subject::law,
          text};
}
constexpr std::string_view look_at_records = "Look at the records";
// A row for a doubt about a record. It is printed wherever numbers of this record are used.
constexpr Row doubt(FindingKind kind, std::string_view key, Severity severity, unsigned grouping, std::string_view text,
                    Sentence compose = nullptr) {
  constexpr unsigned places = in_report | with_law | with_building | on_certificate;
  return {kind, key, "record", severity, look_at_records, grouping, places, Subject::devices, text, compose};
}
// A row for a fact about a record. It is printed only beside the record.
constexpr Row fact(FindingKind kind, std::string_view key, std::string_view text, Sentence compose = nullptr) {
  return {kind, key, "record", Severity::note, look_at_records, each_alone, anywhere, Subject::devices, text, compose};
}

}  // namespace

std::span<Row const> rows() {
  using enum FindingKind;
  using enum Severity;
  using enum Subject;
  static constexpr std::string_view records = look_at_records, laws = "Do not rely on these laws",
                                    search = "Search longer or in finer steps",
                                    parameters = "Fix parameters, widen their boxes, or test more",
                                    go_on = "Continue the campaign",
                                    keep_blocks = "Leave blocks of the tests out of the fit (--fit-blocks)",
                                    stated = "{text}", lot_file = "Correct the lot file";
  static constexpr unsigned everywhere = in_report | with_law | with_building, taken = with_law | with_building,
                            signed_too = everywhere | on_certificate;
  // The formatter is off, since it would indent every text of a row anew when one of them changes its length.
  // clang-format off
  static constexpr Row table[]{
      // [campaign] Findings about a campaign, its laws and its devices.
      campaign(
          runs_missing, "runs-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
          "[This is part {part} of {parts}. ]{runs} of {expected_runs} runs are done: every number and the choice of a law may still change."),
      campaign(
          analyses_missing, "analyses-missing", "not complete", serious, go_on, one_sentence, everywhere, none,
          "{analyses} of {expected_analyses} analyses are done: open parameters and errors on devices left out are not all known yet."),
      campaign(device_refused, "device-refused", "refused", serious, records, each_alone, in_report | on_certificate,
               none, "{devices} was refused: {reason}"),
      campaign(rule_set_not_kept_by_device, "rule-set-not-kept-by-device", "rule set", serious, records, each_alone,
               taken, none, "{devices} fails {rules}: {failures}"),
      campaign(rule_set_not_kept_by_lot, "rule-set-not-kept-by-lot", "rule set", serious, records, each_alone, taken,
               none, "The lot does not keep its rule set: {verdict}"),
      campaign(
          verdict_rests_on_corrections, "verdict-rests-on-corrections", "corrections", serious, records, each_alone,
          signed_too, none,
          "The verdict rests on the corrections by hand of {devices}. Without them it would be {verdict}, not {now}: {sentence}."),
      campaign(devices_not_in_lot_law, "devices-not-in-lot-law", "refused", caution, records, each_alone, taken, none,
               "{devices} {was|were} refused. The lot has {lot_devices} devices; its law is made from the others."),
      campaign(
          same_record, "same-record", "copies", serious, records, each_alone, signed_too, none,
          "{devices} hold the same record[{altered}, scaled, shifted, sampled anew or with noise added]: it counts as one device.[ Means, spreads, draws and bounds leave out {left_out}.]"),
      campaign(copies_not_sought, "copies-not-sought", "copies", caution, records, each_alone, signed_too, none,
               "the lot has more than {most:,} devices: only exact copies of records are looked for, no record that was "
               "scaled, shifted, sampled anew or given noise."),
      campaign(same_compression_test, "same-compression-test", "copies", serious, records, each_alone, signed_too, none,
               "{devices} hold the same compression test: its K_v counts {times} times."),
      campaign(
          stiffness_unlike_design, "stiffness-unlike-design", "record", serious, records, by_words, signed_too, devices,
          "K_eff of {K_eff_kN_per_mm:4} is {ratio:3} times the design value. {mistake}"),
      campaign(
          strain_implausible, "strain-implausible", "record", serious, records, each_alone, signed_too, devices,
          "{amplitude_mm:4} is {strain_percent:3} % of the rubber's thickness, more than rubber bears. Are the unit of displacement and the thickness right?"),
      campaign(
          energy_falls, "energy-falls", "degradation", caution, records, each_alone, everywhere, devices,
          "the energy of a cycle falls by {measured_percent:2} % from cycle {first_cycle} to cycle {last_cycle} of block {block}. [{several_laws}No law follows this fall ({law} comes nearest, with {law_percent:2} %): each fits only some cycle in between.][{only_law}{law} does not follow this fall (its own energy falls by {law_percent:2} %): it fits only some cycle in between.][{fit_cycles}]"),
      campaign(
          law_refused, "law-refused", "law not identified", serious, laws, by_law | by_words, everywhere, none,
          "{law} was not identified on {devices}: {reason}[. Its mean and beta cover the other {others} device{|s} only]"),
      campaign(
          runs_failed, "runs-failed", "failed runs", caution, search, by_law, everywhere, law,
          "{failed_of_law} of {runs_of_law} runs failed (~{failed} on {devices}~)[; its numbers are those of the other {other_runs}]. The first failure: {reason}"),
      campaign(
          evaluations_failed, "evaluations-failed", "failed evaluations", note, search, by_law, in_report, law,
          "{failed} of {tried} parameter sets that were tried ({share:%}) gave no finite force and were passed over."),
      campaign(
          law_inadequate, "law-inadequate", "not adequate", serious, laws, each_alone, everywhere, none,
          "{law} does not describe the devices. Its mean errors are too large[: {misfit:%1} of the force's standard deviation][, {K_eff_error_percent:.1f} % of the effective stiffness][, {energy_error_percent:.1f} % of the dissipated energy]."),
      campaign(law_runs_away, "law-runs-away", "not for a building", serious, "Take another law for a building",
               each_alone, everywhere, law, "it is not named for a building: {rule}[ ({devices})]."),
      campaign(law_faulty, "law-faulty", "not for use", serious, "Take another law", each_alone, everywhere, law,
               "its force is not possible, even within the tests: {rule}."),
      campaign(
          held_by_box, "held-by-box", "at bound", caution, parameters, each_alone, everywhere, law,
          "{count} of its {calibrated} parameters lie at a bound on half of the devices or more: the search box keeps them together, so its beta does not show robustness."),
      campaign(prediction_poor, "prediction-poor", "prediction", serious, laws, each_alone, everywhere, law,
               "its prediction is poor: {objectives}."),
      campaign(
          prediction_unusable, "prediction-unusable", "prediction", serious, laws, each_alone, everywhere, law,
          "its prediction is unusable: {objectives}.{collapse} Use it only for amplitudes and frequencies that it was fitted to[, up to {fitted_to_mm:3}]."),
      campaign(searches_disagree, "searches-disagree", "search", caution, search, by_words, everywhere, law,
               "{share:few%} of the runs came within 0.1 % of the best fit of this campaign."),
      campaign(runs_differ, "runs-differ", "search", caution, search, by_law, everywhere, law,
               "its {runs} searches ended ~{apart:%1} apart on {devices}~. The same command with --runs {more} adds searches."),
      campaign(
          not_determined, "not-determined", "undetermined", caution, parameters, by_law, everywhere, law,
          "the tests cannot fix ~{parameters}[ ({affected} of {examined} devices)]~.[ {reduced_form} searches a form with the same loops and without the redundant parameter.]"),
      campaign(
          prediction_not_asked, "prediction-not-asked", "not predicted", note, keep_blocks, one_sentence, everywhere,
          none,
          "The records hold several blocks, but every block was fitted: nothing shows whether a law that is fitted to some blocks holds for the others. Use --fit-blocks with the numbers of some blocks to predict the rest."),
      campaign(
          outlier, "outlier", "outlier", caution, records, by_device, everywhere, none,
          "{devices} is an outlier in its lot: ~{property} {value:4 unit} ({percent:+.0f} % from the median)~."),
      campaign(not_compared, "not-compared", "outlier", caution, records, each_alone, everywhere, none,
               "{devices} {is|are} in no search for outliers among the measured values, which come from cycles of another "
               "amplitude than the usual {usual_mm:4}: it differs by more than {allowed:3} %."),
      campaign(at_bound, "at-bound", "at bound", caution, parameters, by_law, everywhere, law,
               "~{parameters} at its {side} bound on [all {all_devices} devices][{some}{devices}][ ({set} moves it)]~."),
      campaign(lot_law_at_bound, "lot-law-at-bound", "at bound", caution, parameters, by_law, everywhere, law,
               "in the one law for all devices, ~{parameters} at its {side} bound~."),
      campaign(integration_coarse, "integration-coarse", "integration", caution, search, by_law, everywhere, law,
               "a finer integration step would move the objective by {shift:2} on {devices}."),
      campaign(
          integration_not_finite, "integration-not-finite", "integration", serious, search, by_law, everywhere, law,
          "its force is not finite in finer integration steps on {devices}: the result comes from the step, not from the law."),
      campaign(
          laws_disagree, "laws-disagree", "other laws", note, "Test to that displacement", one_sentence, taken, none,
          "At {disp_mm:4}{beyond}, the {count} best laws have a stiffness of {K_low_kN_per_mm:3!} to {K_high_kN_per_mm:3} and dissipate {energy_low_kN_mm:3!} to {energy_high_kN_mm:3} in a cycle."),
      campaign(prediction_good, "prediction-good", "prediction", note, "", each_alone, anywhere, law,
               "its prediction is good: {objectives}."),
      campaign(prediction_fair, "prediction-fair", "prediction", note, "", each_alone, anywhere, law,
               "its prediction is fair: {objectives}."),
      campaign(
          prediction_larger_swings, "prediction-larger-swings", "prediction", note, "", each_alone, anywhere, law,
          "fitted to the smaller swings of the tests alone, it misses the larger ones by {predicted:%}[, or by as little as {least:%} with another fit that is as good]."),
      campaign(prediction_unknown, "prediction-unknown", "prediction", note, keep_blocks, each_alone, anywhere, law,
               "how well it predicts is not known: no block was left out of the fit, and the swings do not differ enough in size to fit the small ones alone."),
      campaign(
          verdict_without_corrections_same, "verdict-without-corrections-same", "corrections", note, records,
          each_alone, in_report | on_certificate, none,
          "Without the corrections by hand of {devices} the verdict would be {verdict} too."),
      campaign(
          conditions_differ, "conditions-differ", "lot", serious, "Compare the devices under one condition",
          each_alone, signed_too, none,
          "The devices were tested under different conditions[; temperature {least_C:3} to {largest_C:3} °C (alike within {allowed_C:3} °C)][; frequency {least_Hz:3} to {largest_Hz:3} Hz (alike within {allowed_Hz:3} Hz)][; vertical load {least_kN:4!} to {largest_kN:4} (alike within {allowed_kN:3})][; amplitude {least_mm:4!} to {largest_mm:4} (alike within {allowed_mm:3})][; earlier cycles of up to {least_earlier_mm:4!} to {largest_earlier_mm:4} (alike within {allowed_earlier_mm:3})][; {least_earlier_cycles:.0f} to {largest_earlier_cycles:.0f} earlier cycles of this amplitude or a larger one (alike within {allowed_earlier_cycles:3})].[ Tolerances: {tolerances}.] Part of the spread of the devices comes from that, and the lot has no verdict, since a verdict holds for one condition."),
      // [conditions] Findings of `isolaw conditions` (study/conditions_findings.hpp).
      campaign(conditions_not_compared, "conditions-not-compared", "conditions", serious, lot_file, each_alone, signed_too,
               none, "The tests under other conditions cannot be compared: {reason}."),
      campaign(condition_test_refused, "condition-test-refused", "conditions", serious, records, each_alone,
               in_report | on_certificate, none, "The test {test} of {devices}[ ({place})] is not used: {reason}."),
      campaign(condition_test_unlike, "condition-test-unlike", "conditions", serious, records, each_alone, signed_too, none,
               "K_eff of the test {test} of {devices}[ ({place})] is {times:3} times the median of the reference tests. No condition does that: are the units and the device right?"),
      campaign(condition_test_doubt, "condition-test-doubt", "conditions", caution, records, each_alone,
               in_report | on_certificate, none, "The test {test} of {devices}[ ({place})]: {doubt}"),
      campaign(tests_show_no_effect, "tests-show-no-effect", "conditions", caution, "Check that this is meant", each_alone, in_report, none,
               "No effect is shown by {count} {test|tests}, because {role}: {named}."),
      campaign(devices_disagree, "devices-disagree", "conditions", caution, records, each_alone, in_report | on_certificate,
               none,
               "The devices disagree on the effect of {effect} at {level}: the factor on {quantity} is from {least:.3f} to {largest:.3f} on {devices}."),
      campaign(condition_load_unlike, "condition-load-unlike", "conditions", serious, lot_file, each_alone, signed_too, none,
               "The vertical load of {test} of {devices}[ ({place})] is {times:.3} times that of the reference. Is its unit right?"),
      campaign(condition_name_differs, "condition-name-differs", "conditions", serious, lot_file, each_alone, signed_too, none,
               "The test {test} of {devices}[ ({place})] or its file has a name that says {named}, and the lot file states {stated}."),
      campaign(stiffer_when_warm, "stiffer-when-warm", "conditions", serious, lot_file, each_alone, signed_too, none,
               "K_eff rises with the temperature: its factor is {cold:.3f} at {cold_C:g} C and {warm:.3f} at {warm_C:g} C. Rubber is stiffer in the cold, so temperatures may be interchanged."),
      campaign(order_lacks_tests, "order-lacks-tests", "conditions", caution, "Check that no test is missing", each_alone, in_report | on_certificate, none,
               "The last test of {devices} has the order {last_order}, and the lot file has {tests} {test|tests} of it. A test that is missing may have changed the device."),
      campaign(bounds_rest_on_doubts, "bounds-rest-on-doubts", "conditions", serious, lot_file, each_alone, signed_too, none,
               "The bounds rest on tests with a doubt: {named}."),
      campaign(histories_differ, "histories-differ", "conditions", caution, records, each_alone, in_report, none,
               "The reference cycle has not the same history on all devices: {named}. Their factors are averaged all the same."),
      campaign(interval_of_one_device, "interval-of-one-device", "conditions", caution, "Test a further device", each_alone,
               in_report | on_certificate, none,
               "A single device shows the effect of {effects}. The interval of the bounds contains only how much repeated tests of this device differ, not how much devices do."),
      campaign(effect_left_out, "effect-left-out", "conditions", caution, "State it in design of [conditions], if the device will meet it",
               each_alone, in_report | on_certificate, none,
               "The tests show an effect of {effect}: K_eff has the factor {factor:.3f} at {level}. The design states no {key}, so the bounds leave it out."),
      campaign(effect_not_covered, "effect-not-covered", "conditions", serious,
               "Test devices at this condition, or state it", each_alone, signed_too, none,
               "The effect of {effect} is NOT COVERED[ at {at:6} {unit}]: {lack}[; tested: {tested}]."),
      campaign(
          effect_assumed, "effect-assumed", "conditions", serious, "Test devices under this condition", each_alone,
          signed_too, none,
          "The effect of {effect} on {quantity} is ASSUMED: factors {max:.3f} and {min:.3f}, the default of {rules}[, {clause}][{unverified}, which nobody has verified]. No test of this lot shows it."),
      campaign(
          dependence_not_kept, "dependence-not-kept", "conditions", serious, "Read the limit of the rule set", each_alone, signed_too, none,
          "{quantity} under {effect}: FAIL: {changes}{worst_percent:+.1f} %[ at {at:6} {unit}][ on {devices}]; {rules} allows {within_percent:g} %[ ({clause})]."),
      campaign(
          dependence_judged, "dependence-judged", "conditions", note, "", each_alone, in_report | on_certificate, none,
          "{quantity} under {effect}: {kept}[: {changes}{worst_percent:+.1f} % at most][ at {at:6} {unit}]; {rules} allows {within_percent:g} %[ ({clause})][{because}]."),
      campaign(
          mean_properties_judged, "mean-properties-judged", "conditions", note, "", each_alone, in_report | on_certificate,
          none,
          "An analysis with mean properties is {mean_properties}: over the design conditions {quantity} changes by up to {farthest_percent:+.1f} %; {rules} allows {within_percent:g} %[ ({clause})]."),
      campaign(
          design_bound, "design-bound", "conditions", note, "", each_alone, in_report | on_certificate, none,
          "{quantity}, {which} bound over the design conditions: [{partial} ]{factor:.3f} times the value at reference[ ({low:.3f} to {high:.3f}, 95 %)][, {status}; {share_shown:0%} of it rests on tests at such conditions or between them][; not covered: {not_covered}][; ASSUMED: {assumed}]."),
      campaign(
          chamber_too_short, "chamber-too-short", "conditions", caution, records, each_alone, in_report, none,
          "The temperature of {test} of {devices}[ ({place})] is that of the chamber, and rubber of this thickness needs {needed_h:3} h to take it (not verified)[; the device was there for {conditioned_h:4} h][{unknown}; how long the device was there is not stated (conditioned-h)]."),
      campaign(line_not_checked, "line-not-checked", "conditions", caution, "Test a further level", each_alone, in_report,
               none, "Whether the response is straight between the tests is not checked for {effects}: too few levels were tested."),
      campaign(drift_not_checked, "drift-not-checked", "conditions", note, "Repeat the reference test at the end", each_alone,
               in_report, none, "Drift is not checked for {effects}: no device tested for it has a second reference test."),
      campaign(rest_not_stated, "rest-not-stated", "conditions", note, "State rest-h or started", each_alone, in_report, none,
               "The rest before {tests} {test|tests} is not stated: a first cycle there counts as the first after a rest."),
      campaign(short_rest, "short-rest", "conditions", note, "", each_alone, in_report, none,
               "After rests below {rest_h:g} h it is heat more than structure that recovers (not verified)."),
      campaign(ageing_stands_for, "ageing-stands-for", "conditions", note, "", each_alone, in_report | on_certificate, none,
               "The ageing test stands for {years:3} years at {service_C:4} C."),
      campaign(conditions_stated, "conditions-stated", "conditions", note, "", each_alone, on_certificate, none,
               "Stated by the laboratory, not measured: {stated} of the tests under other conditions."),
      // [answers] Which law to take and why (study/recommendation.hpp).
      answer(law_recommended, "law-recommended", "answer", "Take {law}{sure}."),
      answer(
          law_errors, "law-errors", "answer",
          "It gives back {fitted_to} within {fits:%}[, and larger swings that it was not fitted to within {predicts:%}][, and blocks that it was not fitted to within {blocks:%}].[ {laws} {is|are} as good.]{larger}"),
      campaign(no_law_recommended, "no-law-recommended", "answer", serious, laws, one_sentence, taken, none,
               "No law can be recommended."),
      answer(law_shown_up_to, "law-shown-up-to", "answer", "Shown up to {disp_mm:3}."),
      answer(why_next, "why-next", "reason", "The next best, {law}, has a mean error of {error:%}."),
      answer(why_better_refused, "why-better-refused", "reason",
             "{law} has a smaller mean error ({error:%}), but is ruled out."),
      answer(none_identified, "none-identified", "reason", "No law could be identified."),
      answer(none_describes, "none-describes", "reason",
             "The law of least error, {law}, has a mean error of {error:%}, more than {most:%}."),
      answer(none_predicts, "none-predicts", "reason",
             "{laws} {does|do} not predict the blocks that were left out of the fit."),
      answer(none_on_every_device, "none-on-every-device", "reason",
             "{laws} {was|were} not identified on every device."),
      answer(none_for_a_building, "none-for-a-building", "reason", "{laws} {is|are} not fit for a building."),
      answer(none_energy, "none-energy", "reason",
             "Every law of least error ({laws}) is more than {most:%} off in the energy of the largest cycles."),
      answer_doubt(weak_prediction_fair, "weak-prediction-fair",
             "its prediction of blocks that it was not fitted to is only fair"),
      answer_doubt(weak_error, "weak-error", "its mean error of {error:%} is large"),
      answer_doubt(weak_larger_swings, "weak-larger-swings",
             "its error on larger swings is {times:.1f} times its error on what it was fitted to"),
      answer_doubt(weak_other_blocks, "weak-other-blocks",
             "its error on blocks that it was not fitted to is {times:.1f} times its error on what it was fitted to"),
      answer_doubt(weak_cycle_stiffness, "weak-cycle-stiffness",
             "on the largest cycle its stiffness is {percent:.0f} % off"),
      answer_doubt(weak_cycle_energy, "weak-cycle-energy",
             "on the largest cycle its energy is {percent:.0f} % off"),
      answer_doubt(weak_cycle_damping, "weak-cycle-damping",
             "on the largest cycle its damping is {percent:.0f} % off"),
      answer_doubt(weak_stiffness_beyond, "weak-stiffness-beyond",
             "its stiffness at {asked_mm:3} is {ratio:.2f} times that at {tested_mm:3}, where the tests end"),
      answer_doubt(weak_damping_beyond, "weak-damping-beyond",
             "its damping at {asked_mm:3} is {ratio:.2f} times that at {tested_mm:3}, where the tests end"),
      answer_doubt(weak_far_beyond, "weak-far-beyond",
             "the design asks for {asked_mm:3}, {times:.1f} times the largest displacement tested"),
      answer_doubt(weak_one_sided, "weak-one-sided",
             "the tests reach {far_mm:3} to one side and only {near_mm:3} to the other"),
      answer(weak_only_law, "weak-only-law", "confidence", "no other law was identified to compare it with"),
      answer(weak_incomplete, "weak-incomplete", "confidence", "the campaign is not complete"),
      answer(weak_search, "weak-search", "confidence", "{share:few%} of its searches reached the best fit found"),
      answer(weak_bounds, "weak-bounds", "confidence",
             "{count} of its {calibrated} parameters lie at a bound on half of the devices or more"),
      answer(weak_open, "weak-open", "confidence", "the tests cannot fix {share:%} of its parameters"),
      answer(weak_conditions, "weak-conditions", "confidence", "the devices were tested under different conditions"),
      answer(surer_finish, "surer-finish", "advice", "finish the campaign with the same command"),
      answer(surer_other_laws, "surer-other-laws", "advice", "identify other laws to compare it with (--laws)"),
      answer(surer_both_sides, "surer-both-sides", "advice", "test whole cycles that reach as far to both sides"),
      answer(surer_design, "surer-design", "advice", "test up to the {asked_mm:3} that the design asks for"),
      answer(surer_fit_blocks, "surer-fit-blocks", "advice",
             "leave an amplitude or rate out of the fit (--fit-blocks)"),
      answer(surer_other_amplitude, "surer-other-amplitude", "advice",
             "test another amplitude or rate"),
      answer(surer_further_test, "surer-further-test", "advice", "make a further test and leave it out of the fit"),
      answer(surer_more_devices, "surer-more-devices", "advice", "test more devices (only {devices_tested} so far)"),
      answer(surer_amplitude_between, "surer-amplitude-between", "advice", "test an amplitude between the tested ones"),
      answer(out_not_identified, "out-not-identified", "standing", "was not identified"),
      answer(out_prediction, "out-prediction", "standing", "its prediction is {grade}"),
      answer(out_partial, "out-partial", "standing", "was not identified on every device"),
      answer(out_runs_away, "out-runs-away", "standing", "{rule}[ ({devices})]"),
      answer(not_in_opensees, "not-in-opensees", "answer",
             "OpenSees has no such material; isolaw brings the law itself into OpenSeesPy"),
      answer(headline_only_law, "headline-only-law", "comparison", "{law} is the only law that was identified."),
      answer(headline_best_of_both, "headline-best-of-both", "comparison",
             "{law} is both the most accurate and the most robust law{among}."),
      answer(headline_most_accurate, "headline-most-accurate", "comparison",
             "{law} is the most accurate law{among}; how robust it is cannot be said."),
      answer(
          headline_scatter_by_box, "headline-scatter-by-box", "comparison",
          "{law} is the most accurate law{among}; the laws that scatter less are held together by their search box."),
      answer(
          headline_choice, "headline-choice", "comparison",
          "{considered} of {compared} laws are worth considering: choose between accuracy ({law}) and robustness ({robust:law}).[ The best compromise is {compromise:law}.]{none_between}"),
      answer(headline_nearest, "headline-nearest", "comparison",
             "No law describes these devices. The nearest is {law}."),
      answer(
          role_best_of_both, "role-best-of-both", "comparison",
          "No law{among} is more accurate and none is more robust: it misses the measured force by {misfit:%1} of its standard deviation on average, and its parameters lie up to {beta:%} from the lot's mean, averaged over the parameters."),
      answer(
          role_alone, "role-alone", "comparison",
          "It misses the measured force by {misfit:%1} of its standard deviation on average; its parameters lie up to {beta:%} from the lot's mean, averaged over the parameters."),
      answer(
          role_most_robust, "role-most-robust", "comparison",
          "Its parameters lie up to {beta:%} from the lot's mean, averaged over the parameters, {least}. The price is an error of {misfit:%1} against {other_misfit:%1} for {laws}."),
      answer(
          role_between, "role-between", "comparison",
          "It scatters less than {accurate:law} ({beta:%} against {accurate_beta:%}) and errs less than {robust:law} ({misfit:%1} against {robust_misfit:%1})."),
      answer(role_dominated, "role-dominated", "comparison",
             "{laws} {is|are} at least as accurate and as robust (this law: error {misfit:%1}, scatter {beta:%})."),
      answer(role_not_on_front, "role-not-on-front", "comparison",
             "It is not on the front (error {misfit:%1}, scatter {beta:%})."),
      answer(role_not_identified, "role-not-identified", "comparison", "It was not identified on any device."),
      answer(role_least_error, "role-least-error", "comparison",
             "It misses the measured force by {misfit:%1} of its standard deviation on average[, {least}]."),
      answer(role_behind, "role-behind", "comparison",
             "Its mean error is {misfit:%1}, {times:.2f} times that of {laws}."),
      answer(role_no_beta, "role-no-beta", "comparison", "It has no beta: {note}."),
      answer(converged_front, "converged-front", "best fits",
             "Without the optimiser's noise the front is {same}{laws}[; of the mean of the runs it is {of_runs}]."),
      answer(
          converged_beta, "converged-beta", "best fits",
          "From the best fits, without the parameters that the tests cannot fix or the search box decides, beta changes: ~{law} {beta_converged:%} instead of {beta:%}[{reduced}][ (without {parameters})]~.",
          one_sentence),
      answer(
          converged_untested, "converged-untested", "best fits",
          "On a device that was not tested, the one law of the lot errs by {error:%1} on average with {law}, {least}, and by {worst:%1} at worst ({devices})[; fitted to each device it would err by {fitted:%1}]."),
      answer(
          converged_prediction, "converged-prediction", "best fits",
          "{law} is best at predicting the blocks that the laws were not fitted to: {grade} (objective {predicted:3}, against {fitted:3} on the fitted blocks)[; the prediction of {laws} is unusable]."),
      answer(converged_no_prediction, "converged-no-prediction", "best fits",
             "No law that was fitted to some blocks predicts the others: {laws}."),
      answer(converged_determined, "converged-determined", "best fits",
             "Share of the parameters that the tests fix: ~{law} {determined:%} (and {weakly:%} weakly)~.",
             one_sentence),
      // [building] Findings about the analyses of a building.
      answer(building_holds, "building-holds", "answer", "{holds}{alone}."),
      answer(building_holds_with, "building-holds-with", "answer", "{holds}{alone}."),
      answer(
          building_law_failed, "building-law-failed", "answer",
          "{law} gave no finite numbers{where}[{also} in {collapsed} of {draws:,} draws]: these count as outside of every limit and of the bounds. This is a failure of the law in the model; it does not show that the building would fail."),
      answer(
          building_reach, "building-reach", "answer",
          "The bearings move {nominal_mm:3} in the nominal building[, at most {bound_mm:3} in the two bound analyses][, and {p95_mm:3} or less in 95 % of {draws:,} drawn buildings][; {tested}]."),
      answer(building_scatter, "building-scatter", "answer",
             "The scatter of the lot changes this by {lot_std_ln:%1}[, the motions differ by {motions}]."),
      answer(building_most_moved, "building-most-moved", "answer", "{bearings}."),
      answer(
          building_bounds_cover, "building-bounds-cover", "answer",
          "{answer} {law} the bounds cover {inside:0%} of {draws:,} buildings ({interval_low:0%} to {interval_high:0%}) in the largest displacement of a bearing[; {collapsed} of these have no finite numbers and count as outside][, {nominal_outside}]; {factors}."),
      answer(covering_factors, "covering-factors", "answer", "{factors}"),
      answer(building_bounds_cover_with, "building-bounds-cover-with", "answer",
             "{answer} {law} the bounds of {laws} cover {inside:0%} of {draws:,} buildings[; {collapsed} of these have no finite numbers and count as outside]."),
      answer(building_law_or_lot, "building-law-or-lot", "answer", "{more} matters more than {less}."),
      answer(building_no_draws, "building-no-draws", "answer",
             "No bearing is drawn from the lot, so there is no scatter for the bounds to cover."),
      campaign(
          displacement_beyond_tests, "displacement-beyond-tests", "extrapolation", serious, "Test to that displacement",
          each_alone, with_building, law,
          "bearings move up to {most_mm:.0f} ([{of}][under {motion}]), but the tests went to {tested_mm:.0f}. Beyond that the law is extrapolated."),
      campaign(
          bounds_not_monotonic, "bounds-not-monotonic", "bounds", caution, "Ignore the share for this quantity",
          each_alone, with_building, law,
          "[the share of {inside:0%} of the draws between the bounds says nothing about {quantity}, because ]both bound analyses ({lower:4 unit} and {upper:4 unit}) are {side} the nominal building ({nominal:4 unit})."),
      campaign(bounds_cover_less, "bounds-cover-less", "bounds", caution, "Widen the factors for these quantities",
               by_law, with_building, law,
               "the bounds cover less than {wanted:0%} of the draws: ~{inside:0%} in {quantity}~."),
      campaign(
          springs_as_given, "springs-as-given", "two directions", caution,
          "Fit springs: isolaw calibrate --bidirectional springs", each_alone, with_building, law,
          "it has no coupled form, and its springs have the parameters of the law along one direction: they round its knee and dissipate less. isolaw calibrate --bidirectional springs fits them."),
      campaign(unequal_sides, "unequal-sides", "two directions", caution, "Take a law of equal force on both sides",
               each_alone, taken, law, "its force differs between its two directions{how}."),
      campaign(building_runs_failed, "building-runs-failed", "failed runs", serious, "Look at the runs", each_alone,
               with_building, law, "{failed} run{|s} gave no finite numbers."),
      campaign(draws_collapsed, "draws-collapsed", "failed runs", serious, "Look at the runs", each_alone,
               with_building, law,
               "{collapsed} of {draws} drawn buildings have no finite numbers under a motion. They count as outside of every limit and of the bounds, and in medians and fractiles as larger than all others; a standard deviation or a mean over draws is given only if {finite:0%} of them have numbers."),
      campaign(
          draws_too_few, "draws-too-few", "not complete", serious, "Raise `draws` of the building file", each_alone,
          with_building, none,
          "{draws:,} draws are too few to tell whether {wanted:0%} of buildings lie between the bounds: no answer yet[; {enough:,} suffice if the share between them stays as it is (`draws` of the building file, with --fresh)]."),
      campaign(
          motions_too_few, "motions-too-few", "motions", caution, "Use more motions", each_alone, with_building, none,
          "{motions} motion{|s}: codes accept the mean over {wanted} motions or more as the design's response, some over eleven."),
      campaign(ground_zero_removed, "ground-zero-removed", "motions", note, "", each_alone, with_building, none,
               "the motion {motion} along {axis} is as the instrument gave it; its mean of {mean_g:3} g was subtracted."),
      campaign(ground_padded, "ground-padded", "motions", note, "", each_alone, with_building, none,
               "the motion {motion} is shorter along {axis} by {samples} sample{|s}, which are taken as zero."),
      campaign(
          ground_too_strong, "ground-too-strong", "motions", serious, "Check the unit of the motion", each_alone,
          with_building, none,
          "the motion {motion} reaches {peak_g:3} g along {axis}. Hardly any ground motion of more than {limit_g} g was recorded: is its unit right?"),
      campaign(
          ground_off_zero, "ground-off-zero", "motions", caution, "Correct the baseline of the motion", each_alone,
          with_building, none,
          "the mean of the motion {motion} along {axis} is {mean_percent:2} % of its peak. It was taken as it is; a record whose baseline is corrected has a mean near zero."),
      campaign(
          ground_keeps_moving, "ground-keeps-moving", "motions", caution, "Correct the baseline of the motion",
          each_alone, with_building, none,
          "the ground still moves at {final_mm_s:3} when the motion {motion} ends along {axis}; its largest velocity is {largest_mm_s:3}. Was it cut off, or its baseline not corrected?"),
      campaign(
          period_implausible, "period-implausible", "building", serious, "Check masses and bearings", each_alone,
          with_building, law,
          "the building swings on its bearings with a period of {period_s:2} s at {amplitude_mm:.0f}. Isolated buildings have one of {least_s} s to {most_s} s: are the masses in Mg, and are all bearings there?"),
      campaign(
          energy_error_large, "energy-error-large", "accuracy", caution, "Take a smaller step_s", each_alone,
          with_building, law,
          "the energy of {whose} does not balance: {error:2} of it is missing[ under {motion}], more than {limit}."),
      campaign(
          draws_off_reference, "draws-off-reference", "accuracy", caution, "Take a smaller step_s", each_alone,
          with_building, law,
          "the integration of the drawn buildings is off by {percent:2} % from the implicit one, under {motion}; up to {limit_percent} % is usual."),
      campaign(
          rotation_large, "rotation-large", "accuracy", serious, "Check the plan", each_alone, with_building, law,
          "the base rotates by {rotation_rad:2} rad under {motion}, and the analysis holds for small rotations, up to {limit_rad} rad."),
      // [exports] How the response of a building changes if a re-fit takes the place of a law (programs/response.hpp).
      campaign(
          refit_response_off, "refit-response-off", "re-fit", serious, "Use the law itself", each_alone, anywhere, law,
          "with {refit} in its place, a building's peak displacement is off by {disp_percent:+.1f} %[ ({disp_least_percent:+.1f} to {disp_most_percent:+.1f} %)] and its peak base shear by {shear_percent:+.1f} %[ ({shear_least_percent:+.1f} to {shear_most_percent:+.1f} %)] under {motions}. That is more than {allowed_percent} %: use the law itself, or allow for it in the design."),
      campaign(
          refit_response, "refit-response", "re-fit", note, "", each_alone, anywhere, law,
          "with {refit} in its place, a building's peak displacement is off by {disp_percent:+.1f} %[ ({disp_least_percent:+.1f} to {disp_most_percent:+.1f} %)] and its peak base shear by {shear_percent:+.1f} %[ ({shear_least_percent:+.1f} to {shear_most_percent:+.1f} %)] under {motions}."),
      // [records] Faults of the signals, and other reasons why a record has no cyclic properties.
      doubt(no_cyclic_properties, "no-cyclic-properties", serious, by_words, "no cyclic properties: {reason}"),
      doubt(signal_clipped, "signal-clipped", serious, by_words, "", wording::signal_clipped),
      doubt(signal_stuck, "signal-stuck", serious, by_words, "", wording::signal_stuck),
      doubt(signal_without_sign, "signal-without-sign", serious, by_words, "", wording::signal_without_sign),
      doubt(signal_wraps, "signal-wraps", serious, by_words, "", wording::signal_wraps),
      doubt(signal_interrupted, "signal-interrupted", serious, by_words, "", wording::signal_interrupted),
      doubt(signal_spike, "signal-spike", serious, by_words, "", wording::signal_spike),
      doubt(
          cycle_gives_energy, "cycle-gives-energy", serious, one_sentence,
          "<cycle {cycle} of block {block} gives back {energy_kN_mm:4} of energy>, and no device does that. Is a channel late, without its sign, or exchanged with the other?"),
      doubt(
          cycle_not_stiff, "cycle-not-stiff", serious, one_sentence,
          "<cycle {cycle} of block {block} has an effective stiffness of {K_eff_kN_per_mm:4}>, and no device does that. Does the force wrap around, or is it late, exchanged or of the other sign?"),
      doubt(
          not_cyclic, "not-cyclic", serious, one_sentence,
          "the motion is not cyclic: {regular_swings} of {swings} swings to and fro repeat an amplitude or are symmetric within 5 %, which is {travel_percent:2} % of the travel; a cyclic test has {needed_percent} % or more. Amplitudes go from {least_mm:3!} to {largest_mm:3}."),
      doubt(no_complete_cycle, "no-complete-cycle", serious, one_sentence, "", wording::no_complete_cycle),
      doubt(no_cycle_counts, "no-cycle-counts", serious, one_sentence,
            "no cycle counts: none has the amplitude and period of its block."),
      doubt(samples_too_few, "samples-too-few", serious, one_sentence,
            "{samples:.1f} samples per cycle, fewer than the {needed} that stiffness and energy need."),
      doubt(vertical_test_refused, "vertical-test-refused", serious, by_words, "vertical test: {reason}"),
      doubt(
          units_implausible, "units-implausible", serious, by_words,
          "{force_kN:4} over {way_mm:4}: {than_any}. Are displacements really in {disp_unit} and forces in {force_unit}? (--units disp=UNIT,force=UNIT)"),
      doubt(
          motion_implausible, "motion-implausible", serious, by_words,
          "the device would move by {amplitude_mm:4}[ at up to {speed_mm_s:4}], farther or faster than test rigs do. Are displacements really in {disp_unit}?[ They may be in {likely}.] (--units disp=UNIT --channel-scale disp=FACTOR)"),
      doubt(
          force_beyond_load, "force-beyond-load", serious, one_sentence,
          "the horizontal force of {force_kN:4} is {ratio:3} times the vertical load of {load_kN:4}. Are both in their right units? (--units force=UNIT,load=UNIT)"),
      doubt(vertical_stiffness_implausible, "vertical-stiffness-implausible", serious, by_words,
            "vertical test: no isolator has a vertical stiffness of {K_v_kN_per_mm:4}. Are the units right?"),
      doubt(
          vertical_softer_than_expected, "vertical-softer-than-expected", serious, one_sentence,
          "vertical test: {K_v_kN_per_mm:4} is less than {least_ratio} times the horizontal stiffness. Is it a compression test, in the units that its file states?"),
      doubt(
          time_in_days, "time-in-days", serious, one_sentence,
          "time runs <from {first_s:10} to {last_s:10} s>, {rate_Hz:4} samples a second. These look like days of a spreadsheet; try --units time=d."),
      doubt(
          about_acceleration, "about-acceleration", serious, by_words,
          "the file mentions acceleration ('{line}'), but isolaw needs the displacement of the device, one face against the other, over time."),
      doubt(
          force_lost, "force-lost", serious, one_sentence,
          "the force is suddenly lost: <{where} has {percent:3} % of {of}>. The specimen failed, or its channel did. No verdict passes the device until someone finds which; --rows or --to leaves the rest of the record out."),
      doubt(
          cycle_unlike_neighbours, "cycle-unlike-neighbours", caution, one_sentence,
          "a force differs from those of its neighbours: <the peak of cycle {cycle} of block {block} has {percent:3} % of the force in the cycles beside it>. A channel may have dropped out or changed its range in that cycle, and the values of the cycle are wrong."),
      doubt(
          stiffness_rises, "stiffness-rises", caution, one_sentence,
          "the force rises by {percent:2} %, and the stiffness with it, <from cycle {from_cycle} to cycle {cycle} of block {block}[, at about {time_s:4} s]>, at the same amplitude. Rubber softens from cycle to cycle: the gain of a channel may have changed, and K_eff of the cycles before or after is then wrong by this share."),
      doubt(force_late, "force-late", caution, by_words, "", wording::force_late),
      doubt(
          lag_grows, "lag-grows", caution, one_sentence,
          "the delay of the force behind displacement changes within the test: <{first_ms:3} ms in cycle {from_cycle} and {last_ms:3} ms in cycle {to_cycle} of block {block}; {reported_ms:3} ms in the reported cycle {cycle}> (+- {uncertainty_ms:2} ms, {reversals} reversals). The clocks of the channels may differ. The damping of the reported cycle changes by about {damping_points:2} points by it (pi f dt); --skew-ms moves all cycles by one time and cannot correct this."),
      doubt(friction_in_force, "friction-in-force", caution, one_sentence, "", wording::jump_of_force),
      doubt(
          samples_few, "samples-few", caution, one_sentence,
          "{samples:.1f} samples per cycle: energy comes out [{up_to}up to ]{energy_percent:2} % too small, and a peak up to {peak_percent:2} %. Use {wanted} or more."),
      doubt(time_uneven, "time-uneven", caution, one_sentence,
            "sampling is not uniform: <intervals from {least_s:6} to {largest_s:6} s>, {mean_s:6} s on average."),
      doubt(
          time_jumps, "time-jumps", caution, one_sentence,
          "time jumps: <{count} jump{|s} of up to {length_s:4} s, the longest after sample {sample} ({time_s:6} s); isolaw counts {taken_s:4} s of that as motion>. It estimates the time of the motion from the speed before and after the jump; periods and frequency leave out the rest."),
      doubt(
          noise, "noise", caution, one_sentence,
          "noise of {disp_mm:2} in displacement ({disp_percent:2} % of the amplitude) and of {force_kN:2} in force ({force_percent:2} %). The extremes of a cycle lie about {beyond_percent:2} % too far out and K_eff comes out at least as much too small; besides, K_eff of one cycle is uncertain by {scatter_percent:2} % (one standard deviation)."),
      doubt(
          hum, "hum", caution, by_words,
          "{channel} holds an oscillation of <{amplitude:unit3} at {frequency_Hz:4} Hz>, {percent:2} % of its amplitude, besides the motion of the test[; it may be hum of the mains' {mains_Hz} Hz][, which {rate_Hz:4} samples a second show at this frequency]. K_eff of one cycle may be wrong by up to {percent:2} %, and its damping by as much."),
      doubt(
          drift, "drift", caution, by_words,
          "{channel} drifts: the middle of its cycles moves by <{drift:unit3} through block {block}>, {percent:2} % of the whole travel (limit {limit_percent} %)."),
      doubt(
          offset_steps, "offset-steps", caution, by_words,
          "{channel} jumps by <{step:unit3}[ at about {time_s:4} s] in block {block}>, {percent:2} % of the whole travel (limit {limit_percent} %): its zero moved at once, which is no drift. The values of the cycle in which it jumps are wrong, and F/d of one side is wrong before or after."),
      doubt(
          loop_open, "loop-open", caution, one_sentence,
          "<cycle {cycle} of block {block} ends {closure_mm:3} from where it starts>, {percent:2} % of the whole travel (limit {limit_percent} %). The energy may be wrong by this gap times the force, {energy_kN_mm:3}."),
      doubt(speed_off, "speed-off", caution, by_words, "", wording::largest_speed),
      doubt(
          frequency_sweeps, "frequency-sweeps", caution, one_sentence,
          "the frequency changes from cycle to cycle, <from {first_Hz:3} Hz in the first to {last_Hz:3} Hz in the last> (a sweep). The values of a cycle belong to the frequency of that cycle, and no rule set judges these cycles by a frequency."),
      doubt(
          off_centre, "off-centre", caution, by_words,
          "{channel} is off centre by <{offset:unit4} in cycle {cycle} of block {block}>, {percent:2} % of its amplitude. This does not change peak-to-peak stiffness and energy; it changes F/d of one side and the laws. `isolaw calibrate --center` removes it."),
      doubt(
          gain_of_one_side, "gain-of-one-side", caution, one_sentence,
          "the two halves of the loop differ by a factor of {ratio:4}: <K+ is {K_plus_kN_per_mm:4} and K- {K_minus_kN_per_mm:4} in cycle {cycle} of block {block}>. The forces differ in proportion and not by a constant, so this is no offset: the gain of the force channel, or the device, differs between the two directions, and K_eff is a mean of both."),
      doubt(
          starts_off_zero, "starts-off-zero", caution, one_sentence,
          "the first sample is at {disp_mm:4}, {percent:2} % of the half range of {half_range_mm:4}; laws start at rest at zero."),
      doubt(
          several_amplitudes, "several-amplitudes", caution, one_sentence,
          "cycles of several amplitudes, the smallest {least_mm:3} and the largest {largest_mm:3}: stiffness, energy and damping are from <cycle {cycle} of block {block} at {amplitude_mm:3}>."),
      doubt(
          damping_undefined, "damping-undefined", caution, one_sentence,
          "equivalent damping is not defined: it relates the loop's energy to an effective stiffness, and hardly any of this device's force is stiffness."),
      doubt(
          average_too_wide, "average-too-wide", caution, one_sentence,
          "the moving average over {window_samples} samples, of {samples_per_cycle:3} in a cycle, removes {percent:2} % of the motion at the test's frequency and {third_harmonic_percent:2} % of its third harmonic. This affects only the laws; properties are computed from raw values. A smaller --smooth removes less."),
      doubt(tests_state_differently, "tests-state-differently", serious, each_alone,
            "the files of its tests state different values of {fact}: {values}. They may be tests of different devices."),
      doubt(shared_time_short, "shared-time-short", caution, by_words,
            "only {samples} of {of} samples are used: {file} does not cover the time of the others."),
      doubt(
          channel_interpolated, "channel-interpolated", caution, by_words,
          "{file} has a sample only every {interval_s:4} s, {other_file} every {other_interval_s:4} s: values of {file} are interpolated in between."),
      doubt(axis_taken_for_channel, "axis-taken-for-channel", caution, by_words,
            "{column} is named after the machine's axis and used as the {channel}, because the file has no other."),
      doubt(unit_overridden, "unit-overridden", caution, by_words,
            "{column} states {stated}, but is read in {used} as --units asks."),
      doubt(loads_ambiguous, "loads-ambiguous", caution, by_words,
            "{columns} may each be the {channel}, so none is read; choose one with {options}."),
      doubt(load_unit_unclear, "load-unit-unclear", caution, by_words,
            "{reason}: the vertical load is not read; state its unit with {options}."),
      doubt(velocity_unused, "velocity-unused", caution, by_words,
            "{column} is not used: velocities are computed from displacement and time."),
      doubt(
          direction_unread, "direction-unread", caution, by_words,
          "{columns} hold a second direction, whose force is not read. If the device moved in it too, the values of one direction alone do not describe the device[; --columns {option} reads its displacement too, and the page draws the orbit]."),
      doubt(
          values_uncorrected, "values-uncorrected", caution, by_words,
          "without the corrections by hand, K_eff would be {K_eff_kN_per_mm:4} instead of {now_K_eff_kN_per_mm:4}[ and damping {damping_percent:3} % instead of {now_damping_percent:3} %].[ The verdict would be {verdict} instead of {now_verdict}.][{verdict_same}]"),
      doubt(uncorrected_without_properties, "uncorrected-without-properties", caution, by_words,
            "without the corrections by hand there would be no properties: {reason}"),
      doubt(uncorrected_not_known, "uncorrected-not-known", caution, by_words,
            "isolaw does not have the record without its corrections by hand, so nothing shows what they change."),
      fact(
          viscous_device, "viscous-device",
          "a viscous device by its loop, F = F_0 +- C v^alpha with C in kN and v in mm/s: F_0 = {F_0_kN:3}, C = {C_out:4} and alpha = {alpha_out:3} while displacement rises, {C_back:4} and {alpha_back:3} while it falls; at the largest speed of {v_max_mm_s:4} the force is {out_kN:4} and {back_kN:4}. It has no effective stiffness, so neither K_eff nor damping judges anything."),
      fact(
          sliding_device, "sliding-device",
          "a sliding device by its loop: friction of {mu_percent:3} % of the vertical load of {load_kN:4} (Q_d / N)[, and a radius of {R_mm:4} (N / K_d)]. The jump of force at reversals is its own friction."),
      fact(
          samples_per_cycle, "samples-per-cycle",
          "{samples:.1f} samples per cycle: energy comes out [{up_to}up to ]{energy_percent:2} % too small, and a peak up to {peak_percent:2} %."),
      fact(force_early, "force-early", "", wording::force_early),
      fact(jump_of_force, "jump-of-force", "", wording::jump_of_force),
      fact(
          rig_friction, "rig-friction",
          "if the rig's friction were 0.5 % of the vertical load of {load_kN:4}, it would be {friction_kN:3} and add {damping_points:2} points of damping (2 F_f / (pi K D))."),
      fact(
          moving_mass, "moving-mass",
          "each tonne that moves between the device and the load cell reduces the stiffness by {stiffness_kN_per_mm:2} at {frequency_Hz:3} Hz, {percent:2} % of it (m w^2)."),
      fact(
          stands_still, "stands-still",
          "the device is at rest <for {still_s:3} s in cycle {cycle} of block {block}, longer than its period[, and so in {others} more cycle{|s}]>. Period, frequency and samples per cycle leave out that rest, but rubber recovers and cools meanwhile."),
      fact(cut_off_zero, "cut-off-zero",
           "cycles are cut where displacement passes {centre_mm:4}, the centre of the motion."),
      fact(largest_speed, "largest-speed", "", wording::largest_speed),
      fact(
          average_over_samples, "average-over-samples",
          "the moving average over {window_samples} samples, of {samples_per_cycle:3} in a cycle, removes {percent:2} % of the motion at the test's frequency and {third_harmonic_percent:2} % of its third harmonic. This affects only the laws; properties are computed from raw values."),
      fact(
          largest_swings, "largest-swings",
          "the largest swings, with an amplitude of {amplitude_mm:4} on average ({pairs} pair{|s} of neighbours), have a stiffness of {K_kN_per_mm:4} and a damping of {damping_percent:3} %."),
      fact(file_format, "file-format", stated),
      fact(header_found, "header-found", stated),
      fact(column_taken, "column-taken", stated),
      fact(columns_unused, "columns-unused", stated),
      fact(units_given, "units-given", stated),
      fact(time_scale, "time-scale", stated),
      fact(no_time_column, "no-time-column",
           "no time column: rate-dependent laws need --dt SECONDS, the sampling interval"),
      fact(rows_read, "rows-read", stated),
      fact(test_chosen, "test-chosen", stated),
      fact(file_joined, "file-joined", stated),
      fact(force_flipped, "force-flipped", "the force is multiplied by -1, as asked for (--flip-force)"),
      fact(half_cycles_count, "half-cycles-count",
           "each swing that belongs to no full cycle counts as a half cycle, with twice its energy, as asked for "
           "(--half-cycles)"),
      fact(spikes_repaired, "spikes-repaired", "", wording::spikes_repaired),
      fact(skew_removed, "skew-removed", "", wording::skew_removed),
      fact(
          friction_removed, "friction-removed",
          "the rig's friction of [{friction_kN:6}][{coefficient:6} times the vertical load] was subtracted in the direction of the motion"),
      fact(
          inertia_removed, "inertia-removed",
          "the inertia of a moving mass of {mass_kg:6} kg was subtracted, {least_kN:3!} to {largest_kN:3}; its acceleration comes from displacement averaged three times over {window_samples} samples"),
      fact(force_multiplied, "force-multiplied", "force multiplied by {factor:6}"),
      fact(
          centred, "centred",
          "centred: {disp_mm:4} subtracted from displacement and {force_kN:4} from force, (max + min) / 2 over <[cycle {cycle} of block {block}][{whole}]>"),
      fact(
          smoothed, "smoothed",
          "displacement and force averaged over {window_samples} samples, fewer at the ends[: this removes {percent:2} % of a sine of the test's frequency and {third_harmonic_percent:2} % of its third harmonic]"),
      fact(not_smoothed, "not-smoothed", "no smoothing"),
      fact(
          scored_in_part, "scored-in-part",
          "laws are judged by {samples} of {of} samples (blocks {blocks}, cycles {cycles}); the rest of the history only acts on their state"),
      fact(faulty_not_scored, "faulty-not-scored",
           "laws are not fitted to [block {block}][{outside}], in which a signal or a loop cannot be true"),
      fact(failed_not_scored, "failed-not-scored",
           "laws are [fitted to what the device did before {for_good}, in which it lost its force]"
           "[not fitted to the cycles in which the device lost its force for a time, from {for_a_time} on]"),
      fact(all_samples_kept, "all-samples-kept", "", wording::all_samples_kept),
      fact(velocity_computed, "velocity-computed",
           "velocity comes from central differences of the averaged displacement, with the recorded times"),
      fact(no_velocity, "no-velocity",
           "no velocity: the record has no time, so the number of a sample is used as time"),
      fact(
          samples_thinned, "samples-thinned",
          "thinned from {from_per_cycle:.1f} to {to_per_cycle:.1f} samples per cycle: every {every}th of {of_samples} samples kept ({samples}), each the average of {window_samples}"),
      fact(samples_weighed, "samples-weighed", "a law is fitted with weights {weights}"),
      fact(if_late_force_is_moved, "if-late-force-is-moved", "the late force channel is moved back"),
      fact(if_force_is_early, "if-force-is-early", "the force channel is early"),
      fact(if_jump_is_of_rig, "if-jump-is-of-rig", "the force's jump at reversals is friction of the rig"),
      fact(if_rig_rubs, "if-rig-rubs", "the rig's friction is 0.5 % of the vertical load"),
      // [conditions] The bound laws over the design conditions (study/design_bounds.hpp).
      campaign(
          bound_law, "bound-law", "bounds", note, "", each_alone, with_building, law,
          "{which} bound over the design conditions ({status}; {share_shown:0%} of it rests on tests at such conditions or between them): K_eff times {K_eff_factor:.3f} and energy times {energy_factor:.3f} in the reference cycle; {made}"),
      answer(no_bound_laws, "no-bound-laws", "bounds", "no bound law over the design conditions: {because}"),
  };
  // clang-format on
  static_assert(
      [] {
        for (std::size_t i = 0; i < std::size(table); ++i)
          if (table[i].kind != static_cast<FindingKind>(i)) return false;
        return true;
      }(),
      "a row for each kind, in the order of FindingKind");
  return table;
}

}  // namespace isolaw::wording
