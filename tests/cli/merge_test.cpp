// A campaign computed in parts and merged must equal, byte by byte, a campaign computed on one machine. merge refuses
// anything that is not a part of the campaign.
#include <sys/file.h>

#include <numeric>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

// Returns all files of a campaign's directory by name, without run.json, which records when and how long it ran.
std::map<std::string, std::string> results_in(fs::path const& directory) {
  std::map<std::string, std::string> found;
  for (auto const& entry : fs::recursive_directory_iterator(directory))
    if (auto const name = fs::relative(entry.path(), directory).string(); entry.is_regular_file() && name != "run.json")
      found[name] = read_file(entry.path());
  return found;
}

void change(fs::path const& store, std::string const& sql) {
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(store.c_str(), &db), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
  sqlite3_close(db);
}

class Merge : public InFreshDirectory {
 protected:
  static constexpr int parts = 7;

  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a b.csv", csv(record()));
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
    write("small.csv", csv(record({.amplitude_mm = 45.0})));
    write("c.csv", "time,displacement,force\nno record\n");
    write("lot.toml",
          "[[device]]\nname = \"a, 'b'\"\nfile = \"a b.csv\"\n[[device]]\nname = \"b\"\n"
          "[[device.test]]\nfile = \"b.csv\"\n[[device.test]]\nfile = \"small.csv\"\n"
          "[[device]]\nname = \"c\"\nfile = \"c.csv\"\n");
  }
  static Words campaign(std::string const& out, Words const& more = {}) {
    return Words{"calibrate",
                 "lot.toml",
                 "--laws",
                 "bilinear,vaiana,menegotto-pinto",
                 "--runs",
                 "4",
                 "--method",
                 "ga",
                 "--population",
                 "40",
                 "--generations",
                 "40",
                 "--analysis",
                 "full",
                 "--replicates",
                 "0",
                 "--samples-per-cycle",
                 "40",
                 "--out",
                 out} +
           more;
  }
  static std::string dir(int number) { return fmt::format("P{}", number); }
  static Words part(int number, Words const& more = {}) {
    return campaign(dir(number), Words{"--part", fmt::format("{}/{}", number, parts)} + more);
  }
  static Words merge(std::vector<int> const& numbers, Words const& more = {}) {
    Words words{"merge", "O", "--figures", "none"};
    for (int const number : numbers) words.push_back(dir(number));
    return words + more;
  }
  void compute(std::vector<int> const& numbers) {
    for (int const number : numbers) {
      auto const o = isolaw(part(number));
      expect_message(o, 0, {fmt::format("part {} of 7 is finished: ", number), "isolaw merge OUT PARTS..."});
      EXPECT_EQ(o.out, "");
    }
  }
  static std::vector<int> all() {
    std::vector<int> numbers(parts);
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
  }
  void expect_as_one_machine() {
    if (!exists("W")) {
      ASSERT_EQ(isolaw(campaign("W", {"--jobs", "3"})).code, 1);  // the exit code is 1 because device c is refused
    }
    auto const one = results_in(path("W")), merged = results_in(path("O"));
    ASSERT_TRUE(one.contains("campaign.sqlite") && one.contains("summary.json") && one.contains("report.html"));
    EXPECT_EQ(all_rows(path("O/campaign.sqlite")), all_rows(path("W/campaign.sqlite")));
    for (auto const& [name, bytes] : one) {
      ASSERT_TRUE(merged.contains(name)) << name;
      EXPECT_TRUE(merged.at(name) == bytes) << name << " differs";
    }
    EXPECT_EQ(merged.size(), one.size());
  }
};

TEST_F(Merge, of_seven_parts_in_any_order_one_killed_one_twice_is_what_one_machine_computes) {
  // Part 4 is killed in the middle of its search and then continued by the same command. On a busy machine the search
  // may end before the kill, in which case the test tries again.
  for (int attempt = 1;; ++attempt) {
    auto killed = start(part(4, {"--jobs", "1"}));
    Outcome result;
    bool ended = false;
    while (stored_rows(path("P4/campaign.sqlite"), "run") < 1 && !(ended = killed.ended(result)))
      std::this_thread::sleep_for(1ms);
    if (!ended) {
      killed.send(SIGKILL);
      result = killed.wait();
    }
    if (result.code == 128 + SIGKILL && stored_rows(path("P4/campaign.sqlite"), "run") < 3) break;
    ASSERT_LT(attempt, 50) << "never killed in its middle";
    std::filesystem::remove_all(path("P4"));
  }
  compute({6, 1, 7, 3, 2, 5, 4});
  ASSERT_EQ(isolaw(campaign("again", {"--part", "2/7", "--jobs", "2"})).code, 0);
  EXPECT_EQ(read("again/campaign.sqlite"), read("P2/campaign.sqlite"));
  auto const o = isolaw(merge({3, 7, 2, 1, 6, 4, 5}, {"again"}));
  expect_message(o, 1, {"24 runs copied, ", " there already"});  // the exit code is 1 because device c is refused
  expect_as_one_machine();
  EXPECT_EQ(without_folder(o.out, "O"), without_folder(isolaw(campaign("W")).out, "W"));
}

TEST_F(Merge, has_no_run_in_two_parts_and_every_run_in_one) {
  compute(all());
  Words found;
  std::vector<int> sizes;
  for (int const number : all()) {
    auto const rows = query(path(dir(number)) / "campaign.sqlite", "SELECT device, law, number FROM run");
    sizes.push_back(static_cast<int>(rows.size()));
    found = found + rows;
  }
  EXPECT_EQ(found.size(), 24u);
  std::ranges::sort(found);
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
  EXPECT_LE(std::ranges::max(sizes) - std::ranges::min(sizes), 1);
}

TEST_F(Merge, takes_what_others_have_examined_of_devices) {
  compute(all());
  auto const examine = [&](std::string const& share) {
    auto words = merge(all(), {"--part", share});
    words[1] = "E" + share.substr(0, 1);
    return isolaw(words);
  };
  expect_message(examine("1/2"), 0,
                 {"part 1 of 2 of the analyses of the devices is finished", "isolaw merge OUT PARTS..."});
  EXPECT_FALSE(exists("E1/summary.json"));
  ASSERT_EQ(examine("2/2").code, 0);
  ASSERT_EQ(examine("2/2").code, 0);  // the same command again has nothing left to compute
  auto const examined = [&](char const* store) { return stored_rows(path(store), "device_analysis"); };
  EXPECT_EQ(examined("E1/campaign.sqlite") + examined("E2/campaign.sqlite"), 6);
  EXPECT_GE(std::min(examined("E1/campaign.sqlite"), examined("E2/campaign.sqlite")), 1);
  EXPECT_EQ(stored_rows(path("E1/campaign.sqlite"), "lot_analysis"), 0);
  // The laws of the lot are fitted in a second step, which may also be divided among several machines.
  auto const fit = [&](std::string const& share) {
    auto words = merge(all(), {"E1", "E2", "--part", share});
    words[1] = "L" + share.substr(0, 1);
    return isolaw(words);
  };
  expect_message(fit("1/2"), 0, {"part 1 of 2 of the analyses of the devices and of the lot's laws is finished"});
  EXPECT_FALSE(exists("L1/summary.json"));
  ASSERT_EQ(fit("2/2").code, 0);
  auto const rows = [&](char const* table) {
    std::vector<int> counts;
    for (auto const* store : {"L1/campaign.sqlite", "L2/campaign.sqlite"})
      counts.push_back(stored_rows(path(store), table));
    return counts;
  };
  EXPECT_EQ(rows("lot_analysis"), (std::vector<int>{1, 2}));
  EXPECT_EQ(rows("left_out"), (std::vector<int>{2, 4}));
  expect_message(isolaw(merge(all(), {"L2", "L1"})), 1, {"24 runs and 15 analyses copied"});
  expect_as_one_machine();
  fs::remove_all(path("O"));
  expect_message(isolaw(merge(all(), {"E1", "E2"})), 1, {"24 runs and 6 analyses copied"});
  expect_as_one_machine();
  expect_refused(examine("3/2"), {"--part", "K/N"});
  expect_refused_as_object(isolaw(merge(all(), {"--part", "1/2", "--json"})),
                           {"--json: a part computes only a share of the analyses"});
}

TEST_F(Merge, names_what_is_missing_and_who_should_hold_it_and_goes_on_from_there) {
  compute({1, 2, 3, 4, 6, 7});
  auto const o = isolaw(merge(all()));
  expect_message(o, 1,
                 {"P5/campaign.sqlite: not there", "runs copied to O/campaign.sqlite",
                  "not complete: ", "of part 5/7 (", "then repeat: isolaw merge O PARTS..."});
  EXPECT_FALSE(exists("O/summary.json"));
  // The table on standard output lists the missing runs. They must be exactly the runs that part 5 computes.
  compute({5});
  Words expected;
  for (auto const& row : query(path("P5/campaign.sqlite"),
                               "SELECT 5, replace(d.name, 'a, ''b''', '\"a, ''b''\"'), law, number "
                               "FROM run JOIN device AS d ON d.id = run.device ORDER BY device, law, number")) {
    expected.push_back(row);
    std::ranges::replace(expected.back(), '|', ',');
  }
  std::string text = "part,device,law,run\n";
  for (auto const& line : expected) text += line + "\n";
  EXPECT_EQ(o.out, text);
  // merge adds part 5 to the parts that were merged before.
  expect_message(isolaw(merge({5})), 1, {"runs copied"});
  expect_as_one_machine();
}

TEST_F(Merge, of_a_part_that_was_killed_and_not_continued_names_its_runs) {
  compute({1, 2, 3, 5, 6, 7});
  auto process = start(part(4));
  process.wait();
  change(path("P4/campaign.sqlite"),
         "DELETE FROM run_parameter WHERE (device, law, number) = (SELECT device, law, number FROM run LIMIT 1);"
         "DELETE FROM run WHERE (device, law, number) = (SELECT device, law, number FROM run LIMIT 1)");
  expect_message(isolaw(merge(all())), 1, {"not complete: 1 run is missing", "of part 4/7 (1 run)"});
  expect_message(isolaw(part(4)), 0, {"continuing: ", " is finished: "});
  expect_message(isolaw(merge({4})), 1, {"1 run copied", "there already"});
  expect_as_one_machine();
}

TEST_F(Merge, refuses_a_part_of_another_build_or_instruction_set_and_changes_nothing) {
  compute({1, 2});
  fs::copy(path("P2"), path("B"));
  change(path("B/campaign.sqlite"), "UPDATE maker SET version = '0.0.9', build = '0123456789ab'");
  expect_refused(isolaw({"merge", "O", "P1", "B"}),
                 {"B/campaign.sqlite: computed by isolaw 0.0.9, build 0123456789ab; this is " ISOLAW_VERSION,
                  "parts and merge of one build", "isolaw --version", "--part 2/7 --fresh"});
  EXPECT_FALSE(exists("O/campaign.sqlite"));
  fs::copy(path("P2"), path("I"));
  change(path("I/campaign.sqlite"), "UPDATE maker SET instruction_set = 'abacus'");
  expect_refused(isolaw({"merge", "O", "P1", "I"}),
                 {"I/campaign.sqlite: computed with instruction set abacus; the merge runs with ",
                  "one instruction set in all parts", "ISOLAW_SIMD=abacus isolaw merge", "--part 2/7 --fresh"});
  EXPECT_FALSE(exists("O/campaign.sqlite"));
  // The store in I above only claims that it was computed with another instruction set. The store in S really was. A
  // merge that runs with the instruction set of S must refuse part 1, unless both instruction sets give the same bits.
  auto const scalar = campaign("S", {"--part", "2/7"});
  ASSERT_EQ(start(scalar, {"ISOLAW_SIMD=scalar"}).wait().code, 0);
  auto const o = start({"merge", "O", "P1", "S"}, {"ISOLAW_SIMD=scalar"}).wait();
  if (read("S/campaign.sqlite") != read("P2/campaign.sqlite"))
    expect_refused(o, {"P1/campaign.sqlite: computed with instruction set ", "the merge runs with scalar"});
}

TEST_F(Merge, refuses_parts_of_another_campaign_saying_what_differs) {
  compute({1});
  auto const refused = [&](Words const& more, std::string const& what) {
    ASSERT_EQ(isolaw(campaign("X", Words{"--part", "2/7", "--fresh"} + more)).code, 0);
    expect_refused(isolaw({"merge", "O", "P1", "X"}),
                   {"X/campaign.sqlite: of another campaign than P1/campaign.sqlite: ", what, "the same lot"});
    EXPECT_FALSE(exists("O/campaign.sqlite"));
  };
  refused({"--seed", "9"}, "seed: 1 in P1/campaign.sqlite, 9 in X/campaign.sqlite");
  auto larger = campaign("X", {"--part", "2/7", "--fresh"});
  *(std::ranges::find(larger, "--runs") + 1) = "5";
  ASSERT_EQ(isolaw(larger).code, 0);
  expect_refused(isolaw({"merge", "O", "P1", "X"}),
                 {"X/campaign.sqlite: of another campaign than P1", "larger by 5 runs"});
  refused({"--design", "K_eff=1.2", "--rules", "ntc-2018"}, "another title, or other rules or design values");
  write("b.csv", csv(record({.amplitude_mm = 91.0})));
  refused({}, "b: its file has changed");
  write("b.csv", csv(record({.amplitude_mm = 90.0})));
  ASSERT_EQ(isolaw(campaign("Y", {"--part", "2/3"})).code, 0);
  expect_refused(isolaw({"merge", "O", "P1", "Y"}),
                 {"Y/campaign.sqlite: is part 2/3; P1/campaign.sqlite is one of 7", "parts of one deal"});
  expect_refused(isolaw({"merge", "P1", "Y"}), {"part"});
  expect_refused(isolaw({"merge", "P1", "P1"}), {"P1: is the directory that is merged into"});
  expect_refused(isolaw({"merge", "O", "nowhere"}), {"nowhere/campaign.sqlite: no part is there"});
}

// merge --fresh must replace the store in O only after it has checked and copied everything that takes its place.
TEST_F(Merge, that_starts_over_replaces_no_part_and_nothing_whole_by_less) {
  compute(all());
  ASSERT_EQ(isolaw(merge(all())).code, 1);  // the exit code is 1 because device c is refused
  auto const whole = results_in(path("O")), part = results_in(path("P1"));
  ASSERT_TRUE(whole.contains("summary.json"));
  auto const refused = [&](Outcome const& o, Words const& said) {
    expect_message(o, 2, said);
    EXPECT_TRUE(results_in(path("O")) == whole);
    EXPECT_TRUE(results_in(path("P1")) == part);
  };
  refused(isolaw({"merge", "P1", "P2", "P3", "--fresh"}),
          {"P1/campaign.sqlite: is part 1/7 itself", "another directory"});
  refused(isolaw(merge({1, 2, 3, 4, 5, 6}, {"p7", "--fresh"})),
          {"p7/campaign.sqlite: is not there, and O/campaign.sqlite was to be replaced", "its name as it is"});
  refused(isolaw(merge({1, 2, 3, 4, 5, 6}, {"--fresh"})),
          {"O/campaign.sqlite: has every run, and is left as it is: of what was to replace it ", "of part 7/7 ("});
  fs::copy(path("P2"), path("X"));
  change(path("X/campaign.sqlite"), "UPDATE run SET evaluations = evaluations + 1");
  refused(isolaw(merge(all(), {"X", "--fresh"})), {"X/campaign.sqlite: run ", "differs from the one"});
  EXPECT_EQ(isolaw({"merge", "P1"}).code, 2);
  // merge --fresh may replace a complete store if all parts are given. It may always replace an empty or damaged store.
  expect_message(isolaw(merge(all(), {"--fresh"})), 1, {"24 runs copied to O/campaign.sqlite"});
  EXPECT_TRUE(results_in(path("O")) == whole);
  for (auto const size : {std::size_t{0}, std::size_t{5000}}) {
    write("O/campaign.sqlite", std::string_view(whole.at("campaign.sqlite")).substr(0, size));
    expect_refused(isolaw(merge(all())), {"O/campaign.sqlite: not a ", "--fresh"});
    expect_message(isolaw(merge({1, 2}, {"--fresh"})), 1, {"runs copied to O/campaign.sqlite"});
    EXPECT_FALSE(exists("O/summary.json"));
    expect_message(isolaw(merge(all(), {"--fresh"})), 1, {"24 runs copied"});
    EXPECT_TRUE(results_in(path("O")) == whole);
  }
  // A merge that is killed leaves temporary files with these names. The next merge must remove them.
  for (auto const* name :
       {"campaign.sqlite.part", "campaign.sqlite.part-wal", "campaign.sqlite.part-shm", "campaign.sqlite.part.part",
        "campaign.sqlite.part.part-journal", "report.html.1999999999.part"})
    write(fs::path("O") / name, "left");
  expect_message(isolaw(merge({1})), 1, {"0 runs copied"});
  EXPECT_TRUE(results_in(path("O")) == whole);
}

TEST_F(Merge, tells_campaigns_from_buildings_and_names_where_both_are) {
  compute({1, 2});
  fs::copy(path("P1"), path("both"));
  write("both/building.sqlite", "");
  expect_refused(isolaw({"merge", "O", "both", "P2"}),
                 {"both: holds a campaign and a study of a building", "both/campaign.sqlite or both/building.sqlite"});
  expect_refused(isolaw({"merge", "both"}), {"both: holds a campaign and a study of a building", "another directory"});
  expect_message(isolaw({"merge", "O", "both/campaign.sqlite", "P2", "--copy-only"}), 1, {"runs copied to O/"});
  write("B/building.sqlite", "");
  expect_refused(isolaw({"merge", "N", "P1", "B"}), {"B: is a study of a building; P1 is a campaign"});
  expect_refused(isolaw({"merge", "O", "B"}), {"O: holds a campaign", "another directory"});
  expect_refused(isolaw({"merge", "B", "P1"}), {"B: holds a study of a building", "another directory"});
  EXPECT_FALSE(exists("N/campaign.sqlite"));
}

TEST_F(Merge, says_where_it_may_not_write) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  compute({1, 2});
  ASSERT_EQ(isolaw(merge({1})).code, 1);
  fs::permissions(path("O/campaign.sqlite"), fs::perms::owner_read);
  auto const o = isolaw(merge({2}));
  expect_refused(o, {"O/campaign.sqlite: may not be written", "permissions"});
  EXPECT_FALSE(contains(o.err, "stopped in the middle"));
}

TEST_F(Merge, finds_out_a_part_that_was_cut_off_or_changed) {
  compute({1, 2});
  auto const bytes = read("P2/campaign.sqlite");
  for (auto const size :
       {bytes.size() / 2, bytes.size() - 4096, bytes.size() - 1, std::size_t{4096}, std::size_t{50}}) {
    write("T/campaign.sqlite", std::string_view(bytes).substr(0, size));
    auto const o = isolaw({"merge", "O", "P1", "T"});
    expect_refused(o, {"T/campaign.sqlite"});
    EXPECT_TRUE(o.err.find("damaged") != std::string::npos || o.err.find("not a ") != std::string::npos) << o;
    EXPECT_FALSE(exists("O/campaign.sqlite")) << size;
  }
  write("T/campaign.sqlite", bytes);
  ASSERT_EQ(isolaw({"merge", "O", "T"}).code, 1);
  change(path("T/campaign.sqlite"), "UPDATE run SET evaluations = evaluations + 1");
  auto const rows = all_rows(path("O/campaign.sqlite"));
  expect_refused(isolaw({"merge", "O", "P1", "T"}),
                 {"T/campaign.sqlite: run ", "differs from the one that is there already", "isolaw check"});
  change(path("T/campaign.sqlite"), "UPDATE run SET number = 99; UPDATE run_parameter SET number = 99");
  expect_refused(isolaw({"merge", "O", "T"}), {"T/campaign.sqlite", "damaged", "run 99 of "});
  for (auto const& row : rows) EXPECT_TRUE(std::ranges::binary_search(all_rows(path("O/campaign.sqlite")), row));
}

TEST_F(Merge, is_refused_where_another_one_is_at_work) {
  compute({1});
  fs::create_directory(path("O"));
  int const held = ::open(path("O").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(held, LOCK_EX | LOCK_NB), 0);  // a merge holds this lock while it works
  expect_refused(isolaw(merge({1})), {"O: another isolaw works in this directory"});
  EXPECT_FALSE(exists("O/campaign.sqlite"));
  close(held);
  // This merge of all parts holds the lock itself, so a second merge must be refused meanwhile.
  compute({2, 3, 4, 5, 6, 7});
  auto first = start(merge(all(), {"--jobs", "1"}));
  Outcome ended;
  bool refused = false;
  while (!exists("O/campaign.sqlite") && !first.ended(ended)) std::this_thread::sleep_for(1ms);
  while (!first.ended(ended) && !refused) {
    auto const second = isolaw(merge(all()));
    refused = second.err.find("another isolaw works in this directory") != std::string::npos;
    EXPECT_EQ(second.code, refused ? 2 : 1) << second;
  }
  if (refused) first.wait();
  EXPECT_TRUE(refused);
  expect_as_one_machine();
}

TEST_F(Merge, that_was_killed_is_done_again_by_the_same_command) {
  compute(all());
  auto process = start(merge(all(), {"--jobs", "1"}));
  Outcome ended;
  while (stored_rows(path("O/campaign.sqlite"), "device_analysis") < 1 && !process.ended(ended))
    std::this_thread::sleep_for(1ms);
  process.send(SIGKILL);
  process.wait();
  // The kill came after all runs had been copied into O, so the merge can continue without the parts.
  for (int const number : all()) fs::remove_all(path(dir(number)));
  expect_message(isolaw({"merge", "O", "--figures", "none"}), 1, {"0 runs copied"});
  expect_as_one_machine();
}

TEST_F(Merge, copies_only_if_asked_and_calibrate_ends_it_as_well) {
  compute(all());
  auto const o = isolaw(merge(all(), {"--copy-only"}));
  expect_message(o, 0, {"24 runs copied"});
  EXPECT_FALSE(exists("O/summary.json"));
  EXPECT_EQ(isolaw(campaign("O")).code, 1);
  expect_as_one_machine();
}

TEST_F(Merge, part_is_an_ordinary_store_that_knows_it_is_one) {
  compute({3});
  EXPECT_EQ(query(path("P3/campaign.sqlite"), "SELECT value FROM meta WHERE key = 'part'"), Words{"3/7"});
  EXPECT_FALSE(exists("P3/summary.json"));
  auto const o = isolaw({"report", "P3"});
  expect_message(o, 1, {"this is part 3 of 7", "isolaw merge OUT PARTS..."});
  EXPECT_EQ(json("P3/summary.json")["part"], 3);
  EXPECT_EQ(json("P3/summary.json")["parts"], 7);
  EXPECT_TRUE(contains(read("P3/report.html"), "This is part 3 of 7. "));
  auto const checked = isolaw({"check", "P3"});
  EXPECT_EQ(checked.code, 0) << checked;
  EXPECT_TRUE(contains(checked.out, "this is part 3 of 7"));
  expect_refused(isolaw(campaign("P3", {"--part", "4/7"})), {"part 3/7 there, part 4/7 now"});
  expect_refused(isolaw(campaign("P3")), {"part 3/7 there, all of it now"});
  auto more = part(3);
  *(std::ranges::find(more, "--runs") + 1) = "5";
  expect_refused(isolaw(more), {"P3/campaign.sqlite: part 3/7 of a campaign that is now larger, by 5 runs instead of 4",
                                "dealt anew"});
  expect_refused_as_object(isolaw(part(3, {"--json"})), {"--json: a part has no summary"});
}

TEST_F(Merge, parts_are_named_as_they_may_be) {
  for (auto const* text : {"0/7", "8/7", "1", "/7", "1/", "a/b", "1/2/3", "-1/7", "1/1000001", ""})
    expect_refused(isolaw(campaign("X", {"--part", text})), {"--part", "K/N, part K of N"});
  EXPECT_FALSE(exists("X"));
  // Where there are more parts than runs, the last parts have nothing to compute and must succeed.
  expect_message(isolaw(campaign("X", {"--part", "100/100"})), 0, {"part 100 of 100 is finished: 0 runs"});
}

// Preparing a record for a law takes far more memory than the record itself. Only the records of runs in progress may
// be prepared, so memory must hardly grow with the number of devices.
TEST_F(Merge, of_a_part_holds_in_memory_what_is_at_work) {
  auto const peak_kB = [&](int devices) {
    auto const folder = fmt::format("lot of {}", devices);
    for (int i = 0; i < devices; ++i)
      write(fs::path(folder) / fmt::format("{:03}.csv", i), csv(record({.amplitude_mm = 80.0 + 0.1 * i})));
    auto const o = isolaw({"calibrate", folder, "--laws", "bilinear,jankowski,vaiana,bouc-wen,hwang-wu,abe-y0,abe",
                           "--method", "ga", "--runs", "1", "--population", "4", "--generations", "1", "--jobs", "2",
                           "--part", "1/1", "--out", fmt::format("O{}", devices)});
    EXPECT_EQ(o.code, 0) << o;
    return o.peak_kB;
  };
  auto const few = peak_kB(50), many = peak_kB(150);
  RecordProperty("kB_per_device", std::to_string((many - few) / 100));
  EXPECT_LT(many - few, 100 * 150);  // a record takes 70 kB when prepared for one law, 490 kB for all seven
}

// `isolaw parts` prints scripts. The names in these tests contain blanks, quotes and dollar signs, which the shell and
// make must not interpret.
class PartScripts : public Merge {
 protected:
  static Words in_parts(std::string const& to, std::string const& out) {
    auto words = campaign(out, {"--figures", "none"});
    words.front() = "parts";
    words.insert(words.begin() + 2, {"5", "--to", to});
    return words;
  }
  Outcome run(Words const& command, Words const& environment = {}) {
    return Process(command, directory(), path("out"), path("err"), environment).wait();
  }
  static bool is_there(std::string const& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
  }
  void expect_merged(std::string const& out) {
    if (!exists("W")) {
      ASSERT_EQ(isolaw(campaign("W")).code, 1);
    }
    for (auto const* name : {"campaign.sqlite", "summary.json", "report.html"})
      EXPECT_TRUE(read(fs::path(out) / name) == read(fs::path("W") / name)) << name;
  }
};

TEST_F(PartScripts, of_make_and_parallel_end_as_one_machine_also_after_a_loss) {
  for (std::string const to : {"make", "parallel"}) {
    if (!is_there(to)) {
      std::cout << "SKIPPED: no " << to << " here\n";
      continue;
    }
    auto const out = "it's $(HOME) $HOME \"" + to + "\" 100%";
    auto const printed = isolaw(in_parts(to, out));
    ASSERT_EQ(printed.code, 0) << printed;
    auto const script = "the '" + to + "' script";
    write(script, printed.out);
    auto const command = to == "make" ? Words{"make", "-f", script, "-j", "2", "-k"} : Words{"sh", script};
    auto const o = run(command, {"ISOLAW_SCRATCH=" + path("disk of $1").string()});
    EXPECT_TRUE(contains(o.err, "24 runs copied")) << o;
    expect_merged(out);
    EXPECT_FALSE(exists("disk of $1/isolaw"));
    fs::remove_all(path(out));
    fs::remove_all(path(out + ".parts/4"));
    auto const again = run(command);
    EXPECT_TRUE(contains(again.err, "24 runs copied")) << again;
    expect_merged(out);
  }
}

// A script skips the parts that exist. It must refuse to merge a part that has other settings or records.
TEST_F(PartScripts, merge_nothing_that_is_of_other_settings_or_records) {
  for (std::string const to : {"make", "parallel", "slurm"}) {
    if (to != "slurm" && !is_there(to)) {
      std::cout << "SKIPPED: no " << to << " here\n";
      continue;
    }
    auto const script = to + " script";
    auto const print = [&](Words const& more) {
      auto const printed = isolaw(in_parts(to, to) + more);
      ASSERT_EQ(printed.code, 0) << printed;
      write(script, printed.out);
    };
    // Runs the whole script. make and parallel start all parts and the merge by themselves; for Slurm the test starts
    // each part as a job would.
    auto const everything = [&] {
      if (to == "make") return run({"make", "-f", script, "-k"});
      if (to == "parallel") return run({"sh", script}, {"ISOLAW_SCRATCH=" + path("disk").string()});
      Outcome all;
      for (int number = 1; number <= 5; ++number) {
        auto const o = run({"sh", script, "part", std::to_string(number)}, {"ISOLAW_SCRATCH=" + path("disk").string()});
        all.err += o.err;
        write(to + fmt::format(".parts/{}.log", number), o.err);
      }
      auto const merged = run({"sh", script, "merge"}, {"ISOLAW_TRY=3"});
      all.err += merged.err;
      all.code = merged.code;
      return all;
    };
    print({});
    everything();
    expect_merged(to);
    auto const whole = results_in(path(to));
    auto const bytes = read(to + ".parts/2/campaign.sqlite");
    auto const refused = [&](Words const& said) {
      auto const o = everything();
      EXPECT_EQ(o.code, 2) << to << o;
      for (auto const& what : said) EXPECT_TRUE(contains(o.err, what)) << to;
      if (to != "make") {
        EXPECT_TRUE(contains(o.err, "not merged, since parts were refused: "));
        EXPECT_TRUE(contains(o.err, to + ".parts/2.log"));
        EXPECT_TRUE(contains(read(to + ".parts/2.log"), "rm -r '")) << to;
      }
      EXPECT_TRUE(results_in(path(to)) == whole) << to;
    };
    print({"--seed", "9"});
    refused({"seed: 1 there, 9 now"});
    print({});
    write("b.csv", csv(record({.amplitude_mm = 91.0})));
    refused({"b: its file has changed"});
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
    // With the original settings and records, running the whole script gives the same bytes again.
    everything();
    EXPECT_TRUE(read(to + ".parts/2/campaign.sqlite") == bytes) << to;
    EXPECT_TRUE(results_in(path(to)) == whole) << to;
    // The test cuts off the store of part 2, in its middle or near its end. merge must refuse the store although its
    // name is right.
    for (auto const size : {bytes.size() / 2, bytes.size() - 100}) {
      write(to + ".parts/2/campaign.sqlite", std::string_view(bytes).substr(0, size));
      refused({"damaged"});
      fs::remove_all(path(to + ".parts/2"));
      everything();
      EXPECT_TRUE(read(to + ".parts/2/campaign.sqlite") == bytes) << to;
    }
    if (to == "make") continue;
    // The script must compute two stores again by itself: an empty one, which a full disk may leave, and a damaged one
    // on the node's own disk.
    write(to + ".parts/2/campaign.sqlite", "");
    everything();
    EXPECT_TRUE(read(to + ".parts/2/campaign.sqlite") == bytes) << to;
    auto const disk = [&] {
      auto const text = read(script);
      auto const end = text.find('\n', text.find("/isolaw-$(id -u)-"));
      return path("disk") / fmt::format("isolaw-{}-{}", getuid(), text.substr(end - 12, 12));
    }();
    fs::remove_all(path(to + ".parts/3"));
    write_file(disk / "3" / "campaign.sqlite", std::string_view(bytes).substr(0, 5000));
    auto const o = everything();
    EXPECT_TRUE(contains(o.err, "0 runs copied, 24 there already")) << o;
    EXPECT_TRUE(exists(to + ".parts/3/campaign.sqlite")) << o;
    // The script must leave no files on the node's disk.
    EXPECT_TRUE(!exists("disk") || fs::is_empty(path("disk"))) << to;
    // The directory holds part 1 of 5, so a script for 2 parts must refuse to use it.
    auto words = in_parts(to, to);
    words[2] = "2";
    write(script, isolaw(words).out);
    auto const other = run({"sh", script, "part", "1"}, {"ISOLAW_SCRATCH=" + path("disk").string()});
    EXPECT_EQ(other.code, 2);
    EXPECT_TRUE(contains(other.err, "part 1/5 there, part 1/2 now")) << other;
  }
}

TEST_F(PartScripts, fix_the_instruction_set_and_ask_for_time_and_memory) {
  auto const o = start(in_parts("slurm", "O"), {"ISOLAW_SIMD=scalar"}).wait();
  ASSERT_EQ(o.code, 0) << o;
  for (auto const* part : {"export ISOLAW_SIMD=scalar\n", "--array=\"$array\" --requeue", "--time=10 ",
                           "--mem=", "--dependency=afterany:", "# 5 parts of work, merged into O.", "isolaw-$(id -u)-"})
    EXPECT_TRUE(contains(o.out, part));
  write("s", o.out);
  EXPECT_EQ(run({"sh", "-n", "s"}).code, 0);
  EXPECT_EQ(run({"sh", "s", "else"}).code, 2);
}

TEST_F(PartScripts, are_refused_as_commands_are) {
  expect_refused(isolaw(in_parts("pbs", "O")), {"--to", "'pbs'", "slurm, make, parallel"});
  expect_refused(isolaw(in_parts("make", "a\nb")), {"holds a line break"});
  auto none = in_parts("make", "O");
  none[2] = "0";
  expect_refused(isolaw(none), {"count: 0", "1 to 100000 parts"});
  expect_message(isolaw(Words{"parts", "lot.toml", "50", "--to", "make"} + Words(none.begin() + 5, none.end())), 0,
                 {"24 runs for 50 parts: some parts will have none"});
  // `isolaw parts` refuses options that would have no effect on a script.
  expect_refused(isolaw(in_parts("make", "O") + Words{"--motion", "m.csv"}),
                 {"--motion: is given for a lot", "--campaign"});
  expect_refused(isolaw({"parts", "b.toml", "5", "--to", "make", "--campaign", "O", "--runs", "3", "--seed", "2"}),
                 {"--runs", "--seed", "is given for a building file", "--motion-unit, --out and --jobs"});
}

}  // namespace
}  // namespace isolaw::cli_test
