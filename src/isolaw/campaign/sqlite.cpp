#include "isolaw/campaign/sqlite.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"

namespace isolaw::campaign::sqlite {
namespace {

static_assert(std::endian::native == std::endian::little, "series are stored as little-endian doubles");

[[noreturn]] void fail(sqlite3* db, std::string_view doing) {
  auto const* name = db == nullptr ? nullptr : sqlite3_db_filename(db, "main");
  std::string const file = name == nullptr ? "store" : name;
  int const code = db == nullptr ? SQLITE_NOMEM : sqlite3_errcode(db) & 0xff;
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  if (code == SQLITE_NOTADB || code == SQLITE_CORRUPT) refuse_damaged(file, sqlite3_errmsg(db));
  if (code == SQLITE_READONLY && name != nullptr && has_log(file))
    throw Error(
        {.where = file,
         .found = "the program was stopped in the middle of a write, which must be undone before it can be read",
         .advice = "the command it was started with: it does so, and continues"});
  if (code == SQLITE_READONLY)
    throw Error({.where = file,
                 .found = "may not be written",
                 .allowed = "a store, and its directory, that this user may write",
                 .advice = "another directory, or the permissions of this one"});
  if (code == SQLITE_CANTOPEN && name != nullptr && has_log(file))
    throw Error(
        {.where = file,
         .found =
             "the program was killed, and the last finished runs are in the log beside the store, which is read only where files can be made beside it",
         .allowed = "a store in a directory that may be written, or one whose campaign ended",
         .advice =
             "a copy of the whole directory where you may write; or let its owner run the command it was started with, which folds the log in"});
  throw Error({.where = file,
               .found = fmt::format("{}: {}", doing, sqlite3_errmsg(db)),
               .advice = "check free space and permissions of the directory; finished runs in the store are kept"});
}

std::uintmax_t bytes_of_pages(Connection const& db) {
  Statement size(db, "SELECT page_size * page_count FROM pragma_page_size, pragma_page_count");
  std::size_t bytes = 0;
  if (size.row()) size.read(bytes);
  return bytes;
}

}  // namespace

void refuse_damaged(std::string file, std::string_view reason) {
  throw Error({.where = std::move(file),
               .found = fmt::format("not a store of isolaw, or a damaged one: {}", reason),
               .allowed = "campaign.sqlite or building.sqlite as isolaw left it",
               .advice = advice_on_damaged});
}

bool has_log(std::filesystem::path const& file) {
  std::error_code unknown;
  return std::filesystem::exists(file.string() + "-wal", unknown) ||
         std::filesystem::exists(file.string() + "-journal", unknown);
}

void require_plain(std::filesystem::path const& file) {
  for (auto const* suffix : {"", companion_suffixes[0], companion_suffixes[1], companion_suffixes[2]})
    if (auto const kind = other_than_plain(file.string() + suffix))
      throw Error({.where = file.string() + suffix,
                   .found = "is " + *kind,
                   .allowed = "campaign.sqlite or building.sqlite, a plain file",
                   .advice = "another directory"});
}

void Connection::Close::operator()(sqlite3* db) const {
  sqlite3_close_v2(db);
}

Connection Connection::open(std::string const& name, int flags, std::filesystem::path const& file) {
  sqlite3* raw = nullptr;
  int const status = sqlite3_open_v2(name.c_str(), &raw, flags, nullptr);
  Connection db(raw);
  if (status != SQLITE_OK)
    throw Error(
        {.where = file.string(),
         .found = fmt::format("cannot open the store: {}", raw == nullptr ? "out of memory" : sqlite3_errmsg(raw)),
         .advice = "check that the directory exists and may be written"});
  sqlite3_busy_timeout(raw, 5000);
  // A store may come from a stranger: allow no value larger than the longest series, and in its schema only
  // functions that SQLite regards as harmless.
  constexpr int largest_value_bytes = 256 << 20;
  sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, largest_value_bytes);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  return db;
}

Connection Connection::create(std::filesystem::path const& file) {
  return open(file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, file);
}

Connection Connection::to_write(std::filesystem::path const& file) {
  require_plain(file);
  return open(file.string(), SQLITE_OPEN_READWRITE, file);
}

Connection Connection::to_read(std::filesystem::path const& file) {
  require_plain(file);
  if (has_log(file)) return open(file.string(), SQLITE_OPEN_READONLY, file);
  std::string uri = "file:";
  for (char const c : std::filesystem::absolute(file).generic_string())
    uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02x}", static_cast<unsigned char>(c)) : std::string(1, c);
  return open(uri + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, file);
}

Connection Connection::in_memory() {
  return open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "store");
}

void Connection::execute(std::string const& sql) const {
  if (sqlite3_exec(get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail(get(), "cannot write");
}

bool Connection::try_execute(char const* sql) const noexcept {
  return sqlite3_exec(get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK;
}

Statement::Statement(Connection const& db, std::string const& sql) : db_(db.get()) {
  if (sqlite3_prepare_v2(db_, sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK) fail(db_, "cannot read");
}

Statement::~Statement() {
  sqlite3_finalize(statement_);
}

void Statement::check(int status) {
  if (status != SQLITE_OK) fail(db_, "cannot write");
}

void Statement::put(std::string_view text) {
  check(sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
}
void Statement::put(std::size_t value) {
  check(sqlite3_bind_int64(statement_, ++bound_, static_cast<sqlite3_int64>(value)));
}
void Statement::put(int value) {
  check(sqlite3_bind_int64(statement_, ++bound_, value));
}
void Statement::put(double value) {
  check(std::isnan(value) ? sqlite3_bind_null(statement_, ++bound_) : sqlite3_bind_double(statement_, ++bound_, value));
}
void Statement::put(std::optional<double> value) {
  put(value.value_or(std::nan("")));
}
void Statement::put(std::vector<double> const& values) {
  if (values.empty()) return check(sqlite3_bind_zeroblob(statement_, ++bound_, 0));  // a null address would bind NULL
  check(sqlite3_bind_blob64(statement_, ++bound_, values.data(), values.size() * sizeof(double), SQLITE_TRANSIENT));
}

bool Statement::insert() {
  if (sqlite3_step(statement_) != SQLITE_DONE) fail(db_, "cannot write");
  bool const changed = sqlite3_changes(db_) > 0;
  start_over();
  return changed;
}

void Statement::start_over() {
  sqlite3_reset(statement_);
  bound_ = 0;
}

bool Statement::row() {
  int const status = sqlite3_step(statement_);
  if (status != SQLITE_ROW && status != SQLITE_DONE) fail(db_, "cannot read");
  next_ = 0;
  return status == SQLITE_ROW;
}

std::string Statement::text() {
  std::string text;
  take(text);
  return text;
}

void Statement::take(std::string& text) {
  auto const* bytes = sqlite3_column_text(statement_, next_);
  auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, next_++));
  text =
      bytes == nullptr ? std::string() : std::string(static_cast<char const*>(static_cast<void const*>(bytes)), size);
}
void Statement::take(long long& value) {
  value = sqlite3_column_int64(statement_, next_++);
}
void Statement::take(std::size_t& value) {
  value = static_cast<std::size_t>(sqlite3_column_int64(statement_, next_++));
}
void Statement::take(int& value) {
  auto const stored = sqlite3_column_int64(statement_, next_++);
  if (!std::in_range<int>(stored)) throw Error({.found = fmt::format("the number {}, which is too large", stored)});
  value = static_cast<int>(stored);
}
void Statement::take(double& value) {
  bool const null = sqlite3_column_type(statement_, next_) == SQLITE_NULL;
  double const stored = sqlite3_column_double(statement_, next_++);
  value = null ? std::nan("") : stored;
}
void Statement::take(std::optional<double>& value) {
  double stored = 0.0;
  take(stored);
  value = std::isnan(stored) ? std::nullopt : std::optional(stored);
}
void Statement::take(std::vector<double>& values) {
  auto const* bytes = sqlite3_column_blob(statement_, next_);
  auto const size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, next_++));
  if (size % sizeof(double) != 0) throw Error({.found = fmt::format("a series of {} bytes", size)});
  values.resize(size / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), bytes, size);
}

std::string Statement::whole_row() {
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

std::filesystem::path unfinished(std::filesystem::path const& file) {
  return file.string() + ".part";
}

void remove_unfinished(std::filesystem::path const& file) {
  std::error_code ignored;
  auto const aside = unfinished(file).string();
  for (auto const& name : {unfinished(aside).string(), aside})  // put_in_order(aside) may have left unfinished(aside)
    for (auto const* suffix : {companion_suffixes[0], companion_suffixes[1], companion_suffixes[2], ""})
      std::filesystem::remove(name + suffix, ignored);
  // put_in_order() works on two files in one transaction. While it commits, SQLite keeps a list of both beside them.
  auto const list = std::filesystem::path(aside).filename().string() + "-mj";
  std::vector<std::filesystem::path> lists;
  for (std::filesystem::directory_iterator at(std::filesystem::absolute(file, ignored).parent_path(), ignored), end;
       at != end; at.increment(ignored))
    if (at->path().filename().string().starts_with(list)) lists.push_back(at->path());
  for (auto const& left : lists) std::filesystem::remove(left, ignored);
}

void move_into_place(std::filesystem::path const& whole, std::filesystem::path const& file) {
  // SQLite would apply a log of the former file to the new file, so the log is removed. It is first folded into the
  // former file, so that this file is complete if the program is killed before the rename. If the former file has
  // another schema or is damaged, the log cannot be folded in and is lost.
  std::error_code error;
  if (std::filesystem::exists(file, error) && !is_plain(file)) try {
      Connection::to_write(file).try_execute("PRAGMA journal_mode = DELETE");
    } catch (Error const&) {
    }
  for (auto const* suffix : companion_suffixes) std::filesystem::remove(file.string() + suffix, error);
  std::filesystem::rename(whole, file, error);
  if (error)
    throw Error({.where = file.string(),
                 .found = "cannot make the store: " + error.message(),
                 .advice = "check free space and permissions of the directory"});
}

bool is_plain(std::filesystem::path const& file) {
  require_plain(file);
  // Bytes 18 and 19 of an SQLite file are 1 with a rollback journal and 2 with a write-ahead log.
  std::array<char, 20> header{};
  std::ifstream(file, std::ios::binary).read(header.data(), header.size());
  return !has_log(file) && header[18] == 1 && header[19] == 1;
}

void put_in_order(std::filesystem::path const& file, std::function<void(Connection const&)> const& create_tables) {
  std::array<char, 28> header{};  // bytes 24 to 27 of an SQLite file count the transactions that wrote to it
  std::ifstream(file, std::ios::binary).read(header.data(), header.size());
  bool const written_once = header[24] == 0 && header[25] == 0 && header[26] == 0 && header[27] == 1;
  if (written_once || !is_plain(file)) return;
  auto const aside = unfinished(file);
  remove_unfinished(file);
  try {
    auto const db = Connection::create(aside);
    Statement(db, "ATTACH DATABASE ? AS former").bind(file.string()).insert();
    Transaction transaction(db);
    create_tables(db);
    std::vector<std::string> names;
    for (Statement table(db, "SELECT name FROM main.sqlite_master WHERE type = 'table' ORDER BY rowid"); table.row();)
      names.push_back(table.text());
    for (auto const& name : names)
      db.execute(fmt::format("INSERT INTO main.\"{0}\" SELECT * FROM former.\"{0}\"", name));
    transaction.commit();
  } catch (Error const&) {
    return remove_unfinished(file);  // the old file stays; it is complete, only not in order
  }
  std::error_code error;
  std::filesystem::rename(aside, file, error);
  if (error) remove_unfinished(file);
}

std::vector<std::string> integrity(std::filesystem::path const& file) {
  auto const db = Connection::to_read(file);
  std::vector<std::string> faults;
  // SQLite reads a file that was cut off within a page as if the rest were zeros, and finds no fault.
  auto const bytes = std::filesystem::file_size(file);
  if (auto const whole = bytes_of_pages(db); is_plain(file) && whole != bytes)
    faults.push_back(fmt::format("it has {} bytes instead of {}", bytes, whole));
  for (auto const* pragma : {"PRAGMA integrity_check", "PRAGMA foreign_key_check"}) {
    Statement rows(db, pragma);
    while (rows.row())
      if (auto row = rows.text(); row != "ok") faults.push_back(std::move(row));
  }
  return faults;
}

}  // namespace isolaw::campaign::sqlite
