// SQLite's handles as objects that close themselves. The error messages speak of a store of isolaw.
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

// The advice in messages about a damaged store. It names the command that computed the store and not `merge --fresh`,
// which would not compute a damaged part again.
inline constexpr char const* advice_on_damaged =
    "copying it once more, or the command that computed it, with --fresh, which starts over";

inline constexpr std::array companion_suffixes{"-wal", "-shm", "-journal"};  // SQLite's own files beside a store

[[noreturn]] void refuse_damaged(std::string file, std::string_view reason);
void require_plain(std::filesystem::path const& file);  // throws Error for a pipe or device: opening one could block
bool has_log(std::filesystem::path const& file);

class Connection {
 public:
  // These functions may throw Error and std::bad_alloc.
  static Connection create(std::filesystem::path const& file);
  static Connection to_write(std::filesystem::path const& file);
  // Unless a log lies beside `file`, takes no locks and makes no files, so read-only media and network shares work.
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

class Statement {  // its values are bound in order, and its columns are read in order
 public:
  Statement(Connection const& db, std::string const& sql);
  Statement(Statement const&) = delete;
  Statement& operator=(Statement const&) = delete;
  ~Statement();

  Statement& bind(auto const&... values) {  // binds the next values; NaN is stored as NULL
    (put(values), ...);
    return *this;
  }
  bool insert();  // runs an INSERT or UPDATE, gets ready for the next row, returns whether a row changed
  Statement& again(auto const&... values) {  // starts a SELECT over with other values
    start_over();
    return bind(values...);
  }

  bool row();  // moves to the next row of a SELECT; false after the last one
  // Reads the next columns. Throws Error for a number too large for an int and for a series cut off within a number.
  void read(auto&... values) { (take(values), ...); }
  std::string text();       // reads the next column
  std::string whole_row();  // all values of the row with their kinds; different rows give different texts

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

class Transaction {  // rolls back when destroyed without commit()
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

bool is_plain(std::filesystem::path const& file);                     // whether it has no log or journal beside it
std::filesystem::path unfinished(std::filesystem::path const& file);  // the name of a new version while it is written
void remove_unfinished(std::filesystem::path const& file);            // removes the unfinished new version of `file`
// Removes the unfinished new version of `file` in its destructor. Declare it before any connection to that version, so
// that the connection closes first.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path file) : file_(std::move(file)) {}
  Unfinished(Unfinished const&) = delete;
  Unfinished& operator=(Unfinished const&) = delete;
  ~Unfinished() { remove_unfinished(file_); }

 private:
  std::filesystem::path file_;
};
// Replaces `file` by `whole`, which must have no log and not be open. At every moment one complete file exists. Throws
// Error.
void move_into_place(std::filesystem::path const& whole, std::filesystem::path const& file);
// See StoreKind::put_in_order.
void put_in_order(std::filesystem::path const& file, std::function<void(Connection const&)> const& create_tables);
// Returns the faults that SQLite finds in the file; empty if there are none. Throws Error if it cannot be read at all.
std::vector<std::string> integrity(std::filesystem::path const& file);

}  // namespace isolaw::campaign::sqlite
