#include "isolaw/render/json/summary_json.hpp"

#include <nlohmann/json.hpp>

#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

constexpr int summary_schema = 1;

void write_analysis(JsonWriter& out, ParameterAnalysis const& analysis) {
  write_results(out, analysis_results, analysis, Digits::all, [&](std::string_view) { write_profile(out, analysis); });
}

void write_parameters(JsonWriter& out, std::vector<ParameterFit> const& parameters) {
  out.begin_object();
  for (auto const& parameter : parameters) {
    out.key(parameter.name).begin_object();
    write_results(out, parameter_results, parameter, Digits::all);
    if (parameter.analysis)
      write_analysis(out, *parameter.analysis);
    else
      out.key("identifiability").null();
    out.end_object();
  }
  out.end_object();
}

void write(JsonWriter& out, DeviceFit const& fit) {
  out.begin_object();
  write_results(out, fit_results, fit, Digits::all, [&](std::string_view key) {
    if (key == "parameters")
      write_parameters(out, fit.parameters);
    else if (key == "intervals")
      write_intervals(out, fit);
    else
      write_blocks(out, fit.blocks, Digits::all);
  });
  out.end_object();
}

void write_matrix(JsonWriter& out, std::string_view key, lot::SquareMatrix const& rows) {
  out.key(key).begin_array();
  for (auto const& row : rows) write_values(out, row);
  out.end_array();
}

void write(JsonWriter& out, lot::Population const& population) {
  out.begin_object();
  out.member("devices", std::uint64_t{population.devices}).member("parameters", population.names);
  std::vector<std::string> transforms;
  for (auto const transform : population.transforms) transforms.emplace_back(lot::name(transform));
  out.member("transforms", transforms);
  write_values(out.key("mean"), population.mean);
  write_values(out.key("medians"), population.medians);
  write_matrix(out, "covariance", population.covariance);
  write_matrix(out, "covariance_of_estimates", population.estimates);
  write_matrix(out, "uncertainty", population.uncertainty);
  write_values(out.key("relative_std"), population.relative_std);
  write_matrix(out, "correlation", population.correlation);
  out.member("directions", std::uint64_t{population.directions}).member("note", population.note);
  out.end_object();
}

void write(JsonWriter& out, std::vector<ParameterFit> const& parameters, LotLaw const& lot) {
  out.begin_object();
  write_results(out, lot_law_results, lot, Digits::all, [&](std::string_view key) {
    auto const& values = key == "parameters" ? lot.parameters : lot.worst_parameters;
    out.begin_object();
    for (std::size_t i = 0; i < parameters.size(); ++i) out.member(parameters[i].name, values[i]);
    out.end_object();
  });
  out.end_object();
}

void write(JsonWriter& out, LawResult const& law) {
  out.begin_object();
  write_results(out, law_results, law, Digits::all, [&](std::string_view key) {
    if (key == "devices") {
      out.begin_array();
      for (auto const& fit : law.devices) write(out, fit);
      out.end_array();
    } else if (key == "lot" && law.lot) {
      write(out, parameters_of(law), *law.lot);
    } else if (key == "population" && law.population) {
      write(out, *law.population);
    } else {
      out.null();
    }
  });
  out.end_object();
}

void write(JsonWriter& out, DeviceResult const& device) {
  out.begin_object();
  write_members(out, "name", device.name, "file", device.file, "sha256", device.sha256, "status", device.status,
                "message", device.message, "dead_band_mm", device.record.dead_band_mm);
  out.end_object();
}

}  // namespace

std::string summary_json(Summary const& summary) {
  return summary_json(summary, {});
}

std::string summary_json(Summary const& summary, std::string_view profile) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.member("schema", summary_schema).key("isolaw").begin_array();
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
  write_outliers(out.key("outliers"), summary.outliers, Digits::all);
  auto const runs = summary.missing_runs(), analyses = summary.missing_analyses();
  write_members(out, "complete", runs == 0 && analyses == 0, "missing_runs", runs, "missing_analyses", analyses);
  if (summary.part) write_members(out, "part", summary.part->number, "parts", summary.part->of);
  write_findings(out, "warnings", warnings(summary));
  write_recommendations(out, summary, recommendations(summary));
  write_published(out, summary, Digits::all);
  if (!profile.empty()) out.key("profile").json(profile);
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
