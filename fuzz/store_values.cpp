// Makes a valid campaign store, changes single values in it as the input says, and then does what the commands that
// read a store do. The other target for stores, store.cpp, changes bytes of the file, and SQLite refuses most of these
// changes.
#include <sqlite3.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "harness.hpp"
#include "isolaw/api/building_work.hpp"
#include "isolaw/api/calibrate.hpp"
#include "isolaw/api/fitted.hpp"
#include "isolaw/campaign/check.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/draws.hpp"

namespace {

using namespace isolaw;

struct Value {
  int type = SQLITE_NULL;
  std::int64_t integer = 0;
  double real = 0.0;
  std::string bytes = {};  // the content if the value is a text or blob
};
using Row = std::vector<Value>;
struct Table {
  std::string name, schema;
  std::vector<Row> rows;
};

struct Database {
  explicit Database(std::string const& file) { fuzz::require(sqlite3_open(file.c_str(), &db) == SQLITE_OK, "open"); }
  Database(Database const&) = delete;
  Database& operator=(Database const&) = delete;
  ~Database() { sqlite3_close(db); }
  void execute(std::string const& sql) {
    fuzz::require(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK, sql.c_str());
  }
  sqlite3* db = nullptr;
};

std::vector<Row> rows_of(Database const& database, std::string const& sql) {
  sqlite3_stmt* statement = nullptr;
  fuzz::require(sqlite3_prepare_v2(database.db, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK, sql.c_str());
  std::vector<Row> rows;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    auto& row = rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(statement); ++i) {
      auto& value = row.emplace_back();
      value.type = sqlite3_column_type(statement, i);
      if (value.type == SQLITE_INTEGER) value.integer = sqlite3_column_int64(statement, i);
      if (value.type == SQLITE_FLOAT) value.real = sqlite3_column_double(statement, i);
      if (value.type == SQLITE_TEXT || value.type == SQLITE_BLOB)
        if (auto const* bytes = static_cast<char const*>(sqlite3_column_blob(statement, i)))
          value.bytes.assign(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement, i)));
    }
  }
  sqlite3_finalize(statement);
  return rows;
}

void insert(Database const& database, Table const& table) {
  if (table.rows.empty()) return;
  std::string sql = "INSERT OR IGNORE INTO " + table.name + " VALUES (?";
  for (std::size_t i = 1; i < table.rows.front().size(); ++i) sql += ", ?";
  sqlite3_stmt* statement = nullptr;
  fuzz::require(sqlite3_prepare_v2(database.db, (sql + ")").c_str(), -1, &statement, nullptr) == SQLITE_OK, "insert");
  for (auto const& row : table.rows) {
    int place = 0;
    for (auto const& value : row) {
      auto const count = static_cast<int>(value.bytes.size());
      ++place;
      switch (value.type) {
        case SQLITE_INTEGER:
          sqlite3_bind_int64(statement, place, value.integer);
          break;
        case SQLITE_FLOAT:
          sqlite3_bind_double(statement, place, value.real);
          break;
        case SQLITE_TEXT:
          sqlite3_bind_text(statement, place, value.bytes.data(), count, SQLITE_STATIC);
          break;
        case SQLITE_BLOB:
          sqlite3_bind_blob(statement, place, value.bytes.data(), count, SQLITE_STATIC);
          break;
        default:
          sqlite3_bind_null(statement, place);
      }
    }
    sqlite3_step(statement);  // if the schema does not allow the row, the row is left out
    sqlite3_reset(statement);
  }
  sqlite3_finalize(statement);
}

// Returns the tables of a finished campaign with three devices, two laws and every kind of analysis.
std::vector<Table> sound_store(std::filesystem::path const& folder) {
  std::vector<campaign::NamedRecord> records;
  for (double const factor : {1.0, 1.04, 0.97}) {
    std::string text = "t [s],disp [mm],force [kN]\n";
    for (int i = 0; i < 42; ++i) {
      double const angle = std::numbers::pi * i / 5.0;
      text += std::to_string(0.1 * i) + "," + std::to_string(100.0 * std::sin(angle)) + "," +
              std::to_string(factor * 50.0 * std::sin(angle + 0.3)) + "\n";
    }
    auto const name = std::string(1, static_cast<char>('a' + records.size()));
    records.push_back({.name = name, .record = data::read_record_text(text, name + ".csv")});
  }
  campaign::Settings settings;
  settings.laws = {"bilinear", "jankowski"};
  settings.method = campaign::Method::genetic;
  settings.runs = 2;
  settings.genetic.population = 4;
  settings.genetic.generations = 2;
  settings.replicates = 40;
  calibrate(std::move(records), settings, {.run = {.jobs = 1}, .directory = folder / "sound"});
  Database const database((folder / "sound" / "campaign.sqlite").string());
  std::vector<Table> tables;
  for (auto const& row : rows_of(database, "SELECT name, sql FROM sqlite_schema WHERE sql <> '' ORDER BY rowid"))
    tables.push_back({row[0].bytes, row[1].bytes, rows_of(database, "SELECT * FROM " + row[0].bytes)});
  return tables;
}

// Returns the bytes of the input one after another, and zeros after the end of the input.
struct Bytes {
  std::string_view left;
  std::size_t next() {
    if (left.empty()) return 0;
    auto const byte = static_cast<unsigned char>(left.front());
    left.remove_prefix(1);
    return byte;
  }
  std::size_t below(std::size_t count) {
    auto const low = next();
    return (low + 256 * next()) % count;
  }
};

Value odd_value(Bytes& bytes) {
  static std::array const integers{0LL,
                                   1LL,
                                   -1LL,
                                   2LL,
                                   7LL,
                                   99LL,
                                   2147483647LL,
                                   4294967296LL,
                                   std::numeric_limits<long long>::max(),
                                   std::numeric_limits<long long>::min()};
  static std::array const reals{0.5, -1.0, 1e-300, 1e300, -1e300, std::numeric_limits<double>::infinity(), 1e9};
  static std::array const texts{"",      "x",        "[]",        "{}",       "[1]", "null",
                                "1e999", "bilinear", "jankowski", "\x1b[31m", "\xff"};
  switch (bytes.below(5)) {
    case 0:
      return {};
    case 1:
      return {.type = SQLITE_INTEGER, .integer = integers[bytes.below(integers.size())]};
    case 2:
      return {.type = SQLITE_FLOAT, .real = reals[bytes.below(reals.size())]};
    case 3:
      return {.type = SQLITE_TEXT, .bytes = texts[bytes.below(texts.size())]};
    default:
      return {.type = SQLITE_BLOB, .bytes = std::string(bytes.below(64), '\0')};
  }
}

// Changes a part of a text or blob: it replaces a number in JSON by another value, or it changes single bytes.
void edit(Value& value, Bytes& bytes) {
  static std::array const numbers{"0",     "-1",   "1",     "2",  "99", "1e300", "-1e300",
                                  "1e999", "null", "\"x\"", "[]", "{}", "true"};
  auto& text = value.bytes;
  if (text.empty()) return;
  auto const at = bytes.below(text.size());
  if (value.type == SQLITE_BLOB) {
    static std::array const reals{0.0, -1.0, 1e300, std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity()};
    auto const real = reals[bytes.below(reals.size())];
    if (text.size() >= sizeof real) std::memcpy(text.data() + at / 8 * 8, &real, sizeof real);
    return;
  }
  auto const first = text.find_first_of("-0123456789", at);
  if (auto const way = bytes.below(4); way == 0 || first == std::string::npos) {
    text[at] = static_cast<char>(bytes.next());
  } else if (way == 1) {
    text.erase(at, 1 + bytes.below(64));
  } else {
    auto const last = std::min(text.find_first_not_of("-+.eE0123456789", first), text.size());
    text.replace(first, last - first, numbers[bytes.below(numbers.size())]);
  }
}

void change(Table& table, Bytes& bytes) {
  auto& rows = table.rows;
  auto const way = bytes.below(8);
  if (rows.empty()) return;
  auto const row = bytes.below(rows.size()), column = bytes.below(rows.front().size()),
             other = bytes.below(rows.size());
  auto& value = rows[row][column];
  switch (way) {
    case 0:
      rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row));
      break;
    case 1: {  // removes all rows with the same value in this column
      auto const same = value;
      std::erase_if(rows, [&](Row const& each) {
        return each[column].type == same.type && each[column].integer == same.integer &&
               each[column].bytes == same.bytes;
      });
      break;
    }
    case 2:
      value = odd_value(bytes);
      break;
    case 3: {  // puts one odd value into this column of all rows
      auto const odd = odd_value(bytes);
      for (auto& each : rows) each[column] = odd;
      break;
    }
    case 4:
      std::swap(value, rows[other][column]);
      break;
    case 5:
      value = rows[other][bytes.below(rows.front().size())];
      break;
    default:
      edit(value, bytes);
  }
}

std::string in_a_file(std::vector<Table> const& tables) {
  Database database(":memory:");
  database.execute("PRAGMA page_size = 4096; PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON; BEGIN");
  for (auto const& table : tables) {
    database.execute(table.schema);
    insert(database, table);
  }
  database.execute("COMMIT");
  sqlite3_int64 size = 0;
  auto* const bytes = sqlite3_serialize(database.db, "main", &size, 0);
  fuzz::require(bytes != nullptr, "a database in memory can be copied");
  std::string file(fuzz::as_text(bytes, static_cast<std::size_t>(size)));
  sqlite3_free(bytes);
  return file;
}

void use(campaign::Contents const& contents) {
  auto const summary = study::build_summary(contents);
  for (auto const& [name, text] : render::output_texts(summary))
    if (name.ends_with(".json")) fuzz::require(nlohmann::json::accept(text), name.c_str());
  render::for_each_figure(summary, render::FigureChoice::all, [](render::Figure const&) {});
  render::ranking(summary, 80);
  for (auto const& law : contents.settings.laws) {
    fuzz::attempt([&] { study::draw_devices(contents, summary, law, 3, 1, "store"); });
    for (auto const* device : {"a", "lot"}) {
      fuzz::attempt([&] { fitted_law(contents, law, device); });
      fuzz::attempt([&] {
        auto const subject = programs::make_subject(contents, summary, law, device);
        // "cpp" exports the law itself and is fast. Most other export targets first fit another material to the law.
        programs::write_export(subject, programs::find_target("cpp"), unit_systems[0], true);
      });
    }
  }
  fuzz::attempt([&] {
    building::Motion const motion{.name = "m", .step_s = 0.01, .x_mm_s2 = {0.0, 900.0, -900.0, 0.0}};
    auto file = building::read_building_text(building::building_template(), "b.toml", {}, {.motions = {motion}});
    file.settings.laws = {"bilinear"};
    checked_model(building_study(std::move(file), contents, "store"));
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  static fuzz::Folder const folder;
  static auto const sound = sound_store(folder.path());
  auto tables = sound;
  Bytes bytes{fuzz::as_text(data, size)};
  for (int changes = 0; changes < 8 && !bytes.left.empty(); ++changes)
    change(tables[bytes.below(tables.size())], bytes);
  auto const file = folder.path() / "campaign.sqlite";
  std::ofstream(file, std::ios::binary | std::ios::trunc) << in_a_file(tables);
  fuzz::attempt([&] { campaign::check(file); });
  fuzz::attempt([&] { use(campaign::Store::read(file)); });
  return 0;
}
