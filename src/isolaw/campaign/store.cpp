#include "isolaw/campaign/store.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/analysis_json.hpp"

namespace isolaw::campaign {
namespace {

static_assert(std::endian::native == std::endian::little, "series are stored as little-endian doubles");

constexpr char const* schema = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE setting (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, json TEXT NOT NULL);
CREATE TABLE device (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, file TEXT NOT NULL, sha256 TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('ok', 'refused')), message TEXT NOT NULL,
  serial TEXT NOT NULL, lot TEXT NOT NULL, test_date TEXT NOT NULL,
  temperature_C REAL, rubber_thickness_mm REAL, rubber_area_mm2 REAL,
  recognised TEXT NOT NULL, corrections TEXT NOT NULL, warnings TEXT NOT NULL, cleaning TEXT NOT NULL);
CREATE TABLE series (  -- values: little-endian 8-byte floats; kind: as read, or as the laws saw it
  device INTEGER NOT NULL REFERENCES device(id), kind TEXT NOT NULL CHECK (kind IN ('raw', 'fit')),
  channel TEXT NOT NULL, count INTEGER NOT NULL, "values" BLOB NOT NULL,
  PRIMARY KEY (device, kind, channel)) WITHOUT ROWID;
CREATE TABLE search (
  device INTEGER NOT NULL REFERENCES device(id), law TEXT NOT NULL, refusal TEXT NOT NULL,
  PRIMARY KEY (device, law)) WITHOUT ROWID;
CREATE TABLE search_parameter (
  device INTEGER NOT NULL, law TEXT NOT NULL, position INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
  free INTEGER NOT NULL, value REAL, lower REAL, upper REAL, scale TEXT NOT NULL, tied_to INTEGER,
  PRIMARY KEY (device, law, position)) WITHOUT ROWID;
CREATE TABLE run (
  device INTEGER NOT NULL, law TEXT NOT NULL, number INTEGER NOT NULL, outcome TEXT NOT NULL,
  objective REAL, integration_shift REAL, refinement INTEGER NOT NULL, evaluations INTEGER NOT NULL, failed_evaluations INTEGER NOT NULL,
  message TEXT NOT NULL, history BLOB NOT NULL,
  PRIMARY KEY (device, law, number)) WITHOUT ROWID;
CREATE TABLE run_parameter (
  device INTEGER NOT NULL, law TEXT NOT NULL, number INTEGER NOT NULL, position INTEGER NOT NULL, value REAL NOT NULL,
  PRIMARY KEY (device, law, number, position)) WITHOUT ROWID;
CREATE TABLE device_analysis (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, PRIMARY KEY (device, law)) WITHOUT ROWID;
CREATE TABLE lot_analysis (law TEXT PRIMARY KEY, json TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE left_out (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, PRIMARY KEY (device, law)) WITHOUT ROWID;
)sql";

[[noreturn]] void refuse_damaged(std::string file, std::string_view what) {
  throw Error({.where = std::move(file),
               .found = fmt::format("not a campaign store of isolaw, or a damaged one: {}", what),
               .allowed = "campaign.sqlite of a campaign",
               .advice = "a copy of it, or --fresh to start over"});
}

bool has_log(std::filesystem::path const& file) {
  std::error_code unknown;
  return std::filesystem::exists(file.string() + "-wal", unknown) ||
         std::filesystem::exists(file.string() + "-journal", unknown);
}

constexpr std::array beside{"-wal", "-shm", "-journal"};  // SQLite's own files beside a store

// A pipe or a device would be waited for, or set going.
void require_plain(std::filesystem::path const& file) {
  for (auto const* suffix : {"", beside[0], beside[1], beside[2]})
    if (auto const kind = other_than_plain(file.string() + suffix))
      throw Error({.where = file.string() + suffix,
                   .found = "is " + *kind,
                   .allowed = "campaign.sqlite of a campaign, a plain file",
                   .advice = "another directory"});
}

[[noreturn]] void fail(sqlite3* db, std::string_view doing) {
  auto const* file = db == nullptr ? nullptr : sqlite3_db_filename(db, "main");
  int const code = db == nullptr ? SQLITE_NOMEM : sqlite3_errcode(db) & 0xff;
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT)
    refuse_damaged(file == nullptr ? "campaign store" : file, sqlite3_errmsg(db));
  if (code == SQLITE_READONLY)
    throw Error(
        {.where = file == nullptr ? "campaign store" : file,
         .found = "the program was stopped in the middle of a write, which must be undone before it can be read",
         .advice = "the calibrate command it was started with: it does so, and continues"});
  if (code == SQLITE_CANTOPEN && file != nullptr && has_log(file))
    throw Error({.where = file,
                 .found =
                     "the program was killed, and the last finished runs are in the log beside the store, which is "
                     "read only where files can be made beside it",
                 .allowed = "a store in a directory that may be written, or one whose campaign ended",
                 .advice = "a copy of the whole directory where you may write; or let its owner run the calibrate "
                           "command it was started with, which folds the log in"});
  throw Error({.where = file == nullptr ? "campaign store" : file,
               .found = fmt::format("{}: {}", doing, sqlite3_errmsg(db)),
               .advice = "check free space and permissions of the directory; finished runs in the store are kept"});
}

void execute(sqlite3* db, char const* sql) {
  if (sqlite3_exec(db, sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail(db, "cannot write");
}

// A prepared statement whose values are bound in order.
class Statement {
 public:
  Statement(sqlite3* db, char const* sql) : db_(db) {
    if (sqlite3_prepare_v2(db, sql, -1, &statement_, nullptr) != SQLITE_OK) fail(db, "cannot read");
  }
  Statement(Statement const&) = delete;
  Statement& operator=(Statement const&) = delete;
  ~Statement() { sqlite3_finalize(statement_); }

  Statement& bind(std::string_view text) {
    return check(sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
  }
  Statement& bind(std::size_t value) {
    return check(sqlite3_bind_int64(statement_, ++bound_, static_cast<sqlite3_int64>(value)));
  }
  Statement& bind(int value) { return check(sqlite3_bind_int64(statement_, ++bound_, value)); }
  Statement& bind(double value) {  // not a number is stored as NULL
    return check(std::isnan(value) ? sqlite3_bind_null(statement_, ++bound_)
                                   : sqlite3_bind_double(statement_, ++bound_, value));
  }
  Statement& bind(std::optional<double> value) { return bind(value.value_or(std::nan(""))); }
  Statement& bind(std::vector<double> const& values) {
    return check(
        sqlite3_bind_blob64(statement_, ++bound_, values.data(), values.size() * sizeof(double), SQLITE_TRANSIENT));
  }
  // Runs an INSERT or UPDATE and makes the statement ready for the next row.
  void insert() {
    if (sqlite3_step(statement_) != SQLITE_DONE) fail(db_, "cannot write");
    sqlite3_reset(statement_);
    bound_ = 0;
  }
  // The next row of a SELECT.
  bool row() {
    int const status = sqlite3_step(statement_);
    if (status != SQLITE_ROW && status != SQLITE_DONE) fail(db_, "cannot read");
    next_ = 0;
    return status == SQLITE_ROW;
  }
  std::string text() {
    auto const* bytes = sqlite3_column_text(statement_, next_);
    auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, next_++));
    return bytes == nullptr ? std::string()
                            : std::string(static_cast<char const*>(static_cast<void const*>(bytes)), size);
  }
  sqlite3_int64 integer() { return sqlite3_column_int64(statement_, next_++); }
  std::size_t index() { return static_cast<std::size_t>(integer()); }
  double real() {
    bool const null = sqlite3_column_type(statement_, next_) == SQLITE_NULL;
    double const value = sqlite3_column_double(statement_, next_++);
    return null ? std::nan("") : value;
  }
  // Of a column that holds a count or a number of a run.
  int whole() {
    auto const value = integer();
    if (!std::in_range<int>(value)) throw Error({.found = fmt::format("the number {}, which is too large", value)});
    return static_cast<int>(value);
  }
  std::optional<double> optional_real() {
    double const value = real();
    return std::isnan(value) ? std::nullopt : std::optional(value);
  }
  // All values of the row, with their kinds.
  std::string whole_row() {
    std::string row;
    for (int i = 0; i < sqlite3_column_count(statement_); ++i) {
      auto const kind = sqlite3_column_type(statement_, i);
      double const real = sqlite3_column_double(statement_, i);
      row += fmt::format("{}:", kind);
      if (kind == SQLITE_FLOAT) {
        row += fmt::format("{:x}|", std::bit_cast<std::uint64_t>(real));
        continue;
      }
      auto const* bytes = static_cast<char const*>(sqlite3_column_blob(statement_, i));
      auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, i));
      row += fmt::format("{}:{}|", size, size == 0 ? std::string_view() : std::string_view(bytes, size));
    }
    return row;
  }
  std::vector<double> reals() {
    auto const* bytes = sqlite3_column_blob(statement_, next_);
    auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, next_++));
    if (size % sizeof(double) != 0) throw Error({.found = fmt::format("a series of {} bytes", size)});
    std::vector<double> values(size / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), bytes, values.size() * sizeof(double));
    return values;
  }

 private:
  Statement& check(int status) {
    if (status != SQLITE_OK) fail(db_, "cannot write");
    return *this;
  }
  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
  int next_ = 0;
};

// BEGIN ... COMMIT; rolled back when left by an exception.
class Transaction {
 public:
  explicit Transaction(sqlite3* db) : db_(db) { execute(db_, "BEGIN IMMEDIATE"); }
  Transaction(Transaction const&) = delete;
  Transaction& operator=(Transaction const&) = delete;
  ~Transaction() {
    if (!done_) sqlite3_exec(db_, "ROLLBACK", nullptr, nullptr, nullptr);
  }
  void commit() {
    execute(db_, "COMMIT");
    done_ = true;
  }

 private:
  sqlite3* db_;
  bool done_ = false;
};

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

void write_devices(sqlite3* db, Contents const& contents) {
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

void write_searches(sqlite3* db, Contents const& contents) {
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

void read_settings(sqlite3* db, Contents& contents) {
  std::vector<std::pair<std::string, std::string>> pairs;
  Statement setting(db, "SELECT key, json FROM setting ORDER BY position");
  while (setting.row()) {
    auto key = setting.text();
    pairs.emplace_back(std::move(key), setting.text());
  }
  contents.settings = settings_from_pairs(pairs);
  contents.settings.validate();
}

void read_devices(sqlite3* db, Contents& contents) {
  Statement device(
      db,
      "SELECT name, file, sha256, status, message, serial, lot, test_date, temperature_C, "
      "rubber_thickness_mm, rubber_area_mm2, recognised, corrections, warnings, cleaning FROM device ORDER BY id");
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

void read_searches(sqlite3* db, Contents& contents) {
  Statement search(db, "SELECT device, law, refusal FROM search");
  std::map<std::pair<std::size_t, std::string>, Search> found;
  while (search.row()) {
    Search s;
    s.device = search.index();
    s.law = search.text();
    s.refusal = search.text();
    found[{s.device, s.law}] = s;
  }
  Statement parameter(db,
                      "SELECT device, law, name, unit, free, value, lower, upper, scale, tied_to FROM search_parameter "
                      "ORDER BY device, law, position");
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

void read_runs(sqlite3* db, Contents& contents) {
  std::map<std::tuple<std::size_t, std::string, int>, std::vector<double>> values;
  Statement parameter(db,
                      "SELECT device, law, number, value FROM run_parameter ORDER BY device, law, number, position");
  while (parameter.row()) {
    auto const device = parameter.index();
    auto law = parameter.text();
    auto const number = parameter.whole();
    values[{device, std::move(law), number}].push_back(parameter.real());
  }
  Statement run(db,
                "SELECT device, law, number, outcome, objective, integration_shift, refinement, evaluations, "
                "failed_evaluations, message, history FROM run ORDER BY device, law, number");
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
    if (auto const found = values.find({r.device, r.law, r.number}); found != values.end())
      r.parameters = std::move(found->second);
    contents.runs.push_back(std::move(r));
  }
}

void read_analyses(sqlite3* db, Contents& contents) {
  Statement device(db, "SELECT device, law, json FROM device_analysis ORDER BY device, law");
  while (device.row()) {
    auto const index = device.index();
    auto law = device.text();
    contents.device_analyses.push_back(device_analysis(index, std::move(law), device.text()));
  }
  Statement lot(db, "SELECT law, json FROM lot_analysis ORDER BY law");
  while (lot.row()) {
    auto law = lot.text();
    contents.lot_analyses.push_back(lot_analysis(std::move(law), lot.text()));
  }
  Statement left_out(db, "SELECT device, law, json FROM left_out ORDER BY device, law");
  while (left_out.row()) {
    auto const index = left_out.index();
    auto law = left_out.text();
    contents.left_out.push_back(left_out_analysis(index, std::move(law), left_out.text()));
  }
}

std::string meta(sqlite3* db, std::string_view key) {
  Statement select(db, "SELECT value FROM meta WHERE key = ?");
  select.bind(key);
  return select.row() ? select.text() : std::string();
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

void read_descriptions(sqlite3* db, Contents& contents) {
  contents.title = meta(db, "title");
  auto& a = contents.acceptance;
  a.rules = meta(db, "rules");
  a.rules_file = meta(db, "rules-file");
  a.design = meta(db, "design");
  if (auto const size = meta(db, "lot-size"); !size.empty()) a.lot_size = parse_lot_size(size);
}

// What readers of Contents rely on: indices and lengths that fit together. A store this program wrote has them; a damaged
// or foreign one need not.
class Consistency {
 public:
  Consistency(Contents const& contents, std::string file) : contents_(contents), file_(std::move(file)) {
    for (auto const& search : contents.searches) search_of_[{search.device, search.law}] = &search;
  }

  void require() const {
    for (auto const& device : contents_.devices) device_fits(device);
    for (auto const& search : contents_.searches) search_fits(search);
    for (auto const& run : contents_.runs) run_fits(run);
    for (auto const& analysis : contents_.device_analyses) analysis_fits(analysis);
    for (auto const& analysis : contents_.lot_analyses) analysis_fits(analysis);
    for (auto const& analysis : contents_.left_out) analysis_fits(analysis);
  }

 private:
  void device_fits(Device const& d) const {
    auto const same = [&](auto const& channel, std::size_t size) { return channel.empty() || channel.size() == size; };
    auto const& raw = d.raw;
    auto const& fit = d.record;
    bool const fits = same(raw.time_s, raw.size()) && raw.force_kN.size() == raw.size() &&
                      same(raw.load_kN, raw.size()) && fit.time_s.size() == fit.size() &&
                      same(fit.vel_mm_s, fit.size()) && fit.force_kN.size() == fit.size() &&
                      same(fit.scored, fit.size()) && same(fit.block, fit.size());
    if (!fits) fail(fmt::format("the channels of device '{}' differ in length", d.name));
    if (!std::ranges::all_of(fit.scored, [](double value) { return value == 0.0 || value == 1.0; }))
      fail(fmt::format("what is scored of device '{}' is neither 0 nor 1", d.name));
    if (d.usable() && fit.size() == 0) fail(fmt::format("device '{}' has no record", d.name));
  }
  void search_fits(Search const& s) const {
    auto const law =
        std::ranges::find(laws::catalogue(), std::string_view(s.law), [](auto const& l) { return l.info.id; });
    if (law == laws::catalogue().end()) fail(fmt::format("law '{}' is not known", s.law));
    if (!s.refusal.empty()) return;
    if (!contents_.devices[s.device].usable())
      fail(fmt::format("{} was searched on '{}', which was refused", s.law, contents_.devices[s.device].name));
    if (s.box.parameters.size() != law->parameters.size())
      fail(fmt::format("the box of {} has {} parameters instead of {}", s.law, s.box.parameters.size(),
                       law->parameters.size()));
    for (std::size_t i = 0; i < law->parameters.size(); ++i) {
      auto const& p = s.box.parameters[i];
      if (p.name != law->parameters[i].name)
        fail(fmt::format("parameter {} of {} is called '{}'", i + 1, s.law, p.name));
      if (p.tied_to && (p.free || *p.tied_to >= s.box.parameters.size()))
        fail(fmt::format("parameter {} of {} is tied to none", p.name, s.law));
      if (!std::isfinite(p.free ? p.lower + p.upper : p.value))
        fail(fmt::format("the box of {} of {} is not finite", p.name, s.law));
    }
  }
  void run_fits(Run const& r) const {
    auto const found = search_of_.find({r.device, r.law});
    if (found == search_of_.end() || !found->second->refusal.empty())
      fail(fmt::format("a run of {} on device {}, which was not searched", r.law, r.device));
    if (r.number < 1 || r.number > contents_.settings.runs)
      fail(fmt::format("run {} of {}, of {} asked for", r.number, r.law, contents_.settings.runs));
    refinement_fits(r.refinement);
    if (r.usable() && r.parameters.size() != found->second->box.parameters.size())
      fail(fmt::format("run {} of {} has {} parameters", r.number, r.law, r.parameters.size()));
    if (!std::ranges::all_of(r.parameters, [](double value) { return std::isfinite(value); }))
      fail(fmt::format("run {} of {} has a parameter that is not finite", r.number, r.law));
    if (r.usable() != r.failure.empty() || r.usable() != std::isfinite(r.objective))
      fail(fmt::format("run {} of {} is neither a result nor a failure", r.number, r.law));
  }
  Search const& searched(std::size_t device, std::string const& law) const {
    auto const found = search_of_.find({device, law});
    if (found == search_of_.end() || !found->second->refusal.empty())
      fail(fmt::format("an analysis of {} on device {}, which was not searched", law, device));
    return *found->second;
  }
  void values_fit(std::vector<double> const& parameters, Search const& search) const {
    if (parameters.size() != search.box.parameters.size() ||
        !std::ranges::all_of(parameters, [](double value) { return std::isfinite(value); }))
      fail(fmt::format("an analysis of {} without its parameters", search.law));
  }
  void refinement_fits(int refinement) const {
    constexpr int finest = 64;
    if (refinement < 1 || refinement > finest) fail(fmt::format("{} steps per sample", refinement));
  }
  void analysis_fits(DeviceAnalysis const& a) const {
    auto const& search = searched(a.device, a.law);
    refinement_fits(a.refinement);
    values_fit(a.determination.optimum, search);
    auto const free = search.box.free_count();
    auto const is_free = [&](std::size_t i) {
      return i < search.box.parameters.size() && search.box.parameters[i].free;
    };
    auto const names = [&](auto const& items) {
      return items.size() == free && std::ranges::all_of(items, [&](auto const& p) { return is_free(p.parameter); });
    };
    bool fits = names(a.determination.parameters) && names(a.intervals.parameters) &&
                a.intervals.covariance.size() == free * free;
    for (auto const& p : a.determination.parameters)
      fits = fits && p.profile.value.size() == p.profile.objective.size();
    for (auto const& t : a.determination.trade_offs)
      fits = fits && t.change.size() == t.parameters.size() && std::ranges::all_of(t.parameters, is_free);
    if (!fits) fail(fmt::format("an analysis of {} that does not fit its parameters", a.law));
  }
  void analysis_fits(LotAnalysis const& a) const {
    refinement_fits(a.refinement);
    for (auto const device : a.devices) {
      auto const& search = searched(device, a.law);
      if (a.mean.parameters.empty()) continue;
      values_fit(a.mean.parameters, search);
      values_fit(a.worst.law.parameters, search);
    }
    if (!a.mean.parameters.empty() &&
        (a.mean.objectives.size() != a.devices.size() || a.worst.law.objectives.size() != a.devices.size()))
      fail(fmt::format("the law of the lot, {}, is not judged by every device", a.law));
  }
  void analysis_fits(LeftOutAnalysis const& a) const {
    auto const& search = searched(a.device, a.law);
    if (!a.left_out.parameters.empty()) values_fit(a.left_out.parameters, search);
  }
  [[noreturn]] void fail(std::string found) const { refuse_damaged(file_, found); }

  Contents const& contents_;
  std::string file_;
  std::map<std::pair<std::size_t, std::string_view>, Search const*> search_of_;
};

struct CloseQuietly {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};

std::unique_ptr<sqlite3, CloseQuietly> in_memory() {
  sqlite3* raw = nullptr;
  int const status = sqlite3_open(":memory:", &raw);
  std::unique_ptr<sqlite3, CloseQuietly> memory(raw);
  if (status != SQLITE_OK) fail(raw, "cannot read");
  return memory;
}

// What the file declares, by name: tables, and what another program may have added.
std::map<std::string, std::string> declarations(sqlite3* db) {
  std::map<std::string, std::string> found;
  Statement tables(db, "SELECT name, sql FROM sqlite_master");
  while (tables.row()) {
    auto name = tables.text();
    found[std::move(name)] = tables.text();
  }
  return found;
}

std::map<std::string, std::string> const& our_declarations() {
  static auto const ours = [] {
    auto const memory = in_memory();
    execute(memory.get(), schema);
    return declarations(memory.get());
  }();
  return ours;
}

// A store of ours, of a schema this version knows. Its tables must be declared word by word as ours: a view or a computed
// column in place of one could run without end, or fill the memory; a trigger could change what is written.
void check_schema(sqlite3* db, std::filesystem::path const& file) {
  auto const theirs = declarations(db);
  auto const is_ours = [&](std::string const& name) {
    auto const found = theirs.find(name);
    return found != theirs.end() && found->second == our_declarations().at(name);
  };
  auto const version = is_ours("meta") ? meta(db, "schema") : std::string();
  if (version.empty())
    throw Error({.where = file.string(),
                 .found = "not a campaign store of isolaw",
                 .allowed = "campaign.sqlite of a campaign"});
  if (version != std::to_string(Store::schema_version))
    throw Error({.where = file.string(),
                 .found = fmt::format("schema version {}", version),
                 .allowed = fmt::format("version {}", Store::schema_version),
                 .advice = "the version of isolaw that wrote it"});
  for (auto const& [name, declaration] : our_declarations())
    if (!is_ours(name))
      refuse_damaged(file.string(), fmt::format("table '{}' is missing or not as isolaw makes it", name));
  for (auto const& [name, declaration] : theirs)
    if (!our_declarations().contains(name))
      refuse_damaged(file.string(), fmt::format("it holds {}, which isolaw does not make", in_quotes(name)));
}

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::confirmed:
      return "confirmed";
    case Outcome::budget_spent:
      return "budget_spent";
    case Outcome::all_generations:
      return "all_generations";
    case Outcome::stagnated:
      return "stagnated";
    case Outcome::no_finite_value:
      return "no_finite_value";
  }
  return "";
}

void Store::Close::operator()(sqlite3* db) const {
  sqlite3_close_v2(db);
}

Store::Handle Store::open_handle(std::filesystem::path const& file, int flags, std::string const& uri) {
  sqlite3* raw = nullptr;
  int const status = sqlite3_open_v2(uri.empty() ? file.c_str() : uri.c_str(), &raw, flags, nullptr);
  Handle db(raw);
  if (status != SQLITE_OK)
    throw Error(
        {.where = file.string(),
         .found = fmt::format("cannot open the store: {}", raw == nullptr ? "out of memory" : sqlite3_errmsg(raw)),
         .advice = "check that the directory exists and may be written"});
  sqlite3_busy_timeout(raw, 5000);
  // Stores come from others, too: no value larger than the longest series, no functions run by the schema.
  constexpr int largest_value_bytes = 256 << 20;
  sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, largest_value_bytes);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  return db;
}

namespace {
std::filesystem::path unfinished(std::filesystem::path const& file) {
  return file.string() + ".part";
}
}  // namespace

void Store::remove_unfinished(std::filesystem::path const& file) {
  std::error_code ignored;
  for (auto const* suffix : {"-journal", ""}) std::filesystem::remove(unfinished(file).string() + suffix, ignored);
}

// Whatever the file is: a store of another schema, a damaged one. What cannot be folded in is not to be had.
void Store::fold_log(std::filesystem::path const& file) {
  if (!std::filesystem::exists(file) || is_plain(file)) return;
  try {
    auto const handle = open_handle(file, SQLITE_OPEN_READWRITE);
    sqlite3_exec(handle.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr);
  } catch (Error const&) {
    return;
  }
}

Store Store::create(std::filesystem::path const& file, Contents const& contents,
                    std::function<void()> const& before_replacing) {
  // Written aside and moved into place when whole: whatever stops the program, there is a store or there is none, and
  // the one it replaces is not lost to a full disk or a kill.
  require_plain(file);
  remove_unfinished(file);
  auto const aside = unfinished(file);
  {
    auto const handle = open_handle(aside, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    fill(handle.get(), contents);
  }
  if (before_replacing) before_replacing();
  // A log of the former store beside the new one would be taken for the new one's. Folded in before it is removed, so
  // that the former store is whole without it should the program be killed just now.
  fold_log(file);
  std::error_code error;
  for (auto const* suffix : beside) std::filesystem::remove(file.string() + suffix, error);
  std::filesystem::rename(aside, file, error);
  if (error)
    throw Error({.where = file.string(),
                 .found = "cannot make the store: " + error.message(),
                 .advice = "check free space and permissions of the directory"});
  return open(file);
}

void Store::fill(sqlite3* db, Contents const& contents) {
  Transaction transaction(db);
  execute(db, schema);
  Statement meta(db, "INSERT INTO meta VALUES (?, ?)");
  meta.bind("schema").bind(std::to_string(schema_version)).insert();
  meta.bind("isolaw").bind(ISOLAW_VERSION).insert();
  for (auto const& [key, value] : descriptions(contents)) meta.bind(key).bind(value).insert();
  Statement setting(db, "INSERT INTO setting VALUES (?, ?, ?)");
  std::size_t position = 0;
  for (auto const& [key, json] : to_pairs(contents.settings)) setting.bind(position++).bind(key).bind(json).insert();
  write_devices(db, contents);
  write_searches(db, contents);
  transaction.commit();
}

bool Store::is_plain(std::filesystem::path const& file) {
  require_plain(file);
  // Bytes 18 and 19 of an SQLite file: 1 for a rollback journal, 2 for a write-ahead log.
  std::array<char, 20> header{};
  std::ifstream(file, std::ios::binary).read(header.data(), header.size());
  return !has_log(file) && header[18] == 1 && header[19] == 1;
}

Store::Handle Store::open_to_read(std::filesystem::path const& file) {
  require_plain(file);
  if (has_log(file)) return open_handle(file, SQLITE_OPEN_READONLY);
  // Nobody writes: read without locks and without files beside it, which read-only media and some network shares lack.
  std::string uri = "file:";
  for (char const c : std::filesystem::absolute(file).generic_string())
    uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
  return open_handle(file, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, uri + "?immutable=1");
}

Store Store::open(std::filesystem::path const& file) {
  require_plain(file);
  auto handle = open_handle(file, SQLITE_OPEN_READWRITE);
  check_schema(handle.get(), file);
  execute(handle.get(), "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  return Store(std::move(handle), file);
}

Contents Store::read(std::filesystem::path const& file) {
  if (!std::filesystem::exists(file))
    throw Error({.where = file.string(),
                 .found = "no such file",
                 .allowed = "campaign.sqlite of a campaign",
                 .advice = "isolaw calibrate ... --out DIR makes one"});
  auto const handle = open_to_read(file);
  auto* db = handle.get();
  check_schema(db, file);
  Contents contents;
  try {
    read_descriptions(db, contents);
    read_settings(db, contents);
    read_devices(db, contents);
    read_searches(db, contents);
    read_runs(db, contents);
    read_analyses(db, contents);
  } catch (nlohmann::json::exception const& error) {
    refuse_damaged(file.string(), error.what());
  } catch (Error const& error) {
    if (error.complaints().front().where == file.string()) throw;
    refuse_damaged(file.string(), error.what());
  }
  Consistency(contents, file.string()).require();
  return contents;
}

namespace {

void write_run(sqlite3* db, Run const& run) {
  Statement row(db, "INSERT INTO run VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  row.bind(run.device).bind(run.law).bind(run.number).bind(name(run.outcome)).bind(run.objective);
  row.bind(run.integration_shift)
      .bind(run.refinement)
      .bind(run.evaluations)
      .bind(run.failed_evaluations)
      .bind(run.failure);
  row.bind(run.history).insert();
  Statement parameter(db, "INSERT INTO run_parameter VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.parameters.size(); ++i)
    parameter.bind(run.device).bind(run.law).bind(run.number).bind(i).bind(run.parameters[i]).insert();
}

void write_analysis(sqlite3* db, DeviceAnalysis const& analysis) {
  Statement row(db, "INSERT INTO device_analysis VALUES (?, ?, ?)");
  row.bind(analysis.device).bind(analysis.law).bind(analysis_json(analysis)).insert();
}
void write_analysis(sqlite3* db, LotAnalysis const& analysis) {
  Statement row(db, "INSERT INTO lot_analysis VALUES (?, ?)");
  row.bind(analysis.law).bind(analysis_json(analysis)).insert();
}
void write_analysis(sqlite3* db, LeftOutAnalysis const& analysis) {
  Statement row(db, "INSERT INTO left_out VALUES (?, ?, ?)");
  row.bind(analysis.device).bind(analysis.law).bind(analysis_json(analysis)).insert();
}

template <class Analysis>
void add_analysis(sqlite3* db, Analysis const& analysis) {
  Transaction transaction(db);
  write_analysis(db, analysis);
  transaction.commit();
}

// The rows of a table, each as one text that tells values and their kinds apart.
std::vector<std::string> rows_of(sqlite3* db, std::string const& columns_and_table) {
  std::vector<std::string> found;
  Statement rows(db, ("SELECT " + columns_and_table).c_str());
  while (rows.row()) found.push_back(rows.whole_row());
  std::ranges::sort(found);
  return found;
}

}  // namespace

void Store::add(Run const& run) {
  Transaction transaction(db_.get());
  write_run(db_.get(), run);
  transaction.commit();
}

void Store::add(DeviceAnalysis const& analysis) {
  add_analysis(db_.get(), analysis);
}
void Store::add(LotAnalysis const& analysis) {
  add_analysis(db_.get(), analysis);
}
void Store::add(LeftOutAnalysis const& analysis) {
  add_analysis(db_.get(), analysis);
}

std::vector<std::string> Store::foreign_rows(std::filesystem::path const& file, Contents const& contents) {
  auto const theirs = open_to_read(file);
  auto const ours = in_memory();
  fill(ours.get(), contents);
  execute(ours.get(), "BEGIN");
  for (auto const& run : contents.runs) write_run(ours.get(), run);
  for (auto const& analysis : contents.device_analyses) write_analysis(ours.get(), analysis);
  for (auto const& analysis : contents.lot_analyses) write_analysis(ours.get(), analysis);
  for (auto const& analysis : contents.left_out) write_analysis(ours.get(), analysis);
  execute(ours.get(), "COMMIT");
  std::vector<std::string> faults;
  for (auto const* table :
       {"key, value FROM meta WHERE key <> 'isolaw'", "* FROM setting", "* FROM device",
        "device, kind, channel, count FROM series", "* FROM search", "* FROM search_parameter", "* FROM run",
        "* FROM run_parameter", "* FROM device_analysis", "* FROM lot_analysis", "* FROM left_out"}) {
    std::vector<std::string> differing;
    std::ranges::set_symmetric_difference(rows_of(theirs.get(), table), rows_of(ours.get(), table),
                                          std::back_inserter(differing));
    auto const name = std::string_view(table).substr(std::string_view(table).find("FROM ") + 5);
    if (!differing.empty())
      faults.push_back(
          fmt::format("table '{}' holds rows that are not as isolaw writes them", name.substr(0, name.find(' '))));
  }
  return faults;
}

void Store::describe(Contents const& contents) {
  auto* db = db_.get();
  Transaction transaction(db);
  Statement meta(db, "UPDATE meta SET value = ? WHERE key = ?");
  for (auto const& [key, value] : descriptions(contents)) meta.bind(value).bind(key).insert();
  Statement analysis(db, "UPDATE setting SET json = ? WHERE key = 'analysis'");
  analysis.bind(contents.settings.analysis ? "\"full\"" : "\"none\"").insert();
  Statement device(db,
                   "UPDATE device SET serial = ?, lot = ?, test_date = ?, temperature_C = ?, rubber_thickness_mm = ?, "
                   "rubber_area_mm2 = ? WHERE id = ?");
  for (std::size_t id = 0; id < contents.devices.size(); ++id) {
    auto const& info = contents.devices[id].info;
    device.bind(info.serial).bind(info.lot).bind(info.test_date);
    device.bind(info.temperature_C).bind(info.rubber_thickness_mm).bind(info.rubber_area_mm2).bind(id).insert();
  }
  transaction.commit();
}

std::vector<std::string> Store::integrity(std::filesystem::path const& file) {
  auto const handle = open_to_read(file);
  std::vector<std::string> faults;
  for (auto const* pragma : {"PRAGMA integrity_check", "PRAGMA foreign_key_check"}) {
    Statement rows(handle.get(), pragma);
    while (rows.row())
      if (auto row = rows.text(); row != "ok") faults.push_back(std::move(row));
  }
  return faults;
}

bool Store::finish() {
  return sqlite3_exec(db_.get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr) == SQLITE_OK;
}

}  // namespace isolaw::campaign
