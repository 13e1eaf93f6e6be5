#include "isolaw/campaign/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/version.hpp"
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

// What a schema added to the table before it: in an older store the declaration lacks these words, and its rows are
// read as if they held `before`, an SQL value.
struct Addition {
  int since;
  char const *table, *column, *words, *before;
};
constexpr std::array additions{
    Addition{2, "run", "failed_evaluations", " failed_evaluations INTEGER NOT NULL,",
             "CASE WHEN objective IS NULL THEN evaluations ELSE 0 END"},
    Addition{2, "run", "message", "\n  message TEXT NOT NULL,",
             "CASE WHEN objective IS NULL THEN 'no parameter set gave a finite force' ELSE '' END"},
    Addition{3, "device", "corrections", " corrections TEXT NOT NULL,", "'[]'"},
    Addition{4, "search_parameter", "tied_to", " tied_to INTEGER,", "NULL"},
    Addition{4, "run", "refinement", " refinement INTEGER NOT NULL,", "1"},
    Addition{5, "run", "maker", " maker INTEGER NOT NULL REFERENCES maker(id),", "0"},
    Addition{5, "device_analysis", "maker", " maker INTEGER NOT NULL REFERENCES maker(id),", "0"},
    Addition{5, "lot_analysis", "maker", ", maker INTEGER NOT NULL REFERENCES maker(id)", "0"},
    Addition{5, "left_out", "maker", " maker INTEGER NOT NULL REFERENCES maker(id),", "0"},
    Addition{6, "device", "dead_band_mm", ", dead_band_mm REAL NOT NULL", "0.0"},
    Addition{7, "device", "vertical", ",\n  vertical TEXT NOT NULL", "''"},
};

// A table that a schema added; an older store reads as if it held these rows.
struct AddedTable {
  int since;
  char const *table, *rows;
};
constexpr std::array added_tables{
    AddedTable{4, "device_analysis", "SELECT 0 AS device, '' AS law, '' AS json, 0 AS maker WHERE 0"},
    AddedTable{4, "lot_analysis", "SELECT '' AS law, '' AS json, 0 AS maker WHERE 0"},
    AddedTable{4, "left_out", "SELECT 0 AS device, '' AS law, '' AS json, 0 AS maker WHERE 0"},
    AddedTable{
        5, "maker",
        "SELECT 0 AS id, value AS version, '' AS build, '' AS instruction_set FROM main.meta WHERE key = 'isolaw'"}};

// Settings that older stores lack, with what the program of their time did.
struct AddedSetting {
  int since;
  char const *key, *json;
};
constexpr std::array added_settings{AddedSetting{2, "turning-points", "\"sampled\""},
                                    AddedSetting{3, "fit-blocks", "\"all\""},
                                    AddedSetting{3, "fit-cycles", "\"all\""},
                                    AddedSetting{4, "score-blocks", "\"all\""},
                                    AddedSetting{4, "analysis", "\"none\""},
                                    AddedSetting{4, "replicates", "0"},
                                    AddedSetting{6, "dead-band", "0.0"},
                                    AddedSetting{9, "bidirectional", "\"none\""}};

// Keys of meta that a schema added, empty before.
struct AddedKey {
  int since;
  char const* key;
};
constexpr std::array added_keys{AddedKey{3, "rules"}, AddedKey{3, "rules-file"}, AddedKey{3, "design"},
                                AddedKey{3, "lot-size"}, AddedKey{8, "part"}};

using Declarations = std::map<std::string, std::string>;  // by name

// What a file declares: tables, and what another program may have added.
Declarations declarations(Connection const& db) {
  Declarations found;
  Statement objects(db, "SELECT name, sql FROM sqlite_master");
  while (objects.row()) {
    auto name = objects.text();
    found[std::move(name)] = objects.text();
  }
  return found;
}

Connection const& empty_store() {
  static auto const made = [] {
    auto memory = Connection::in_memory();
    create_tables(memory);
    return memory;
  }();
  return made;
}

// As a program of schema `version` declared them.
Declarations declarations_of(int version) {
  auto found = declarations(empty_store());
  for (auto const& [since, table, rows] : added_tables)
    if (version < since) found.erase(table);
  for (auto const& [since, table, column, words, before] : additions) {
    auto const declared = found.find(table);
    if (version >= since || declared == found.end()) continue;
    auto& text = declared->second;
    text.erase(text.find(words), std::string_view(words).size());
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

// A store of ours, of a schema this version knows. Its tables must be declared word by word as ours: a view or a
// computed column in place of one could run without end, or fill the memory; a trigger could change what is written.
int checked_version(Connection const& db, std::filesystem::path const& file) {
  auto const theirs = declarations(db);
  auto const present = declarations_of(schema_version);
  auto const same = [&](std::string const& name, std::string const& declaration) {
    auto const found = theirs.find(name);
    return found != theirs.end() && found->second == declaration;
  };
  if (!same("meta", present.at("meta"))) refuse_foreign(file);
  int const version = number_in<int>(meta(db, "schema")).value_or(0);
  if (version < 1) refuse_foreign(file);
  if (version > schema_version)
    throw Error(
        {.where = file.string(),
         .found = fmt::format("written by a newer isolaw, {}, as schema {}", in_quotes(meta(db, "isolaw")), version),
         .allowed = fmt::format("schema 1 to {}, which isolaw {} reads", schema_version, isolaw::version()),
         .advice = "the isolaw that wrote it, or a newer one"});
  auto const ours = declarations_of(version);
  for (auto const& [name, declaration] : ours)
    if (!same(name, declaration))
      sqlite::refuse_damaged(file.string(), fmt::format("table '{}' is missing or not as isolaw makes it", name));
  for (auto const& [name, declaration] : theirs)
    if (!ours.contains(name))
      sqlite::refuse_damaged(file.string(), fmt::format("it holds {}, which isolaw does not make", in_quotes(name)));
  return version;
}

// The rows of a table as the present schema has them, read from one of schema `version`; empty where they are the same.
std::string rows_as_present(std::string const& table, int version) {
  for (auto const& added : added_tables)
    if (version < added.since && table == added.table) return added.rows;
  std::vector<std::string> columns;
  bool changed = false;
  Statement present(empty_store(), "SELECT name FROM pragma_table_info(?)");
  present.bind(table);
  while (present.row()) {
    auto const column = present.text();
    auto const added = std::ranges::find_if(
        additions, [&](Addition const& a) { return version < a.since && table == a.table && column == a.column; });
    bool const missing = added != additions.end();
    columns.push_back(missing ? fmt::format("{} AS \"{}\"", added->before, column) : fmt::format("\"{}\"", column));
    changed = changed || missing;
  }
  return changed ? fmt::format("SELECT {} FROM main.\"{}\"", joined(columns), table) : std::string();
}

// Reads as one of the present schema from now on; the file is not changed.
void show_as_present(Connection const& db, int version) {
  db.execute("PRAGMA temp_store = MEMORY");
  // A view is found before the table of the same name.
  for (auto const& [table, declaration] : declarations(empty_store()))
    if (auto const rows = rows_as_present(table, version); !rows.empty())
      db.execute(fmt::format("CREATE TEMP VIEW \"{}\" AS {}", table, rows));
  db.execute(
      "CREATE TEMP TABLE setting AS SELECT * FROM main.setting; CREATE TEMP TABLE meta AS SELECT * FROM main.meta");
  Statement setting(db, "INSERT INTO temp.setting SELECT max(position) + 1, ?, ? FROM temp.setting");
  for (auto const& [since, key, json] : added_settings)
    if (version < since) setting.bind(key, json).insert();
  Statement described(db, "INSERT INTO temp.meta VALUES (?, '')");
  for (auto const& [since, key] : added_keys)
    if (version < since) described.bind(key).insert();
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

void require_readable_schema(Connection const& db, std::filesystem::path const& file) {
  if (int const version = checked_version(db, file); version < schema_version) show_as_present(db, version);
}

void require_present_schema(Connection const& db, std::filesystem::path const& file) {
  int const version = checked_version(db, file);
  if (version < schema_version)
    throw Error({.where = file.string(),
                 .found = fmt::format("of an older isolaw, {}, as schema {}", in_quotes(meta(db, "isolaw")), version),
                 .allowed = fmt::format("schema {}, to write to; isolaw report and isolaw check read older ones",
                                        schema_version),
                 .advice = "the isolaw that wrote it, to go on; or --fresh to start over, or another --out DIR"});
}

}  // namespace isolaw::campaign
