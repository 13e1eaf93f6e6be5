#include "isolaw/render/json/summary_json.hpp"

#include <nlohmann/json.hpp>

#include "isolaw/base/json.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

constexpr int schema = 1;

void write_array(JsonWriter& out, std::string_view key, std::vector<double> const& values) {
  out.key(key).begin_array();
  for (double const value : values) out.value(value);
  out.end_array();
}

void write_pair(JsonWriter& out, std::string_view key, std::optional<double> lower, std::optional<double> upper) {
  out.key(key).begin_array();
  for (auto const& value : {lower, upper}) value ? out.value(*value) : out.null();
  out.end_array();
}

void write(JsonWriter& out, Statistic const& statistic) {
  out.begin_object().member("mean", statistic.mean).member("std", statistic.std).member("best", statistic.best);
  out.end_object();
}

void write(JsonWriter& out, ParameterFit const& parameter) {
  out.key(parameter.name).begin_object();
  out.member("unit", parameter.unit);
  out.member("mean", parameter.value.mean).member("std", parameter.value.std).member("best", parameter.value.best);
  out.key("at_bound");
  parameter.at_bound.empty() ? out.null() : out.value(parameter.at_bound);
  out.member("free", parameter.free).member("lower", parameter.lower).member("upper", parameter.upper);
  out.member("percent_of_lot", parameter.percent_of_lot);
  out.key("tied_to");
  parameter.tied_to.empty() ? out.null() : out.value(parameter.tied_to);
  out.key("identifiability");
  parameter.analysis ? out.value(parameter.analysis->identifiability) : out.null();
  if (parameter.analysis) {
    auto const& a = *parameter.analysis;
    out.member("optimum", a.optimum);
    write_pair(out, "open_range", a.open_lower, a.open_upper);
    out.member("open_below", a.open_below).member("open_above", a.open_above);
    write_pair(out, "linear_interval", a.linear_lower, a.linear_upper);
    write_pair(out, "bootstrap_interval", a.bootstrap_lower, a.bootstrap_upper);
    out.key("profile").begin_object();
    write_array(out, "value", a.profile_value);
    write_array(out, "objective", a.profile_objective);
    out.end_object();
  }
  out.end_object();
}

void write_blocks(JsonWriter& out, std::vector<BlockScore> const& blocks) {
  out.key("blocks").begin_array();
  for (auto const& score : blocks) {
    out.begin_object().member("block", score.block).member("fitted", score.fitted).member("objective", score.objective);
    out.end_object();
  }
  out.end_array();
}

void write(JsonWriter& out, DeviceFit const& fit) {
  out.begin_object();
  out.member("name", fit.device);
  out.key("objective");
  write(out, fit.objective);
  out.member("K_eff_error_percent", fit.K_eff_error_percent);
  out.member("energy_error_percent", fit.energy_error_percent);
  out.member("damping_error_percent", fit.damping_error_percent);
  out.member("integration_shift", fit.integration_shift);
  out.key("parameters").begin_object();
  for (auto const& parameter : fit.parameters) write(out, parameter);
  out.end_object();
  out.member("status", fit_status(fit)).member("message", fit.refusal.empty() ? fit.failure : fit.refusal);
  out.member("runs", fit.runs).member("failed_runs", fit.failed_runs);
  out.member("evaluations", fit.evaluations).member("failed_evaluations", fit.failed_evaluations);
  out.member("refinement", fit.refinement);
  out.member("success_share", fit.success_share).member("success_reference", fit.success_reference);
  out.member("optimum", fit.optimum).member("rise", fit.rise).member("trade_offs", fit.trade_offs);
  out.key("intervals").begin_object();
  out.member("level", fit.interval_level).member("samples", std::uint64_t{fit.interval_samples});
  out.member("block", std::uint64_t{fit.interval_block}).member("replicates", fit.interval_replicates).end_object();
  out.member("lot_objective", fit.lot_objective).member("worst_objective", fit.worst_objective);
  out.member("left_out_objective", fit.left_out_objective);
  write_blocks(out, fit.blocks);
  out.end_object();
}

void write_matrix(JsonWriter& out, std::string_view key, lot::SquareMatrix const& rows) {
  out.key(key).begin_array();
  for (auto const& row : rows) {
    out.begin_array();
    for (double const value : row) out.value(value);
    out.end_array();
  }
  out.end_array();
}

void write(JsonWriter& out, lot::Population const& population) {
  out.key("population").begin_object();
  out.member("devices", std::uint64_t{population.devices}).member("parameters", population.names);
  std::vector<std::string> transforms;
  for (auto const transform : population.transforms) transforms.emplace_back(lot::name(transform));
  out.member("transforms", transforms);
  write_array(out, "mean", population.mean);
  write_array(out, "medians", population.medians);
  write_matrix(out, "covariance", population.covariance);
  write_matrix(out, "covariance_of_estimates", population.estimates);
  write_matrix(out, "uncertainty", population.uncertainty);
  write_array(out, "relative_std", population.relative_std);
  write_matrix(out, "correlation", population.correlation);
  out.member("directions", std::uint64_t{population.directions}).member("note", population.note);
  out.end_object();
}

void write(JsonWriter& out, LawResult const& law, LotLaw const& lot) {
  auto const by_name = [&](std::string_view key, std::vector<double> const& values) {
    out.key(key).begin_object();
    auto const& parameters = parameters_of(law);
    for (std::size_t i = 0; i < parameters.size(); ++i) out.member(parameters[i].name, values[i]);
    out.end_object();
  };
  out.key("lot").begin_object();
  by_name("parameters", lot.parameters);
  out.member("mean_objective", lot.mean).member("worst_objective", lot.worst).member("worst_device", lot.worst_device);
  by_name("least_worst_parameters", lot.worst_parameters);
  out.member("least_worst_objective", lot.least_worst).member("least_worst_bound", lot.least_worst_bound);
  out.end_object();
}

void write(JsonWriter& out, LawResult const& law) {
  out.begin_object();
  out.member("id", law.id);
  out.key("objective");
  write(out, law.objective);
  out.member("beta", law.beta).member("on_front", law.on_front);
  out.key("devices").begin_array();
  for (auto const& fit : law.devices) write(out, fit);
  out.end_array();
  out.member("beta_note", law.beta_note).member("title", law.title).member("notes", law.notes);
  out.member("success_share", law.success_share).member("success_reference", law.success_reference);
  out.member("objective_converged", law.objective_converged).member("beta_converged", law.beta_converged);
  out.member("beta_converged_note", law.beta_converged_note).member("left_out_of_beta", law.left_out_of_beta);
  out.member("reduced", law.reduced).member("on_front_converged", law.on_front_converged);
  out.member("loo_objective", law.loo_objective).member("loo_worst", law.loo_worst);
  out.member("loo_worst_device", law.loo_worst_device).member("on_front_loo", law.on_front_loo);
  if (law.lot)
    write(out, law, *law.lot);
  else
    out.key("lot").null();
  if (law.population)
    write(out, *law.population);
  else
    out.key("population").null();
  out.member("fitted_objective", law.fitted_objective).member("predicted_objective", law.predicted_objective);
  out.member("worst_predicted", law.worst_predicted).member("prediction_collapses", law.prediction_collapses);
  out.member("reduced_form", law.reduced_form);
  out.end_object();
}

void write(JsonWriter& out, DeviceResult const& device) {
  out.begin_object();
  out.member("name", device.name).member("file", device.file).member("sha256", device.sha256);
  out.member("status", device.status).member("message", device.message);
  out.end_object();
}

}  // namespace

std::string summary_json(Summary const& summary) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.member("schema", schema).key("isolaw").begin_array();
  for (auto const& maker : summary.makers) {
    out.begin_object().member("version", maker.version).key("build");
    maker.build.empty() ? out.null() : out.value(maker.build);
    out.end_object();
  }
  out.end_array().member("seed", summary.seed);
  out.key("settings").begin_object();
  for (auto const& setting : summary.settings) out.key(setting.key).json(setting.json);
  out.end_object();
  out.key("devices").begin_array();
  for (auto const& device : summary.devices) write(out, device);
  out.end_array();
  out.key("laws").begin_array();
  for (auto const& law : summary.laws) write(out, law);
  out.end_array();
  out.member("title", summary.title);
  out.key("outliers").begin_array();
  for (auto const& outlier : summary.outliers) {
    out.begin_object()
        .member("device", outlier.device)
        .member("property", outlier.property)
        .member("unit", outlier.unit);
    out.member("value", outlier.value).member("median", outlier.median).member("score", outlier.score);
    out.member("percent", outlier.percent).end_object();
  }
  out.end_array();
  out.member("complete", summary.missing_runs() == 0 && summary.missing_analyses() == 0)
      .member("missing_runs", std::uint64_t{summary.missing_runs()});
  out.member("missing_analyses", std::uint64_t{summary.missing_analyses()});
  out.end_object();
  return out.take() + "\n";
}

std::optional<std::size_t> missing_runs_in(std::string_view summary_json) {
  auto const json = nlohmann::json::parse(summary_json, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  auto const found = json.find("missing_runs");
  return found != json.end() && found->is_number_unsigned() ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

}  // namespace isolaw::render
