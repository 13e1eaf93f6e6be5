#include "isolaw/render/page/page_data.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/base/json.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/render/json/properties_json.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/command.hpp"
#include "isolaw/study/drawn_samples.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

constexpr int digits = 9;
constexpr int profile_digits = 6;
constexpr double curve_levels = 20000.0;
constexpr std::size_t convergence_points = 120;

void write(JsonWriter& out, Statistic const& statistic) {
  out.begin_object();
  out.key("mean").rounded(statistic.mean, digits);
  out.key("std").rounded(statistic.std, digits);
  out.key("best").rounded(statistic.best, digits);
  out.end_object();
}

// Integer differences of the quantised values; the steps do not add up to a drift. Not finite: the value before.
void write_curve(JsonWriter& out, std::vector<double> const& values, std::vector<std::size_t> const& samples) {
  double lower = 0.0, upper = 0.0;
  bool first = true;
  for (std::size_t const i : samples) {
    if (!std::isfinite(values[i])) continue;
    lower = first ? values[i] : std::min(lower, values[i]);
    upper = first ? values[i] : std::max(upper, values[i]);
    first = false;
  }
  double const step = upper > lower ? (upper - lower) / curve_levels : 1.0;
  out.begin_object();
  out.key("o").rounded(lower, digits).key("s").rounded(step, digits);
  out.key("d").begin_array();
  int before = 0;
  for (std::size_t const i : samples) {
    int const level = std::isfinite(values[i]) ? static_cast<int>(std::lround((values[i] - lower) / step)) : before;
    out.value(level - before);
    before = level;
  }
  out.end_array().end_object();
}

// The page shares about two million drawn points among all curves, so that 160 devices stay small.
std::size_t points_per_curve(Summary const& summary) {
  std::size_t const curves = std::max<std::size_t>(1, summary.devices.size() * (summary.laws.size() + 5));
  return std::clamp<std::size_t>(2'000'000 / curves, 300, 2400);
}

// The raw loop, thinned: sample k of the curves is raw sample min(k stride, samples - 1).
void write_raw(JsonWriter& out, data::TestRecord const& raw, std::size_t most) {
  auto const drawn = drawn_samples(raw.size(), most);
  out.key("raw").begin_object();
  out.member("samples", std::uint64_t{raw.size()});
  out.member("stride", std::uint64_t{drawn.size() > 1 ? drawn[1] - drawn[0] : 1});
  if (!drawn.empty()) {
    if (raw.has_time()) {
      out.key("time_s");
      write_curve(out, raw.time_s, drawn);
    }
    out.key("disp_mm");
    write_curve(out, raw.disp_mm, drawn);
    out.key("force_kN");
    write_curve(out, raw.force_kN, drawn);
  }
  out.end_object();
}

// Ranges of time that laws are judged by; null: all of it.
void write_scored(JsonWriter& out, data::FitRecord const& record) {
  out.key("scored");
  if (record.scored.empty()) {
    out.null();
    return;
  }
  out.begin_array();
  for (std::size_t i = 0; i < record.size();) {
    auto const first = i;
    while (i < record.size() && record.is_scored(i)) ++i;
    if (i > first) {
      out.begin_object().key("from").rounded(record.time_s[first], digits);
      out.key("to").rounded(record.time_s[i - 1], digits).end_object();
    } else {
      ++i;
    }
  }
  out.end_array();
}

void write_device(JsonWriter& out, DeviceResult const& device, std::vector<std::size_t> const& drawn,
                  std::size_t most) {
  out.begin_object();
  out.member("name", device.name).member("file", device.file).member("sha256", device.sha256);
  out.member("status", device.status).member("message", device.message);
  out.member("serial", device.serial).member("lot", device.lot).member("test_date", device.test_date);
  out.member("temperature_C", device.temperature_C).member("rubber_thickness_mm", device.rubber_thickness_mm);
  out.member("rubber_area_mm2", device.rubber_area_mm2);
  write_properties(out, device);
  write_raw(out, device.raw, most);
  out.member("recognised", device.raw.recognised).member("warnings", device.raw.warnings);
  out.member("cleaning", device.record.cleaning);
  auto const& record = device.record;
  write_scored(out, record);
  out.key("record").begin_object();
  out.member("samples", std::uint64_t{record.size()}).member("drawn", std::uint64_t{drawn.size()});
  out.member("has_time", record.has_time());
  if (!drawn.empty()) {
    out.key("time_s");
    write_curve(out, record.time_s, drawn);
    out.key("disp_mm");
    write_curve(out, record.disp_mm, drawn);
    out.key("force_kN");
    write_curve(out, record.force_kN, drawn);
  }
  out.end_object().end_object();
}

void write_values(JsonWriter& out, std::vector<double> const& values, int to_digits) {
  out.begin_array();
  for (double const value : values) out.rounded(value, to_digits);
  out.end_array();
}

// A property of all parameters of a fit; their names stand once, in the law.
template <class Of>
void write_column(JsonWriter& out, std::string_view name, std::vector<ParameterFit> const& parameters, Of const& of) {
  out.key(name).begin_array();
  for (auto const& parameter : parameters) of(parameter);
  out.end_array();
}

// Columns, not rows: the names of the properties stand once a fit.
void write_parameters(JsonWriter& out, std::vector<ParameterFit> const& parameters) {
  auto const column = [&](std::string_view name, auto const& of) {
    write_column(out, name, parameters, [&](ParameterFit const& parameter) { out.rounded(of(parameter), digits); });
  };
  out.key("parameters").begin_object();
  column("mean", [](auto const& p) { return p.value.mean; });
  column("std", [](auto const& p) { return p.value.std; });
  column("best", [](auto const& p) { return p.value.best; });
  column("percent_of_lot", [](auto const& p) { return p.percent_of_lot; });
  write_column(out, "at_bound", parameters, [&](auto const& p) { out.value(p.at_bound); });
  column("lower", [](auto const& p) { return p.lower; });
  column("upper", [](auto const& p) { return p.upper; });
  out.end_object();
}

// Columns; a parameter that was not examined is null in each. Null as a whole without an analysis.
void write_determination(JsonWriter& out, DeviceFit const& fit) {
  out.key("determination");
  if (!fit.optimum) {
    out.null();
    return;
  }
  auto const column = [&](std::string_view name, auto const& write) {
    write_column(out, name, fit.parameters, [&](ParameterFit const& parameter) {
      parameter.analysis ? write(*parameter.analysis) : static_cast<void>(out.null());
    });
  };
  auto const number = [&](std::string_view name, auto member, int to_digits) {
    column(name, [&](ParameterAnalysis const& a) { out.rounded(a.*member, to_digits); });
  };
  auto const curve = [&](std::string_view name, auto member) {
    column(name, [&](ParameterAnalysis const& a) { write_values(out, a.*member, profile_digits); });
  };
  out.begin_object();
  column("identifiability", [&](auto const& a) { out.value(a.identifiability); });
  number("optimum", &ParameterAnalysis::optimum, digits);
  number("open_lower", &ParameterAnalysis::open_lower, profile_digits);
  number("open_upper", &ParameterAnalysis::open_upper, profile_digits);
  column("open_below", [&](auto const& a) { out.value(a.open_below); });
  column("open_above", [&](auto const& a) { out.value(a.open_above); });
  number("linear_lower", &ParameterAnalysis::linear_lower, profile_digits);
  number("linear_upper", &ParameterAnalysis::linear_upper, profile_digits);
  number("bootstrap_lower", &ParameterAnalysis::bootstrap_lower, profile_digits);
  number("bootstrap_upper", &ParameterAnalysis::bootstrap_upper, profile_digits);
  curve("profile_value", &ParameterAnalysis::profile_value);
  curve("profile_objective", &ParameterAnalysis::profile_objective);
  out.end_object();
}

void write_analysis(JsonWriter& out, DeviceFit const& fit) {
  out.key("success_share").rounded(fit.success_share, digits);
  out.member("success_reference", fit.success_reference);
  out.key("optimum").rounded(fit.optimum, digits);
  out.key("rise").rounded(fit.rise, digits);
  write_determination(out, fit);
  out.member("trade_offs", fit.trade_offs);
  out.key("intervals").begin_object();
  out.member("level", fit.interval_level).member("samples", std::uint64_t{fit.interval_samples});
  out.member("block", std::uint64_t{fit.interval_block}).member("replicates", fit.interval_replicates).end_object();
  out.key("lot_objective").rounded(fit.lot_objective, digits);
  out.key("worst_objective").rounded(fit.worst_objective, digits);
  out.key("left_out_objective").rounded(fit.left_out_objective, digits);
  out.key("blocks").begin_array();
  for (auto const& score : fit.blocks) {
    out.begin_object().member("block", score.block).member("fitted", score.fitted);
    out.key("objective").rounded(score.objective, digits).end_object();
  }
  out.end_array();
}

// How the runs came down: decimal logarithms of the smallest, median and largest best objective so far over the runs, after
// each generation or start; a run that ended earlier keeps its last.
void write_convergence(JsonWriter& out, DeviceFit const& fit) {
  std::vector<std::vector<double>> runs;
  std::size_t steps = 0;
  for (auto const& history : fit.histories) {
    if (history.empty() || !(history.back() > 0.0)) continue;
    runs.push_back(history);
    steps = std::max(steps, history.size());
  }
  out.key("convergence");
  if (runs.empty() || steps < 2) {
    out.null();
    return;
  }
  std::vector<double> lowest, median, highest;
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<double> values;
    for (auto const& run : runs) values.push_back(run[std::min(i, run.size() - 1)]);
    std::ranges::sort(values);
    auto const n = values.size();
    lowest.push_back(std::log10(values.front()));
    median.push_back(std::log10(0.5 * (values[(n - 1) / 2] + values[n / 2])));
    highest.push_back(std::log10(values.back()));
  }
  auto const drawn = drawn_samples(steps, convergence_points);
  out.begin_object().member("steps", std::uint64_t{steps});
  out.member("stride", std::uint64_t{drawn.size() > 1 ? drawn[1] - drawn[0] : 1});
  out.member("runs", std::uint64_t{runs.size()});
  out.key("lowest");
  write_curve(out, lowest, drawn);
  out.key("median");
  write_curve(out, median, drawn);
  out.key("highest");
  write_curve(out, highest, drawn);
  out.end_object();
}

void write_fit(JsonWriter& out, DeviceFit const& fit, int device, std::vector<std::size_t> const& drawn) {
  out.begin_object();
  out.member("device", device).member("status", fit_status(fit));
  out.member("message", fit.refusal.empty() ? fit.failure : fit.refusal);
  out.member("runs", fit.runs).member("failed_runs", fit.failed_runs);
  out.member("evaluations", fit.evaluations).member("failed_evaluations", fit.failed_evaluations);
  out.key("objective");
  write(out, fit.objective);
  out.key("K_eff_error_percent").rounded(fit.K_eff_error_percent, digits);
  out.key("energy_error_percent").rounded(fit.energy_error_percent, digits);
  out.key("damping_error_percent").rounded(fit.damping_error_percent, digits);
  out.key("integration_shift").rounded(fit.integration_shift, digits);
  write_parameters(out, fit.parameters);
  write_analysis(out, fit);
  write_convergence(out, fit);
  out.key("force_kN");
  bool const has_curve = !drawn.empty() && drawn.back() < fit.force_kN.size();
  if (has_curve) {
    write_curve(out, fit.force_kN, drawn);
  } else {
    out.null();
  }
  out.end_object();
}

void write_lot_law(JsonWriter& out, std::optional<LotLaw> const& lot) {
  out.key("lot");
  if (!lot) {
    out.null();
    return;
  }
  out.begin_object();
  out.key("parameters");
  write_values(out, lot->parameters, digits);
  out.key("mean_objective").rounded(lot->mean, digits).key("worst_objective").rounded(lot->worst, digits);
  out.member("worst_device", lot->worst_device);
  out.key("least_worst_parameters");
  write_values(out, lot->worst_parameters, digits);
  out.key("least_worst_objective").rounded(lot->least_worst, digits);
  out.key("least_worst_bound").rounded(lot->least_worst_bound, digits);
  out.end_object();
}

// What is shown of it: not its covariances.
void write_population(JsonWriter& out, std::optional<lot::Population> const& population) {
  out.key("population");
  if (!population) {
    out.null();
    return;
  }
  out.begin_object().member("devices", std::uint64_t{population->devices}).member("parameters", population->names);
  out.key("medians");
  write_values(out, population->medians, digits);
  out.key("relative_std");
  write_values(out, population->relative_std, profile_digits);
  out.key("correlation").begin_array();
  for (auto const& row : population->correlation) write_values(out, row, profile_digits);
  out.end_array();
  out.member("note", population->note);
  out.end_object();
}

void write_lot_analysis(JsonWriter& out, LawResult const& law) {
  out.key("success_share").rounded(law.success_share, digits);
  out.member("success_reference", law.success_reference);
  out.key("objective_converged").rounded(law.objective_converged, digits);
  out.key("beta_converged").rounded(law.beta_converged, digits);
  out.member("beta_converged_note", law.beta_converged_note).member("left_out_of_beta", law.left_out_of_beta);
  out.member("reduced", law.reduced).member("on_front_converged", law.on_front_converged);
  out.key("loo_objective").rounded(law.loo_objective, digits).key("loo_worst").rounded(law.loo_worst, digits);
  out.member("loo_worst_device", law.loo_worst_device).member("on_front_loo", law.on_front_loo);
  write_lot_law(out, law.lot);
  write_population(out, law.population);
  out.key("fitted_objective").rounded(law.fitted_objective, digits);
  out.key("predicted_objective").rounded(law.predicted_objective, digits);
  out.key("worst_predicted").rounded(law.worst_predicted, digits);
  out.member("prediction_collapses", law.prediction_collapses).member("reduced_form", law.reduced_form);
}

void write_law(JsonWriter& out, Summary const& summary, LawResult const& law,
               std::vector<std::vector<std::size_t>> const& drawn) {
  out.begin_object();
  out.member("id", law.id).member("title", law.title).member("notes", law.notes);
  out.key("objective");
  write(out, law.objective);
  out.key("beta").rounded(law.beta, digits);
  out.member("beta_note", law.beta_note).member("on_front", law.on_front);
  out.key("K_eff_error_percent").rounded(mean_magnitude(law, &DeviceFit::K_eff_error_percent), digits);
  out.key("energy_error_percent").rounded(mean_magnitude(law, &DeviceFit::energy_error_percent), digits);
  write_lot_analysis(out, law);
  out.key("parameters").begin_array();
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    out.begin_object();
    out.member("name", parameters[n].name).member("unit", parameters[n].unit).member("free", parameters[n].free);
    out.key("delta").rounded(largest_difference(law, n), digits);
    out.end_object();
  }
  out.end_array();
  out.key("devices").begin_array();
  for (auto const& fit : law.devices) {
    auto const found = std::find_if(summary.devices.begin(), summary.devices.end(),
                                    [&](auto const& device) { return device.name == fit.device; });
    if (found == summary.devices.end()) continue;
    auto const index = static_cast<std::size_t>(found - summary.devices.begin());
    write_fit(out, fit, static_cast<int>(index), drawn[index]);
  }
  out.end_array().end_object();
}

void write_findings(JsonWriter& out, Summary const& summary) {
  auto const found = findings(summary);
  out.key("findings").begin_object();
  out.member("headline", found.headline).member("beta_note", found.beta_note);
  out.key("verdicts").begin_array();
  for (auto const& verdict : found.verdicts) {
    out.begin_object();
    out.member("law", static_cast<int>(verdict.law)).member("role", name(verdict.role));
    out.member("sentence", verdict.sentence).member("dominated_by", verdict.dominated_by);
    out.end_object();
  }
  out.end_array();
  out.key("warnings").begin_array();
  for (auto const& warning : found.warnings)
    out.begin_object().member("topic", warning.topic).member("sentence", warning.sentence).end_object();
  out.end_array().member("converged", found.converged).end_object();
}

// What the words of the verdicts mean, so that the page says it with the numbers that were used.
void write_thresholds(JsonWriter& out) {
  out.key("thresholds").begin_object();
  out.member("found_within", found_within).member("determined_within", analysis::determined_within);
  out.member("weakly_determined_within", analysis::weakly_determined_within);
  out.member("collapsed_objective", collapsed_objective).member("collapsed_ratio", collapsed_ratio);
  out.end_object();
}

void write_outliers(JsonWriter& out, Summary const& summary) {
  out.key("outliers").begin_array();
  for (auto const& outlier : summary.outliers) {
    out.begin_object();
    out.member("device", outlier.device).member("property", outlier.property).member("unit", outlier.unit);
    out.key("value").rounded(outlier.value, digits).key("median").rounded(outlier.median, digits);
    out.key("score").rounded(outlier.score, digits).key("percent").rounded(outlier.percent, digits);
    out.end_object();
  }
  out.end_array();
}

}  // namespace

std::string page_data_json(Summary const& summary) {
  auto const most = points_per_curve(summary);
  std::vector<std::vector<std::size_t>> drawn;
  for (auto const& device : summary.devices) drawn.push_back(drawn_samples(device.record.size(), most));

  JsonWriter out;
  out.begin_object();
  out.member("isolaw", campaign::text(std::span(summary.makers))).member("title", summary.title);
  out.member("seed", std::to_string(summary.seed));  // as text: 64 bits do not fit a JavaScript number
  out.member("runs", std::uint64_t{summary.runs}).member("missing_runs", std::uint64_t{summary.missing_runs()});
  out.member("missing_analyses", std::uint64_t{summary.missing_analyses()}).member("command", command_again(summary));
  out.key("settings").begin_object();
  for (auto const& setting : summary.settings) out.key(setting.key).json(setting.json);
  out.end_object();
  write_findings(out, summary);
  write_outliers(out, summary);
  write_thresholds(out);
  out.key("assessment");
  write_acceptance(out, summary.acceptance);
  out.key("devices").begin_array();
  for (std::size_t i = 0; i < summary.devices.size(); ++i) write_device(out, summary.devices[i], drawn[i], most);
  out.end_array();
  out.key("laws").begin_array();
  for (auto const& law : summary.laws) write_law(out, summary, law, drawn);
  out.end_array();
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
