#include "isolaw/campaign/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/analysis_json.hpp"
#include "isolaw/campaign/schema.hpp"

namespace isolaw::campaign {
namespace {

using sqlite::Connection;
using sqlite::Statement;

std::string to_json(std::vector<std::string> const& lines) {
  return nlohmann::json(lines).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
std::vector<std::string> lines_of(std::string const& json) {
  return nlohmann::json::parse(json).get<std::vector<std::string>>();
}

template <class Visit>
void for_each_series(auto& device, Visit&& visit) {
  visit("raw", "time_s", device.raw.time_s);
  visit("raw", "disp_mm", device.raw.disp_mm);
  visit("raw", "force_kN", device.raw.force_kN);
  visit("raw", "load_kN", device.raw.load_kN);
  visit("fit", "time_s", device.record.time_s);
  visit("fit", "disp_mm", device.record.disp_mm);
  visit("fit", "vel_mm_s", device.record.vel_mm_s);
  visit("fit", "force_kN", device.record.force_kN);
  visit("fit", "scored", device.record.scored);
  visit("fit", "block", device.record.block);
}

void write_devices(Connection const& db, Contents const& contents) {
  Statement device(db, "INSERT INTO device VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  Statement series(db, "INSERT INTO series VALUES (?, ?, ?, ?, ?)");
  for (std::size_t id = 0; id < contents.devices.size(); ++id) {
    auto const& d = contents.devices[id];
    device.bind(id).bind(d.name).bind(d.file).bind(d.raw.sha256).bind(d.usable() ? "ok" : "refused").bind(d.refusal);
    device.bind(d.info.serial).bind(d.info.lot).bind(d.info.test_date);
    device.bind(d.info.temperature_C).bind(d.info.rubber_thickness_mm).bind(d.info.rubber_area_mm2);
    device.bind(to_json(d.raw.recognised)).bind(to_json(d.raw.corrections)).bind(to_json(d.raw.warnings));
    device.bind(to_json(d.record.cleaning)).insert();
    for_each_series(d, [&](char const* kind, char const* channel, std::vector<double> const& values) {
      if (!values.empty()) series.bind(id).bind(kind).bind(channel).bind(values.size()).bind(values).insert();
    });
  }
}

void write_searches(Connection const& db, Contents const& contents) {
  Statement search(db, "INSERT INTO search VALUES (?, ?, ?)");
  Statement parameter(db, "INSERT INTO search_parameter VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (auto const& s : contents.searches) {
    search.bind(s.device).bind(s.law).bind(s.refusal).insert();
    for (std::size_t i = 0; i < s.box.parameters.size(); ++i) {
      auto const& p = s.box.parameters[i];
      parameter.bind(s.device).bind(s.law).bind(i).bind(p.name).bind(p.unit).bind(p.free ? 1 : 0);
      parameter.bind(p.value).bind(p.lower).bind(p.upper);
      parameter.bind(p.scale == laws::Scale::logarithmic ? "logarithmic" : "linear");
      parameter.bind(p.tied_to ? std::optional(static_cast<double>(*p.tied_to)) : std::nullopt).insert();
    }
  }
}

void read_makers(Connection const& db, Contents& contents) {
  Statement maker(db, "SELECT version, build, instruction_set FROM maker ORDER BY id");
  while (maker.row()) {
    auto& made = contents.makers.emplace_back();
    made.version = maker.text();
    made.build = maker.text();
    made.instruction_set = maker.text();
  }
  if (contents.makers.empty()) throw Error({.found = "no word on the isolaw that made it"});
}

void read_settings(Connection const& db, Contents& contents) {
  std::vector<std::pair<std::string, std::string>> pairs;
  Statement setting(db, "SELECT key, json FROM setting ORDER BY position");
  while (setting.row()) {
    auto key = setting.text();
    pairs.emplace_back(std::move(key), setting.text());
  }
  contents.settings = settings_from_pairs(pairs);
  contents.settings.validate();
}

void read_devices(Connection const& db, Contents& contents) {
  Statement device(
      db,
      "SELECT name, file, sha256, status, message, serial, lot, test_date, temperature_C, rubber_thickness_mm, rubber_area_mm2, recognised, corrections, warnings, cleaning FROM device ORDER BY id");
  while (device.row()) {
    Device d;
    d.name = device.text();
    d.file = d.raw.file = device.text();
    d.raw.sha256 = device.text();
    bool const refused = device.text() == "refused";
    auto const message = device.text();
    if (refused) d.refusal = message.empty() ? "refused" : message;
    d.info.serial = device.text();
    d.info.lot = device.text();
    d.info.test_date = device.text();
    d.info.temperature_C = device.optional_real();
    d.info.rubber_thickness_mm = device.optional_real();
    d.info.rubber_area_mm2 = device.optional_real();
    d.raw.recognised = lines_of(device.text());
    d.raw.corrections = lines_of(device.text());
    d.raw.warnings = lines_of(device.text());
    d.record.cleaning = lines_of(device.text());
    contents.devices.push_back(std::move(d));
  }
}

void read_series(Connection const& db, Contents& contents) {
  std::map<std::tuple<std::size_t, std::string, std::string>, std::vector<double>> stored;
  Statement series(db, "SELECT device, kind, channel, count, \"values\" FROM series");
  while (series.row()) {
    auto const id = series.index();
    auto kind = series.text(), channel = series.text();
    auto const count = series.integer();
    auto values = series.reals();
    if (!std::cmp_equal(count, values.size()))
      throw Error({.found = fmt::format("a series of {} values where {} are counted", values.size(), count)});
    stored[{id, std::move(kind), std::move(channel)}] = std::move(values);
  }
  for (std::size_t id = 0; id < contents.devices.size(); ++id)
    for_each_series(contents.devices[id], [&](char const* kind, char const* channel, std::vector<double>& values) {
      if (auto const found = stored.find({id, kind, channel}); found != stored.end()) values = std::move(found->second);
    });
}

void read_searches(Connection const& db, Contents& contents) {
  Statement search(db, "SELECT device, law, refusal FROM search");
  std::map<std::pair<std::size_t, std::string>, Search> found;
  while (search.row()) {
    Search s;
    s.device = search.index();
    s.law = search.text();
    s.refusal = search.text();
    found[{s.device, s.law}] = s;
  }
  Statement parameter(
      db,
      "SELECT device, law, name, unit, free, value, lower, upper, scale, tied_to FROM search_parameter ORDER BY device, law, position");
  while (parameter.row()) {
    auto const device = parameter.index();
    auto const owner = found.find({device, parameter.text()});
    if (owner == found.end()) continue;
    auto& box = owner->second.box;
    fit::SearchParameter p;
    p.name = parameter.text();
    p.unit = parameter.text();
    p.free = parameter.integer() != 0;
    p.value = parameter.real();
    p.lower = parameter.real();
    p.upper = parameter.real();
    p.scale = parameter.text() == "logarithmic" ? laws::Scale::logarithmic : laws::Scale::linear;
    if (auto const other = parameter.optional_real()) p.tied_to = static_cast<std::size_t>(std::max(0.0, *other));
    box.parameters.push_back(std::move(p));
  }
  for (std::size_t d = 0; d < contents.devices.size(); ++d)
    for (auto const& law : contents.settings.laws)
      if (auto const s = found.find({d, law}); s != found.end()) contents.searches.push_back(s->second);
  if (contents.searches.size() != found.size())
    throw Error({.found = "a law was searched that was not asked for, or on a device that is not there"});
}

Outcome outcome_from(std::string_view text) {
  for (auto const outcome : {Outcome::confirmed, Outcome::budget_spent, Outcome::all_generations, Outcome::stagnated})
    if (name(outcome) == text) return outcome;
  return Outcome::no_finite_value;
}

void read_runs(Connection const& db, Contents& contents) {
  std::map<std::tuple<std::size_t, std::string, int>, std::vector<double>> values;
  Statement parameter(db,
                      "SELECT device, law, number, value FROM run_parameter ORDER BY device, law, number, position");
  while (parameter.row()) {
    auto const device = parameter.index();
    auto law = parameter.text();
    auto const number = parameter.whole();
    values[{device, std::move(law), number}].push_back(parameter.real());
  }
  Statement run(
      db,
      "SELECT device, law, number, outcome, objective, integration_shift, refinement, evaluations, failed_evaluations, message, history, maker FROM run ORDER BY device, law, number");
  while (run.row()) {
    Run r;
    r.device = run.index();
    r.law = run.text();
    r.number = run.whole();
    r.outcome = outcome_from(run.text());
    r.objective = run.real();
    r.integration_shift = run.real();
    r.refinement = run.whole();
    r.evaluations = run.whole();
    r.failed_evaluations = run.whole();
    r.failure = run.text();
    r.history = run.reals();
    r.maker = run.index();
    if (auto const found = values.find({r.device, r.law, r.number}); found != values.end())
      r.parameters = std::move(found->second);
    contents.runs.push_back(std::move(r));
  }
}

void read_analyses(Connection const& db, Contents& contents) {
  Statement device(db, "SELECT device, law, json, maker FROM device_analysis ORDER BY device, law");
  while (device.row()) {
    auto const index = device.index();
    auto law = device.text();
    contents.device_analyses.push_back(device_analysis(index, std::move(law), device.text()));
    contents.device_analyses.back().maker = device.index();
  }
  Statement lot(db, "SELECT law, json, maker FROM lot_analysis ORDER BY law");
  while (lot.row()) {
    auto law = lot.text();
    contents.lot_analyses.push_back(lot_analysis(std::move(law), lot.text()));
    contents.lot_analyses.back().maker = lot.index();
  }
  Statement left_out(db, "SELECT device, law, json, maker FROM left_out ORDER BY device, law");
  while (left_out.row()) {
    auto const index = left_out.index();
    auto law = left_out.text();
    contents.left_out.push_back(left_out_analysis(index, std::move(law), left_out.text()));
    contents.left_out.back().maker = left_out.index();
  }
}

// What describe() may change.
std::array<std::pair<char const*, std::string>, 5> descriptions(Contents const& contents) {
  auto const& a = contents.acceptance;
  return {{{"title", contents.title},
           {"rules", a.rules},
           {"rules-file", a.rules_file},
           {"design", a.design},
           {"lot-size", a.lot_size ? std::to_string(*a.lot_size) : std::string()}}};
}

void read_descriptions(Connection const& db, Contents& contents) {
  contents.title = meta(db, "title");
  auto& a = contents.acceptance;
  a.rules = meta(db, "rules");
  a.rules_file = meta(db, "rules-file");
  a.design = meta(db, "design");
  if (auto const size = meta(db, "lot-size"); !size.empty()) a.lot_size = parse_lot_size(size);
}

}  // namespace

void write_row(Connection const& db, std::size_t id, Maker const& maker) {
  Statement row(db, "INSERT INTO maker VALUES (?, ?, ?, ?)");
  row.bind(id).bind(maker.version).bind(maker.build).bind(maker.instruction_set).insert();
}

void write_campaign(Connection const& db, Contents const& contents, std::vector<Maker> const& makers) {
  Statement meta(db, "INSERT INTO meta VALUES (?, ?)");
  meta.bind("schema").bind(std::to_string(schema_version)).insert();
  meta.bind("isolaw").bind(makers.front().version).insert();
  for (auto const& [key, value] : descriptions(contents)) meta.bind(key).bind(value).insert();
  Statement setting(db, "INSERT INTO setting VALUES (?, ?, ?)");
  std::size_t position = 0;
  for (auto const& [key, json] : to_pairs(contents.settings)) setting.bind(position++).bind(key).bind(json).insert();
  for (std::size_t id = 0; id < makers.size(); ++id) write_row(db, id, makers[id]);
  write_devices(db, contents);
  write_searches(db, contents);
}

void write_descriptions(Connection const& db, Contents const& contents) {
  Statement meta(db, "UPDATE meta SET value = ? WHERE key = ?");
  for (auto const& [key, value] : descriptions(contents)) meta.bind(value).bind(key).insert();
  Statement analysis(db, "UPDATE setting SET json = ? WHERE key = 'analysis'");
  analysis.bind(contents.settings.analysis ? "\"full\"" : "\"none\"").insert();
  Statement device(
      db,
      "UPDATE device SET serial = ?, lot = ?, test_date = ?, temperature_C = ?, rubber_thickness_mm = ?, rubber_area_mm2 = ? WHERE id = ?");
  for (std::size_t id = 0; id < contents.devices.size(); ++id) {
    auto const& info = contents.devices[id].info;
    device.bind(info.serial).bind(info.lot).bind(info.test_date);
    device.bind(info.temperature_C).bind(info.rubber_thickness_mm).bind(info.rubber_area_mm2).bind(id).insert();
  }
}

void write_row(Connection const& db, Run const& run) {
  Statement row(db, "INSERT INTO run VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  row.bind(run.device).bind(run.law).bind(run.number).bind(name(run.outcome)).bind(run.objective);
  row.bind(run.integration_shift)
      .bind(run.refinement)
      .bind(run.evaluations)
      .bind(run.failed_evaluations)
      .bind(run.failure);
  row.bind(run.history).bind(run.maker).insert();
  Statement parameter(db, "INSERT INTO run_parameter VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.parameters.size(); ++i)
    parameter.bind(run.device).bind(run.law).bind(run.number).bind(i).bind(run.parameters[i]).insert();
}

void write_row(Connection const& db, DeviceAnalysis const& analysis) {
  Statement row(db, "INSERT INTO device_analysis VALUES (?, ?, ?, ?)");
  row.bind(analysis.device).bind(analysis.law).bind(analysis_json(analysis)).bind(analysis.maker).insert();
}
void write_row(Connection const& db, LotAnalysis const& analysis) {
  Statement row(db, "INSERT INTO lot_analysis VALUES (?, ?, ?)");
  row.bind(analysis.law).bind(analysis_json(analysis)).bind(analysis.maker).insert();
}
void write_row(Connection const& db, LeftOutAnalysis const& analysis) {
  Statement row(db, "INSERT INTO left_out VALUES (?, ?, ?, ?)");
  row.bind(analysis.device).bind(analysis.law).bind(analysis_json(analysis)).bind(analysis.maker).insert();
}

Contents read_campaign(Connection const& db) {
  Contents contents;
  read_descriptions(db, contents);
  read_makers(db, contents);
  read_settings(db, contents);
  read_devices(db, contents);
  read_searches(db, contents);
  return contents;
}

Contents read_contents(Connection const& db) {
  auto contents = read_campaign(db);
  read_series(db, contents);
  read_runs(db, contents);
  read_analyses(db, contents);
  return contents;
}

}  // namespace isolaw::campaign
