#include "isolaw/study/recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include "isolaw/base/shell.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

constexpr double infinite = std::numeric_limits<double>::infinity();
double or_infinite(std::optional<double> const& error) {
  return error.value_or(infinite);
}

std::optional<double> error_of_fits(LawResult const& law) {
  if (law.objective_converged) return law.objective_converged;
  double sum = 0.0;
  int count = 0;
  for (auto const& fit : law.counting())
    if (fit.objective.best) sum += *fit.objective.best, ++count;
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

// True if, on some device, a block of larger amplitude than all fitted blocks was left out of the fit. The error on the
// blocks left out then shows how well the law predicts larger amplitudes.
bool larger_blocks_are_predicted(Summary const& summary, LawResult const& law) {
  for (auto const& fit : law.devices) {
    auto const device = std::ranges::find(summary.devices, fit.device, &DeviceResult::name);
    if (device == summary.devices.end() || fit.blocks.empty()) continue;
    double fitted = 0.0, predicted = 0.0;
    for (auto const& block : fit.blocks) {
      auto const found = std::ranges::find(device->properties.blocks, block.block, &data::Block::number);
      if (found == device->properties.blocks.end()) continue;
      auto& largest = block.fitted ? fitted : predicted;
      largest = std::max(largest, found->amplitude_mm);
    }
    if (predicted > fitted) return true;
  }
  return false;
}

std::optional<double> prediction_of_larger(Summary const& summary, LawResult const& law) {
  if (law.predicted_objective && larger_blocks_are_predicted(summary, law)) return law.predicted_objective;
  return law.larger_swings_objective;
}

std::size_t searched_parameters(LawResult const& law) {
  return static_cast<std::size_t>(std::ranges::count_if(parameters_of(law), &ParameterFit::free));
}

std::optional<double> share_open(LawResult const& law) {
  int examined = 0, open = 0;
  for (auto const& fit : law.counting())
    for (auto const& parameter : fit.parameters) {
      if (!parameter.analysis) continue;
      ++examined;
      open += parameter.analysis->identifiability == analysis::Verdict::undetermined ? 1 : 0;
    }
  return examined > 0 ? std::optional(static_cast<double>(open) / examined) : std::nullopt;
}

// The number of devices to which laws can be fitted. Devices with the same record count once.
std::size_t counting_devices(Summary const& summary) {
  return static_cast<std::size_t>(std::ranges::count_if(
      summary.devices, [](DeviceResult const& device) { return device.status == "ok" && device.counts(); }));
}

bool identified_on_every_device(Summary const& summary, LawResult const& law) {
  auto fits = law.counting();
  auto const identified = std::ranges::count_if(fits, [](auto const& fit) { return fit_status(fit) == "ok"; });
  return static_cast<std::size_t>(identified) == counting_devices(summary);
}

std::optional<Finding> ruled_out(Summary const& summary, LawResult const& law) {
  if (!law.objective.mean) return Finding{.kind = FindingKind::out_not_identified, .law = law.id};
  if (!identified_on_every_device(summary, law)) return Finding{.kind = FindingKind::out_partial, .law = law.id};
  if (!law.prediction_holds())
    return Finding{.kind = FindingKind::out_prediction,
                   .law = law.id,
                   .words = {{"grade", std::string(name(*law.prediction_grade))}}};
  if (law.larger_swings_objective && !std::isfinite(*law.larger_swings_objective))
    return Finding{.kind = FindingKind::out_runs_away, .law = law.id, .words = {{"rule", "not-finite-larger"}}};
  if (!law.runs_away) return std::nullopt;
  auto reason = *law.runs_away;
  reason.kind = FindingKind::out_runs_away;
  return reason;
}

// The mean over the devices of the measured damping [%] of the reported cycle or, without it, of the largest swings.
// Infinite if no device has either.
double measured_damping_percent(Summary const& summary) {
  double sum = 0.0, count = 0.0;
  for (auto const& device : summary.devices) {
    if (!device.counts()) continue;
    auto const swings = std::ranges::find(device.notes, FindingKind::largest_swings, &Finding::kind);
    if (auto const& reported = device.properties.reported; reported && reported->damping())
      sum += reported->damping_percent, ++count;
    else if (swings != device.notes.end())
      sum += swings->number("damping_percent"), ++count;
  }
  return count > 0.0 ? sum / count : infinite;
}

// Adds doubts about the stiffness and damping of the law in the cycles of the tests and in those that a building may
// ask for.
void add_doubts_about_cycles(Summary const& summary, LawResult const& law, std::vector<Finding>& doubts) {
  auto const add = [&](FindingKind kind, double percent) {
    doubts.push_back({.kind = kind, .law = law.id, .numbers = {{"percent", percent}}});
  };
  // A relative error is infinite where the measured value is 0. It then says nothing about the law, so it counts as 0.
  auto const error = [&](std::optional<double> DeviceFit::*of) {
    auto const mean = mean_magnitude(law, of);
    return mean && std::isfinite(*mean) ? *mean : 0.0;
  };
  if (double const percent = error(&DeviceFit::K_eff_error_percent); percent > doubtful_stiffness_percent)
    add(FindingKind::weak_cycle_stiffness, percent);
  double const measured = measured_damping_percent(summary);
  double const energy = error(&DeviceFit::energy_error_percent), damping = error(&DeviceFit::damping_error_percent);
  if (measured >= small_damping_percent && energy > doubtful_energy_percent)
    add(FindingKind::weak_cycle_energy, energy);
  else if (measured < small_damping_percent && damping / 100.0 * measured > doubtful_damping_points)
    add(FindingKind::weak_cycle_damping, damping);
  if (!law.beyond_tests) return;
  auto const& beyond = *law.beyond_tests;
  auto const add_ratio = [&](FindingKind kind, double ratio, double low) {
    if (ratio >= low && ratio <= high_ratio) return;
    doubts.push_back({.kind = kind,
                      .law = law.id,
                      .numbers = {{"ratio", ratio}, {"asked_mm", beyond.asked_mm}, {"tested_mm", beyond.tested_mm}}});
  };
  add_ratio(FindingKind::weak_stiffness_beyond, beyond.stiffness_ratio, low_stiffness_ratio);
  add_ratio(FindingKind::weak_damping_beyond, beyond.damping_ratio, low_damping_ratio);
}

// The displacement that the design asks for, if the tests reach less than half of it.
std::optional<double> asked_far_beyond(LawResult const& law) {
  // If no design displacement is stated, asked_mm is twice tested_mm. The 1e-9 keeps this case from counting as far.
  constexpr double far = 2.0 * (1.0 + 1e-9);
  if (!law.beyond_tests || law.beyond_tests->asked_mm <= far * law.beyond_tests->tested_mm) return std::nullopt;
  return law.beyond_tests->asked_mm;
}

bool identifies_several(Summary const& summary) {
  return std::ranges::count_if(summary.laws, [&](auto const& law) {
           return law.objective.mean && identified_on_every_device(summary, law);
         }) > 1;
}

// Finds the first device whose tests reach less than half as far to one side as to the other.
std::optional<Finding> one_sided(Summary const& summary) {
  for (auto const& device : summary.devices) {
    if (device.record.size() == 0) continue;
    auto const [least, most] = std::ranges::minmax(device.record.disp_mm);
    auto const [near, far] = std::minmax({std::max(0.0, most), std::max(0.0, -least)});  // copies, not references
    if (near < 0.5 * far)
      return Finding{.kind = FindingKind::weak_one_sided,
                     .devices = {device.name},
                     .numbers = {{"far_mm", far}, {"near_mm", near}}};
  }
  return std::nullopt;
}

std::vector<Finding> doubts_about(Summary const& summary, Standing const& standing) {
  auto const& law = summary.laws[standing.law];
  std::vector<Finding> doubts;
  auto const add = [&](FindingKind kind, std::vector<FindingNumber> numbers = {}) {
    doubts.push_back({.kind = kind, .law = law.id, .numbers = std::move(numbers)});
  };
  if (or_infinite(standing.error) > doubtful_error)
    add(FindingKind::weak_error, {{"error", or_infinite(standing.error)}});
  auto const add_times = [&](FindingKind kind, std::optional<double> const& error) {
    if (error && standing.fits && *error > doubtful_times * *standing.fits)
      add(kind, {{"times", *error / *standing.fits}});
  };
  if (!larger_blocks_are_predicted(summary, law))
    add_times(FindingKind::weak_larger_swings, law.larger_swings_objective);
  if (law.prediction_grade == PredictionGrade::fair)
    add(FindingKind::weak_prediction_fair);
  else
    add_times(FindingKind::weak_other_blocks, law.predicted_objective);
  add_doubts_about_cycles(summary, law, doubts);
  if (auto found = one_sided(summary)) doubts.push_back(std::move(*found));
  if (auto const far = asked_far_beyond(law))
    add(FindingKind::weak_far_beyond, {{"asked_mm", *far}, {"times", *far / law.beyond_tests->tested_mm}});
  if (!identifies_several(summary)) add(FindingKind::weak_only_law);
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) add(FindingKind::weak_incomplete);
  if (summary.conditions_differ) add(FindingKind::weak_conditions);
  if (law.success_share && *law.success_share < found_share)
    add(FindingKind::weak_search, {{"share", *law.success_share}});
  if (auto const held = pinned(law); held.decides()) {
    doubts.push_back(held.finding(law.id));
    doubts.back().kind = FindingKind::weak_bounds;
  }
  // Undetermined parameters are a doubt only if no prediction by the law was compared with tests. Such a comparison
  // shows directly how well the law does with them.
  if (!law.prediction_grade && !standing.predicts)
    if (auto const share = share_open(law); share && *share > open_share)
      add(FindingKind::weak_open, {{"share", *share}});
  return doubts;
}

Standing standing_of(Summary const& summary, std::size_t index) {
  constexpr std::size_t devices_of_a_lot = 3;
  auto const& law = summary.laws[index];
  Standing standing{.law = index,
                    .fits = error_of_fits(law),
                    .new_device = law.loo_objective,
                    .predicts = prediction_of_larger(summary, law),
                    .error = {},
                    .parameters = searched_parameters(law),
                    .reason = ruled_out(summary, law)};
  bool const is_lot = law.loo_objective && counting_devices(summary) >= devices_of_a_lot;
  standing.error = is_lot ? standing.new_device : standing.fits;
  if (standing.error && standing.predicts) standing.error = 0.5 * (*standing.error + *standing.predicts);
  if (!standing.error && standing.predicts) standing.error = standing.predicts;
  if (standing.reason)
    standing.rank = Rank::ruled_out;
  else
    standing.doubts = doubts_about(summary, standing);
  return standing;
}

std::vector<Standing> standings_of(Summary const& summary) {
  std::vector<Standing> standings;
  for (std::size_t i = 0; i < summary.laws.size(); ++i) standings.push_back(standing_of(summary, i));
  return standings;
}

// Sorts the laws by error; laws that are ruled out come last. Laws tie if their error is near the least one
// (tie_share). Among tied laws, the one with the fewest parameters is taken and comes first.
void rank(std::vector<Standing>& standings) {
  std::ranges::stable_sort(standings, {}, [](Standing const& s) { return or_infinite(s.error); });
  std::ranges::stable_sort(standings, {}, [](Standing const& s) { return s.reason.has_value(); });
  auto const count = static_cast<std::size_t>(
      std::ranges::count_if(standings, [](Standing const& s) { return !s.reason.has_value(); }));
  if (count == 0) return;
  double const most = (1.0 + tie_share) * or_infinite(standings.front().error);
  std::size_t tied = 0;
  for (; tied < count && or_infinite(standings[tied].error) <= most; ++tied) standings[tied].rank = Rank::tied;
  std::ranges::stable_sort(standings.begin(), standings.begin() + static_cast<std::ptrdiff_t>(tied), {},
                           &Standing::parameters);
  standings.front().rank = Rank::taken;
}

bool predicts_blocks(Summary const& summary) {
  return std::ranges::any_of(summary.laws, [](auto const& law) { return law.predicted_objective.has_value(); });
}

std::vector<Finding> what_would_decide(Summary const& summary, bool predicts, bool open) {
  constexpr std::size_t few = 5;
  auto const devices = counting_devices(summary);
  std::vector<Finding> steps;
  auto const add = [&](FindingKind kind) { steps.push_back({.kind = kind}); };
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) add(FindingKind::surer_finish);
  if (open && !identifies_several(summary)) add(FindingKind::surer_other_laws);
  if (one_sided(summary)) add(FindingKind::surer_both_sides);
  for (auto const& law : summary.laws)
    if (auto const far = asked_far_beyond(law)) {
      steps.push_back({.kind = FindingKind::surer_design, .numbers = {{"asked_mm", *far}}});
      break;
    }
  if (!predicts) {
    bool const several = std::ranges::any_of(summary.devices, [](auto const& device) {
      return device.status == "ok" && device.properties.blocks.size() > 1;
    });
    add(several && !predicts_blocks(summary) ? FindingKind::surer_fit_blocks : FindingKind::surer_other_amplitude);
  } else if (open) {
    add(FindingKind::surer_further_test);
  }
  if (devices == 1 || (open && devices < few))
    steps.push_back(
        {.kind = FindingKind::surer_more_devices, .numbers = {{"devices_tested", static_cast<double>(devices)}}});
  if (open && steps.empty()) add(FindingKind::surer_amplitude_between);
  return steps;
}

// The reasons why no law is recommended; empty if a law is recommended.
std::vector<Finding> why_none(Summary const& summary, std::vector<Standing> const& standings) {
  Names failing, partial, running_away, tied;
  for (auto const& s : standings) {
    auto const& id = summary.laws[s.law].id;
    if (!s.reason) {
      if (s.rank != Rank::behind) tied.push_back(id);
    } else if (s.reason->kind == FindingKind::out_prediction) {
      failing.push_back(id);
    } else if (s.reason->kind == FindingKind::out_partial) {
      partial.push_back(id);
    } else if (s.reason->kind == FindingKind::out_runs_away) {
      running_away.push_back(id);
    }
  }
  auto const& best = standings.front();
  if (!best.reason) {
    double least = infinite;
    for (auto const& s : standings)
      if (!s.reason) least = std::min(least, or_infinite(s.error));
    if (!(least <= usable_error))
      return {{.kind = FindingKind::none_describes,
               .law = summary.laws[best.law].id,
               .numbers = {{"error", least}, {"most", usable_error}}}};
    bool const energy_is_off = std::ranges::all_of(standings, [](Standing const& s) {
      return (s.rank != Rank::taken && s.rank != Rank::tied) ||
             std::ranges::find(s.doubts, FindingKind::weak_cycle_energy, &Finding::kind) != s.doubts.end();
    });
    if (!energy_is_off) return {};
    return {{.kind = FindingKind::none_energy,
             .other_laws = std::move(tied),
             .numbers = {{"most", doubtful_energy_percent / 100.0}}}};
  }
  std::vector<Finding> reasons;
  auto const add = [&](FindingKind kind, Names laws) {
    if (!laws.empty()) reasons.push_back({.kind = kind, .other_laws = std::move(laws)});
  };
  add(FindingKind::none_predicts, std::move(failing));
  add(FindingKind::none_for_a_building, std::move(running_away));
  add(FindingKind::none_on_every_device, std::move(partial));
  if (reasons.empty()) reasons.push_back({.kind = FindingKind::none_identified});
  return reasons;
}

std::vector<Finding> why_taken(Summary const& summary, std::vector<Standing> const& standings) {
  std::vector<Finding> why;
  auto const next = std::ranges::find(standings, Rank::behind, &Standing::rank);
  if (next != standings.end() && next->error)
    why.push_back(
        {.kind = FindingKind::why_next, .law = summary.laws[next->law].id, .numbers = {{"error", *next->error}}});
  auto const better = std::ranges::find_if(standings, [&](Standing const& s) {
    return s.reason && or_infinite(s.error) < or_infinite(standings.front().error);
  });
  if (better != standings.end())
    why.push_back({.kind = FindingKind::why_better_refused,
                   .law = summary.laws[better->law].id,
                   .numbers = {{"error", *better->error}}});
  return why;
}

std::vector<Finding> answer_of(Summary const& summary, Recommendation const& advice) {
  auto const& taken = advice.standings.front();
  auto const& law = summary.laws[taken.law];
  Finding errors{.kind = FindingKind::law_errors, .law = law.id};
  for (auto const& s : advice.standings)
    if (s.rank == Rank::tied) errors.other_laws.push_back(summary.laws[s.law].id);
  bool const is_lot = taken.new_device.has_value();
  errors.numbers.push_back({"fits", or_infinite(is_lot ? taken.new_device : taken.fits)});
  if (taken.predicts)
    errors.numbers.push_back({taken.predicts == law.larger_swings_objective ? "predicts" : "blocks", *taken.predicts});
  else if (law.predicted_objective)
    errors.numbers.push_back({"blocks", *law.predicted_objective});
  errors.words = {{"fitted_to", is_lot ? "devices" : "tests"}, {"larger", taken.predicts ? "known" : "unknown"}};
  return {
      {.kind = FindingKind::law_recommended, .law = law.id, .words = {{"sure", std::string(name(advice.confidence))}}},
      std::move(errors)};
}

std::optional<LawSpread> spread_of(Summary const& summary, std::vector<Standing> const& standings) {
  constexpr std::size_t most = 5;
  std::vector<Standing const*> best;
  for (auto const& s : standings)
    if (!s.reason && s.error && summary.laws[s.law].beyond_tests) best.push_back(&s);
  std::ranges::stable_sort(best, {}, [](Standing const* s) { return *s->error; });
  best.resize(std::min(best.size(), most));
  if (best.size() < 2) return std::nullopt;
  auto const in = [&](double BeyondTests::*member) {
    return std::ranges::minmax(
        best | std::views::transform([&](Standing const* s) { return (*summary.laws[s->law].beyond_tests).*member; }));
  };
  auto const K = in(&BeyondTests::K_kN_per_mm), energy = in(&BeyondTests::energy_kN_mm);
  return LawSpread{.count = best.size(),
                   .disp_mm = summary.laws[best.front()->law].beyond_tests->asked_mm,
                   .tested_mm = summary.laws[best.front()->law].beyond_tests->tested_mm,
                   .K_low_kN_per_mm = K.min,
                   .K_high_kN_per_mm = K.max,
                   .energy_low_kN_mm = energy.min,
                   .energy_high_kN_mm = energy.max};
}

}  // namespace

std::string_view name(Rank rank) {
  constexpr std::string_view names[]{"taken", "ties", "behind", "ruled out"};
  return names[static_cast<std::size_t>(rank)];
}

std::string_view name(Confidence confidence) {
  constexpr std::string_view names[]{"clear", "tie", "weak"};
  return names[static_cast<std::size_t>(confidence)];
}

bool compares_laws(Summary const& summary) {
  return std::ranges::count_if(summary.laws, [](auto const& law) { return law.objective.mean.has_value(); }) > 1;
}

std::string export_command(Summary const& summary, Recommendation const& advice, std::string_view campaign) {
  if (!advice.law) return {};
  auto const& law = summary.laws[*advice.law];
  return shell_quoted(std::vector<std::string>{"isolaw", "export", std::string(campaign), "--law", law.id, "--device",
                                               law.lot ? "lot" : device_names(summary).front(), "--to",
                                               advice.programs ? "openseespy-law" : "openseespy"});
}

Finding finding_of(LawSpread const& spread) {
  return {.kind = FindingKind::laws_disagree,
          .numbers = {{"count", static_cast<double>(spread.count)},
                      {"disp_mm", spread.disp_mm},
                      {"K_low_kN_per_mm", spread.K_low_kN_per_mm},
                      {"K_high_kN_per_mm", spread.K_high_kN_per_mm},
                      {"energy_low_kN_mm", spread.energy_low_kN_mm},
                      {"energy_high_kN_mm", spread.energy_high_kN_mm}},
          .words = {{"beyond", spread.disp_mm > 1.01 * spread.tested_mm ? "yes" : "no"}}};
}

std::optional<Recommendation> recommendation(Summary const& summary) {
  if (summary.laws.empty()) return std::nullopt;
  Recommendation advice;
  advice.standings = standings_of(summary);
  rank(advice.standings);
  auto const& best = advice.standings.front();
  advice.spread = spread_of(summary, advice.standings);
  if (advice.spread) advice.range_findings.push_back(finding_of(*advice.spread));
  advice.reasons = why_none(summary, advice.standings);
  if (!advice.reasons.empty()) {
    for (auto& s : advice.standings)
      if (!s.reason) s.rank = Rank::behind;
    advice.answer = {{.kind = FindingKind::no_law_recommended}};
    advice.improvements = what_would_decide(summary, best.predicts.has_value(), true);
    return advice;
  }
  auto const& law = summary.laws[best.law];
  advice.law = best.law;
  bool const ties = advice.standings.size() > 1 && advice.standings[1].rank == Rank::tied;
  advice.confidence = !best.doubts.empty() ? Confidence::weak : ties ? Confidence::tie : Confidence::clear;
  advice.reasons = why_taken(summary, advice.standings);
  advice.answer = answer_of(summary, advice);
  advice.improvements = what_would_decide(summary, best.predicts.has_value(), advice.confidence != Confidence::clear);
  advice.valid_mm = largest_displacement(summary, law);
  if (advice.valid_mm)
    advice.range_findings.insert(
        advice.range_findings.begin(),
        {.kind = FindingKind::law_shown_up_to, .law = law.id, .numbers = {{"disp_mm", *advice.valid_mm}}});
  if (!law.in_programs) advice.programs = Finding{.kind = FindingKind::not_in_opensees, .law = law.id};
  return advice;
}

}  // namespace isolaw::study
