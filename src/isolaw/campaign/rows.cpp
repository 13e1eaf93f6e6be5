#include "isolaw/campaign/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/analysis_json.hpp"
#include "isolaw/campaign/record_json.hpp"
#include "isolaw/campaign/schema.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/wording/finding_json.hpp"

namespace isolaw::campaign {
namespace {

using sqlite::Connection;
using sqlite::Statement;

std::string to_json(data::VerticalTest const& test) {  // a compression test without its series; empty if there is none
  if (!test.is_given()) return {};
  nlohmann::ordered_json object;  // members in alphabetical order
  if (test.found_kN_per_mm) object["K_v_kN_per_mm"] = *test.found_kN_per_mm;
  if (!test.curve_sha256.empty()) object["curve_sha256"] = test.curve_sha256;
  object["file"] = test.file;
  if (test.loads) object["loads_kN"] = {test.loads->low_kN, test.loads->high_kN};
  object["recognised"] = nlohmann::ordered_json::parse(wording::findings_json(test.recognised));
  object["refusal"] = test.refusal;
  object["sha256"] = test.sha256;
  if (test.stated_kN_per_mm) object["stated_kN_per_mm"] = *test.stated_kN_per_mm;
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}
data::VerticalTest vertical_of(std::string const& json) {
  if (json.empty()) return {};
  auto const from = nlohmann::ordered_json::parse(json);
  data::VerticalTest test{.file = from.at("file").get<std::string>(), .sha256 = from.at("sha256").get<std::string>()};
  test.recognised = wording::findings_of(from.at("recognised").dump());
  test.refusal = from.at("refusal").get<std::string>();
  if (from.contains("loads_kN"))
    test.loads = {from["loads_kN"].at(0).get<double>(), from["loads_kN"].at(1).get<double>()};
  if (from.contains("K_v_kN_per_mm")) test.found_kN_per_mm = from["K_v_kN_per_mm"].get<double>();
  if (from.contains("curve_sha256")) test.curve_sha256 = from["curve_sha256"].get<std::string>();
  if (from.contains("stated_kN_per_mm")) test.stated_kN_per_mm = from["stated_kN_per_mm"].get<double>();
  return test;
}

// The tests of a device as a JSON array. The text is empty if the device has only one test.
std::string tests_to_json(Device const& device) {
  if (device.raw.tests.empty()) return {};
  auto tests = nlohmann::ordered_json::array();
  for (std::size_t t = 0; t < device.raw.tests.size(); ++t) {
    auto const& test = device.raw.tests[t];
    tests.push_back({{"name", test.name},
                     {"file", test.file},
                     {"sha256", test.sha256},
                     {"first_raw", device.raw.starts[t]},
                     {"first_fit", device.record.starts[t]}});
    if (!device.uncorrected.starts.empty()) tests.back()["first_uncorrected"] = device.uncorrected.starts[t];
  }
  return tests.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}
void take_tests(std::string const& json, Device& device) {
  if (json.empty()) return;
  for (auto const& test : nlohmann::ordered_json::parse(json)) {
    device.raw.tests.push_back({.name = test.at("name").get<std::string>(),
                                .file = test.at("file").get<std::string>(),
                                .sha256 = test.at("sha256").get<std::string>()});
    device.raw.starts.push_back(test.at("first_raw").get<std::size_t>());
    device.record.starts.push_back(test.at("first_fit").get<std::size_t>());
    if (!test.contains("first_uncorrected")) continue;
    device.uncorrected.starts.push_back(test.at("first_uncorrected").get<std::size_t>());
    device.uncorrected.tests.push_back(device.raw.tests.back());
  }
}

// The faults of the signals of all records as a JSON array. They must be stored, because they were found before the
// corrections and cannot be found again in the corrected samples.
std::string faults_to_json(Contents const& contents) {
  auto faults = Json::array();
  for (std::size_t id = 0; id < contents.devices.size(); ++id)
    for (bool const corrected : {true, false})
      for (auto const& fault : (corrected ? contents.devices[id].raw : contents.devices[id].uncorrected).faults) {
        Json row{{"device", id}, {"corrected", corrected}};
        row.update(fault_json(fault));
        faults.push_back(std::move(row));
      }
  return faults.dump(-1, ' ', false, Json::error_handler_t::replace);
}
void take_faults(std::string const& json, Contents& contents) {
  for (auto const& fault : Json::parse(json)) {
    auto const id = fault.at("device").get<std::size_t>();
    if (id >= contents.devices.size()) throw Error({.found = "a fault of a device that is not in the campaign"});
    auto& device = contents.devices[id];
    auto& record = fault.at("corrected").get<bool>() ? device.raw : device.uncorrected;
    record.faults.push_back(fault_of(fault, record.size()));
  }
}

template <class Visit>
void for_each_vertical_series(auto& device, Visit&& visit) {
  visit("raw", "vertical_disp_mm", device.vertical.disp_mm);
  visit("raw", "vertical_load_kN", device.vertical.load_kN);
}

template <class Visit>
void for_each_series(auto& device, Visit&& visit) {
  visit("raw", "time_s", device.raw.time_s);
  visit("raw", "disp_mm", device.raw.disp_mm);
  visit("raw", "force_kN", device.raw.force_kN);
  visit("raw", "load_kN", device.raw.load_kN);
  visit("raw", "logged_cycle", device.raw.logged_cycle);
  visit("raw", "uncorrected_time_s", device.uncorrected.time_s);
  visit("raw", "uncorrected_disp_mm", device.uncorrected.disp_mm);
  visit("raw", "uncorrected_force_kN", device.uncorrected.force_kN);
  visit("raw", "uncorrected_load_kN", device.uncorrected.load_kN);
  for_each_vertical_series(device, visit);
  visit("fit", "time_s", device.record.time_s);
  visit("fit", "disp_mm", device.record.disp_mm);
  visit("fit", "vel_mm_s", device.record.vel_mm_s);
  visit("fit", "force_kN", device.record.force_kN);
  visit("fit", "scored", device.record.scored);
  visit("fit", "weights", device.record.weights);
  visit("fit", "block", device.record.block);
}

Statement& bind(Statement& row, DeviceInfo const& info) {
  return row.bind(info.serial, info.lot, info.test_date, info.temperature_C, info.rubber_thickness_mm,
                  info.rubber_area_mm2);
}

class SeriesWriter {
 public:
  explicit SeriesWriter(Connection const& db) : row_(db, "INSERT INTO series VALUES (?, ?, ?, ?, ?)") {}
  auto of(std::size_t id) {
    return [this, id](char const* kind, char const* channel, std::vector<double> const& values) {
      if (!values.empty()) row_.bind(id, kind, channel, values.size(), values).insert();
    };
  }

 private:
  Statement row_;
};

void write_devices(Connection const& db, Contents const& contents) {
  Statement device(db, "INSERT INTO device VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SeriesWriter series(db);
  for (std::size_t id = 0; id < contents.devices.size(); ++id) {
    auto const& d = contents.devices[id];
    device.bind(id, d.name, d.file, d.raw.sha256, d.usable() ? "ok" : "refused", d.refusal);
    bind(device, d.info);
    for (auto const* findings : {&d.raw.recognised, &d.raw.corrections, &d.raw.warnings, &d.record.cleaning})
      device.bind(wording::findings_json(*findings));
    device.bind(d.record.dead_band_mm, to_json(d.vertical), tests_to_json(d)).insert();
    for_each_series(d, series.of(id));
  }
}

void write_searches(Connection const& db, Contents const& contents) {
  Statement search(db, "INSERT INTO search VALUES (?, ?, ?)");
  Statement parameter(db, "INSERT INTO search_parameter VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (auto const& s : contents.searches) {
    search.bind(s.device, s.law, s.refusal).insert();
    for (std::size_t i = 0; i < s.first_box.parameters.size(); ++i) {
      auto const& p = s.first_box.parameters[i];
      parameter.bind(s.device, s.law, i, p.name, p.unit, p.free, p.value, p.lower, p.upper);
      parameter.bind(p.scale == laws::Scale::logarithmic ? "logarithmic" : "linear");
      parameter.bind(p.tied_to ? std::optional(static_cast<double>(*p.tied_to)) : std::nullopt).insert();
    }
  }
}

void read_settings(Connection const& db, Contents& contents) {
  std::vector<std::pair<std::string, std::string>> pairs;
  Statement setting(db, "SELECT key, json FROM setting ORDER BY position");
  while (setting.row()) {
    auto& [key, json] = pairs.emplace_back();
    setting.read(key, json);
  }
  contents.settings = settings_from_pairs(pairs);
  contents.settings.validate();
}

void read_devices(Connection const& db, Contents& contents) {
  Statement device(
      db,
      "SELECT name, file, sha256, status, message, serial, lot, test_date, temperature_C, rubber_thickness_mm, rubber_area_mm2, recognised, corrections, warnings, cleaning, dead_band_mm, vertical, tests FROM device ORDER BY id");
  while (device.row()) {
    auto& d = contents.devices.emplace_back();
    auto& info = d.info;
    std::string status, message, recognised, corrections, warnings, cleaning, vertical, tests;
    device.read(d.name, d.file, d.raw.sha256, status, message, info.serial, info.lot, info.test_date);
    device.read(info.temperature_C, info.rubber_thickness_mm, info.rubber_area_mm2);
    device.read(recognised, corrections, warnings, cleaning, d.record.dead_band_mm, vertical, tests);
    d.raw.file = d.file;
    if (status == "refused") d.refusal = message.empty() ? status : message;
    d.raw.recognised = wording::findings_of(recognised);
    d.raw.corrections = wording::findings_of(corrections);
    d.raw.warnings = wording::findings_of(warnings);
    d.record.cleaning = wording::findings_of(cleaning);
    d.vertical = vertical_of(vertical);
    take_tests(tests, d);
  }
}

void read_series(Connection const& db, Contents& contents) {
  std::map<std::tuple<std::size_t, std::string, std::string>, std::vector<double>> stored;
  Statement series(db, "SELECT device, kind, channel, count, \"values\" FROM series");
  while (series.row()) {
    std::size_t id = 0;
    std::string kind, channel;
    long long count = 0;
    std::vector<double> values;
    series.read(id, kind, channel, count, values);
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
    search.read(s.device, s.law, s.refusal);
    found[{s.device, s.law}] = s;
  }
  Statement parameter(
      db,
      "SELECT device, law, name, unit, free, value, lower, upper, scale, tied_to FROM search_parameter ORDER BY device, law, position");
  while (parameter.row()) {
    std::size_t device = 0;
    std::string law, scale;
    fit::SearchParameter p;
    long long free = 0;
    std::optional<double> other;
    parameter.read(device, law, p.name, p.unit, free, p.value, p.lower, p.upper, scale, other);
    auto const owner = found.find({device, law});
    if (owner == found.end()) continue;
    p.free = free != 0;
    if (scale == "logarithmic") p.scale = laws::Scale::logarithmic;
    if (other) p.tied_to = static_cast<std::size_t>(std::max(0.0, *other));
    owner->second.first_box.parameters.push_back(std::move(p));
  }
  for (std::size_t d = 0; d < contents.devices.size(); ++d)
    for (auto const& law : contents.settings.laws)
      if (auto const s = found.find({d, law}); s != found.end()) {
        s->second.box = s->second.first_box;
        contents.searches.push_back(s->second);
      }
  if (contents.searches.size() != found.size())
    throw Error({.found = "a law was searched that was not asked for, or on a device that is not there"});
}

Outcome outcome_from(std::string_view text) {
  for (auto const outcome : {Outcome::confirmed, Outcome::budget_spent, Outcome::all_generations, Outcome::stagnated})
    if (name(outcome) == text) return outcome;
  return Outcome::no_finite_value;
}

template <class Analysis>
void read_analyses(Connection const& db, char const* select, std::vector<Analysis>& analyses) {
  Statement row(db, select);
  while (row.row()) {
    auto& analysis = analyses.emplace_back();
    std::string json;
    if constexpr (requires { analysis.device; }) row.read(analysis.device);
    row.read(analysis.law, json, analysis.maker);
    read_analysis(json, analysis);
  }
}

template <class Analysis>
void write_analysis(Connection const& db, char const* insert, Analysis const& analysis) {
  Statement row(db, insert);
  if constexpr (requires { analysis.device; }) row.bind(analysis.device);
  row.bind(analysis.law, analysis_json(analysis), analysis.maker).insert();
}

// The entries of the table meta that Store::describe() may change, with their keys.
std::vector<std::pair<std::string_view, std::string>> descriptions(Contents const& contents) {
  auto const& a = contents.acceptance;
  std::vector<std::pair<std::string_view, std::string>> all{
      {"title", contents.title},
      {"rules", a.rules},
      {"rules-file", a.rules_file},
      {"design", a.design},
      {"lot-size", a.lot_size ? std::to_string(*a.lot_size) : std::string()},
      {"letterhead", a.letterhead},
      {"letterhead-file", a.letterhead_file},
      {"report-units", std::string(a.report_units)}};
  for (auto const& option : alike_table()) all.emplace_back(option.key, text_of(option.get(a)));
  all.emplace_back("conditions", contents.observed ? text(*contents.observed) : std::string());
  return all;
}

void read_descriptions(Connection const& db, Contents& contents) {
  contents.title = meta(db, "title");
  auto& a = contents.acceptance;
  a.rules = meta(db, "rules");
  a.rules_file = meta(db, "rules-file");
  a.design = meta(db, "design");
  if (auto const size = meta(db, "lot-size"); !size.empty()) a.lot_size = parse_lot_size(size);
  a.letterhead = meta(db, "letterhead");
  a.letterhead_file = meta(db, "letterhead-file");
  if (auto const units = meta(db, "report-units"); !units.empty()) a.report_units = find_unit_system(units).id;
  for (auto const& option : alike_table())
    if (auto const text = meta(db, option.key); !text.empty()) option.set(a, value_of(option.kind, {text}));
  if (auto const observed = meta(db, "conditions"); !observed.empty()) contents.observed = tests_of_text(observed);
  contents.part = read_part(db);
}

}  // namespace

void write_campaign(Connection const& db, Contents const& contents, std::vector<Maker> const& makers) {
  campaign_store().begin(db, makers, contents.part);
  for (auto const& [key, value] : descriptions(contents)) write_meta(db, key, value);
  write_meta(db, "faults", faults_to_json(contents));
  Statement setting(db, "INSERT INTO setting VALUES (?, ?, ?)");
  std::size_t position = 0;
  for (auto const& [key, json] : to_pairs(contents.settings)) setting.bind(position++, key, json).insert();
  write_devices(db, contents);
  write_searches(db, contents);
}

void write_descriptions(Connection const& db, Contents const& contents) {
  for (auto const& [key, value] : descriptions(contents)) write_meta(db, key, value);
  Statement analysis(db, "UPDATE setting SET json = ? WHERE key = 'analysis'");
  analysis.bind(contents.settings.analysis ? "\"full\"" : "\"none\"").insert();
  Statement device(
      db,
      "UPDATE device SET serial = ?, lot = ?, test_date = ?, temperature_C = ?, rubber_thickness_mm = ?, rubber_area_mm2 = ?, vertical = ? WHERE id = ?");
  Statement former(db, "DELETE FROM series WHERE device = ? AND kind = ? AND channel = ?");
  SeriesWriter series(db);
  for (std::size_t id = 0; id < contents.devices.size(); ++id) {
    auto const& d = contents.devices[id];
    bind(device, d.info).bind(to_json(d.vertical), id).insert();
    for_each_vertical_series(d, [&](char const* kind, char const* channel, std::vector<double> const& values) {
      former.bind(id, kind, channel).insert();
      series.of(id)(kind, channel, values);
    });
  }
}

RunWriter::RunWriter(Connection const& db)
    : row_(
          db,
          "INSERT INTO run VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (device, law, number) DO NOTHING"),
      parameter_(db, "INSERT INTO run_parameter VALUES (?, ?, ?, ?, ?)"),
      stored_(
          db,
          "SELECT outcome, objective, integration_shift, refinement, evaluations, failed_evaluations, message, history, box FROM run WHERE device = ? AND law = ? AND number = ?"),
      stored_parameters_(
          db, "SELECT value FROM run_parameter WHERE device = ? AND law = ? AND number = ? ORDER BY position") {}

bool RunWriter::add_if_new(Run const& run) {
  row_.bind(run.device, run.law, run.number, name(run.outcome), run.objective, run.integration_shift, run.refinement);
  row_.bind(run.evaluations, run.failed_evaluations, run.failure, run.history, run.box, run.maker);
  if (!row_.insert()) return false;
  for (std::size_t i = 0; i < run.parameters.size(); ++i)
    parameter_.bind(run.device, run.law, run.number, i, run.parameters[i]).insert();
  return true;
}

bool RunWriter::is_there(Run const& run) {
  auto const bits = [](double value) { return std::isnan(value) ? 0 : std::bit_cast<std::uint64_t>(value); };
  auto const same = [&](double a, double b) { return std::isnan(a) == std::isnan(b) && bits(a) == bits(b); };
  Run there{.device = run.device, .law = run.law, .number = run.number};
  std::string outcome;
  if (!stored_.again(run.device, run.law, run.number).row()) return false;
  stored_.read(outcome, there.objective, there.integration_shift, there.refinement, there.evaluations);
  stored_.read(there.failed_evaluations, there.failure, there.history, there.box);
  stored_parameters_.again(run.device, run.law, run.number);
  while (stored_parameters_.row()) stored_parameters_.read(there.parameters.emplace_back());
  return outcome == name(run.outcome) && same(there.objective, run.objective) &&
         same(there.integration_shift, run.integration_shift) && there.refinement == run.refinement &&
         there.evaluations == run.evaluations && there.failed_evaluations == run.failed_evaluations &&
         there.failure == run.failure && std::ranges::equal(there.history, run.history, same) &&
         std::ranges::equal(there.box, run.box, same) && std::ranges::equal(there.parameters, run.parameters, same);
}

void write_row(Connection const& db, Run const& run) {
  if (!RunWriter(db).add_if_new(run))
    throw Error({.found = fmt::format("run {} of {} on device {} is there already", run.number, run.law, run.device)});
}

void write_row(Connection const& db, DeviceAnalysis const& analysis) {
  write_analysis(db, "INSERT INTO device_analysis VALUES (?, ?, ?, ?)", analysis);
}
void write_row(Connection const& db, LotAnalysis const& analysis) {
  write_analysis(db, "INSERT INTO lot_analysis VALUES (?, ?, ?)", analysis);
}
void write_row(Connection const& db, LeftOutAnalysis const& analysis) {
  write_analysis(db, "INSERT INTO left_out VALUES (?, ?, ?, ?)", analysis);
}

Contents read_campaign(Connection const& db) {
  Contents contents;
  read_descriptions(db, contents);
  contents.makers = read_makers(db);
  read_settings(db, contents);
  read_devices(db, contents);
  read_searches(db, contents);
  return contents;
}

void read_runs(Connection const& db, std::function<void(Run)> const& visit) {
  Statement parameter(db,
                      "SELECT device, law, number, value FROM run_parameter ORDER BY device, law, number, position");
  std::tuple<std::size_t, std::string, int> owner;  // the run to which the next parameter belongs
  double value = 0.0;
  bool more = true;
  auto const next_parameter = [&] {
    more = parameter.row();
    if (more) parameter.read(std::get<0>(owner), std::get<1>(owner), std::get<2>(owner), value);
  };
  next_parameter();
  Statement run(
      db,
      "SELECT device, law, number, outcome, objective, integration_shift, refinement, evaluations, failed_evaluations, message, history, box, maker FROM run ORDER BY device, law, number");
  while (run.row()) {
    Run r;
    std::string outcome;
    run.read(r.device, r.law, r.number, outcome, r.objective, r.integration_shift, r.refinement);
    run.read(r.evaluations, r.failed_evaluations, r.failure, r.history, r.box, r.maker);
    r.outcome = outcome_from(outcome);
    auto const key = std::tie(r.device, r.law, r.number);
    while (more && owner < key) next_parameter();  // skips parameters of a run that is not in the store
    for (; more && owner == key; next_parameter()) r.parameters.push_back(value);
    visit(std::move(r));
  }
}

Contents read_campaign_and_series(Connection const& db) {
  auto contents = read_campaign(db);
  read_series(db, contents);
  if (auto const faults = meta(db, "faults"); !faults.empty())
    take_faults(faults, contents);
  else
    for (auto& device : contents.devices)
      for (auto* record : {&device.raw, &device.uncorrected}) data::find_faults(*record);
  contents.find_copies();
  return contents;
}

Analyses read_analyses(Connection const& db) {
  Analyses found;
  read_analyses(db, "SELECT device, law, json, maker FROM device_analysis ORDER BY device, law", found.devices);
  read_analyses(db, "SELECT law, json, maker FROM lot_analysis ORDER BY law", found.lots);
  read_analyses(db, "SELECT device, law, json, maker FROM left_out ORDER BY device, law", found.left_out);
  return found;
}

Contents read_contents(Connection const& db) {
  auto contents = read_campaign_and_series(db);
  read_runs(db, [&](Run run) { contents.runs.push_back(std::move(run)); });
  contents.take_boxes_of_best_runs();
  auto analyses = read_analyses(db);
  contents.device_analyses = std::move(analyses.devices);
  contents.lot_analyses = std::move(analyses.lots);
  contents.left_out = std::move(analyses.left_out);
  // An earlier build may have fitted a law of the lot to devices that are copies of others (Device::copy_of). Such a
  // law is dropped here, so that it counts as missing and is fitted again.
  std::set<std::string, std::less<>> stale;
  for (auto const& lot : contents.lot_analyses)
    if (std::ranges::any_of(lot.devices, [&](std::size_t device) { return !contents.devices[device].counts(); }))
      stale.insert(lot.law);
  std::erase_if(contents.lot_analyses, [&](auto const& lot) { return stale.contains(lot.law); });
  std::erase_if(contents.left_out, [&](auto const& left_out) { return stale.contains(left_out.law); });
  return contents;
}

}  // namespace isolaw::campaign
