// SQLite's handles, closed by themselves; what goes wrong is said as of a campaign store.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace isolaw::campaign::sqlite {

// Of what is damaged: of a part of a merge, too, whose own --fresh is another.
inline constexpr char const* advice_on_damaged =
    "copying it once more, or the command that computed it, with --fresh, which starts over";

inline constexpr std::array beside{"-wal", "-shm", "-journal"};  // SQLite's own files beside a store

[[noreturn]] void refuse_damaged(std::string file, std::string_view what);
// Throws Error for a pipe or a device, which would be waited for, or set going.
void require_plain(std::filesystem::path const& file);
bool has_log(std::filesystem::path const& file);

class Connection {
 public:
  // Each throws Error, and std::bad_alloc.
  static Connection create(std::filesystem::path const& file);
  static Connection to_write(std::filesystem::path const& file);
  // Where nobody writes without locks and without files beside it, which read-only media and some network shares lack.
  static Connection to_read(std::filesystem::path const& file);
  static Connection in_memory();

  void execute(std::string const& sql) const;
  bool try_execute(char const* sql) const noexcept;
  sqlite3* get() const { return db_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* db) const;
  };
  static Connection open(std::string const& name, int flags, std::filesystem::path const& file);
  explicit Connection(sqlite3* db) : db_(db) {}

  std::unique_ptr<sqlite3, Close> db_;
};

// A prepared statement whose values are bound in order, and whose columns are read in order.
class Statement {
 public:
  Statement(Connection const& db, std::string const& sql);
  Statement(Statement const&) = delete;
  Statement& operator=(Statement const&) = delete;
  ~Statement();

  // The next values, in order; not a number is stored as NULL.
  Statement& bind(auto const&... values) {
    (put(values), ...);
    return *this;
  }
  // Runs an INSERT or UPDATE and makes the statement ready for the next row; whether it changed any.
  bool insert();
  // Starts a SELECT over with other values.
  Statement& again(auto const&... values) {
    start_over();
    return bind(values...);
  }

  // The next row of a SELECT.
  bool row();
  // The next columns, in order. Throws Error for what does not fit: a count too large for an int, half a number.
  void read(auto&... values) { (take(values), ...); }
  std::string text();  // the next column
  // All values of the row, with their kinds.
  std::string whole_row();

 private:
  void start_over();
  void check(int status);
  void put(std::string_view text);
  void put(std::size_t value);
  void put(int value);
  void put(double value);
  void put(std::optional<double> value);
  void put(std::vector<double> const& values);
  void take(std::string& text);
  void take(long long& value);
  void take(std::size_t& value);
  void take(int& value);
  void take(double& value);
  void take(std::optional<double>& value);
  void take(std::vector<double>& values);

  sqlite3* db_;
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
  int next_ = 0;
};

// BEGIN ... COMMIT; rolled back when left by an exception.
class Transaction {
 public:
  explicit Transaction(Connection const& db) : db_(db) { db_.execute("BEGIN IMMEDIATE"); }
  Transaction(Transaction const&) = delete;
  Transaction& operator=(Transaction const&) = delete;
  ~Transaction() {
    if (!done_) db_.try_execute("ROLLBACK");
  }
  void commit() {
    db_.execute("COMMIT");
    done_ = true;
  }

 private:
  Connection const& db_;
  bool done_ = false;
};

// Whether the file stands alone, without a log or a journal, and can be read wherever it is copied to.
bool is_plain(std::filesystem::path const& file);
// A file beside `file` while it is written anew; and what of it a program that was killed left there.
std::filesystem::path unfinished(std::filesystem::path const& file);
void remove_unfinished(std::filesystem::path const& file);
// While what is to replace `file` is made; declared before connections to it.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path file) : file_(std::move(file)) {}
  Unfinished(Unfinished const&) = delete;
  Unfinished& operator=(Unfinished const&) = delete;
  ~Unfinished() { remove_unfinished(file_); }

 private:
  std::filesystem::path file_;
};
// Puts `whole`, a file that stands alone and is open nowhere, in the place of `file`: whatever stops the program, the
// former or the new one is there, whole. Throws Error.
void move_into_place(std::filesystem::path const& whole, std::filesystem::path const& file);
// Writes a file that stands alone anew, rows in the order of their keys: equal rows are then equal files, byte by byte.
// Leaves it as it is where that is so already, and where the new one cannot be written.
void put_in_order(std::filesystem::path const& file, std::function<void(Connection const&)> const& create_tables);
// What SQLite finds wrong with the file itself; empty when it is sound. Throws Error when it cannot be read at all.
std::vector<std::string> integrity(std::filesystem::path const& file);

}  // namespace isolaw::campaign::sqlite
