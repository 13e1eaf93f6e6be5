#include "isolaw/campaign/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "isolaw/base/error.hpp"

namespace isolaw::campaign {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(std::string_view option, std::string_view found, std::string_view allowed) {
  throw Error(
      {.where = fmt::format("--{}", option), .found = fmt::format("'{}'", found), .allowed = std::string(allowed)});
}

// A stored setting: the library would cut a number that is too large for an int, or not whole, without a word.
int whole_number(Json const& json) {
  auto const fits = [](auto value) { return std::in_range<int>(value); };
  bool const whole = json.is_number_unsigned() ? fits(json.get<std::uint64_t>())
                                               : json.is_number_integer() && fits(json.get<std::int64_t>());
  if (!whole)
    throw Error({.where = "stored setting",
                 .found = json.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 40),
                 .allowed = "a whole number"});
  return json.get<int>();
}

}  // namespace

void Settings::complete() {
  if (runs == 0) runs = method == Method::genetic ? 20 : 3;
}

void Settings::validate() const {
  if (runs != 0) checked_runs(runs);
  if (method == Method::genetic)
    genetic.validate();
  else
    multistart.validate();
  clean.validate();
  checked_replicates(replicates);
  for (auto const& id : laws) fit::make_box(laws::find_law(id), box, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, overrides);
}

std::vector<std::string> parse_laws(std::string_view text) {
  std::vector<std::string> ids;
  if (text == "all") {
    for (auto const& law : laws::catalogue()) ids.emplace_back(law.info.id);
    return ids;
  }
  while (true) {
    auto const comma = text.find(',');
    auto id = text.substr(0, comma);
    while (id.starts_with(' ')) id.remove_prefix(1);
    while (id.ends_with(' ')) id.remove_suffix(1);
    auto const& law = laws::find_law(id);
    if (std::ranges::find(ids, law.info.id) == ids.end()) ids.emplace_back(law.info.id);
    if (comma == std::string_view::npos) return ids;
    text.remove_prefix(comma + 1);
  }
}

int parse_lot_size(std::string_view text) {
  constexpr int most = 10'000'000;
  int value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > most)
    refuse("lot-size", text, fmt::format("a whole number of devices, 1 to {}", most));
  return value;
}

std::uint64_t parse_seed(std::string_view text) {
  std::uint64_t value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse("seed", text, "a whole number from 0 to 18446744073709551615");
  return value;
}

fit::BoxKind parse_box(std::string_view text) {
  if (text == "published") return fit::BoxKind::published;
  if (text == "auto") return fit::BoxKind::scaled;
  refuse("box", text, "published, auto");
}

laws::Integration parse_integration(std::string_view text) {
  if (text == "converged") return laws::Integration::converged;
  if (text == "paper") return laws::Integration::paper;
  refuse("integration", text, "converged, paper");
}

laws::TurningPoints parse_turning_points(std::string_view text) {
  if (text == "sampled") return laws::TurningPoints::as_sampled;
  if (text == "interpolated") return laws::TurningPoints::interpolated;
  refuse("turning-points", text, "sampled, interpolated");
}

std::optional<int> parse_samples_per_cycle(std::string_view text) {
  if (text == "all") return std::nullopt;
  int value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse("samples-per-cycle", text, "a whole number of at least 20, or all");
  return value;
}

int checked_runs(int runs) {
  if (runs < 1 || runs > 100000) refuse("runs", fmt::to_string(runs), "1 to 100000");
  return runs;
}

bool parse_analysis(std::string_view text) {
  if (text == "full") return true;
  if (text == "none") return false;
  refuse("analysis", text, "full, none");
}

int checked_replicates(int replicates) {
  constexpr int fewest = 40, most = 100'000;  // a quantile of 2.5 % is that of one replicate in forty
  if (replicates != 0 && (replicates < fewest || replicates > most))
    refuse("replicates", fmt::to_string(replicates), fmt::format("0 for no bootstrap, or {} to {}", fewest, most));
  return replicates;
}

Method parse_method(std::string_view text) {
  if (text == "best") return Method::best;
  if (text == "ga") return Method::genetic;
  refuse("method", text, "best, ga (the genetic algorithm of the paper)");
}
std::string_view name(Method method) {
  return method == Method::genetic ? "ga" : "best";
}

std::string_view name(fit::BoxKind kind) {
  return kind == fit::BoxKind::published ? "published" : "auto";
}
std::string_view name(laws::Integration integration) {
  return integration == laws::Integration::paper ? "paper" : "converged";
}
std::string_view name(laws::TurningPoints turning_points) {
  return turning_points == laws::TurningPoints::interpolated ? "interpolated" : "sampled";
}

std::vector<std::pair<std::string, std::string>> to_pairs(Settings const& s) {
  Json sets = Json::array();
  for (auto const& change : s.overrides) sets.push_back(change.text());
  Json json;
  json["laws"] = s.laws;
  json["method"] = name(s.method);
  json["integration"] = name(s.integration);
  json["turning-points"] = name(s.turning_points);
  json["runs"] = s.runs;
  if (s.method == Method::genetic) {
    json["population"] = s.genetic.population;
    json["generations"] = s.genetic.generations;
    json["mutation_rate"] = s.genetic.mutation_rate;
    json["stagnation"] = s.genetic.stagnation;
    json["stagnation_tolerance"] = s.genetic.stagnation_tolerance;
    json["selection_pressure"] = s.genetic.selection_pressure;
  } else {
    json["least_starts"] = s.multistart.least_starts;
    json["starts"] = s.multistart.starts;
    json["hits"] = s.multistart.hits;
    json["hit_tolerance"] = s.multistart.hit_tolerance;
    json["most_evaluations"] = s.multistart.most_evaluations;
    json["scattered"] = s.multistart.scattered;
    json["hops"] = s.multistart.hops;
  }
  json["seed"] = s.seed;
  json["box"] = name(s.box);
  json["set"] = sets;
  json["smooth"] = s.clean.smooth;
  json["samples-per-cycle"] = s.clean.samples_per_cycle ? Json(*s.clean.samples_per_cycle) : Json("all");
  json["center"] = s.clean.center;
  json["fit-blocks"] = s.clean.scored.blocks.text();
  json["fit-cycles"] = s.clean.scored.cycles.text();
  json["score-blocks"] = s.clean.scored.predicted.text();
  json["analysis"] = s.analysis ? "full" : "none";
  json["replicates"] = s.replicates;
  std::vector<std::pair<std::string, std::string>> pairs;
  for (auto const& [key, value] : json.items()) pairs.emplace_back(key, value.dump());
  return pairs;
}

Settings settings_from_pairs(std::vector<std::pair<std::string, std::string>> const& pairs) {
  Json json;
  for (auto const& [key, value] : pairs) json[key] = Json::parse(value);
  Settings s;
  s.laws = json.at("laws").get<std::vector<std::string>>();
  s.method = parse_method(json.at("method").get<std::string>());
  s.integration = parse_integration(json.at("integration").get<std::string>());
  s.turning_points = parse_turning_points(json.at("turning-points").get<std::string>());
  s.runs = whole_number(json.at("runs"));
  if (s.method == Method::genetic) {
    s.genetic.population = whole_number(json.at("population"));
    s.genetic.generations = whole_number(json.at("generations"));
    s.genetic.mutation_rate = json.at("mutation_rate").get<double>();
    s.genetic.stagnation = whole_number(json.at("stagnation"));
    s.genetic.stagnation_tolerance = json.at("stagnation_tolerance").get<double>();
    s.genetic.selection_pressure = json.at("selection_pressure").get<double>();
  } else {
    s.multistart.least_starts = whole_number(json.at("least_starts"));
    s.multistart.starts = whole_number(json.at("starts"));
    s.multistart.hits = whole_number(json.at("hits"));
    s.multistart.hit_tolerance = json.at("hit_tolerance").get<double>();
    s.multistart.most_evaluations = whole_number(json.at("most_evaluations"));
    s.multistart.scattered = whole_number(json.at("scattered"));
    s.multistart.hops = whole_number(json.at("hops"));
  }
  s.seed = json.at("seed").get<std::uint64_t>();
  s.box = parse_box(json.at("box").get<std::string>());
  for (auto const& text : json.at("set")) s.overrides.push_back(fit::parse_override(text.get<std::string>()));
  s.clean.smooth = whole_number(json.at("smooth"));
  auto const& thinning = json.at("samples-per-cycle");
  s.clean.samples_per_cycle = thinning.is_number() ? std::optional(whole_number(thinning)) : std::nullopt;
  s.clean.center = json.at("center").get<bool>();
  s.clean.scored.blocks = data::parse_numbers("--fit-blocks", json.at("fit-blocks").get<std::string>());
  s.clean.scored.cycles = data::parse_numbers("--fit-cycles", json.at("fit-cycles").get<std::string>());
  s.clean.scored.predicted = data::parse_numbers("--score-blocks", json.at("score-blocks").get<std::string>());
  s.analysis = parse_analysis(json.at("analysis").get<std::string>());
  s.replicates = whole_number(json.at("replicates"));
  return s;
}

}  // namespace isolaw::campaign
