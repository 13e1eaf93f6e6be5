#include "isolaw/campaign/analysis_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::campaign {
namespace {

using Json = nlohmann::ordered_json;
using analysis::Verdict;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json number(std::optional<double> const& value) {
  return value ? number(*value) : Json(nullptr);
}
Json numbers(std::vector<double> const& values) {
  Json made = Json::array();
  for (double const value : values) made.push_back(number(value));
  return made;
}
double to_double(Json const& json) {
  return json.is_null() ? std::nan("") : json.get<double>();
}
std::optional<double> to_optional(Json const& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}
std::vector<double> to_doubles(Json const& json) {
  std::vector<double> made;
  for (auto const& value : json) made.push_back(to_double(value));
  return made;
}

Verdict verdict_from(std::string const& text) {
  for (auto const verdict : {Verdict::determined, Verdict::weakly_determined, Verdict::undetermined, Verdict::at_bound})
    if (name(verdict) == text) return verdict;
  throw Error({.where = "stored analysis", .found = "'" + text + "'", .allowed = "a verdict on a parameter"});
}

Json json_of(analysis::ParameterDetermination const& p) {
  return {{"parameter", p.parameter},
          {"verdict", name(p.verdict)},
          {"lower", number(p.lower)},
          {"upper", number(p.upper)},
          {"open_below", p.open_below},
          {"open_above", p.open_above},
          {"profile", {{"value", numbers(p.profile.value)}, {"objective", numbers(p.profile.objective)}}}};
}
analysis::ParameterDetermination determination_from(Json const& json) {
  analysis::ParameterDetermination made;
  made.parameter = json.at("parameter").get<std::size_t>();
  made.verdict = verdict_from(json.at("verdict").get<std::string>());
  made.lower = to_double(json.at("lower"));
  made.upper = to_double(json.at("upper"));
  made.open_below = json.at("open_below").get<bool>();
  made.open_above = json.at("open_above").get<bool>();
  made.profile.value = to_doubles(json.at("profile").at("value"));
  made.profile.objective = to_doubles(json.at("profile").at("objective"));
  return made;
}

Json json_of(analysis::Determination const& d) {
  Json parameters = Json::array(), trade_offs = Json::array();
  for (auto const& p : d.parameters) parameters.push_back(json_of(p));
  for (auto const& t : d.trade_offs)
    trade_offs.push_back({{"parameters", t.parameters},
                          {"change", numbers(t.change)},
                          {"force_change", number(t.force_change)},
                          {"sentence", t.sentence}});
  return {{"optimum", numbers(d.optimum)}, {"objective", number(d.objective)},
          {"rise", number(d.rise)},        {"singular_values", numbers(d.singular_values)},
          {"parameters", parameters},      {"trade_offs", trade_offs},
          {"evaluations", d.evaluations}};
}
analysis::Determination whole_determination_from(Json const& json) {
  analysis::Determination made;
  made.optimum = to_doubles(json.at("optimum"));
  made.objective = to_double(json.at("objective"));
  made.rise = to_double(json.at("rise"));
  made.singular_values = to_doubles(json.at("singular_values"));
  for (auto const& p : json.at("parameters")) made.parameters.push_back(determination_from(p));
  for (auto const& t : json.at("trade_offs"))
    made.trade_offs.push_back({.parameters = t.at("parameters").get<std::vector<std::size_t>>(),
                               .change = to_doubles(t.at("change")),
                               .force_change = to_double(t.at("force_change")),
                               .sentence = t.at("sentence").get<std::string>()});
  made.evaluations = json.at("evaluations").get<int>();
  return made;
}

Json json_of(analysis::Intervals const& i) {
  Json parameters = Json::array();
  for (auto const& p : i.parameters)
    parameters.push_back({{"parameter", p.parameter},
                          {"linear", {number(p.linear_lower), number(p.linear_upper)}},
                          {"bootstrap", {number(p.bootstrap_lower), number(p.bootstrap_upper)}}});
  return {{"level", i.level},
          {"samples", i.samples},
          {"block", i.block},
          {"replicates", i.replicates},
          {"parameters", parameters},
          {"covariance", numbers(i.covariance)},
          {"evaluations", i.evaluations}};
}
analysis::Intervals intervals_from(Json const& json) {
  analysis::Intervals made;
  made.level = json.at("level").get<double>();
  made.samples = json.at("samples").get<std::size_t>();
  made.block = json.at("block").get<std::size_t>();
  made.replicates = json.at("replicates").get<int>();
  for (auto const& p : json.at("parameters"))
    made.parameters.push_back({.parameter = p.at("parameter").get<std::size_t>(),
                               .linear_lower = to_double(p.at("linear").at(0)),
                               .linear_upper = to_double(p.at("linear").at(1)),
                               .bootstrap_lower = to_optional(p.at("bootstrap").at(0)),
                               .bootstrap_upper = to_optional(p.at("bootstrap").at(1))});
  made.covariance = to_doubles(json.at("covariance"));
  made.evaluations = json.at("evaluations").get<int>();
  return made;
}

Json json_of(analysis::OneLaw const& law) {
  return {{"parameters", numbers(law.parameters)},
          {"objectives", numbers(law.objectives)},
          {"mean", number(law.mean)},
          {"worst", number(law.worst)},
          {"evaluations", law.evaluations}};
}
analysis::OneLaw one_law_from(Json const& json) {
  return {.parameters = to_doubles(json.at("parameters")),
          .objectives = to_doubles(json.at("objectives")),
          .mean = to_double(json.at("mean")),
          .worst = to_double(json.at("worst")),
          .evaluations = json.at("evaluations").get<int>()};
}

}  // namespace

std::string analysis_json(DeviceAnalysis const& analysis) {
  return Json{{"refinement", analysis.refinement},
              {"determination", json_of(analysis.determination)},
              {"intervals", json_of(analysis.intervals)}}
      .dump();
}

std::string analysis_json(LotAnalysis const& analysis) {
  return Json{{"refinement", analysis.refinement},
              {"devices", analysis.devices},
              {"mean", json_of(analysis.mean)},
              {"worst", json_of(analysis.worst.law)},
              {"bound", number(analysis.worst.bound)}}
      .dump();
}

std::string analysis_json(LeftOutAnalysis const& analysis) {
  auto const& left_out = analysis.left_out;
  return Json{{"parameters", numbers(left_out.parameters)},
              {"objective", number(left_out.objective)},
              {"evaluations", left_out.evaluations}}
      .dump();
}

DeviceAnalysis device_analysis(std::size_t device, std::string law, std::string_view text) {
  auto const json = Json::parse(text);
  return {.device = device,
          .law = std::move(law),
          .refinement = json.at("refinement").get<int>(),
          .determination = whole_determination_from(json.at("determination")),
          .intervals = intervals_from(json.at("intervals"))};
}

LotAnalysis lot_analysis(std::string law, std::string_view text) {
  auto const json = Json::parse(text);
  return {.law = std::move(law),
          .refinement = json.at("refinement").get<int>(),
          .devices = json.at("devices").get<std::vector<std::size_t>>(),
          .mean = one_law_from(json.at("mean")),
          .worst = {.law = one_law_from(json.at("worst")), .bound = to_double(json.at("bound"))}};
}

LeftOutAnalysis left_out_analysis(std::size_t device, std::string law, std::string_view text) {
  auto const json = Json::parse(text);
  return {.device = device,
          .law = std::move(law),
          .left_out = {.parameters = to_doubles(json.at("parameters")),
                       .objective = to_double(json.at("objective")),
                       .evaluations = json.at("evaluations").get<int>()}};
}

}  // namespace isolaw::campaign
