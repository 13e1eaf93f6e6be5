// The campaign on disk: one SQLite file, with one transaction per finished run, that plain SQL can read.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/schema.hpp"

namespace isolaw::campaign {

class Store {
 public:
  // Makes a store of `contents` with its results. If `file` exists, it is replaced only when the new store is complete.
  static Store create(std::filesystem::path const& file, Contents const& contents,
                      std::function<void()> const& before_replacing = {});
  // Opens an existing store to add results. Throws Error if the file is no campaign store of the present schema, or
  // if the stored settings, devices or boxes are not as isolaw writes them.
  static Store open(std::filesystem::path const& file);
  static Contents read(std::filesystem::path const& file);  // everything; the file is not changed; throws as open()
  // Reads what a campaign begins with: settings, devices and boxes, without the records' series.
  static Contents read_beginning(std::filesystem::path const& file);
  static Contents read_beginning_and_series(std::filesystem::path const& file);  // the same with the records' series
  // Returns, for each table that holds what the campaign began with, including series, its name and a hash of its rows.
  // The hash does not depend on which part of a campaign the store holds.
  static std::vector<std::pair<std::string, std::string>> hashes_of_beginning(std::filesystem::path const& file);
  // Calls visit(device, law, number) for every run, sorted by these three.
  static void for_each_run(std::filesystem::path const& file,
                           std::function<void(std::size_t, std::string const&, int)> const& visit);
  // `contents` is what read() returned for this file. Returns a sentence for each table whose rows differ from those
  // that this program would write for `contents`. The values of series are not compared, since read() takes them as
  // they are.
  static std::vector<std::string> foreign_rows(std::filesystem::path const& file, Contents const& contents);
  // Adds a run or an analysis in one transaction; not thread-safe. Stores nothing and throws std::logic_error if read()
  // would refuse it.
  template <class Result>
  void add(Result result);
  // Writes the title, the devices' facts and compression tests, the requirements for the tests, and whether to analyse.
  // No law depends on these, so they may change before a campaign is continued.
  void describe(Contents const& contents);
  // Copies all runs of another store or, if it throws Error, none. The other store must belong to this campaign and
  // must have been computed by this build. A run that both stores hold must be the same in both. Memory holds one row
  // at a time.
  struct CopiedRuns {
    std::size_t added = 0, already_there = 0;
  };
  CopiedRuns take_runs(std::filesystem::path const& other);
  // Copies all analyses that are missing here from another store of this campaign, and returns how many. The other
  // store must have every run. If take_analyses() throws, it has copied none.
  std::size_t take_analyses(std::filesystem::path const& other);
  // Must be called after the last result: folds the write-ahead log into the file. Returns false if another program is
  // reading the store. The log then stays, and the next program that opens the store for writing folds it in.
  bool finish();

 private:
  Store(sqlite::Connection db, Contents campaign) : db_(std::move(db)), campaign_(std::move(campaign)) {}
  std::size_t own_maker();  // index of this program among the makers; adds it if it is missing

  sqlite::Connection db_;
  Contents campaign_;  // without series and results; results are checked against it before they are added
};

}  // namespace isolaw::campaign
