#include "isolaw/report/summary_json.hpp"

#include <nlohmann/json.hpp>

#include "isolaw/report/json.hpp"

namespace isolaw::report {
namespace {

constexpr int schema = 1;

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
  out.end_object();
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
  out.member("schema", schema).member("isolaw", summary.version).member("seed", summary.seed);
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
  out.member("complete", summary.missing_runs() == 0).member("missing_runs", std::uint64_t{summary.missing_runs()});
  out.end_object();
  return out.take() + "\n";
}

std::optional<std::size_t> missing_runs_in(std::string_view summary_json) {
  auto const json = nlohmann::json::parse(summary_json, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  auto const found = json.find("missing_runs");
  return found != json.end() && found->is_number_unsigned() ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

}  // namespace isolaw::report
