// After any failure to write files, the same command given again must end as if nothing had happened. The environment
// variable ISOLAW_FAULTS=all tries every kind of fault at every operation. ISOLAW_KILLS=n kills n times at random
// moments.
#include <cstdlib>
#include <random>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

int from_environment(char const* name, int otherwise) {
  char const* value = std::getenv(name);
  return value == nullptr ? otherwise : std::atoi(value);
}

class Fault : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record()));
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
  }
  // Tests that count operations add --jobs 1, because one thread performs them in the same order each time.
  Words campaign(Words const& more = {}) const {
    return Words{"calibrate", "a.csv", "b.csv", "--laws", "bilinear", "--runs", "3", "--out", "O"} + more;
  }
  Outcome with_fault(std::string const& mode, long at, Words const& command, fs::path const& below = "O") {
    return start(command, {"LD_PRELOAD=" ISOLAW_FAULT_LIBRARY, "ISOLAW_FAULT_DIR=" + path(below).string(),
                           "ISOLAW_FAULT_MODE=" + mode, "ISOLAW_FAULT_AT=" + std::to_string(at),
                           "ISOLAW_FAULT_COUNT=" + path("count").string(), "ASAN_OPTIONS=verify_asan_link_order=0"})
        .wait();
  }
  long operations(Words const& command) {
    fs::remove_all(path("O"));
    auto const o = with_fault("count", 0, command);
    EXPECT_EQ(o.code, 0) << o;
    return exists("count") ? std::stol(read("count")) : 0;
  }
  struct Results {
    std::string summary;
    Words rows;
    bool operator==(Results const&) const = default;
  };
  Results results() const { return {read("O/summary.json"), all_rows(path("O/campaign.sqlite"))}; }
  // Expects that the same command without a fault finishes and gives the results of an undisturbed campaign.
  void expect_mended(Words const& command, Results const& expected, std::string const& after) {
    auto const o = isolaw(command);
    ASSERT_EQ(o.code, 0) << after << '\n' << o;
    ASSERT_TRUE(results() == expected) << after;
    for (auto const& entry : fs::recursive_directory_iterator(path("O"))) {
      auto const name = entry.path().filename().string();
      EXPECT_FALSE(name.ends_with(".part") || name.ends_with("-wal") || name.ends_with("-journal"))
          << name << " is left, " << after;
    }
  }
  // Kills a campaign at a moment when some of its runs are only in SQLite's write-ahead log and not yet in the store
  // itself. Returns false if this never happened.
  bool killed_with_log() {
    for (long at = operations(campaign({"--jobs", "1"})) - 20; at > 0; at -= 5) {
      fs::remove_all(path("O"));
      (void)with_fault("kill", at, campaign({"--jobs", "1"}));
      auto const log = path("O/campaign.sqlite-wal");
      if (fs::exists(log) && fs::file_size(log) > 0 && stored_runs(path("O/campaign.sqlite"), "bilinear") > 0)
        return true;
    }
    return false;
  }
  // Restores the campaign in `former` (seed 1), starts it over with --fresh and seed 2, and kills it before operation
  // `at`. Returns which of the two stores is left, after checking that it can be continued. Returns `nothing` if the
  // program ended before that operation.
  enum class Left { former, replaced, nothing };
  Left left_of(std::string const& former, long at) {
    SCOPED_TRACE(fmt::format("killed before operation {}", at));
    fs::remove_all(path("O"));
    fs::copy(path(former), path("O"), fs::copy_options::recursive);
    if (with_fault("kill", at, campaign({"--fresh", "--seed", "2", "--jobs", "1"})).code == 0) return Left::nothing;
    EXPECT_TRUE(exists("O/campaign.sqlite")) << "neither the former store nor the new one";
    auto const reports = exists("O/summary.json") ? json("O/summary.json") : Json();
    auto const o = isolaw(campaign({"--seed", "2"}));
    bool const replaced = o.code == 0;
    if (replaced && !reports.is_null()) {
      EXPECT_EQ(reports["seed"], 2) << "a report of the former campaign beside the new store";
    }
    if (!replaced) {
      expect_refused(o, {"the campaign there differs: seed: 1 there, 2 now"});
      EXPECT_EQ(isolaw(campaign()).code, 0) << "the former campaign cannot be continued";
    }
    auto const check = isolaw({"check", "O"});
    EXPECT_EQ(check.code, 0) << check;
    return replaced ? Left::replaced : Left::former;
  }
  // Kills the program at every tenth operation while it starts over with --fresh, and at every operation near the one
  // that replaces the former store by the new one.
  void expect_one_of_both(std::string const& former) {
    constexpr long stride = 10, around = 20;
    long at = 1;
    while (left_of(former, at) == Left::former && !HasFailure()) at += stride;
    EXPECT_GT(at, stride) << "the operations are not those of starting over";
    for (long near = std::max(1L, at - around); near < at && !HasFailure(); ++near)
      if (left_of(former, near) == Left::replaced) at = near;
    while (!HasFailure() && left_of(former, at) == Left::replaced) at += stride;
    EXPECT_EQ(left_of(former, at), Left::nothing);
  }
  // Tries faults of one kind at about twelve operations spread over the campaign, or at every operation if
  // ISOLAW_FAULTS is set. Returns how many faults it tried.
  int try_all(std::string const& mode, Words const& command) {
    long const count = operations(command);
    EXPECT_GT(count, 50) << "the library that makes faults does not see what the program writes";
    if (count == 0) return 0;
    auto const expected = results();
    bool const all = std::getenv("ISOLAW_FAULTS") != nullptr;
    long const stride = all ? 1 : count / 12;
    int tried = 0;
    for (long at = 1; at <= count && !HasFatalFailure(); at += stride, ++tried) {
      auto const after = fmt::format("after fault '{}' at operation {} of {}", mode, at, count);
      fs::remove_all(path("O"));
      auto const o = with_fault(mode, at, command);
      bool const killed = mode == "kill" || mode == "torn";
      if (killed) {
        EXPECT_EQ(o.code, 128 + SIGKILL) << after << '\n' << o;
      } else if (o.code == 0) {  // the fault did no harm, for example to a file that the program can do without
        EXPECT_TRUE(results() == expected) << after;
      } else {
        EXPECT_EQ(o.code, 2) << after << '\n' << o;
        EXPECT_TRUE(contains(o.err, "; try: ")) << after;
      }
      expect_mended(command, expected, after);
    }
    RecordProperty("faults_tried", tried);
    fmt::print("{}: {} of {} operations tried\n", mode, tried, count);
    return tried;
  }
};

TEST_F(Fault, a_single_write_that_fails) {
  EXPECT_GE(try_all("once", campaign({"--jobs", "1"})), 12);
}
TEST_F(Fault, a_disk_that_is_full) {
  EXPECT_GE(try_all("full", campaign({"--jobs", "1"})), 12);
}
TEST_F(Fault, a_directory_that_turns_read_only) {
  EXPECT_GE(try_all("readonly", campaign({"--jobs", "1"})), 12);
}
TEST_F(Fault, a_kill_before_a_write) {
  EXPECT_GE(try_all("kill", campaign({"--jobs", "1"})), 12);
}
TEST_F(Fault, a_kill_in_the_middle_of_a_write) {
  EXPECT_GE(try_all("torn", campaign({"--jobs", "1"})), 12);
}

// A merge puts its store in order in one transaction over two files. While it commits, SQLite keeps a list of the two
// files. A kill at that moment leaves the list and the new version of the store, and the next merge must remove both.
TEST_F(Fault, a_kill_while_a_merge_commits_leaves_nothing_for_good) {
  for (auto const* part : {"1/2", "2/2"})
    ASSERT_EQ(isolaw({"calibrate", "a.csv", "b.csv", "--laws", "bilinear", "--runs", "3", "--part", part, "--out",
                      std::string("P") + part[0]})
                  .code,
              0);
  Words const merge{"merge", "O", "P1", "P2", "--figures", "none"};
  auto const left = [&] {
    std::size_t files = 0;
    for (auto const& entry : fs::directory_iterator(path("O")))
      files += entry.path().filename().string().find(".part") != std::string::npos;
    return files;
  };
  fs::path const list = "O/campaign.sqlite.part-mj";  // SQLite adds a random number to this name
  ASSERT_EQ(with_fault("count", 0, merge, list).code, 0);
  EXPECT_EQ(left(), 0u);
  auto const operations = std::stol(read("count"));
  EXPECT_GT(operations, 2) << "SQLite made no such list";
  for (long at = 1; at <= operations; ++at) {
    fs::remove_all(path("O"));
    EXPECT_EQ(with_fault("kill", at, merge, list).code, 128 + SIGKILL);
    EXPECT_GT(left(), at > 1 ? 1u : 0u) << at;
    auto const again = isolaw(merge);
    EXPECT_EQ(again.code, 0) << again;
    EXPECT_EQ(left(), 0u) << "after a kill before operation " << at << " on the list";
  }
}

// --fresh must remove the former campaign only when the new store is complete.
TEST_F(Fault, a_full_disk_does_not_cost_the_campaign_that_was_to_be_replaced) {
  ASSERT_EQ(isolaw(campaign()).code, 0);
  auto const before = all_rows(path("O/campaign.sqlite"));
  auto const o = with_fault("full", 1, campaign({"--fresh", "--seed", "2"}));
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(all_rows(path("O/campaign.sqlite")) == before);
}

// Starting over with --fresh is killed at many operations. Each time the former or the new store must be there, and the
// reports must belong to that store.
TEST_F(Fault, a_kill_while_starting_over_leaves_one_of_both) {
  ASSERT_EQ(isolaw(campaign()).code, 0);
  fs::copy(path("O"), path("former"), fs::copy_options::recursive);
  expect_one_of_both("former");
}

// The former campaign was killed, and a write-ahead log of SQLite lies beside its store. The log must not be applied to
// the new store, nor be left beside it.
TEST_F(Fault, starting_over_does_not_take_the_former_log_for_its_own) {
  ASSERT_TRUE(killed_with_log()) << "no kill left a log";
  fs::copy(path("O"), path("former"), fs::copy_options::recursive);
  ASSERT_EQ(isolaw(campaign({"--fresh", "--seed", "2"})).code, 0);
  auto const o = isolaw({"check", "O"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_FALSE(exists("O/campaign.sqlite-wal"));
  expect_one_of_both("former");
}

// A user without write permission reads the store of a killed campaign. SQLite cannot create the files that it needs to
// read the log, so the message must say what to do.
TEST_F(Fault, a_killed_store_read_by_another_says_what_to_do) {
  ASSERT_TRUE(killed_with_log()) << "no kill left a log";
  fs::remove(path("O/campaign.sqlite-shm"));
  auto const o = with_fault("readonly", 1, {"check", "O"});
  expect_refused(o, {"the program was killed", "a copy of the whole directory where you may write"});
}

TEST_F(Fault, the_message_says_what_is_kept_and_how_to_go_on) {
  long const count = operations(campaign({"--jobs", "1"}));
  auto const expected = results();
  fs::remove_all(path("O"));
  auto const o = with_fault("full", 3 * count / 10, campaign({"--jobs", "1"}));
  expect_message(o, 2,
                 {"stopped: ", " finished runs are kept in O/campaign.sqlite",
                  "continue with: ", "calibrate a.csv b.csv --laws bilinear", "database or disk is full"});
}

TEST_F(Fault, a_campaign_killed_again_and_again_ends_like_one_that_was_not) {
  Words const command{"calibrate", "a.csv", "b.csv", "--laws", "bilinear,hwang-wu", "--runs", "6",
                      "--jobs",    "2",     "--out", "O"};
  auto const begin = std::chrono::steady_clock::now();
  ASSERT_EQ(isolaw(command).code, 0);
  auto const whole_time = std::chrono::steady_clock::now() - begin;
  auto const expected = results();
  int const wanted = from_environment("ISOLAW_KILLS", 8);
  std::mt19937 random(20230511);
  int kills = 0, campaigns = 0;
  while (kills < wanted && !HasFatalFailure()) {
    fs::remove_all(path("O"));
    ++campaigns;
    for (int attempt = 0;; ++attempt) {
      auto process = start(command);
      std::this_thread::sleep_for(whole_time * std::uniform_real_distribution<>(0.0, 0.7)(random));
      process.send(SIGKILL);
      auto const o = process.wait();
      if (o.code == 0) break;
      ASSERT_EQ(o.code, 128 + SIGKILL) << o;
      ++kills;
      ASSERT_LT(attempt, 1000) << "no attempt gets any further";
    }
    expect_mended(command, expected, fmt::format("after {} kills", kills));
  }
  RecordProperty("kills_survived", kills);
  fmt::print("{} kills in {} campaigns survived\n", kills, campaigns);
}

TEST_F(Fault, a_second_process_in_one_directory_is_refused) {
  auto first = start({"calibrate", "a.csv", "--laws", "abe", "--runs", "1000", "--out", "O"});
  auto const end = std::chrono::steady_clock::now() + 60s;
  while (stored_runs(path("O/campaign.sqlite"), "abe") < 1 && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(5ms);
  auto const second = isolaw({"calibrate", "a.csv", "--laws", "abe", "--runs", "1000", "--out", "O"});
  expect_refused(second, {"O: another isolaw works in this directory", "try: wait for it, or another --out DIR"});
  first.send(SIGINT);
  EXPECT_EQ(first.wait().code, 1) << "the second process disturbed the first";
}

// report and check must not change a byte of the store, and check must work where nothing can be written.
TEST_F(Fault, reading_leaves_the_store_as_it_is) {
  ASSERT_EQ(isolaw(campaign()).code, 0);
  auto const bytes = read("O/campaign.sqlite");
  EXPECT_EQ(isolaw({"report", "O"}).code, 0);
  auto const o = isolaw({"check", "O"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "O/campaign.sqlite: sound"));
  EXPECT_EQ(isolaw(campaign()).code, 0);
  EXPECT_EQ(read("O/campaign.sqlite"), bytes);
  // "0" means that check tried no operation that changes files in O, not even beside the store.
  auto const readonly = with_fault("readonly", 1, {"check", "O"});
  EXPECT_EQ(readonly.code, 0) << readonly;
  EXPECT_EQ(read("count"), "0\n");
}

}  // namespace
}  // namespace isolaw::cli_test
