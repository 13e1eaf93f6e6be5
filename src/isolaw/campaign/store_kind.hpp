// Stores of campaigns and of building studies share this code. It makes, opens and checks a file, and keeps the tables
// that say which part of a campaign or study the file holds and which build computed it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

// One kind of store: campaign or building study. Every kind has the tables meta and maker besides those in `tables`.
class StoreKind {
 public:
  struct Words {                 // words in messages, with those of a campaign as examples
    std::string_view store;      // "campaign store"
    std::string_view file;       // "campaign.sqlite of a campaign"
    std::string_view whole;      // "campaign"
    std::string_view same;       // what the parts of a campaign share: "the same lot, settings and records"
    std::string_view command;    // "isolaw calibrate"
    std::string_view input;      // "LOT"
    std::string_view once_more;  // "calibrate again"
    std::string_view advice;     // what to do about a file that is no store of this kind
  };
  StoreKind(Words const& words, int schema, std::string tables);

  Words const& words() const { return words_; }
  // Creates the tables in an empty file, and writes the makers and the part into them.
  void begin(sqlite::Connection const& db, std::vector<Maker> const& makers, std::optional<Part> const& part) const;
  // Makes a store by fill() and replaces `file` if it exists. If this fails or the program is killed, the former or the
  // new file is there and complete. Calls before_replacing() when the new file is complete but does not have its name
  // yet. Throws Error if `file` is not a plain file or cannot be written.
  static void create(std::filesystem::path const& file, std::function<void(sqlite::Connection const&)> const& fill,
                     std::function<void()> const& before_replacing = {});
  // to_read() and to_write() throw Error for a file that is missing, not a plain file (a pipe could block), not a store
  // of this kind, or of another schema. Its tables must be declared word by word as isolaw declares them, since a view
  // or a computed column could run without end or fill the memory and a trigger could change results.
  sqlite::Connection to_read(std::filesystem::path const& file) const;
  sqlite::Connection to_write(std::filesystem::path const& file) const;
  // Says what is lost if `file` is replaced: "" for a store of isolaw and for no file, else a sentence about a file
  // that is empty or damaged. Throws Error for a database of another program, which isolaw does not replace.
  std::string lost_with(std::filesystem::path const& file) const;
  // Completes a file beside which a killed program left a log: writes the log into the file, or undoes the transaction
  // that was not finished.
  void fold_log(std::filesystem::path const& file) const;
  // Rewrites a store that has no log, with its rows in the order of their keys. Equal results then give equal files,
  // byte by byte, in whatever order and on however many machines they were computed. Does nothing if the rows are in
  // this order already. Keeps the old file if the new one cannot be written.
  void put_in_order(std::filesystem::path const& file) const;
  // Returns the result of read(). Throws Error, as for a damaged store, if rows are not as isolaw writes them.
  template <class Read>
  static auto as_ours(std::filesystem::path const& file, Read&& read) {
    try {
      return read();
    } catch (...) {
      refuse_unreadable(file);
    }
  }
  template <class Read>
  auto read(std::filesystem::path const& file, Read&& read) const {  // calls read(db)
    auto const db = to_read(file);
    return as_ours(file, [&] { return read(db); });
  }

 private:
  using Declarations = std::map<std::string, std::string>;  // by the name of the table
  // Returns the declarations of all tables, indexes, views and triggers, including those that other programs added.
  static Declarations declarations(sqlite::Connection const& db, std::filesystem::path const& file);
  [[noreturn]] static void refuse_unreadable(std::filesystem::path const& file);
  void create_tables(sqlite::Connection const& db) const;
  void require(sqlite::Connection const& db, std::filesystem::path const& file) const;

  Words words_;
  int schema_;
  std::string tables_;
  Declarations ours_;
};

std::string meta(sqlite::Connection const& db, std::string_view key);  // a value of the table meta; empty if none
void write_meta(sqlite::Connection const& db, std::string_view key, std::string_view value);
std::optional<Part> read_part(sqlite::Connection const& db);
std::vector<Maker> read_makers(sqlite::Connection const& db);
void write_row(sqlite::Connection const& db, std::size_t id, Maker const& maker);

}  // namespace isolaw::campaign
