// Tests the store, the file in which a campaign is kept: everything written can be read, a run is stored whole or not
// at all, and files that are not stores are refused.
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/files/table.hpp"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/schema.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "not_finite.hpp"

namespace isolaw::campaign {
namespace {

using testing::expect_same;

std::string const attack = "O'Brien\"; DROP TABLE run; -- <script>alert('1')</script>\nsecond line\t\\ `x` %s {}";
std::string const unicode = "Prüfling № 試験 🙂 e\u0301";

// Executes SQL on a store as another program would, without the code of the store.
std::vector<std::vector<std::string>> sql(std::filesystem::path const& file, std::string const& text) {
  sqlite3* db = nullptr;
  EXPECT_EQ(sqlite3_open(file.c_str(), &db), SQLITE_OK);
  std::vector<std::vector<std::string>> rows;
  auto const take = [](void* into, int count, char** values, char**) {
    std::vector<std::string> row;
    for (int i = 0; i < count; ++i) row.emplace_back(values[i] == nullptr ? "NULL" : values[i]);
    static_cast<std::vector<std::vector<std::string>>*>(into)->push_back(row);
    return 0;
  };
  char* message = nullptr;
  EXPECT_EQ(sqlite3_exec(db, text.c_str(), take, &rows, &message), SQLITE_OK) << (message == nullptr ? "" : message);
  sqlite3_free(message);
  sqlite3_close(db);
  return rows;
}

Contents full() {
  Contents c;
  c.title = attack;
  c.acceptance = {.rules = attack + unicode,
                  .rules_file = "a/" + attack,
                  .design = "K_eff=1.2",
                  .lot_size = 28,
                  .alike = {.temperature_C = 3.5, .load_percent = 12.0}};
  c.settings.laws = {"hwang-wu", "bilinear", "abe"};  // not in alphabetical order
  c.settings.runs = 3;
  c.settings.seed = 18446744073709551615u;
  c.settings.overrides = {fit::parse_override("abe.r=0.1:0.2")};
  c.settings.clean.scored = {data::parse_numbers("--fit-blocks", "1"), data::parse_numbers("--fit-cycles", "2-4,6-")};

  Device first;
  first.name = attack;
  first.file = "a folder/" + unicode + ".csv, other.csv";
  first.info = {.serial = attack,
                .lot = unicode,
                .test_date = "2023-05-11",
                .temperature_C = -0.5,
                .rubber_thickness_mm = 208.0,
                .rubber_area_mm2 = std::nullopt};
  first.raw.file = first.file;
  first.raw.sha256 = sha256("1");
  first.raw.time_s = {0.0, 0.1, 0.30000000000000004};
  first.raw.disp_mm = {-0.0, std::numeric_limits<double>::denorm_min(), -1e308};
  first.raw.force_kN = {1.0 / 3.0, infinity, -2.0};
  first.raw.load_kN = {1632.0, 1633.0, 1634.0};
  first.raw.faults = {{.kind = data::FaultKind::spike,
                       .channel = "force",
                       .samples = {0, 2},
                       .finding = {.kind = FindingKind::signal_spike,
                                   .numbers = {{"count", 2.0}, {"value_kN", 0.1 + 0.2}},
                                   .words = {{"channel", "force"}, {"unit", "kN"}}}}};
  first.raw.recognised = {data::decision(FindingKind::file_format, attack), data::decision(FindingKind::rows_read, ""),
                          data::decision(FindingKind::units_given, unicode, "--units")};
  first.raw.corrections = {{.kind = FindingKind::friction_removed, .numbers = {{"friction_kN", 0.1 + 0.2}}}};
  first.raw.warnings = {
      {.kind = FindingKind::drift, .blocks = {2}, .words = {{"unit", "[\"not\", \"a list\"]"}, {"channel", attack}}}};
  first.record = {.time_s = {0.0, 1.0},
                  .disp_mm = {1.0, 2.0},
                  .vel_mm_s = {3.0, 4.0},
                  .force_kN = {5.0, 6.0},
                  .scored = {0.0, 1.0},
                  .cleaning = {{.kind = FindingKind::not_smoothed}, {.kind = FindingKind::velocity_computed}}};

  first.vertical = {.file = attack + ".csv",
                    .sha256 = sha256("2"),
                    .disp_mm = {0.0, -0.1, 0.30000000000000004},
                    .load_kN = {-1.0, 1.0 / 3.0, 1e300},
                    .loads = data::LoadRange{0.1 + 0.2, 1000.0},
                    .recognised = {data::decision(FindingKind::column_taken, unicode, attack)}};

  Device refused;
  refused.vertical = {.file = "v.csv", .sha256 = {}, .refusal = "v.csv: " + attack};
  refused.name = unicode;
  refused.file = refused.raw.file = "b.csv";
  refused.refusal = "b.csv:7: found 'x'; allowed: a number\nb.csv: and another line";

  Device no_time;            // a device without vertical load, time and warnings, and with empty texts
  no_time.name = "D\xb0 3";  // bytes of code page 1252, which a file's name may contain
  no_time.vertical.stated_kN_per_mm = 1.0 / 3.0;
  no_time.raw.disp_mm = {1.0};
  no_time.raw.force_kN = {2.0};
  no_time.record.time_s = {0.0};
  no_time.record.disp_mm = {1.0};
  no_time.record.force_kN = {2.0};
  c.devices = {first, refused, no_time};

  // Each box has the parameters of its law. The first two parameters get numbers that are hard to store exactly.
  auto const box_of = [](std::string const& law) {
    fit::SearchBox box;
    for (auto const& info : laws::find_law(law).parameters)
      box.parameters.push_back(
          {.name = std::string(info.name), .unit = "kN/mm", .free = true, .lower = 1.0, .upper = 2.0});
    box.parameters[0] = {.name = box.parameters[0].name,
                         .unit = attack,
                         .free = true,
                         .value = 0.0,
                         .lower = -5e-6,
                         .upper = -1e-9,
                         .scale = laws::Scale::logarithmic};
    box.parameters[1] = {.name = box.parameters[1].name,
                         .unit = "",
                         .free = false,
                         .value = 0.1 + 0.2,
                         .lower = 0.30000000000000004,
                         .upper = 0.30000000000000004,
                         .scale = laws::Scale::linear};
    return box;
  };
  for (auto const& law : c.settings.laws)
    c.searches.push_back({.device = 0, .law = law, .refusal = "", .first_box = box_of(law), .box = box_of(law)});
  c.searches.push_back({.device = 2, .law = "hwang-wu", .refusal = "law hwang-wu: " + attack, .box = {}});
  c.searches.push_back(
      {.device = 2, .law = "bilinear", .refusal = "", .first_box = box_of("bilinear"), .box = box_of("bilinear")});
  c.searches.push_back({.device = 2, .law = "abe", .refusal = "", .first_box = box_of("abe"), .box = box_of("abe")});
  return c;
}

Run good(std::size_t device, std::string law, int number) {
  std::vector<double> parameters{1.0 / 3.0, -2.5e-300};
  parameters.resize(laws::find_law(law).parameters.size(), 0.1);
  return {.device = device,
          .law = std::move(law),
          .number = number,
          .outcome = Outcome::stagnated,
          .objective = 0.05 + 1e-17 * number,
          .integration_shift = 1e-9 / 3.0,
          .evaluations = 4200,
          .failed_evaluations = 17,
          .failure = {},
          .parameters = std::move(parameters),
          .history = {infinity, 0.25, 0.1, 0.05}};
}

Run failed(std::size_t device, std::string law, int number) {
  return testing::failed_run(device, std::move(law), number, attack);
}

// The runs are sorted by device, law (alphabetically) and number, as they are in Contents.
std::vector<Run> runs() {
  auto plain = good(2, "bilinear", 1);
  plain.outcome = Outcome::all_generations;
  plain.integration_shift = std::nan("");
  return {good(0, "abe", 1),        good(0, "abe", 2),      failed(0, "abe", 3),
          failed(0, "hwang-wu", 1), good(0, "hwang-wu", 2), plain};
}

class StoreTest : public testing::Folder {
 protected:
  std::filesystem::path file() const { return folder / "campaign.sqlite"; }
  // Writes a finished store of `full` and `runs` and returns its contents.
  Contents make() const {
    auto contents = full();
    auto store = Store::create(file(), contents);
    for (auto const& run : runs()) store.add(run);
    store.finish();
    contents.runs = runs();
    return contents;
  }
  // Calls Store::read and Store::open on the file. Both must refuse it; their error messages are returned.
  std::string refusal(std::filesystem::path const& path) const {
    std::string said;
    auto const attempt = [&](std::function<void()> const& action, char const* what) {
      try {
        action();
        ADD_FAILURE() << what << " accepted " << path;
      } catch (Error const& error) {
        said += std::string(error.what()) + "\n";
      }
    };
    attempt([&] { Store::read(path); }, "read");
    attempt([&] { Store::open(path); }, "open");
    return said;
  }
};

TEST_F(StoreTest, EverythingComesBack) {
  expect_same(Store::read((make(), file())), [] {
    auto c = full();
    c.runs = runs();
    return c;
  }());
}

TEST_F(StoreTest, RunsComeBackInOrderHoweverTheyWereAdded) {
  auto contents = full();
  auto store = Store::create(file(), contents);
  auto mixed = runs();
  std::ranges::reverse(mixed);
  for (auto const& run : mixed) store.add(run);
  expect_same(Store::read(file()).runs, runs());  // read while it is open for writing
}

TEST_F(StoreTest, ARunWithoutHistoryComesBack) {
  auto run = good(0, "abe", 1);
  run.history.clear();
  auto store = Store::create(file(), full());
  store.add(run);
  expect_same(Store::read(file()).runs, {run});
}

TEST_F(StoreTest, AnEmptyCampaignComesBack) {
  Contents contents;
  Store::create(file(), contents).finish();
  auto const read = Store::read(file());
  EXPECT_TRUE(read.devices.empty() && read.searches.empty() && read.runs.empty() && read.title.empty());
}

TEST_F(StoreTest, CreatingReplacesAnOldStore) {
  make();
  Contents other;
  other.title = "other";
  Store::create(file(), other);
  EXPECT_EQ(Store::read(file()).title, "other");
  EXPECT_TRUE(Store::read(file()).devices.empty());
}

TEST_F(StoreTest, ClosedWithoutFinishingIsReadableAndCanBeContinued) {
  {
    auto store = Store::create(file(), full());
    store.add(runs()[0]);
    store.add(runs()[1]);
  }
  ASSERT_EQ(Store::read(file()).runs.size(), 2u);
  {
    auto store = Store::open(file());
    for (std::size_t i = 2; i < runs().size(); ++i) store.add(runs()[i]);
    store.finish();
  }
  auto expected = full();
  expected.runs = runs();
  expect_same(Store::read(file()), expected);
}

// While the store is open, its files are those that a killed program would leave. A copy of them shows what can be read
// later.
TEST_F(StoreTest, KilledAfterAnyRunKeepsTheRunsBefore) {
  auto store = Store::create(file(), full());
  auto const killed = folder / "killed";
  for (std::size_t i = 0; i < runs().size(); ++i) {
    store.add(runs()[i]);
    std::filesystem::remove_all(killed);
    std::filesystem::create_directory(killed);
    for (auto const* suffix : {"", "-wal"}) {  // SQLite makes the index file "-shm" again, so it is not copied
      auto const from = file().string() + suffix;
      if (std::filesystem::exists(from)) std::filesystem::copy(from, killed / fmt::format("campaign.sqlite{}", suffix));
    }
    auto expected = runs();
    expected.resize(i + 1);
    expect_same(Store::read(killed / "campaign.sqlite").runs, expected);
    auto resumed = Store::open(killed / "campaign.sqlite");
    for (std::size_t k = i + 1; k < runs().size(); ++k) resumed.add(runs()[k]);
    resumed.finish();
    expect_same(Store::read(killed / "campaign.sqlite").runs, runs());
  }
}

// A power failure may cut off the log anywhere. The store may then lose whole runs, but never a part of a run.
TEST_F(StoreTest, ATornLogLosesWholeRunsOnly) {
  auto store = Store::create(file(), full());
  for (auto const& run : runs()) store.add(run);
  auto const log = bytes_of(file().string() + "-wal");
  ASSERT_GT(log.size(), 1000u);
  for (std::size_t part = 1; part <= 20; ++part) {
    auto const copy = write("torn.sqlite", bytes_of(file()));
    write("torn.sqlite-wal", log.substr(0, log.size() * part / 20));
    std::filesystem::remove(copy.string() + "-shm");
    Contents read;
    try {
      read = Store::read(copy);
    } catch (Error const&) {
      continue;  // the log is cut off before the empty store is complete
    }
    ASSERT_LE(read.runs.size(), runs().size());
    for (auto const& run : read.runs) {
      auto const all = runs();
      auto const expected = std::ranges::find_if(
          all, [&](auto const& r) { return r.device == run.device && r.law == run.law && r.number == run.number; });
      ASSERT_NE(expected, all.end());
      expect_same(run, *expected);
    }
    EXPECT_TRUE(part < 20 || read.runs.size() == runs().size());
  }
}

TEST_F(StoreTest, ARunAddedTwiceIsRefusedWholly) {
  auto store = Store::create(file(), full());
  store.add(runs()[0]);
  auto changed = runs()[0];
  changed.parameters.back() = 99.0;
  EXPECT_THROW(store.add(changed), Error);
  store.add(runs()[1]);  // the store still accepts runs
  auto expected = runs();
  expected.resize(2);
  expect_same(Store::read(file()).runs, expected);
}

// A run that breaks the rules of the store is a programming error in isolaw. The store rejects this run and keeps all
// earlier runs.
TEST_F(StoreTest, WhatAReaderWouldRefuseIsNotWritten) {
  auto store = Store::create(file(), full());
  store.add(runs()[0]);
  auto const refused = [&](auto&& spoil) {
    auto run = good(0, "abe", 2);
    spoil(run);
    EXPECT_THROW(store.add(run), std::logic_error);
  };
  refused([](auto& r) { r.objective = infinity; });
  refused([](auto& r) { r.objective = std::nan(""); });
  refused([](auto& r) { r.failure = "and a result"; });
  refused([](auto& r) { r.parameters.pop_back(); });
  refused([](auto& r) { r.parameters[0] = infinity; });
  refused([](auto& r) { r.refinement = 0; });
  refused([](auto& r) { r.number = 4; });
  refused([](auto& r) { r.law = "vaiana"; });
  refused([](auto& r) { r.device = 1; });
  EXPECT_THROW(store.add(LeftOutAnalysis{.device = 0, .law = "abe", .left_out = {.parameters = {1.0}}}),
               std::logic_error);
  store.finish();
  auto expected = full();
  expected.runs = {runs()[0]};
  expect_same(Store::read(file()), expected);
}

TEST_F(StoreTest, ACampaignThatAReaderWouldRefuseIsNotWritten) {
  make();
  auto const refused = [&](auto&& spoil) {
    auto contents = full();
    spoil(contents);
    EXPECT_THROW(Store::create(file(), contents), std::logic_error);
    EXPECT_EQ(Store::read(file()).runs.size(), runs().size());  // the earlier store was not replaced
  };
  refused([](auto& c) { c.devices[0].raw.time_s.pop_back(); });
  refused([](auto& c) { c.devices[0].record.scored[0] = 0.5; });
  refused([](auto& c) { c.searches[0].first_box.parameters[0].lower = infinity; });
  refused([](auto& c) { c.settings.clean.smooth = -1; });
  refused([](auto& c) { c.acceptance.lot_size = 0; });
}

TEST_F(StoreTest, FinishingLeavesOnePlainFile) {
  make();
  EXPECT_EQ(names(), std::vector<std::string>{"campaign.sqlite"});
  auto const bytes = bytes_of(file());
  ASSERT_GT(bytes.size(), 100u);
  // Bytes 18 and 19 of the header give the format for writing and for reading: 1 for a rollback journal, 2 for a
  // write-ahead log.
  EXPECT_EQ(bytes[18], 1);
  EXPECT_EQ(bytes[19], 1);
}

TEST_F(StoreTest, ReadingChangesNothing) {
  make();
  auto const before = bytes_of(file());
  Store::read(file());
  EXPECT_EQ(bytes_of(file()), before);
  EXPECT_EQ(names(), std::vector<std::string>{"campaign.sqlite"});
}

TEST_F(StoreTest, ReadingAnUnfinishedStoreChangesNothing) {
  {
    auto store = Store::create(file(), full());
    for (auto const& run : runs()) store.add(run);
  }
  auto const before = bytes_of(file());
  EXPECT_EQ(Store::read(file()).runs.size(), runs().size());
  // Only the store itself is compared: SQLite may leave the index of its log in the folder.
  EXPECT_EQ(bytes_of(file()), before);
}

TEST_F(StoreTest, PlainSqlReadsIt) {
  make();
  EXPECT_EQ(sql(file(), "SELECT count(*) FROM run"), (std::vector<std::vector<std::string>>{{"6"}}));
  EXPECT_EQ(sql(file(), "SELECT count(*) FROM run WHERE objective IS NULL")[0][0], "2");
  EXPECT_EQ(sql(file(), "SELECT status, count(*) FROM device GROUP BY status ORDER BY status"),
            (std::vector<std::vector<std::string>>{{"ok", "2"}, {"refused", "1"}}));
  EXPECT_EQ(sql(file(), "SELECT name FROM device WHERE id = 0")[0][0], attack);
  EXPECT_EQ(sql(file(), "SELECT count FROM series WHERE device = 0 AND kind = 'raw' AND channel = 'time_s'")[0][0],
            "3");
  EXPECT_EQ(sql(file(), "PRAGMA integrity_check")[0][0], "ok");
}

TEST_F(StoreTest, RefusesWhatIsNotThere) {
  auto const said = refusal(folder / "nothing.sqlite");
  EXPECT_NE(said.find("nothing.sqlite"), std::string::npos) << said;
  EXPECT_TRUE(names().empty());  // reading must not create the file
}

// The message about a file that is not a store must say so and name the file.
TEST_F(StoreTest, RefusesWhatIsNotAStore) {
  auto const text = write("text.sqlite", std::string(5000, 'x') + "\nnot a database\n");
  auto const empty = write("empty.sqlite", "");
  auto const other = folder / "other.sqlite";
  sql(other, "CREATE TABLE bookmarks (url TEXT)");
  auto const other_meta = folder / "other_meta.sqlite";
  sql(other_meta, "CREATE TABLE meta (key TEXT, value TEXT); INSERT INTO meta VALUES ('version', '1')");
  auto const stranger = folder / "stranger.sqlite";
  sql(stranger, "CREATE TABLE meta (something INTEGER)");
  for (auto const& path : {text, empty, other, other_meta, stranger}) {
    auto const before = bytes_of(path);
    auto const said = refusal(path);
    EXPECT_NE(said.find(path.string()), std::string::npos) << said;
    EXPECT_NE(said.find("store of isolaw"), std::string::npos) << path << ": " << said;
    EXPECT_EQ(said.find("free space"), std::string::npos) << path << ": " << said;
    EXPECT_EQ(bytes_of(path), before) << path << " was changed";
  }
  EXPECT_FALSE(refusal(folder).empty());
}

TEST_F(StoreTest, RefusesAnotherSchemaAndChangesNothing) {
  make();
  for (int const other : {schema_version - 1, schema_version + 1}) {
    sql(file(), fmt::format("UPDATE meta SET value = '{}' WHERE key = 'schema'", other));
    auto const before = bytes_of(file());
    auto const said = refusal(file());
    for (auto const& part : {std::string("campaign.sqlite"), fmt::format("a store of schema {}, written by", other),
                             fmt::format("schema {}", schema_version), std::string("--fresh")})
      EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(bytes_of(file()), before);
  }
}

// Stores of earlier builds have no list of signal faults, and such a store must be read. A store with an impossible
// list must be refused.
TEST_F(StoreTest, AStoreWithoutFaultsIsRead) {
  make();
  sql(file(), "DELETE FROM meta WHERE key = 'faults'");
  auto const contents = Store::read(file());
  EXPECT_TRUE(contents.devices.front().raw.faults.empty());
  EXPECT_EQ(Store::foreign_rows(file(), contents), std::vector<std::string>{});
  for (std::string const faults :
       {"[{}]", R"([{"device":7,"corrected":true,"samples":[0],"finding":[{"kind":"signal-spike"}]}])",
        R"([{"device":0,"corrected":true,"samples":[3],"finding":[{"kind":"signal-spike"}]}])",
        R"([{"device":0,"corrected":true,"samples":[0],"finding":[{"kind":"drift"}]}])"}) {
    sql(file(), "INSERT OR REPLACE INTO meta VALUES ('faults', '" + faults + "')");
    EXPECT_THROW(Store::read(file()), Error) << faults;
  }
}

TEST_F(StoreTest, AStoreWithoutASettingStandsForWhatItsRowSays) {
  make();
  sql(file(), "DELETE FROM setting WHERE key = 'bidirectional'");
  auto const contents = Store::read(file());
  EXPECT_FALSE(contents.settings.springs);
  EXPECT_EQ(Store::foreign_rows(file(), contents), std::vector<std::string>{});
  sql(file(), "DELETE FROM setting WHERE key = 'seed'");
  auto const said = refusal(file());
  EXPECT_NE(said.find("seed: is missing in the store"), std::string::npos) << said;
}

// Every store of schema 12 has the settings listed here. A setting that is added later must state the value that is
// assumed for stores without it (Setting::value_if_absent).
TEST(Schema, HasTheseSettingsInEveryStore) {
  std::set<std::string> keys;
  for (auto const& setting : setting_table())
    if (setting.value_if_absent.is_null()) keys.emplace(setting.key);
  EXPECT_EQ(schema_version, 12);
  EXPECT_EQ(keys, (std::set<std::string>{"analysis",
                                         "box",
                                         "center",
                                         "dead-band",
                                         "fit-blocks",
                                         "fit-cycles",
                                         "generations",
                                         "hit_tolerance",
                                         "hits",
                                         "hops",
                                         "integration",
                                         "laws",
                                         "least_starts",
                                         "method",
                                         "most_evaluations",
                                         "mutation_rate",
                                         "population",
                                         "replicates",
                                         "runs",
                                         "samples-per-cycle",
                                         "scattered",
                                         "score-blocks",
                                         "seed",
                                         "selection_pressure",
                                         "set",
                                         "smooth",
                                         "stagnation",
                                         "stagnation_tolerance",
                                         "starts",
                                         "turning-points"}));
}

TEST_F(StoreTest, RefusesATruncatedStore) {
  make();
  auto const bytes = bytes_of(file());
  auto const cut = write("cut.sqlite", bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(Store::read(cut), Error);
}

TEST_F(StoreTest, SaysWhereItCannotBeMade) {
  try {
    Store::create(folder / "no such folder" / "campaign.sqlite", full());
    FAIL() << "made in a folder that is not there";
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find("no such folder"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace isolaw::campaign
