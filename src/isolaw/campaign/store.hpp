// The campaign on disk: one SQLite file, one transaction per finished run, readable by plain SQL.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

class Store {
 public:
  // A new store that holds `contents`, results among them; replaces a file of that name. When it
  // fails, or the program is killed, the former or the new one is there, whole. `before_replacing` is called when the
  // new one is complete and not yet in place. Throws Error: no plain file, cannot be written.
  static Store create(std::filesystem::path const& file, Contents const& contents,
                      std::function<void()> const& before_replacing = {});
  // What a create() that was killed left beside it.
  static void remove_unfinished(std::filesystem::path const& file);
  // An existing one, to add runs to. Throws Error: no such file, no plain file (a pipe is never waited for), not a
  // store, another schema, anything in it that isolaw does not make.
  static Store open(std::filesystem::path const& file);
  // Whether the file stands alone, without a write-ahead log, and can be read wherever it is copied to.
  static bool is_plain(std::filesystem::path const& file);
  // Writes a store that stands alone anew, rows in the order of their keys: equal campaigns are then equal files, byte
  // by byte, in whatever order and on however many machines their runs were computed. Leaves the file as it is where
  // that is so already, and where the new one cannot be written.
  static void put_in_order(std::filesystem::path const& file);
  // Everything in it; the file is not changed. Throws Error as above.
  static Contents read(std::filesystem::path const& file);
  // What a campaign began with, without its records' series and without results.
  static Contents read_beginning(std::filesystem::path const& file);
  // The same with the series.
  static Contents read_beginning_and_series(std::filesystem::path const& file);
  // Of every table that holds what the campaign began with, series too: its name and a hash of its rows, but for which
  // part the store is.
  static std::vector<std::pair<std::string, std::string>> hashes_of_beginning(std::filesystem::path const& file);
  // Every run's device, law and number, in their order.
  static void for_each_run(std::filesystem::path const& file,
                           std::function<void(std::size_t, std::string const&, int)> const& visit);
  // What SQLite finds wrong with the file itself; empty when it is sound. Throws Error when it cannot be read at all.
  static std::vector<std::string> integrity(std::filesystem::path const& file);
  // Rows that are not as this program writes them, given what read() made of them; empty when there is none. Values of
  // series are left out, which read() holds as they are.
  static std::vector<std::string> foreign_rows(std::filesystem::path const& file, Contents const& contents);

  // Each is one transaction; not thread-safe. Throws std::logic_error, and writes nothing, for what read() would
  // refuse.
  void add(Run const& run);
  void add(DeviceAnalysis const& analysis);
  void add(LotAnalysis const& analysis);
  void add(LeftOutAnalysis const& analysis);
  // What the lot file says of the devices and what they are held to, on which no law depends, may be changed before a
  // campaign is continued; and a campaign without analysis may be continued with one.
  void describe(Contents const& contents);
  // The runs of another store of this campaign, made by this program. Those that are here already must be the same.
  // All of them or, with an Error, none; one row at a time is in memory.
  struct Taken {
    std::size_t added = 0, there = 0;
  };
  Taken take_runs(std::filesystem::path const& other);
  // What another store of this campaign, with all its runs, has examined, where that is not here already; how many
  // analyses. Likewise all of them or none.
  std::size_t take_analyses(std::filesystem::path const& other);
  // No more runs: folds the write-ahead log into the one file. False when another program reads the store just now; the
  // log then stays beside it, and whoever opens the store to write next folds it in.
  bool finish();

 private:
  Store(sqlite::Connection db, Contents campaign) : db_(std::move(db)), campaign_(std::move(campaign)) {}
  // The place of this program among those who made the campaign.
  std::size_t own_maker();
  template <class Result>
  void add_result(Result result);

  sqlite::Connection db_;
  Contents campaign_;  // what results are held to before they are added: without series and without results
};

}  // namespace isolaw::campaign
