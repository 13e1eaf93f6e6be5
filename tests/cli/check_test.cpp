// `isolaw check`: a store that was changed after the program wrote it is found out.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Check : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record()));
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
    ASSERT_EQ(isolaw({"calibrate", "a.csv", "b.csv", "--laws", "bilinear,bouc-wen", "--runs", "2", "--population", "6",
                      "--generations", "3", "--out", "O"})
                  .code,
              0);
  }
  void change(std::string const& sql) {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK) << message;
    EXPECT_GT(sqlite3_changes(db), 0) << sql;
    sqlite3_close(db);
  }
  void expect_fault(std::string const& what) {
    auto const o = isolaw({"check", "O"});
    EXPECT_EQ(o.code, 1) << o;
    EXPECT_TRUE(contains(o.out, "fault: "));
    EXPECT_TRUE(contains(o.out, what));
  }
  void expect_damaged(std::string const& what) {
    for (auto const* command : {"check", "report"})
      expect_refused(isolaw({command, "O"}), {"O/campaign.sqlite", "damaged", what, "--fresh"});
  }
};

TEST_F(Check, a_campaign_as_it_was_made_is_sound) {
  auto const o = isolaw({"check", "O"});
  EXPECT_EQ(o.code, 0) << o;
  for (auto const* part : {"sound", "2 devices, 4 laws on them, 8 of 8 runs", "largest relative difference 0",
                           "6 files beside it compared"})
    EXPECT_TRUE(contains(o.out, part));
}

TEST_F(Check, a_changed_objective) {
  change("UPDATE run SET objective = objective * (1 + 1e-7) WHERE device = 1 AND law = 'bilinear' AND number = 2");
  expect_fault("bilinear on b, run 2: its parameters give the objective 0.");
}

TEST_F(Check, a_changed_parameter) {
  change(
      "UPDATE run_parameter SET value = value * 1.0001 WHERE device = 0 AND law = 'bouc-wen' AND number = 1 AND "
      "position = 1");
  expect_fault("bouc-wen on a, run 1: its parameters give the objective 0.");
}

TEST_F(Check, a_parameter_outside_its_box) {
  change("UPDATE search_parameter SET lower = upper WHERE device = 0 AND law = 'bilinear' AND position = 0");
  expect_fault("bilinear on a: the search box is not that of its record");
  expect_fault("lies outside its box");
}

TEST_F(Check, a_changed_raw_record) {
  change(
      "UPDATE series SET \"values\" = zeroblob(length(\"values\")) WHERE device = 0 AND kind = 'raw' AND channel = "
      "'force_kN'");
  expect_fault("a: the record the laws saw is not the one its raw record gives");
}

TEST_F(Check, a_changed_record_of_the_laws) {
  change(
      "UPDATE series SET \"values\" = (SELECT \"values\" FROM series WHERE device = 1 AND kind = 'fit' AND channel = "
      "'force_kN') WHERE device = 0 AND kind = 'fit' AND channel = 'force_kN'");
  expect_fault("a: the record the laws saw is not the one its raw record gives");
}

TEST_F(Check, a_changed_history) {
  change("UPDATE run SET history = zeroblob(length(history)) WHERE device = 0 AND law = 'bilinear' AND number = 1");
  expect_fault("bilinear on a, run 1: its history ends elsewhere");
}

TEST_F(Check, an_edited_output) {
  write("O/summary.json", read("O/summary.json") + "\n");
  expect_fault("summary.json is not what the store gives; isolaw report O makes it again");
}

TEST_F(Check, what_readers_rely_on_is_refused_by_all_commands) {
  auto const sound = read("O/campaign.sqlite");
  struct Damage {
    char const* sql;
    char const* says;
  };
  for (auto const& [sql, says] : std::vector<Damage>{
           {"UPDATE run SET device = 7 WHERE device = 1 AND law = 'bilinear'", "which was not searched"},
           {"UPDATE run SET number = 99 WHERE device = 0 AND law = 'bilinear' AND number = 1", "run 99 of bilinear"},
           {"DELETE FROM run_parameter WHERE position = 1", "parameters"},
           {"DELETE FROM search_parameter WHERE position = 1", "the box of"},
           {"UPDATE search_parameter SET name = 'x' WHERE position = 0", "is called 'x'"},
           {"UPDATE search SET law = 'none' WHERE law = 'bilinear'", "not asked for"},
           {"UPDATE search SET device = 9 WHERE device = 1", "not there"},
           {"UPDATE device SET status = 'refused' WHERE id = 1", "which was refused"},
           {"UPDATE series SET \"values\" = zeroblob(8) WHERE kind = 'fit' AND channel = 'force_kN'",
            "differ in length"},
           {"DELETE FROM series WHERE kind = 'fit' AND device = 0", "has no record"},
           {"UPDATE run SET objective = NULL", "neither a result nor a failure"},
           {"UPDATE setting SET json = '{' WHERE key = 'runs'", "parse error"},
           {"UPDATE setting SET json = '-1' WHERE key = 'runs'", "runs"},
           {"DELETE FROM setting WHERE key = 'seed'", "seed"},
           {"UPDATE device SET recognised = 'x'", "parse error"}}) {
    write("O/campaign.sqlite", sound);
    change(sql);
    SCOPED_TRACE(sql);
    expect_damaged(says);
  }
}

TEST_F(Check, a_directory_without_a_campaign) {
  expect_refused(isolaw({"check", "nowhere"}), {"nowhere/campaign.sqlite", "no such file", "isolaw calibrate"});
}

}  // namespace
}  // namespace isolaw::cli_test
