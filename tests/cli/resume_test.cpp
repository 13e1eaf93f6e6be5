// A campaign is stopped or killed. The same command, given again, must end as if the campaign had never been stopped.
// Further tests change the command, the records or the store; isolaw must refuse such a change or take it into account.
#include <pty.h>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Resume : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    ASSERT_EQ(isolaw({"example", "ex"}).code, 0);
  }
  Words campaign(std::string const& out, Words const& more = {}) const {
    return Words{"calibrate", "ex/study.toml", "--laws", "abe",        "--runs", "4",     "--population",
                 "40",        "--generations", "20",     "--analysis", "none",   "--out", out} +
           more;
  }
  // Starts the campaign and sends the signal once at least 3 of its 40 runs are stored. Returns how it ended.
  Outcome stopped(Words const& words, std::string const& out, int signal, std::string const& law = "abe") {
    auto process = start(words);
    Outcome result;
    auto const end = std::chrono::steady_clock::now() + 60s;
    while (stored_runs(path(out) / "campaign.sqlite", law) < 3 && std::chrono::steady_clock::now() < end) {
      if (process.ended(result)) return result;
      std::this_thread::sleep_for(5ms);
    }
    process.send(signal);
    return process.wait();
  }
};

TEST_F(Resume, interrupted_campaign_keeps_its_runs_continues_and_ends_as_if_never_stopped) {
  auto const o = stopped(campaign("O", {"--jobs", "2"}), "O", SIGINT);
  expect_message(o, 1,
                 {"interrupted", "finished runs are kept in O/campaign.sqlite",
                  "to continue: ", "calibrate ex/study.toml --laws abe --runs 4"});
  EXPECT_EQ(o.out, "");
  EXPECT_FALSE(exists("O/summary.json"));
  EXPECT_FALSE(exists("O/report.html"));
  int const kept = stored_runs(path("O/campaign.sqlite"), "abe");
  EXPECT_GE(kept, 3);
  EXPECT_LT(kept, 40);
  EXPECT_TRUE(contains(o.err, fmt::format("{} finished runs", kept)));

  auto const continued = isolaw(campaign("O"));
  expect_message(continued, 0, {fmt::format("continuing: {} runs are there already", kept)});
  auto const whole = isolaw(campaign("P"));
  ASSERT_EQ(whole.code, 0) << whole;
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), all_rows(path("P/campaign.sqlite")));
  EXPECT_EQ(without_folder(continued.out, "O"), without_folder(whole.out, "P"));
}

// A user normally runs the default search followed by the analyses. The test kills such a campaign and continues it.
TEST_F(Resume, of_the_default_search_and_its_analyses_ends_as_if_never_stopped) {
  auto const campaign = [](std::string const& out) {
    return Words{"calibrate",
                 "ex/study.toml",
                 "--laws",
                 "bilinear,hwang-wu",
                 "--method",
                 "best",
                 "--runs",
                 "2",
                 "--samples-per-cycle",
                 "40",
                 "--out",
                 out};
  };
  auto const o = stopped(campaign("O"), "O", SIGKILL, "hwang-wu");
  ASSERT_EQ(o.code, 128 + SIGKILL) << o;
  expect_message(isolaw(campaign("O")), 0, {"continuing: "});
  ASSERT_EQ(isolaw(campaign("P")).code, 0);
  EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), all_rows(path("P/campaign.sqlite")));
}

TEST_F(Resume, killed_campaign_continues_too) {
  auto const o = stopped(campaign("O"), "O", SIGKILL);
  ASSERT_EQ(o.code, 128 + SIGKILL) << o;
  int const kept = stored_runs(path("O/campaign.sqlite"), "abe");
  EXPECT_GE(kept, 3);
  auto const continued = isolaw(campaign("O"));
  expect_message(continued, 0, {"continuing: "});
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT count(*) FROM run"), Words{"40"});
  EXPECT_FALSE(exists("O/campaign.sqlite-wal"));
}

TEST_F(Resume, polite_kill_stops_like_ctrl_c) {
  auto const o = stopped(campaign("O"), "O", SIGTERM);
  expect_message(o, 1, {"interrupted", "to continue: "});
}

// When an ssh session ends, nobody reads isolaw's last message. The store must be left as after Ctrl-C.
TEST_F(Resume, a_closed_terminal_stops_like_ctrl_c) {
  auto const o = stopped(campaign("O"), "O", SIGHUP);
  expect_message(o, 1, {"interrupted", "to continue: "});
  EXPECT_FALSE(exists("O/campaign.sqlite-wal"));
  if (!fs::exists("/dev/full")) return;
  Process deaf(Words{ISOLAW_BINARY} + campaign("P"), directory(), path("out"), "/dev/full");
  Outcome result;
  while (stored_runs(path("P/campaign.sqlite"), "abe") < 1 && !deaf.ended(result)) std::this_thread::sleep_for(5ms);
  deaf.send(SIGHUP);
  EXPECT_EQ(deaf.wait().code, 1) << "messages that nobody can read must not disturb the end";
  EXPECT_FALSE(exists("P/campaign.sqlite-wal"));
}

// nohup makes a program ignore the signal SIGHUP of a closed terminal. isolaw must not catch the signal then.
TEST_F(Resume, a_closed_terminal_is_ignored_where_it_is_to_be) {
  Process process(Words{"sh", "-c", "trap '' HUP; exec \"$0\" \"$@\"", ISOLAW_BINARY} +
                      Words{"calibrate", "ex/study.toml", "--laws", "abe", "--runs", "2", "--samples-per-cycle", "40",
                            "--analysis", "none", "--out", "O"},
                  directory(), path("out"), path("err"));
  Outcome result;
  while (stored_runs(path("O/campaign.sqlite"), "abe") < 1 && !process.ended(result)) std::this_thread::sleep_for(5ms);
  process.send(SIGHUP);
  EXPECT_EQ(process.wait().code, 0);
}

// A limit on memory makes some of the 64 threads fail to start. The threads that do start must finish the work.
TEST_F(Resume, threads_that_cannot_be_made_are_done_without) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more memory than a limit leaves";
#endif
  ASSERT_EQ(isolaw(campaign("P", {"--jobs", "1"})).code, 0);
  Process process(
      Words{"sh", "-c", "ulimit -v 300000; exec \"$0\" \"$@\"", ISOLAW_BINARY} + campaign("O", {"--jobs", "64"}),
      directory(), path("out"), path("err"));
  auto const o = process.wait();
  if (o.code == 0) {
    EXPECT_EQ(read("O/summary.json"), read("P/summary.json"));
    EXPECT_TRUE(contains(o.err, "the system gave no more threads or memory: "));
    EXPECT_TRUE(contains(o.err, " did the work; try: --jobs "));
  } else {
    expect_message(o, 3, {"out of memory", "fewer --jobs", "finished runs are kept in O/campaign.sqlite"});
  }
}

TEST_F(Resume, the_command_to_continue_with_does_not_start_over) {
  auto const o = stopped(campaign("O", {"--fresh"}), "O", SIGINT);
  expect_message(o, 1, {"to continue: "});
  EXPECT_EQ(o.err.find("--fresh"), std::string::npos) << "following the advice would throw the finished runs away\n"
                                                      << o;
}

TEST_F(Resume, starting_over_leaves_no_results_of_the_former_campaign_beside_the_new_store) {
  ASSERT_EQ(isolaw({"calibrate", "ex/study.toml", "--laws", "bilinear", "--runs", "1", "--population", "4",
                    "--generations", "1", "--out", "O"})
                .code,
            0);
  ASSERT_TRUE(exists("O/summary.json"));
  auto const o = stopped(campaign("O", {"--fresh"}), "O", SIGINT);
  ASSERT_EQ(o.code, 1) << o;
  EXPECT_FALSE(exists("O/summary.json")) << "of " << read("O/summary.json").substr(0, 300);
  EXPECT_FALSE(exists("O/report.html"));
}

TEST_F(Resume, a_reader_of_the_store_does_not_cost_the_campaign_its_results) {
  // docs/store.md recommends SQL viewers. The test opens the store as a viewer does, and keeps it open while the
  // campaign runs.
  auto process = start(campaign("O"));
  Outcome result;
  while (stored_runs(path("O/campaign.sqlite"), "abe") < 3 && !process.ended(result)) std::this_thread::sleep_for(5ms);
  sqlite3* viewer = nullptr;
  ASSERT_EQ(sqlite3_open_v2(path("O/campaign.sqlite").c_str(), &viewer, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(viewer, "SELECT count(*) FROM run", nullptr, nullptr, nullptr), SQLITE_OK);
  auto const o = process.wait();
  sqlite3_close(viewer);
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(exists("O/summary.json"));
}

TEST_F(Resume, report_of_an_unfinished_campaign_says_what_is_missing) {
  ASSERT_EQ(stopped(campaign("O"), "O", SIGINT).code, 1);
  int const kept = stored_runs(path("O/campaign.sqlite"), "abe");
  auto const o = isolaw({"report", "O"});
  EXPECT_TRUE(contains(o.err, fmt::format("not complete: {} runs are missing", 40 - kept))) << o;
  EXPECT_TRUE(exists("O/summary.json"));
}

TEST_F(Resume, finished_campaign_is_not_searched_again) {
  ASSERT_EQ(isolaw(campaign("O")).code, 0);
  auto const summary = read("O/summary.json");
  auto const rows = all_rows(path("O/campaign.sqlite"));
  auto const again = isolaw(campaign("O"));
  EXPECT_EQ(again.code, 0) << again;
  EXPECT_EQ(read("O/summary.json"), summary);
  EXPECT_EQ(again.err.find("continuing"), std::string::npos) << again;
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), rows);
}

class Changed : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record()));
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
    write("lot.toml", lot("S1", "b.csv"));
    ASSERT_EQ(run().code, 0);
  }
  static std::string lot(std::string const& serial, std::string const& second) {
    return "[[device]]\nname = \"a\"\nfile = \"a.csv\"\nserial = \"" + serial +
           "\"\n\n[[device]]\nname = \"b\"\nfile = \"" + second + "\"\n";
  }
  Outcome run(Words const& more = {}, Words const& size = {"--runs", "2"}) {
    return isolaw(
        Words{"calibrate", "lot.toml", "--laws", "bilinear", "--population", "4", "--generations", "2", "--out", "O"} +
        size + more);
  }
};

TEST_F(Changed, settings_are_refused_naming_each) {
  auto const before = read("O/campaign.sqlite"), summary = read("O/summary.json");
  auto const o = isolaw({"calibrate",           "lot.toml", "--laws", "abe",       "--population", "4",
                         "--generations",       "3",        "--runs", "3",         "--seed",       "9",
                         "--integration",       "paper",    "--box",  "published", "--set",        "bilinear.K2=0.5",
                         "--samples-per-cycle", "100",      "--out",  "O"});
  expect_refused(o, {"O/campaign.sqlite", "the campaign there differs", "laws: bilinear there, abe now",
                     "generations: 2 there, 3 now", "seed: 1 there, 9 now", "integration: ", "box: ", "set: ",
                     "samples-per-cycle: 200 there, 100 now", "--fresh", "another --out"});
  EXPECT_EQ(o.err.find("population"), std::string::npos) << "did not change";
  EXPECT_EQ(read("O/campaign.sqlite"), before);
  EXPECT_EQ(read("O/summary.json"), summary);
}

// A campaign must not continue with another method. The default search and the genetic algorithm differ in many
// settings. The message that refuses must name only the method and the weights, whose default depends on the method.
TEST_F(Changed, the_method_is_refused_by_its_name_in_both_directions) {
  Words const command{"calibrate", "a.csv", "--laws", "bilinear", "--runs", "2", "--out", "P"};
  Words const genetic{"--method", "ga", "--population", "4", "--generations", "2"};
  std::string const advice =
      "; allowed: the same settings and records, to continue it; devices, laws and runs may be added; try: --fresh to start over";
  ASSERT_EQ(isolaw(command + genetic).code, 0);
  for (auto const& best : {Words{"--method", "best"}, Words{}})
    expect_refused(
        isolaw(command + best),
        {"P/campaign.sqlite: the campaign there differs: method: ga there, best now; weights: time there, auto now" +
         advice});
  ASSERT_EQ(isolaw(command + Words{"--fresh"}).code, 0);
  auto const before = read("P/campaign.sqlite");
  expect_refused(
      isolaw(command + genetic),
      {"P/campaign.sqlite: the campaign there differs: method: best there, ga now; weights: auto there, time now" +
       advice});
  EXPECT_EQ(read("P/campaign.sqlite"), before);
}

TEST_F(Changed, settings_are_accepted_with_fresh) {
  auto const o = run({"--fresh", "--seed", "9"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(json("O/summary.json")["seed"], 9);
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT count(*) FROM run"), Words{"4"});
}

TEST_F(Changed, records_are_refused_naming_the_device) {
  write("b.csv", csv(record({.amplitude_mm = 91.0})));
  expect_refused(run(), {"the campaign there differs", "b: its file has changed", "--fresh"});
}

TEST_F(Changed, reading_and_cleaning_are_refused) {
  expect_refused(run({"--smooth", "5"}), {"smooth: 1 there, 5 now"});
  expect_refused(run({"--columns", "time=none"}), {"a: its file is read in another way"});
}

TEST_F(Changed, a_load_that_is_not_read_is_refused) {
  auto const with_load = csv(record(), "time [s],displacement [mm],force [kN],vertical load [kN]",
                             [](std::size_t, Sample const& s) { return row(s) + ",500"; });
  write("a.csv", with_load);
  ASSERT_EQ(run({"--fresh"}).code, 0);
  ASSERT_EQ(query(path("O/campaign.sqlite"), "SELECT count(*) FROM series WHERE channel = 'load_kN'"), Words{"1"});
  expect_refused(run({"--columns", "load=none"}), {"a: its file is read in another way"});
}

TEST_F(Changed, a_record_that_is_gone_is_said_to_be) {
  fs::remove(path("b.csv"));
  expect_message(run(), 2, {"the campaign there differs", "b: refused now: b.csv: no such file"});
}

TEST_F(Changed, devices_are_refused) {
  write("lot.toml", "[[device]]\nname = \"a\"\nfile = \"a.csv\"\n");
  expect_refused(run(), {"there and not now: 'b'"});
  write("lot.toml", "[[device]]\nname = \"z\"\nfile = \"a.csv\"\n\n[[device]]\nname = \"b\"\nfile = \"b.csv\"\n");
  expect_refused(run(), {"there and not now: 'a'"});
}

TEST_F(Changed, what_the_lot_file_says_of_a_device_is_not_silently_left_as_it_was) {
  write("lot.toml", lot("S2", "b.csv"));
  auto const o = run();
  if (o.code == 2) return;  // refusing the change is correct too
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT serial FROM device WHERE name = 'a'"), Words{"S2"}) << o;
}

TEST_F(Changed, a_refusal_is_not_silently_left_as_it_was) {
  write("b.csv", "");
  auto const first = run({"--fresh"});
  expect_message(first, 1, {"b.csv: is empty"});
  write("b.csv", csv_with_line(101, "0.9900,nan,12.0"));
  auto const o = run();
  if (o.code == 2) return;  // refusing the change is correct too
  EXPECT_TRUE(contains(json("O/summary.json")["devices"][1]["message"].get<std::string>(), "b.csv:101")) << o;
}

TEST_F(Changed, a_store_that_is_none_is_refused_and_kept) {
  write("O/campaign.sqlite", "text");
  expect_refused(run(), {"campaign.sqlite", "not a database"});
  EXPECT_EQ(read("O/campaign.sqlite"), "text");
  write("O/campaign.sqlite", "");
  expect_refused(run(), {"campaign.sqlite", "not a campaign store of isolaw"});
  expect_refused(isolaw({"report", "nowhere"}), {"nowhere/campaign.sqlite", "no such file", "isolaw calibrate"});
}

TEST_F(Changed, an_unfinished_campaign_of_another_build_is_not_continued) {
  auto const change = [&](std::string const& sql) {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(db);
  };
  change("UPDATE maker SET version = '0.0.9', build = '0123456789ab'");
  auto const finished = run();
  EXPECT_EQ(finished.code, 0) << finished;  // another build may report this store, because no run is missing
  EXPECT_EQ(json("O/summary.json")["isolaw"].dump(), R"([{"version":"0.0.9","build":"0123456789ab"}])");
  EXPECT_TRUE(contains(read("O/report.html"), "0.0.9, build 0123456789ab"));
  change("DELETE FROM run WHERE number = 1; DELETE FROM run_parameter WHERE number = 1");
  auto const before = all_rows(path("O/campaign.sqlite"));
  expect_refused(run(),
                 {"O/campaign.sqlite",
                  "a campaign of isolaw 0.0.9, build 0123456789ab that is to be continued; this is " ISOLAW_VERSION,
                  "runs of one build", "isolaw --version", "--fresh"});
  EXPECT_EQ(all_rows(path("O/campaign.sqlite")), before);
  EXPECT_EQ(isolaw({"report", "O"}).code, 1);  // the exit code is 1 because runs are missing
  EXPECT_EQ(run({"--fresh"}).code, 0);
}

TEST_F(Changed, every_run_names_its_maker) {
  auto const makers =
      query(path("O/campaign.sqlite"), "SELECT version, length(build), instruction_set <> '' FROM maker");
  EXPECT_EQ(makers, Words{ISOLAW_VERSION "|12|1"});
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT DISTINCT maker FROM run"), Words{"0"});
}

TEST_F(Changed, a_store_of_a_newer_schema_is_refused) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(path("O/campaign.sqlite").c_str(), &db), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(db, "UPDATE meta SET value = '99' WHERE key = 'schema'", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(db);
  for (auto const& o : {run(), isolaw({"report", "O"})})
    expect_refused(o, {"O/campaign.sqlite", "a store of schema 99, written by isolaw '" ISOLAW_VERSION "'",
                       "the isolaw that wrote it"});
}

TEST_F(Changed, a_damaged_store_is_refused_without_a_crash) {
  auto bytes = read("O/campaign.sqlite");
  for (std::size_t i = 5000; i < bytes.size(); i += 97) bytes[i] = static_cast<char>(bytes[i] ^ 0x5a);
  write("O/campaign.sqlite", bytes);
  expect_refused(isolaw({"report", "O"}), {"O/campaign.sqlite"});
  write("O/campaign.sqlite", bytes.substr(0, bytes.size() / 2));
  expect_refused(isolaw({"report", "O"}), {"O/campaign.sqlite"});
}

// On a terminal one line shows the progress: share, runs, time left and the best objectives. It is erased at the end.
TEST_F(Changed, progress_is_shown_on_a_terminal) {
  int terminal = -1, other = -1;
  char name[256] = {};
  winsize size{.ws_row = 40, .ws_col = 120, .ws_xpixel = 0, .ws_ypixel = 0};
  if (openpty(&terminal, &other, name, nullptr, &size) != 0) GTEST_SKIP() << "no pseudo terminal here";
  Process process({ISOLAW_BINARY, "calibrate", "lot.toml", "--laws", "bilinear,abe", "--runs", "8", "--population",
                   "20", "--generations", "20", "--analysis", "none", "--out", "T"},
                  directory(), path("stdout"), name);
  std::string shown;
  fcntl(terminal, F_SETFL, O_NONBLOCK);
  Outcome result;
  bool ended = false;
  while (!ended) {
    ended = process.ended(result);
    char buffer[4096];
    for (ssize_t got = 0; (got = ::read(terminal, buffer, sizeof buffer)) > 0;)
      shown.append(buffer, static_cast<std::size_t>(got));
    std::this_thread::sleep_for(2ms);
  }
  close(other);
  close(terminal);
  EXPECT_EQ(result.code, 0) << shown;
  for (auto const* part : {"/32 runs", " %  ", " left", "Abe on ", "100 %  0 s left  32/32 runs", "\r"})
    EXPECT_TRUE(contains(shown, part));
  // A line is short enough for 80 columns, although this terminal has 120.
  for (auto at = shown.find('\r'); at != std::string::npos; at = shown.find('\r', at + 1))
    EXPECT_LT(shown.find("\033[K", at) - at, 80u) << shown.substr(at, 120);
}

}  // namespace
}  // namespace isolaw::cli_test
