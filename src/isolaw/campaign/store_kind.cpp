#include "isolaw/campaign/store_kind.hpp"

#include <fmt/format.h>

#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {

using sqlite::Connection;
using sqlite::Statement;

namespace {

constexpr char const* common_tables = R"sql(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE maker (  -- who computed: the first the records and boxes; build: a hash of the sources that decide numbers
  id INTEGER PRIMARY KEY, version TEXT NOT NULL, build TEXT NOT NULL, instruction_set TEXT NOT NULL);
)sql";

}  // namespace

StoreKind::StoreKind(Words const& words, int schema, std::string tables)
    : words_(words), schema_(schema), tables_(common_tables + std::move(tables)) {
  auto const memory = Connection::in_memory();
  create_tables(memory);
  ours_ = declarations(memory, "store");
}

void StoreKind::create_tables(Connection const& db) const {
  db.execute(tables_);
}

void StoreKind::begin(Connection const& db, std::vector<Maker> const& makers, std::optional<Part> const& part) const {
  create_tables(db);
  write_meta(db, "schema", std::to_string(schema_));
  write_meta(db, "isolaw", makers.front().version);
  write_meta(db, "part", part ? text(*part) : std::string());
  for (std::size_t id = 0; id < makers.size(); ++id) write_row(db, id, makers[id]);
}

void StoreKind::create(std::filesystem::path const& file, std::function<void(Connection const&)> const& fill,
                       std::function<void()> const& before_replacing) {
  // Writes another file and then renames it, so that the old store remains if the disk fills or the program is killed.
  sqlite::require_plain(file);
  sqlite::remove_unfinished(file);
  auto const aside = sqlite::unfinished(file);
  fill(Connection::create(aside));
  if (before_replacing) before_replacing();
  sqlite::move_into_place(aside, file);
}

Connection StoreKind::to_read(std::filesystem::path const& file) const {
  if (!std::filesystem::exists(file))
    throw Error({.where = file.string(),
                 .found = "no such file",
                 .allowed = std::string(words_.file),
                 .advice = fmt::format("{} ... --out DIR makes one", words_.command)});
  auto db = Connection::to_read(file);
  require(db, file);
  return db;
}

Connection StoreKind::to_write(std::filesystem::path const& file) const {
  auto db = Connection::to_write(file);
  require(db, file);
  return db;
}

void StoreKind::fold_log(std::filesystem::path const& file) const {
  if (!sqlite::is_plain(file)) to_write(file).try_execute("PRAGMA journal_mode = DELETE");
}

std::string StoreKind::lost_with(std::filesystem::path const& file) const {
  std::error_code unknown;
  if (!std::filesystem::exists(file, unknown)) return {};
  sqlite::require_plain(file);
  auto const bytes = std::filesystem::file_size(file, unknown);
  if (bytes == 0) return fmt::format("{} was an empty file: nothing is lost", file.string());
  Declarations theirs;
  try {
    theirs = declarations(Connection::to_read(file), file);
  } catch (Error const&) {
    return fmt::format("{} was damaged, or no store of isolaw: its {} bytes are lost", file.string(), bytes);
  }
  if (theirs.empty()) return fmt::format("{} was a database without tables: nothing is lost", file.string());
  // The table meta is the same in every schema of isolaw's stores, so it tells a store of isolaw from other databases.
  if (auto const own = theirs.find("meta"); own != theirs.end() && own->second == ours_.at("meta")) return {};
  std::vector<std::string> names;
  for (auto const& [name, declaration] : theirs) names.push_back(in_quotes(name));
  constexpr std::size_t shown = 5;
  throw Error({.where = file.string(),
               .found = fmt::format("is a database of another program, which holds {}", shortened(names, shown)),
               .allowed = fmt::format("with --fresh, a {} of isolaw, which it replaces", words_.store),
               .advice = "another directory, or moving that file away"});
}

void StoreKind::put_in_order(std::filesystem::path const& file) const {
  sqlite::put_in_order(file, [this](Connection const& db) { create_tables(db); });
}

StoreKind::Declarations StoreKind::declarations(Connection const& db, std::filesystem::path const& file) {
  Declarations found;
  try {
    Statement objects(db, "SELECT name, sql FROM sqlite_master");
    while (objects.row()) {
      auto name = objects.text();
      found[std::move(name)] = objects.text();
    }
  } catch (std::bad_alloc const&) {  // SQLite also reports lack of memory for some damaged schemas
    sqlite::refuse_damaged(file.string(), "its tables cannot be read");
  }
  return found;
}

void StoreKind::require(Connection const& db, std::filesystem::path const& file) const {
  auto const theirs = declarations(db, file);
  auto const same = [&](std::string const& name) {
    auto const found = theirs.find(name);
    return found != theirs.end() && found->second == ours_.at(name);
  };
  int const version = same("meta") ? number_in<int>(meta(db, "schema")).value_or(0) : 0;
  if (version < 1) {
    std::error_code unknown;
    bool const empty = std::filesystem::file_size(file, unknown) == 0;
    throw Error({.where = file.string(),
                 .found = fmt::format("not a {} of isolaw{}", words_.store, empty ? ": an empty file" : ""),
                 .allowed = std::string(words_.file),
                 .advice = std::string(empty ? sqlite::advice_on_damaged : words_.advice)});
  }
  if (version != schema_)
    throw Error(
        {.where = file.string(),
         .found = fmt::format("a store of schema {}, written by isolaw {}", version, in_quotes(meta(db, "isolaw"))),
         .allowed = fmt::format("schema {}", schema_),
         .advice =
             fmt::format("{} with the same command and --fresh, or use the isolaw that wrote it", words_.once_more)});
  for (auto const& [name, declaration] : ours_)
    if (!same(name))
      sqlite::refuse_damaged(file.string(), fmt::format("table '{}' is missing or not as isolaw makes it", name));
  for (auto const& [name, declaration] : theirs)
    if (!ours_.contains(name))
      sqlite::refuse_damaged(file.string(), fmt::format("it holds {}, which isolaw does not make", in_quotes(name)));
}

void StoreKind::refuse_unreadable(std::filesystem::path const& file) {
  try {
    throw;
  } catch (nlohmann::json::exception const& error) {
    sqlite::refuse_damaged(file.string(), error.what());
  } catch (Error const& error) {
    if (error.complaints().front().where == file.string()) throw;
    sqlite::refuse_damaged(file.string(), error.what());
  }
}

std::string meta(Connection const& db, std::string_view key) {
  Statement select(db, "SELECT value FROM meta WHERE key = ?");
  select.bind(key);
  return select.row() ? select.text() : std::string();
}

void write_meta(Connection const& db, std::string_view key, std::string_view value) {
  Statement(db, "INSERT OR REPLACE INTO meta VALUES (?, ?)").bind(key, value).insert();
}

std::optional<Part> read_part(Connection const& db) {
  auto const part = meta(db, "part");
  return part.empty() ? std::nullopt : std::optional(parse_part(part));
}

std::vector<Maker> read_makers(Connection const& db) {
  std::vector<Maker> makers;
  Statement row(db, "SELECT version, build, instruction_set FROM maker ORDER BY id");
  while (row.row()) {
    auto& maker = makers.emplace_back();
    row.read(maker.version, maker.build, maker.instruction_set);
  }
  if (makers.empty()) throw Error({.found = "no word on the isolaw that made it"});
  return makers;
}

void write_row(Connection const& db, std::size_t id, Maker const& maker) {
  Statement(db, "INSERT INTO maker VALUES (?, ?, ?, ?)")
      .bind(id, maker.version, maker.build, maker.instruction_set)
      .insert();
}

}  // namespace isolaw::campaign
