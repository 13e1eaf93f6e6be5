#include "isolaw/render/page/page_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/base/symbol.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/data/properties/remainder.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/json/properties_json.hpp"
#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/acceptance_results.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/building_results.hpp"
#include "isolaw/study/command.hpp"
#include "isolaw/study/condition_curves.hpp"
#include "isolaw/study/conditions_results.hpp"
#include "isolaw/study/cycle_results.hpp"
#include "isolaw/study/drawn_samples.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/front_view.hpp"
#include "isolaw/study/law_look.hpp"
#include "isolaw/study/published_results.hpp"
#include "isolaw/study/typical_device.hpp"
#include "isolaw/study/value_doubts.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::render {
namespace {

constexpr int profile_digits = 6;
constexpr double curve_levels = 20000.0;
constexpr std::size_t convergence_points = 120;

// Rounds each value to a whole number of steps of 1/20,000 of the curve's range, and writes the differences between
// neighbours. The differences are integers, so a reader can add them up without error. In place of a value that is not
// finite it writes the previous value again.
void write_curve(JsonWriter& out, std::string_view key, std::vector<double> const& values,
                 std::vector<std::size_t> const& samples) {
  double lower = 0.0, upper = 0.0;
  bool first = true;
  for (std::size_t const i : samples) {
    if (!std::isfinite(values[i])) continue;
    lower = first ? values[i] : std::min(lower, values[i]);
    upper = first ? values[i] : std::max(upper, values[i]);
    first = false;
  }
  double const step = upper > lower ? (upper - lower) / curve_levels : 1.0;
  out.key(key).begin_object();
  write_members(out, "o", lower, "s", step);
  int before = 0;
  out.key("d").array(samples, [&](std::size_t i) {
    int const level = std::isfinite(values[i]) ? static_cast<int>(std::lround((values[i] - lower) / step)) : before;
    out.value(level - std::exchange(before, level));
  });
  out.end_object();
}

// Divides about two million points among all curves, so that a page of 160 devices stays small. A curve gets from 300
// to 2400 points.
std::size_t points_per_curve(Summary const& summary) {
  bool const predicts =
      std::ranges::any_of(summary.laws, [](auto const& law) { return law.larger_swings_objective.has_value(); });
  std::size_t const of_laws = (predicts ? 2 : 1) * summary.laws.size();
  std::size_t const curves = std::max<std::size_t>(1, summary.devices.size() * (of_laws + 5));
  return std::clamp<std::size_t>(2'000'000 / curves, 300, 2400);
}

std::size_t stride_of(std::vector<std::size_t> const& drawn) {
  return drawn.size() > 1 ? drawn[1] - drawn[0] : 1;
}

template <class Record>
void write_curves(JsonWriter& out, Record const& record, std::vector<std::size_t> const& drawn) {
  if (drawn.empty()) return;
  if (!record.time_s.empty()) write_curve(out, "time_s", record.time_s, drawn);
  write_curve(out, "disp_mm", record.disp_mm, drawn);
  write_curve(out, "force_kN", record.force_kN, drawn);
}

// Writes the remainder of a doubtful channel, or null. The remainder is the signal minus the mean cycle of its block.
// Point k of the curve is the sample first + min(k stride, samples - 1). The points of `gaps` have no value.
void write_remainder(JsonWriter& out, DeviceResult const& device, std::size_t most) {
  out.key("remainder");
  auto const found = data::remainder(device.raw, device.properties);
  if (!found) return void(out.null());
  auto const drawn = drawn_samples(found->values.size(), most);
  out.object([&] {
    write_members(out, "block", found->block, "first", found->first, "samples", found->values.size(), "stride",
                  stride_of(drawn));
    write_values(out.key("at"), found->at, shown_digits);
    write_curve(out, found->of_force ? "force_kN" : "disp_mm", found->values, drawn);
    std::vector<std::size_t> gaps;
    for (std::size_t k = 0; k < drawn.size(); ++k)
      if (std::isnan(found->values[drawn[k]])) gaps.push_back(k);
    out.key("gaps").array(gaps, [&](std::size_t k) { out.value(static_cast<double>(k)); });
  });
}

// Writes the raw record. Point k of a curve is the sample min(k stride, samples - 1).
void write_raw(JsonWriter& out, data::TestRecord const& raw, std::size_t most) {
  auto const drawn = drawn_samples(raw.size(), most);
  out.key("raw").object([&] {
    write_members(out, "samples", raw.size(), "stride", stride_of(drawn));
    write_curves(out, raw, drawn);
    if (!raw.second_disp_mm.empty()) write_curve(out, "second_disp_mm", raw.second_disp_mm, drawn);
  });
}

// Writes the time ranges of those samples for whose index inside(i) is true.
template <class Inside>
void write_ranges(JsonWriter& out, data::FitRecord const& record, Inside const& inside) {
  out.begin_array();
  for (std::size_t i = 0; i < record.size(); ++i) {
    auto const first = i;
    while (i < record.size() && inside(i)) ++i;
    if (i > first) out.object([&] { write_members(out, "from", record.time_s[first], "to", record.time_s[i - 1]); });
  }
  out.end_array();
}

// Writes the time ranges of the record that the laws were fitted to, or null for the whole record. Also writes the time
// ranges of the large swings, which laws predict after a fit to the small swings. A swing is the motion from one
// turning point to the next.
void write_parts(JsonWriter& out, DeviceResult const& device) {
  auto const& record = device.record;
  out.key("scored");
  if (record.scored.empty())
    out.null();
  else
    write_ranges(out, record, [&](std::size_t i) { return record.is_scored(i); });
  write_ranges(out.key("large_swings"), record,
               [&](std::size_t i) { return i < device.in_large_swings.size() && device.in_large_swings[i]; });
}

void write_device(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device,
                  std::vector<Finding> const& findings, std::vector<std::size_t> const& drawn, std::size_t most) {
  auto const& record = device.record;
  write_members(out, "name", device.name, "file", device.file, "sha256", device.sha256, "status", device.status,
                "message", device.message, "serial", device.serial, "lot", device.lot, "test_date", device.test_date);
  out.member("temperature_C", device.temperature_C).member("rubber_thickness_mm", device.rubber_thickness_mm);
  out.member("rubber_area_mm2", device.rubber_area_mm2);
  write_properties(out, lot, device, unit_systems);
  write_tests(out, device);
  write_raw(out, device.raw, most);
  write_remainder(out, device, most);
  out.key("recognised").objects(device.raw.recognised, [&](Finding const& finding) {
    write_said(out.key("sentence"), unit_systems, [&](auto const& units) { return wording::remark(finding, units); });
    out.member("option", finding.word("option"));
  });
  write_remarks(out.key("warnings"), findings, unit_systems);
  write_remarks(out.key("cleaning"), record.cleaning, unit_systems);
  write_findings(out, "findings", findings, wording::anywhere, unit_systems);
  write_parts(out, device);
  out.key("record").object([&] {
    write_members(out, "samples", record.size(), "drawn", drawn.size(), "has_time", record.has_time());
    write_curves(out, record, drawn);
  });
}

// The results of a parameter that are the same on every device are written only once for each law.
constexpr auto of_the_law = columns(parameter_results, {"unit", "free", "paper_name"});

// Writes one array for each property of the parameters, so that a fit does not repeat the properties' names.
void write_parameter_columns(JsonWriter& out, std::vector<ParameterFit> const& parameters) {
  for (auto const& row : parameter_results)
    if (std::ranges::find(of_the_law, row.key, &Result<ParameterFit>::key) == of_the_law.end())
      out.key(row.key).array(parameters, [&](auto const& one) { write_value(out, row.value(one), row.digits); });
}

void write_examined(JsonWriter& out, Result<ParameterAnalysis> const& row,
                    std::optional<ParameterAnalysis> const& analysis) {
  auto const value = analysis ? row.value(*analysis) : Value();
  if (std::holds_alternative<study::Nested>(value))
    write_profile(out, *analysis, row.digits);
  else
    write_value(out, value, row.digits);
}

// Writes one array for each property, with null for a parameter that was not examined. Writes null without an analysis.
void write_determination(JsonWriter& out, DeviceFit const& fit) {
  out.key("determination");
  if (!fit.optimum) return void(out.null());
  out.object([&] {
    for (auto const& row : analysis_results)
      out.key(row.key).array(fit.parameters, [&](auto const& one) { write_examined(out, row, one.analysis); });
  });
}

// Writes how the searches of a law on a device converge. A step is a generation or a start of a search. After a step,
// each run has a best objective so far; the smallest, median and largest over the runs are written as log10. A run
// that has ended keeps its last value. Writes null if there is only one step, or if no run has an objective above 0.
void write_convergence(JsonWriter& out, DeviceFit const& fit) {
  std::vector<std::vector<double>> runs;
  std::size_t steps = 0;
  for (auto const& history : fit.histories) {
    if (history.empty() || !(history.back() > 0.0)) continue;
    runs.push_back(history);
    steps = std::max(steps, history.size());
  }
  out.key("convergence");
  if (runs.empty() || steps < 2) return void(out.null());
  std::vector<double> lowest, median, highest;
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<double> values;
    for (auto const& run : runs) values.push_back(run[std::min(i, run.size() - 1)]);
    auto const [least, most] = std::ranges::minmax(values);
    lowest.push_back(std::log10(least));
    median.push_back(std::log10(num::median(values)));
    highest.push_back(std::log10(most));
  }
  auto const drawn = drawn_samples(steps, convergence_points);
  out.object([&] {
    write_members(out, "steps", steps, "stride", stride_of(drawn), "runs", runs.size());
    write_curve(out, "lowest", lowest, drawn);
    write_curve(out, "median", median, drawn);
    write_curve(out, "highest", highest, drawn);
  });
}

void write_fit(JsonWriter& out, DeviceFit const& fit, int device, std::vector<std::size_t> const& drawn) {
  out.member("device", device);
  write_results(out, fit_results, fit, Digits::shown, [&](std::string_view key) {
    if (key == "blocks") return write_rows(out, score_results, fit.blocks, Digits::shown);
    if (key == "tests") return write_rows(out, test_results, fit.tests, Digits::shown);
    out.object([&] {
      if (key == "intervals") return write_results(out, interval_results, fit, Digits::all);
      write_parameter_columns(out, fit.parameters);
    });
  });
  write_determination(out, fit);
  write_convergence(out, fit);
  auto const write_force = [&](std::string_view key, std::vector<double> const& force) {
    if (!drawn.empty() && drawn.back() < force.size())
      write_curve(out, key, force, drawn);
    else
      out.key(key).null();
  };
  write_force("force_kN", fit.force_kN);
  write_force("larger_swings_force_kN", fit.larger_swings_force_kN);
}

void write_lot_law(JsonWriter& out, LotLaw const& lot) {
  write_results(out, lot_law_results, lot, Digits::shown, [&](std::string_view key) {
    write_values(out, key == "parameters" ? lot.parameters : lot.worst_parameters, shown_digits);
  });
  out.key("at_bound").objects(lot.at_bound, [&](auto const& bound) {
    auto const& [parameter, side] = bound;
    out.member("parameter", parameter).member("side", name(side));
  });
}

// Writes the population of a law's parameters over the devices, without covariances, because the page draws only
// correlations.
void write_population(JsonWriter& out, lot::Population const& population) {
  out.member("devices", std::uint64_t{population.devices}).member("parameters", population.names);
  write_values(out.key("medians"), population.medians, shown_digits);
  write_values(out.key("relative_std"), population.relative_std, profile_digits);
  out.key("correlation").array(population.correlation, [&](auto const& row) {
    write_values(out, row, profile_digits);
  });
  out.member("note", population.note);
}

void write_fits(JsonWriter& out, Summary const& summary, LawResult const& law,
                std::vector<std::vector<std::size_t>> const& drawn) {
  out.begin_array();
  for (auto const& fit : law.devices) {
    auto const found = std::ranges::find(summary.devices, fit.device, &DeviceResult::name);
    if (found == summary.devices.end()) continue;
    auto const index = static_cast<std::size_t>(found - summary.devices.begin());
    out.object([&] { write_fit(out, fit, static_cast<int>(index), drawn[index]); });
  }
  out.end_array();
}

void write_law(JsonWriter& out, Summary const& summary, LawResult const& law,
               std::vector<std::vector<std::size_t>> const& drawn) {
  write_results(out, law_results, law, Digits::shown, [&](std::string_view key) {
    if (key == "devices")
      write_fits(out, summary, law, drawn);
    else if (key == "lot" && law.lot)
      out.object([&] { write_lot_law(out, *law.lot); });
    else if (key == "population" && law.population)
      out.object([&] { write_population(out, *law.population); });
    else
      out.null();
  });
  write_members(out, "K_eff_error_percent", mean_magnitude(law, &DeviceFit::K_eff_error_percent),
                "energy_error_percent", mean_magnitude(law, &DeviceFit::energy_error_percent));
  std::size_t n = 0;
  out.key("parameters").objects(parameters_of(law), [&](ParameterFit const& parameter) {
    out.member("name", parameter.name);
    for (auto const& row : of_the_law) write_value(out.key(row.key), row.value(parameter), row.digits);
    write_members(out, "delta", largest_difference(law, n++));
  });
}

void write_conclusions(JsonWriter& out, Summary const& summary) {
  auto const found = findings(summary);
  write_recommendation(out, summary, found.recommendation, unit_systems);
  out.member("headline", wording::paragraph(found.headline)).member("beta_note", found.beta_note);
  out.key("verdicts").objects(found.verdicts, [&](auto const& verdict) {
    write_members(out, "law", verdict.law, "role", verdict.role, "sentence",
                  wording::paragraph(verdict.findings, record_units, " ", false), "dominated_by", verdict.dominated_by);
  });
  write_findings(out, "warnings", found.warnings, wording::in_report, unit_systems);
  // Writes the positions, in the list of warnings, of the warnings that concern the recommended law.
  std::uint64_t place = 0;
  out.key("answer_warnings").array(wording::grouped(found.warnings), [&](auto const& group) {
    if (found.recommendation && std::ranges::any_of(group, [&](Finding const& warning) {
          return concerns_answer(summary, *found.recommendation, warning);
        }))
      out.value(place);
    ++place;
  });
  write_findings(out, "converged", found.converged, wording::anywhere, unit_systems);
}

void write_condition_curves(JsonWriter& out, Summary const& summary) {
  if (!summary.conditions) return;
  constexpr int digits = 6;
  out.key("condition_curves").objects(condition_curves(*summary.conditions), [&](ConditionCurve const& curve) {
    write_members(out, "quantity", curve.quantity, "effect", curve.effect, "kind", curve.kind, "device", curve.device,
                  "unit", unit_of(curve.effect));
    write_values(out.key("at"), curve.at, digits);
    write_values(out.key("lambda"), curve.lambda, digits);
  });
}

void write_shown(JsonWriter& out, Summary const& summary) {
  out.key("by_objective").array(by_objective(summary), [&](std::size_t law) {
    if (summary.laws[law].objective.mean) out.value(std::uint64_t{law});
  });
  write_members(out, "typical_device", typical_device(summary));
  out.key("stands").object([&] {
    for (auto const view : front_views)
      out.key(key(view)).array(front_points(summary, view), [&](auto const& point) {
        if (point.is_unbeaten) out.value(point.law);
      });
  });
}

// Writes the limits by which isolaw chooses the words of verdicts, since the page states these limits.
void write_thresholds(JsonWriter& out) {
  out.key("thresholds").begin_object();
  out.member("found_within", found_within).member("determined_within", analysis::determined_within);
  out.member("weakly_determined_within", analysis::weakly_determined_within);
  out.member("good_prediction", good_prediction).member("fair_prediction", fair_prediction);
  out.member("poor_prediction", poor_prediction).member("collapsed_objective", collapsed_objective);
  out.member("collapsed_ratio", collapsed_ratio).member("collapsed_least", collapsed_least);
  out.end_object();
}

template <class Of, std::size_t count>
void write_headings(JsonWriter& out, std::string_view kind, Result<Of> const (&rows)[count]) {
  out.key(kind).begin_object();
  for (auto const& row : rows) {
    if (row.heading.empty()) continue;
    out.key(row.key).objects(study::headings(row), [&](auto const& heading) {
      out.member("title", heading.title).member("unit", heading.unit);
      if (row.printed.decimals) out.member("decimals", *row.printed.decimals);
      if (row.printed.significant) out.member("significant", *row.printed.significant);
    });
  }
  out.end_object();
}

void write_all_headings(JsonWriter& out) {
  out.key("headings").begin_object();
  write_headings(out, "laws", law_results);
  write_headings(out, "lot_laws", lot_law_results);
  write_headings(out, "fits", fit_results);
  write_headings(out, "parameters", parameter_results);
  write_headings(out, "determination", analysis_results);
  write_headings(out, "scores", score_results);
  write_headings(out, "outliers", outlier_results);
  write_headings(out, "published_laws", study::published_law_results);
  write_headings(out, "published_statements", study::published_statement_results);
  write_headings(out, "blocks", block_results);
  write_headings(out, "cycles", cycle_results);
  write_headings(out, "stability", stability_results);
  write_headings(out, "vertical", vertical_results);
  write_headings(out, "levels", level_results);
  write_headings(out, "skeleton", skeleton_results);
  write_headings(out, "assessments", assessment_results);
  write_headings(out, "quantities", quantity_results);
  write_headings(out, "test_factors", test_factor_results);
  write_headings(out, "lot_outliers", lot_outlier_results);
  write_headings(out, "factors", factor_results);
  write_headings(out, "conditions_tests", study::conditions_test_results);
  write_headings(out, "conditions_cycles", study::conditions_cycle_results);
  write_headings(out, "conditions_levels", study::conditions_level_results);
  write_headings(out, "conditions_factors", study::conditions_factor_results);
  out.end_object().key("followed").objects(followed_properties, [&](auto const& followed) {
    auto const& [name, key, property] = followed;
    out.member("name", name).member("key", key);
  });
}

Notation notation_of(Summary const& summary) {
  Notation notation;
  for (auto const& law : summary.laws)
    for (auto const& parameter : parameters_of(law)) {
      notation.parameters.insert(parameter.name);
      if (!parameter.paper_name.empty()) notation.parameters.insert(parameter.paper_name);
    }
  for (auto const& device : summary.devices) notation.devices.insert(device.name);
  return notation;
}

}  // namespace

void write_units(JsonWriter& out, UnitSystem const& shown) {
  out.key("units").begin_object().member("chosen", shown.id);
  out.key("systems").objects(unit_systems, [&](UnitSystem const& system) {
    out.member("id", system.id).key("units").object([&] {
      for (auto const& stored : result_units)
        out.key(stored.unit).object([&] {
          auto const unit = shown_unit(stored.unit, system);
          out.member("unit", unit.unit).member("factor", unit.factor);
        });
    });
  });
  out.key("endings").array(
      result_units, [&](auto const& stored) { out.begin_array().value(stored.ending).value(stored.unit).end_array(); });
  // The keys of numbers whose unit is in another member of the same object. "o" and "s" belong to curves, "from" and
  // "width" to histograms, "value_at_reference" to bounds over the design conditions.
  std::set<std::string_view> own{"o", "s", "from", "width", "value_at_reference"};
  auto const add = [&](auto const& rows) {
    for (auto const& row : rows)
      if (row.unit == study::own_unit) own.insert(row.key);
  };
  add(assessment_results), add(quantity_results), add(lot_outlier_results), add(factor_results);
  add(conditions_level_results), add(doubt_results), add(outlier_results), add(study::distribution_results),
      add(study::judged_results);
  out.key("own").array(own, [&](auto key) { out.value(key); });
  out.end_object();
}

void write_notation(JsonWriter& out, Notation const& of) {
  out.key("symbols").array(law_looks, [&](auto const& look) { out.value(look.symbol); });
  // Returns whether the name can only mean a parameter where it stands in a sentence. This is so for a name with a
  // digit, such as "a10", because no English word has one, unless a device has the same name.
  auto const is_no_other_word = [&](std::string_view name) {
    return name.size() > 1 && std::ranges::any_of(name, is_digit) && !of.devices.contains(name);
  };
  std::set<std::string_view> words;
  for (auto const word : symbol_words()) words.insert(word);
  for (auto const name : of.parameters)
    if (symbol_of(name).is_greek() || is_no_other_word(name)) words.insert(name);
  // Each name is written with its symbol as [letter, index].
  auto const write = [&](std::string_view key, std::set<std::string_view> const& names) {
    out.key(key).begin_object();
    for (auto const name : names) {
      auto const symbol = symbol_of(name);
      out.key(name).begin_array().value(symbol.letter).value(symbol.index).end_array();
    }
    out.end_object();
  };
  out.key("notation").begin_object();
  write("words", words);
  write("parameters", of.parameters);
  out.end_object();
}

std::string page_data_json(Summary const& summary) {
  auto const most = points_per_curve(summary);
  std::vector<std::vector<std::size_t>> drawn;
  for (auto const& device : summary.devices) drawn.push_back(drawn_samples(device.record.size(), most));

  JsonWriter out;
  out.begin_object();
  auto const seed = std::to_string(summary.seed);  // as text, since a JavaScript number does not hold 64 bits
  write_members(out, "isolaw", campaign::text(std::span(summary.makers)), "title", summary.title, "seed", seed, "runs",
                summary.runs, "missing_runs", summary.missing_runs(), "missing_analyses", summary.missing_analyses(),
                "letterhead", summary.asked.letterhead, "command", command_again(summary), "takes_lot_file",
                takes_lot_file(summary));
  write_settings(out, summary);
  out.key("findings").object([&] { write_conclusions(out, summary); });
  write_units(out, summary.units());
  write_shown(out, summary);
  write_rows(out.key("outliers"), outlier_results, summary.outliers, Digits::shown);
  write_conditions(out, summary);
  write_condition_curves(out, summary);
  write_published(out, summary, Digits::shown);
  write_thresholds(out);
  write_all_headings(out);
  write_notation(out, notation_of(summary));
  write_verdict(out, overall_verdict(summary));
  out.key("assessment");
  write_acceptance(out, summary.acceptance);
  auto const of_devices = device_warnings(summary);
  std::size_t i = 0;
  out.key("devices").objects(summary.devices, [&](DeviceResult const& device) {
    write_device(out, summary.acceptance, device, of_devices[i], drawn[i], most);
    ++i;
  });
  out.key("laws").objects(summary.laws, [&](LawResult const& law) { write_law(out, summary, law, drawn); });
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
