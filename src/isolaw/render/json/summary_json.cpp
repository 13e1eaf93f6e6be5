#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/json/conditions_json.hpp"

#include <nlohmann/json.hpp>

#include "isolaw/render/json/properties_json.hpp"
#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/findings.hpp"

namespace isolaw::render {
namespace {

constexpr int summary_schema = 2;

void write(JsonWriter& out, ParameterFit const& parameter) {
  write_results(out, parameter_results, parameter, Digits::all);
  if (!parameter.analysis) return void(out.key("identifiability").null());
  auto const& analysis = *parameter.analysis;
  write_results(out, analysis_results, analysis, Digits::all, [&](std::string_view) { write_profile(out, analysis); });
}

void write(JsonWriter& out, DeviceFit const& fit) {
  write_results(out, fit_results, fit, Digits::all, [&](std::string_view key) {
    if (key == "blocks") return write_rows(out, score_results, fit.blocks, Digits::all);
    if (key == "tests") return write_rows(out, test_results, fit.tests, Digits::all);
    out.object([&] {
      if (key == "intervals") return write_results(out, interval_results, fit, Digits::all);
      for (auto const& parameter : fit.parameters) out.key(parameter.name).object([&] { write(out, parameter); });
    });
  });
}

void write(JsonWriter& out, lot::Population const& population) {
  auto const matrix = [&](std::string_view key, lot::SquareMatrix const& rows) {
    out.key(key).array(rows, [&](auto const& row) { write_values(out, row); });
  };
  out.member("devices", std::uint64_t{population.devices}).member("parameters", population.names);
  out.key("transforms").array(population.transforms, [&](auto transform) { out.value(lot::name(transform)); });
  write_values(out.key("mean"), population.mean);
  write_values(out.key("medians"), population.medians);
  matrix("covariance", population.covariance);
  matrix("covariance_of_estimates", population.estimates);
  matrix("uncertainty", population.uncertainty);
  write_values(out.key("relative_std"), population.relative_std);
  matrix("correlation", population.correlation);
  out.member("directions", std::uint64_t{population.directions}).member("note", population.note);
}

void write(JsonWriter& out, std::vector<ParameterFit> const& parameters, LotLaw const& lot) {
  write_results(out, lot_law_results, lot, Digits::all, [&](std::string_view key) {
    auto const& values = key == "parameters" ? lot.parameters : lot.worst_parameters;
    out.object([&] {
      for (std::size_t i = 0; i < parameters.size(); ++i) out.member(parameters[i].name, values[i]);
    });
  });
}

void write(JsonWriter& out, LawResult const& law) {
  write_results(out, law_results, law, Digits::all, [&](std::string_view key) {
    if (key == "devices")
      out.objects(law.devices, [&](DeviceFit const& fit) { write(out, fit); });
    else if (key == "lot" && law.lot)
      out.object([&] { write(out, parameters_of(law), *law.lot); });
    else if (key == "population" && law.population)
      out.object([&] { write(out, *law.population); });
    else
      out.null();
  });
}

}  // namespace

std::string summary_json(Summary const& summary) {
  return summary_json(summary, {});
}

std::string summary_json(Summary const& summary, std::string_view profile) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.member("schema", summary_schema);
  out.key("isolaw").objects(summary.makers, [&](auto const& maker) {
    out.member("version", maker.version).key("build");
    maker.build.empty() ? out.null() : out.value(maker.build);
  });
  out.member("seed", summary.seed);
  write_settings(out, summary);
  out.key("devices").objects(summary.devices, [&](DeviceResult const& device) {
    write_members(out, "name", device.name, "file", device.file, "sha256", device.sha256, "status", device.status,
                  "message", device.message, "dead_band_mm", device.record.dead_band_mm);
    write_tests(out, device);
  });
  out.key("laws").objects(summary.laws, [&](LawResult const& law) { write(out, law); });
  out.member("title", summary.title);
  write_rows(out.key("outliers"), outlier_results, summary.outliers, Digits::all);
  auto const runs = summary.missing_runs(), analyses = summary.missing_analyses();
  write_members(out, "complete", runs == 0 && analyses == 0, "missing_runs", runs, "missing_analyses", analyses);
  if (summary.part) write_members(out, "part", summary.part->number, "parts", summary.part->total);
  write_findings(out, "warnings", warnings(summary));
  write_recommendation(out, summary, recommendation(summary));
  write_published(out, summary, Digits::all);
  write_conditions(out, summary);
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
