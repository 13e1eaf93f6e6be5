#include "isolaw/campaign/schema.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

using sqlite::Connection;
using sqlite::Statement;

constexpr char const* tables = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE maker (  -- who computed: the first the records and boxes; build: a hash of the sources that decide numbers
  id INTEGER PRIMARY KEY, version TEXT NOT NULL, build TEXT NOT NULL, instruction_set TEXT NOT NULL);
CREATE TABLE setting (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, json TEXT NOT NULL);
CREATE TABLE device (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, file TEXT NOT NULL, sha256 TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('ok', 'refused')), message TEXT NOT NULL,
  serial TEXT NOT NULL, lot TEXT NOT NULL, test_date TEXT NOT NULL,
  temperature_C REAL, rubber_thickness_mm REAL, rubber_area_mm2 REAL,
  recognised TEXT NOT NULL, corrections TEXT NOT NULL, warnings TEXT NOT NULL, cleaning TEXT NOT NULL, dead_band_mm REAL NOT NULL,
  vertical TEXT NOT NULL);  -- compression test as JSON but for its series; empty: none
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
  message TEXT NOT NULL, history BLOB NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id),
  PRIMARY KEY (device, law, number)) WITHOUT ROWID;
CREATE TABLE run_parameter (
  device INTEGER NOT NULL, law TEXT NOT NULL, number INTEGER NOT NULL, position INTEGER NOT NULL, value REAL NOT NULL,
  PRIMARY KEY (device, law, number, position)) WITHOUT ROWID;
CREATE TABLE device_analysis (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id), PRIMARY KEY (device, law)) WITHOUT ROWID;
CREATE TABLE lot_analysis (law TEXT PRIMARY KEY, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id)) WITHOUT ROWID;
CREATE TABLE left_out (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id), PRIMARY KEY (device, law)) WITHOUT ROWID;
)sql";

using Declarations = std::map<std::string, std::string>;  // by name

Declarations declarations(Connection const& db) {  // tables, and additions of other programs
  Declarations found;
  Statement objects(db, "SELECT name, sql FROM sqlite_master");
  while (objects.row()) {
    auto name = objects.text();
    found[std::move(name)] = objects.text();
  }
  return found;
}

[[noreturn]] void refuse_foreign(std::filesystem::path const& file) {
  std::error_code unknown;
  bool const empty = std::filesystem::file_size(file, unknown) == 0;
  throw Error({.where = file.string(),
               .found = empty ? "not a campaign store of isolaw: an empty file" : "not a campaign store of isolaw",
               .allowed = "campaign.sqlite of a campaign",
               .advice = empty ? sqlite::advice_on_damaged : ""});
}

}  // namespace

void create_tables(Connection const& db) {
  db.execute(tables);
}

std::string meta(Connection const& db, std::string_view key) {
  Statement select(db, "SELECT value FROM meta WHERE key = ?");
  select.bind(key);
  return select.row() ? select.text() : std::string();
}

void require_schema(Connection const& db, std::filesystem::path const& file) {
  auto const theirs = declarations(db);
  static auto const ours = [] {
    auto const memory = Connection::in_memory();
    create_tables(memory);
    return declarations(memory);
  }();
  auto const same = [&](std::string const& name) {
    auto const found = theirs.find(name);
    return found != theirs.end() && found->second == ours.at(name);
  };
  if (!same("meta")) refuse_foreign(file);
  int const version = number_in<int>(meta(db, "schema")).value_or(0);
  if (version < 1) refuse_foreign(file);
  if (version != schema_version)
    throw Error(
        {.where = file.string(),
         .found = fmt::format("a store of schema {}, written by isolaw {}", version, in_quotes(meta(db, "isolaw"))),
         .allowed = fmt::format("schema {}", schema_version),
         .advice = "calibrate again with the same command and --fresh, or use the isolaw that wrote it"});
  for (auto const& [name, declaration] : ours)
    if (!same(name))
      sqlite::refuse_damaged(file.string(), fmt::format("table '{}' is missing or not as isolaw makes it", name));
  for (auto const& [name, declaration] : theirs)
    if (!ours.contains(name))
      sqlite::refuse_damaged(file.string(), fmt::format("it holds {}, which isolaw does not make", in_quotes(name)));
}

}  // namespace isolaw::campaign
