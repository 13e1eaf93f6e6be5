#include "isolaw/campaign/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/analysis_json.hpp"
#include "isolaw/campaign/consistency.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/rows.hpp"
#include "isolaw/campaign/schema.hpp"

namespace isolaw::campaign {
namespace {

using sqlite::Connection;
using sqlite::Statement;
using sqlite::Transaction;

// A result that read() would refuse is a mistake of this program. It is not stored, so that the store stays readable.
template <class Require>
void require_readable(Require&& require) {
  try {
    require();
  } catch (Error const& error) {
    throw std::logic_error(
        fmt::format("a result that cannot be stored: {}; what was finished before it is kept", error.what()));
  } catch (nlohmann::json::exception const& error) {
    throw std::logic_error(
        fmt::format("a result that cannot be stored: {}; what was finished before it is kept", error.what()));
  }
}

Run const& stored(Run const& run) {  // the run as read() will return it: unchanged
  return run;
}
// The analysis as read() will return it: numbers that are not finite become NaN.
template <class Analysis>
Analysis stored(Analysis const& analysis) {
  Analysis read = analysis;
  read_analysis(analysis_json(analysis), read);
  return read;
}

void fill(Connection const& db, Contents const& contents, std::vector<Maker> const& makers) {
  Transaction transaction(db);
  write_campaign(db, contents, makers);
  transaction.commit();
}

void write_results(Connection const& db, Contents const& contents) {
  Transaction transaction(db);
  auto const write = [&](auto const& results) {
    for (auto const& result : results) write_row(db, result);
  };
  write(contents.runs);
  write(contents.device_analyses);
  write(contents.lot_analyses);
  write(contents.left_out);
  transaction.commit();
}

// The rows of a table, each as one text that differs if values or their kinds differ.
std::vector<std::string> rows_of(Connection const& db, std::string_view columns_and_table) {
  std::vector<std::string> found;
  Statement rows(db, fmt::format("SELECT {}", columns_and_table));
  while (rows.row()) found.push_back(rows.whole_row());
  std::ranges::sort(found);
  return found;
}

}  // namespace

Store Store::create(std::filesystem::path const& file, Contents const& contents,
                    std::function<void()> const& before_replacing) {
  require_readable([&] { require_consistent(contents); });
  StoreKind::create(
      file,
      [&](Connection const& db) {
        fill(db, contents, contents.makers.empty() ? std::vector{this_maker()} : contents.makers);
        write_results(db, contents);
        require_readable([&] { read_campaign(db); });
      },
      before_replacing);
  return open(file);
}

Store Store::open(std::filesystem::path const& file) {
  auto db = campaign_store().to_write(file);
  auto campaign = StoreKind::as_ours(file, [&] { return read_campaign(db); });
  db.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  return {std::move(db), std::move(campaign)};
}

Contents Store::read(std::filesystem::path const& file) {
  return campaign_store().read(file, [](Connection const& db) {
    auto contents = read_contents(db);
    require_consistent(contents);
    return contents;
  });
}

Store::CopiedRuns Store::take_runs(std::filesystem::path const& other) {
  auto const theirs = campaign_store().to_read(other);
  auto const maker = own_maker();
  // Merging a part changes pages all over the database. With a long log, SQLite writes a page that several parts change
  // into the file once, and not once for each part.
  db_.execute("PRAGMA wal_autocheckpoint = 16384");
  CopiedRuns taken;
  Transaction transaction(db_);
  RunWriter writer(db_);
  auto const take = [&](Run run) {
    require_consistent(campaign_, run);
    run.maker = maker;
    if (writer.add_if_new(run)) return void(++taken.added);
    ++taken.already_there;
    if (!writer.is_there(run))
      throw Error({.where = other.string(),
                   .found = fmt::format("run {} of {} on device '{}' differs from the one that is there already",
                                        run.number, run.law, campaign_.devices.at(run.device).name),
                   .allowed = "one result of a run, whoever computed it",
                   .advice = "isolaw check on both, and the part that is not sound again"});
  };
  StoreKind::as_ours(other, [&] { read_runs(theirs, take); });
  transaction.commit();
  return taken;
}

std::size_t Store::take_analyses(std::filesystem::path const& other) {
  auto const theirs = campaign_store().to_read(other);
  auto const maker = own_maker();
  std::size_t added = 0;
  auto const take = [&](auto const& here, auto offered, auto const& key) {
    std::set<decltype(key(offered.front()))> there;
    for (auto const& analysis : here) there.insert(key(analysis));
    for (auto& analysis : offered) {
      if (!there.insert(key(analysis)).second) continue;
      require_consistent(campaign_, analysis);
      analysis.maker = maker;
      write_row(db_, analysis);
      ++added;
    }
  };
  auto const device_and_law = [](auto const& analysis) { return std::pair(analysis.device, analysis.law); };
  Transaction transaction(db_);
  StoreKind::as_ours(other, [&] {
    auto const here = read_analyses(db_);
    auto offered = read_analyses(theirs);
    take(here.devices, std::move(offered.devices), device_and_law);
    take(here.lots, std::move(offered.lots), [](LotAnalysis const& analysis) { return analysis.law; });
    take(here.left_out, std::move(offered.left_out), device_and_law);
  });
  transaction.commit();
  return added;
}

Contents Store::read_beginning(std::filesystem::path const& file) {
  return campaign_store().read(file, read_campaign);
}

Contents Store::read_beginning_and_series(std::filesystem::path const& file) {
  return campaign_store().read(file, [](Connection const& db) {
    auto contents = read_campaign_and_series(db);
    require_consistent(contents);
    return contents;
  });
}

std::vector<std::pair<std::string, std::string>> Store::hashes_of_beginning(std::filesystem::path const& file) {
  auto const db = campaign_store().to_read(file);
  std::vector<std::pair<std::string, std::string>> found;
  for (auto const& [table, rows] :
       {std::pair("meta", "meta WHERE key <> 'part' ORDER BY key"), std::pair("setting", "setting ORDER BY position"),
        std::pair("device", "device ORDER BY id"), std::pair("series", "series ORDER BY device, kind, channel"),
        std::pair("search", "search ORDER BY device, law"),
        std::pair("search_parameter", "search_parameter ORDER BY device, law, position")}) {
    std::string hash;
    for (Statement row(db, fmt::format("SELECT * FROM {}", rows)); row.row();) hash = sha256(hash + row.whole_row());
    found.emplace_back(table, std::move(hash));
  }
  return found;
}

void Store::for_each_run(std::filesystem::path const& file,
                         std::function<void(std::size_t, std::string const&, int)> const& visit) {
  auto const db = Connection::to_read(file);
  Statement run(db, "SELECT device, law, number FROM run ORDER BY device, law, number");
  while (run.row()) {
    std::size_t device = 0;
    std::string law;
    int number = 0;
    run.read(device, law, number);
    visit(device, law, number);
  }
}

std::size_t Store::own_maker() {
  auto const me = this_maker();
  auto& makers = campaign_.makers;
  auto const place = static_cast<std::size_t>(std::ranges::find(makers, me) - makers.begin());
  if (place == makers.size()) {
    Transaction transaction(db_);
    write_row(db_, place, me);
    transaction.commit();
    makers.push_back(me);
  }
  return place;
}

template <class Result>
void Store::add(Result result) {
  result.maker = own_maker();
  require_readable([&] { require_consistent(campaign_, stored(result)); });
  Transaction transaction(db_);
  write_row(db_, result);
  transaction.commit();
}
template void Store::add(Run);
template void Store::add(DeviceAnalysis);
template void Store::add(LotAnalysis);
template void Store::add(LeftOutAnalysis);

std::vector<std::string> Store::foreign_rows(std::filesystem::path const& file, Contents const& contents) {
  auto const theirs = campaign_store().to_read(file);
  auto const ours = Connection::in_memory();
  fill(ours, contents, contents.makers);
  write_results(ours, contents);
  std::vector<std::string> faults;
  // The stored file may lack rows of these two tables, since read() assumes a value for a missing one.
  char const *settings = "key, json FROM setting", *meta = "key, value FROM meta WHERE key <> 'schema'";
  for (auto const* table : {settings, meta, "* FROM maker", "* FROM device", "device, kind, channel, count FROM series",
                            "* FROM search", "* FROM search_parameter", "* FROM run", "* FROM run_parameter",
                            "* FROM device_analysis", "* FROM lot_analysis", "* FROM left_out"}) {
    auto const there = rows_of(theirs, table), made = rows_of(ours, table);
    if (table == settings || table == meta ? std::includes(made.begin(), made.end(), there.begin(), there.end())
                                           : made == there)
      continue;
    auto const name = std::string_view(table).substr(std::string_view(table).find("FROM ") + 5);
    faults.push_back(
        fmt::format("table '{}' holds rows that are not as isolaw writes them", name.substr(0, name.find(' '))));
  }
  return faults;
}

void Store::describe(Contents const& contents) {
  Transaction transaction(db_);
  write_descriptions(db_, contents);
  require_readable([&] { read_campaign(db_); });
  transaction.commit();
}

bool Store::finish() {
  return db_.try_execute("PRAGMA journal_mode = DELETE");
}

}  // namespace isolaw::campaign
