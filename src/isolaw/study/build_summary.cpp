#include "isolaw/study/build_summary.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

#include "isolaw/base/error.hpp"
#include "isolaw/base/number_text.hpp"
#include "isolaw/base/version.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/data/cycles/swing_sizes.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/properties/swing_properties.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/lot/robustness.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/study/acceptance.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/energy_fall.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/lot_conditions.hpp"
#include "isolaw/study/range_test.hpp"
#include "isolaw/study/uncorrected.hpp"

namespace isolaw::study {
namespace {

// True if the only reason why a record has no reported cycle is that its motion is not cyclic. If the properties were
// computed from a TestRecord, its signals are then sound, since a fault would be another reason. If they were computed
// from a CycleView, the signals were not checked.
bool is_irregular(data::Properties const& properties) {
  return !properties.reported && std::ranges::all_of(properties.refusal, [](Finding const& finding) {
    return finding.kind == FindingKind::not_cyclic || finding.kind == FindingKind::no_complete_cycle ||
           finding.kind == FindingKind::no_cycle_counts;
  });
}

using Runs = std::vector<campaign::Run const*>;

Statistic statistic(std::vector<double> const& values) {
  if (values.empty()) return {};
  auto const m = num::moments(values);
  Statistic result{.mean = m.mean, .std = std::nullopt, .best = std::nullopt};
  if (m.count > 1) result.std = m.std;
  return result;
}

template <class Get>
std::vector<double> collect(Runs const& runs, Get&& get) {
  std::vector<double> values;
  for (auto const* run : runs) values.push_back(get(*run));
  return values;
}

void add_vertical(DeviceResult& result) {
  auto& test = result.vertical_test;
  if (!test.is_given()) return;
  try {
    if (test.refusal.empty()) result.vertical = data::vertical_stiffness(test);
  } catch (Error const& error) {
    test.refusal = error.what();
  }
  auto& warnings = result.raw.warnings;
  if (!test.refusal.empty())
    warnings.push_back({.kind = FindingKind::vertical_test_refused, .words = {{"reason", test.refusal}}});
  if (result.vertical) std::ranges::copy(result.vertical->warnings, std::back_inserter(warnings));
  // Isolators carry weight, so they are far stiffer vertically than horizontally. A vertical stiffness below this many
  // times the horizontal stiffness is implausible.
  constexpr double least_ratio = 3.0;
  auto const& reported = result.properties.reported;
  if (result.vertical && reported && result.vertical->K_v_kN_per_mm < least_ratio * reported->K_eff_kN_per_mm)
    warnings.push_back({.kind = FindingKind::vertical_softer_than_expected,
                        .numbers = {{"K_v_kN_per_mm", result.vertical->K_v_kN_per_mm}, {"least_ratio", least_ratio}}});
}

rules::VerticalValue vertical_value(DeviceResult const& device) {
  rules::VerticalValue value;
  if (!device.vertical_test.refusal.empty()) value.reason = "vertical test: " + device.vertical_test.refusal;
  if (!device.vertical) return value;
  value.K_v_kN_per_mm = device.vertical->K_v_kN_per_mm;
  value.formula = device.vertical->description;
  return value;
}

// For each sample, whether it lies in a large swing. Laws that were fitted to the small swings are judged on the large
// ones. Empty if the tests have no such swings.
std::vector<bool> in_large_swings(data::FitRecord const& record, std::optional<data::Weighting> weighting) {
  auto const sizes = data::swing_sizes(data::tests_of(record), weighting.value_or(data::Weighting::swing));
  if (!sizes.shows_larger_swings) return {};
  std::vector<bool> inside;
  auto const ranges = data::test_ranges(record.starts, record.size());
  for (std::size_t t = 0; t < ranges.size(); ++t)
    for (std::size_t i = 0; i < ranges[t].size(); ++i)
      inside.push_back(i < sizes.tests[t].large.size() && sizes.tests[t].large[i] > 0.0);
  return inside;
}

DeviceResult device_result(campaign::Device const& device, data::CleanOptions const& clean) {
  int const smooth = clean.smooth;
  DeviceResult result;
  result.name = device.name;
  result.file = device.file;
  result.sha256 = device.raw.sha256;
  result.status = device.usable() ? "ok" : "refused";
  result.message = device.refusal;
  result.copy_of = device.copy_of;
  result.complaints = device.complaints;
  result.serial = device.info.serial;
  result.lot = device.info.lot;
  result.test_date = device.info.test_date;
  result.temperature_C = device.info.temperature_C;
  result.rubber_thickness_mm = device.info.rubber_thickness_mm;
  result.rubber_area_mm2 = device.info.rubber_area_mm2;
  result.raw = device.raw;
  result.record = device.record;
  if (device.record.size() > 0) result.in_large_swings = in_large_swings(device.record, clean.weights);
  result.vertical_test = device.vertical;
  if (device.uncorrected.size() > 0) result.uncorrected = data::cyclic_properties(device.uncorrected);
  if (device.usable())
    result.properties = data::cyclic_properties(device.raw);
  else
    result.properties.refusal = {{.kind = FindingKind::no_cyclic_properties, .words = {{"reason", device.refusal}}}};
  add_vertical(result);
  if (!device.usable()) return result;
  auto budget = data::error_budget(device.raw, result.properties, smooth);
  result.notes = std::move(budget.notes);
  if (is_irregular(result.properties))
    if (auto const swings = data::swing_properties(device.raw))
      result.notes.push_back({.kind = FindingKind::largest_swings,
                              .numbers = {{"pairs", static_cast<double>(swings->pairs)},
                                          {"amplitude_mm", swings->amplitude_mm},
                                          {"K_kN_per_mm", swings->K_kN_per_mm},
                                          {"damping_percent", swings->damping_percent}}});
  result.effects = std::move(budget.effects);
  // The record has the warnings about its unsmoothed signals. Smoothing may cause others, which are added here.
  if (smooth > 1) {
    auto const read = data::error_budget(device.raw, result.properties).warnings;
    for (auto const& warning : budget.warnings)
      if (std::ranges::find(read, warning) == read.end()) result.raw.warnings.push_back(warning);
  }
  return result;
}

ParameterFit parameter_fit(fit::SearchParameter const& searched, std::size_t index, Runs const& usable,
                           campaign::Run const* best) {
  ParameterFit fitted;
  fitted.name = searched.name;
  fitted.unit = searched.unit;
  fitted.free = searched.free;
  fitted.lower = searched.lower;
  fitted.upper = searched.upper;
  fitted.value = statistic(collect(usable, [&](campaign::Run const& run) { return run.parameters[index]; }));
  if (best == nullptr) return fitted;
  fitted.value.best = best->parameters[index];
  fitted.at_bound = fit::at_bound(searched, *fitted.value.best);
  return fitted;
}

// The cycle in which law and test are compared: normally the reported cycle. If the law was fitted to some cycles only,
// it is the third of these (or the last, if there are fewer) in the block of largest amplitude that has any of them.
std::optional<data::Cycle> compared_cycle(data::Properties const& measured, data::FitRecord const& record) {
  if (record.scored.empty() || !measured.reported) return measured.reported;
  auto const is_scored = [&](data::Cycle const& cycle) {
    return record.is_scored(std::min(record.size() - 1, static_cast<std::size_t>((cycle.first + cycle.last) / 2.0)));
  };
  std::optional<data::Cycle> chosen;
  double largest = 0.0;
  for (auto const& block : measured.blocks) {
    std::vector<data::Cycle const*> scored;
    for (auto const* cycle : block.counted())
      if (is_scored(*cycle)) scored.push_back(cycle);
    if (scored.empty() || block.amplitude_mm <= largest) continue;
    largest = block.amplitude_mm;
    chosen = *scored[std::min<std::size_t>(scored.size(), 3) - 1];
  }
  return chosen;
}

// Sets the law's errors in one test: in the cycle of compared_cycle() or, if the motion is not cyclic, on the largest
// swings (motions from one turning point to the next). If the test has neither, the errors stay empty.
void compare_properties(TestFit& fitted, data::FitRecord const& record, std::span<double const> force_kN) {
  auto const time = record.has_time() ? std::span<double const>(record.time_s) : std::span<double const>();
  auto const measured = data::cyclic_properties(data::CycleView{record.disp_mm, record.force_kN, time, {}});
  auto const error = [](double value, double truth) {
    return truth != 0.0 ? std::optional(100.0 * (value - truth) / truth) : std::nullopt;
  };
  if (auto const reference = compared_cycle(measured, record)) {
    auto const computed = data::properties_on(*reference, record.disp_mm, force_kN);
    fitted.energy_error_percent = error(computed.energy_kN_mm, reference->energy_kN_mm);
    if (measured.viscous) return;  // a viscous device has no stiffness that could be compared
    fitted.K_eff_error_percent = error(computed.K_eff_kN_per_mm, reference->K_eff_kN_per_mm);
    fitted.damping_error_percent = error(computed.damping_percent, reference->damping_percent);
    return;
  }
  auto const swings = data::scored_swings(record);
  auto const reference = data::properties_on(swings, record.disp_mm, record.force_kN);
  if (!is_irregular(measured) || !(reference.K_kN_per_mm > 0.0)) return;
  auto const computed = data::properties_on(swings, record.disp_mm, force_kN);
  fitted.K_eff_error_percent = error(computed.K_kN_per_mm, reference.K_kN_per_mm);
  fitted.energy_error_percent = error(computed.energy_kN_mm, reference.energy_kN_mm);
  fitted.damping_error_percent = error(computed.damping_percent, reference.damping_percent);
}

// Compares law and measurement in every test. The errors of the device are the largest of its tests.
void compare_tests(DeviceFit& fitted, data::FitRecord const& record, std::vector<data::TestSource> const& sources) {
  auto const time = record.has_time() ? std::span<double const>(record.time_s) : std::span<double const>();
  auto const measured =
      data::cyclic_properties(data::CycleView{record.disp_mm, record.force_kN, time, {}, record.starts});
  fitted.energy_fall = energy_fall(measured, record, fitted.force_kN);
  auto const tests = data::tests_of(record);
  auto const ranges = data::test_ranges(record.starts, record.size());
  std::vector<TestFit> all;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    auto const force = ranges[t].slice(fitted.force_kN);
    auto& one = all.emplace_back();
    if (t < sources.size()) one.test = sources[t].name;
    if (double const misfit = fit::objective_on(tests[t], force, tests[t].scored); !std::isnan(misfit))
      one.objective = misfit;
    compare_properties(one, tests[t], force);
  }
  auto const worst = [&](std::optional<double> TestFit::*error) {
    std::optional<double> largest;
    for (auto const& one : all)
      if (one.*error && (!largest || std::abs(*(one.*error)) > std::abs(*largest))) largest = one.*error;
    return largest;
  };
  fitted.K_eff_error_percent = worst(&TestFit::K_eff_error_percent);
  fitted.energy_error_percent = worst(&TestFit::energy_error_percent);
  fitted.damping_error_percent = worst(&TestFit::damping_error_percent);
  if (all.size() > 1) fitted.tests = std::move(all);
}

DeviceFit device_fit(campaign::Contents const& contents, campaign::Search const& search, Runs const& runs) {
  auto const& device = contents.devices[search.device];
  DeviceFit fitted;
  fitted.device = device.name;
  fitted.counts = device.counts();
  fitted.refusal = search.refusal;
  if (!search.refusal.empty()) return fitted;

  Runs usable;
  for (auto const* run : runs) {
    if (run->usable()) usable.push_back(run);
    fitted.histories.push_back(run->history);
  }
  fitted.runs = static_cast<int>(runs.size());
  fitted.missing_runs = contents.settings.runs - fitted.runs;
  fitted.failed_runs = static_cast<int>(runs.size() - usable.size());
  if (runs.empty()) fitted.failure = "no run has finished yet";
  for (auto const* run : runs) {
    fitted.evaluations += static_cast<std::uint64_t>(run->evaluations);
    fitted.failed_evaluations += static_cast<std::uint64_t>(run->failed_evaluations);
    if (fitted.failure.empty()) fitted.failure = run->failure;
  }
  campaign::Run const* best = nullptr;
  for (auto const* run : usable)
    if (best == nullptr || run->objective < best->objective) best = run;

  fitted.objective = statistic(collect(usable, [](campaign::Run const& run) { return run.objective; }));
  auto const& law = laws::find_law(search.law);
  for (std::size_t i = 0; i < search.box.parameters.size(); ++i) {
    fitted.parameters.push_back(parameter_fit(search.box.parameters[i], i, usable, best));
    fitted.parameters.back().paper_name = law.parameters[law.index_of(fitted.parameters.back().name)].paper_name;
  }
  for (std::size_t i = 0; i < search.box.parameters.size(); ++i)
    if (auto const other = search.box.parameters[i].tied_to)
      fitted.parameters[i].tied_to = search.box.parameters[*other].name;
  if (best == nullptr) return fitted;

  fitted.objective.best = best->objective;
  auto const worst = std::ranges::max(usable, {}, [](campaign::Run const* run) { return run->objective; });
  if (best->objective > 0.0) fitted.runs_apart = worst->objective / best->objective - 1.0;
  fitted.integration_shift = best->integration_shift;
  fit::LawOnRecord const model(laws::find_law(search.law), device.record, contents.settings.integration,
                               contents.settings.turning_points, best->refinement);
  fitted.force_kN = model.force_kN(best->parameters);
  if (!device.record.weights.empty()) {
    auto by_time = device.record;
    by_time.weights.clear();
    fitted.objective_by_time = fit::objective_on(by_time, fitted.force_kN, by_time.scored);
  }
  fitted.refinement = best->refinement;
  compare_tests(fitted, device.record, device.raw.tests);
  add_analysis(fitted, contents, search);
  if (auto const* found = contents.analysis_of(search.device, search.law); found != nullptr && found->larger_swings)
    fitted.larger_swings_force_kN = model.force_kN(found->larger_swings->parameters);
  return fitted;
}

std::vector<double> means_of(LawResult const& law, std::size_t parameter) {
  std::vector<double> means;
  for (auto const& fit : law.counting())
    if (fit.objective.mean) means.push_back(*fit.parameters[parameter].value.mean);
  return means;
}

void add_lot_statistics(LawResult& law) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> device_means;
  auto const is_identified = [](DeviceFit const& fit) { return fit.counts && fit.objective.mean; };
  auto const first = std::ranges::find_if(law.devices, is_identified);
  if (first == law.devices.end()) {
    law.beta_note = "no device was identified";
    return;
  }
  for (std::size_t i = 0; i < first->parameters.size(); ++i) {
    auto const means = means_of(law, i);
    bool const compared = first->parameters[i].free && means.size() > 1;
    auto const differences = compared ? lot::percent_differences(means) : std::vector<double>{};
    for (std::size_t d = 0, k = 0; d < law.devices.size(); ++d)
      if (is_identified(law.devices[d]) && k < differences.size())
        law.devices[d].parameters[i].percent_of_lot = differences[k++];
    if (!first->parameters[i].free) continue;
    names.push_back(first->parameters[i].name);
    device_means.push_back(means);
  }
  auto const robustness = lot::robustness_index(names, device_means);
  law.beta = robustness.beta;
  law.beta_note = robustness.note;
}

bool in_programs(LawResult const& law, laws::LawEntry const& entry) {
  auto const fit = std::ranges::find_if(law.devices, [](auto const& f) { return f.objective.best.has_value(); });
  if (fit == law.devices.end()) return false;
  std::vector<double> values;
  for (auto const& parameter : fit->parameters) values.push_back(*parameter.value.best);
  return !std::holds_alternative<laws::NoForm>(entry.canonical(values));
}

void add_accuracy(LawResult& law, std::vector<double> const& all_objectives) {
  std::vector<double> means;
  for (auto const& fit : law.counting())
    if (fit.objective.mean) means.push_back(*fit.objective.mean);
  if (means.empty()) return;
  law.objective = statistic(all_objectives);
  law.objective.mean = num::moments(means).mean;
  law.objective.best = *std::ranges::min_element(all_objectives);
}

}  // namespace

bool conditions_refused(Summary const& summary) {
  return !summary.no_conditions.empty() || (summary.conditions && !summary.conditions->refused.empty());
}

bool acceptance_failed(Summary const& summary) {
  if (summary.conditions && dependence_failed(*summary.conditions)) return true;
  return lot_failed(summary.acceptance) || std::ranges::any_of(summary.devices, [](auto const& device) {
           return any_failed(device.acceptance.assessments);
         });
}

void add_acceptance(Summary& summary, rules::RuleSet const& rules, rules::Design const& design,
                    std::optional<int> lot_size) {
  std::vector<AssessedTest> tests;
  for (auto const& device : summary.devices)
    tests.push_back({.device = device.name,
                     .properties = &device.properties,
                     .rubber_thickness_mm = device.rubber_thickness_mm,
                     .rubber_area_mm2 = device.rubber_area_mm2,
                     .vertical = vertical_value(device),
                     .copy_of = device.status == "ok" ? device.copy_of : std::string()});
  std::vector<DeviceAcceptance> devices;
  summary.acceptance = assess_lot(rules, design, lot_size, tests, devices, summary.asked.alike);
  if (summary.conditions && summary.conditions->mean_properties)
    summary.acceptance.conditions_forbid_mean = summary.conditions->mean_properties->permitted == false;
  for (std::size_t d = 0; d < devices.size(); ++d) summary.devices[d].acceptance = std::move(devices[d]);
  summary.conditions_differ = conditions_differ(summary);
  if (summary.conditions_differ) withhold_lot_verdicts(summary.acceptance);
  add_uncorrected(summary, std::move(tests));
}

Summary build_summary(campaign::Contents const& contents) {
  Summary summary;
  summary.version = version();
  summary.makers = campaign::builds(contents.makers);
  summary.title = contents.title;
  summary.seed = contents.settings.seed;
  summary.runs = contents.runs.size();
  summary.expected_runs = contents.expected_runs();
  summary.part = contents.part;
  summary.expected_here = contents.expected_here();
  summary.analyses = contents.analyses();
  summary.expected_analyses = contents.expected_analyses();
  for (auto const& [key, json] : campaign::to_pairs(contents.settings))
    if (key != "seed") summary.settings.push_back({key, json});
  for (auto const& device : contents.devices) summary.devices.push_back(device_result(device, contents.settings.clean));

  for (auto const& id : contents.settings.laws) {
    auto const& entry = laws::find_law(id);
    LawResult law;
    law.id = id;
    law.title = std::string(entry.info.title);
    if (!entry.info.note.empty()) law.notes.emplace_back(entry.info.note);
    std::vector<double> all_objectives;
    for (auto const& search : contents.searches) {
      if (search.law != id) continue;
      Runs runs;
      auto const key = [](campaign::Run const& run) { return std::pair(run.device, std::string_view(run.law)); };
      std::pair const wanted(search.device, std::string_view(id));
      for (auto run = std::ranges::lower_bound(contents.runs, wanted, {}, key);
           run != contents.runs.end() && key(*run) == wanted; ++run) {
        runs.push_back(&*run);
        if (run->usable() && contents.devices[search.device].counts()) all_objectives.push_back(run->objective);
      }
      law.devices.push_back(device_fit(contents, search, runs));
    }
    law.in_programs = in_programs(law, entry);
    add_accuracy(law, all_objectives);
    add_lot_statistics(law);
    add_lot_analysis(law, contents);
    summary.laws.push_back(std::move(law));
  }
  mark_front(
      summary.laws, [](auto const& law) { return law.beta; }, [](auto const& law) { return law.objective.mean; },
      &LawResult::on_front);
  add_converged_views(summary);
  if (contents.observed) try {
      summary.conditions = build_conditions(*contents.observed, contents.title, contents.acceptance);
    } catch (Error const& error) {
      summary.no_conditions = to_string(error.complaints().front());
    }
  auto const& asked = summary.asked = contents.acceptance;
  add_acceptance(summary, asked.rules.empty() ? rules::RuleSet{} : rules::read_rule_text(asked.rules, asked.rules_file),
                 asked.design.empty() ? rules::Design{} : rules::parse_design(asked.design), asked.lot_size);
  add_range_tests(summary, contents);
  return summary;
}

}  // namespace isolaw::study
