// A finished campaign may be extended by devices, laws or runs. Only the addition is computed, and the result must
// equal a campaign that had everything from the start.
#include <sqlite3.h>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Grow : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    double strength = 20.0;
    for (auto const* name : {"a", "b", "c", "d"})
      write(std::string(name) + ".csv", csv(record({.strength_kN = strength += 2.0})));
  }
  void lot(std::string const& file, std::string const& devices) const {
    std::string text;
    for (char const name : devices) text += fmt::format("[[device]]\nname = \"{0}\"\nfile = \"{0}.csv\"\n\n", name);
    write(file, text);
  }
  Words campaign(std::string const& file, std::string const& laws, std::string const& runs, std::string const& out,
                 Words const& more = {}) const {
    return Words{
               "calibrate",           file, "--laws", laws, "--runs", runs, "--analysis", "full", "--replicates", "40",
               "--samples-per-cycle", "40", "--out",  out} +
           more;
  }
  void change(std::string const& store, std::string const& sql) const {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path(store).c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    EXPECT_GT(sqlite3_changes(db), 0);
    sqlite3_close(db);
  }
  void expect_same(std::string const& grown, std::string const& whole) {
    EXPECT_EQ(read(grown + "/summary.json"), read(whole + "/summary.json"));
    EXPECT_EQ(all_rows(path(grown + "/campaign.sqlite")), all_rows(path(whole + "/campaign.sqlite")));
    EXPECT_EQ(isolaw({"check", grown}).code, 0);
  }
};

TEST_F(Grow, by_a_device_in_the_middle) {
  lot("three.toml", "abd");
  lot("four.toml", "abcd");
  ASSERT_EQ(isolaw(campaign("three.toml", "bilinear,vaiana", "2", "G")).code, 0);
  expect_message(isolaw(campaign("four.toml", "bilinear,vaiana", "2", "G")), 0,
                 {"grows by 1 device\n", "continuing: 12 runs are there already"});
  ASSERT_EQ(isolaw(campaign("four.toml", "bilinear,vaiana", "2", "W")).code, 0);
  expect_same("G", "W");
}

TEST_F(Grow, by_laws_with_what_is_set_for_them) {
  lot("lot.toml", "abc");
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear", "2", "G", {"--set", "bilinear.K2=0.1:2"})).code, 0);
  Words const sets{"--set", "bilinear.K2=0.1:2", "--set", "bouc-wen.n=1"};
  expect_message(isolaw(campaign("lot.toml", "vaiana,bilinear,bouc-wen", "2", "G", sets)), 0,
                 {"grows by laws vaiana, bouc-wen\n", "continuing: 6 runs are there already"});
  ASSERT_EQ(isolaw(campaign("lot.toml", "vaiana,bilinear,bouc-wen", "2", "W", sets)).code, 0);
  expect_same("G", "W");
}

// The genetic algorithm ends at different values in each run. If an added run is the best of all, every result that
// depends on the best run must be computed again.
TEST_F(Grow, by_runs_of_which_some_are_the_best) {
  lot("lot.toml", "abc");
  Words const genetic{"--method", "ga", "--population", "8", "--generations", "4"};
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear,bouc-wen", "2", "G", genetic)).code, 0);
  expect_message(isolaw(campaign("lot.toml", "bilinear,bouc-wen", "5", "G", genetic)), 0,
                 {"grows by 5 runs instead of 2\n", "continuing: 12 runs are there already"});
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear,bouc-wen", "5", "W", genetic)).code, 0);
  expect_same("G", "W");
}

// The test writes impossible numbers into stored rows and then adds a law. Rows that still have these numbers
// afterwards were not computed again.
TEST_F(Grow, computes_nothing_twice) {
  lot("two.toml", "ab");
  lot("three.toml", "abc");
  ASSERT_EQ(isolaw(campaign("two.toml", "bilinear", "2", "G")).code, 0);
  change("G/campaign.sqlite", "UPDATE run SET evaluations = 424242");
  change("G/campaign.sqlite",
         "UPDATE device_analysis SET json = json_set(json, '$.determination.evaluations', 171717)");
  change("G/campaign.sqlite", "UPDATE lot_analysis SET json = json_set(json, '$.mean.evaluations', 272727)");
  ASSERT_EQ(isolaw(campaign("two.toml", "bilinear,vaiana", "2", "G")).code, 0);
  EXPECT_EQ(query(path("G/campaign.sqlite"), "SELECT count(*) FROM run WHERE evaluations = 424242"), Words{"4"});
  EXPECT_EQ(query(path("G/campaign.sqlite"), "SELECT count(*) FROM run"), Words{"8"});
  auto const kept = [&](std::string const& table, std::string const& number) {
    return query(path("G/campaign.sqlite"), "SELECT count(*) FROM " + table + " WHERE json LIKE '%" + number + "%'")
        .at(0);
  };
  EXPECT_EQ(kept("device_analysis", "171717"), "2");
  EXPECT_EQ(kept("lot_analysis", "272727"), "1");
  // A third device makes the lot a different one, so the analysis of the lot must be computed again.
  ASSERT_EQ(isolaw(campaign("three.toml", "bilinear,vaiana", "2", "G")).code, 0);
  EXPECT_EQ(kept("device_analysis", "171717"), "2");
  EXPECT_EQ(kept("lot_analysis", "272727"), "0");
}

// The records of a campaign must not change. Only the record of a refused device may change, because that device has no
// results yet.
TEST_F(Grow, takes_a_device_that_was_refused_once_it_is_mended) {
  lot("lot.toml", "abc");
  auto const good = read("c.csv");
  write("c.csv", "time [s],displacement [mm],force [kN]\n0,0,0\n");
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear", "2", "G")).code, 1);
  write("c.csv", "time [s],displacement [mm],force [kN]\n0,0,0\n0,0,0\n");
  expect_message(isolaw(campaign("lot.toml", "bilinear", "2", "G")), 1, {"grows by 'c', still refused, "});
  write("c.csv", good);
  expect_message(isolaw(campaign("lot.toml", "bilinear", "2", "G")), 0,
                 {"grows by 'c', refused before\n", "continuing: 4 runs are there already"});
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear", "2", "W")).code, 0);
  expect_same("G", "W");
}

TEST_F(Grow, never_loses_what_is_there) {
  lot("lot.toml", "abc");
  lot("fewer.toml", "ab");
  ASSERT_EQ(isolaw(campaign("lot.toml", "bilinear,vaiana", "3", "G")).code, 0);
  auto const store = read("G/campaign.sqlite");
  expect_refused(isolaw(campaign("fewer.toml", "bilinear,vaiana", "3", "G")), {"there and not now: 'c'"});
  expect_refused(isolaw(campaign("lot.toml", "bilinear", "3", "G")), {"laws: bilinear,vaiana there, bilinear now"});
  expect_refused(isolaw(campaign("lot.toml", "bilinear,vaiana", "2", "G")), {"runs: 3 there, 2 now"});
  expect_refused(isolaw(campaign("lot.toml", "bilinear,vaiana", "3", "G", {"--set", "bilinear.K2=1"})), {"set: "});
  EXPECT_EQ(read("G/campaign.sqlite"), store);
}

}  // namespace
}  // namespace isolaw::cli_test
