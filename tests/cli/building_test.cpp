// Tests `isolaw building` as a user meets it: the template, the example, a study with the laws of a campaign, and
// refusals.
#include <sys/file.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <thread>

#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Building : public InFreshDirectory {
 protected:
  // Calibrates three bilinear devices, tested in blocks at 50 and 100 mm, whose force has a small third harmonic.
  void campaign() {
    double stiffness = 5.0;
    for (auto const* name : {"a.csv", "b.csv", "c.csv"}) {
      std::string text = "time [s],disp [mm],force [kN]\n";
      double hysteretic = 0.0, before = 0.0;
      for (int i = 0; i <= 360; ++i) {
        double const phase = 2.0 * std::numbers::pi * i / 60.0, x = (i <= 180 ? 50.0 : 100.0) * std::sin(phase);
        hysteretic = std::clamp(hysteretic + 2.0 * (x - before), -20.0, 20.0);
        before = x;
        text += fmt::format("{:.4f},{:.5f},{:.5f}\n", i / 30.0, x,
                            stiffness * (0.4 * x + hysteretic + std::sin(3.0 * phase)));
      }
      write(name, text);
      stiffness += 0.4;
    }
    auto const calibration = isolaw({"calibrate", "a.csv", "b.csv", "c.csv", "--laws", "bilinear", "--runs", "1",
                                     "--analysis", "full", "--replicates", "40", "--figures", "none", "--out", "lot"});
    ASSERT_EQ(calibration.code, 0) << calibration;
  }
  // The bearings of the campaign do not keep the limits of the example.
  void example_without_limits() {
    ASSERT_EQ(isolaw({"example", "case", "--building"}).code, 0);
    auto text = read("case/building.toml");
    auto const from = text.find("[limits]"), to = text.find("# The slab");
    ASSERT_NE(to, std::string::npos);
    write("case/building.toml", text.erase(from, to - from));
  }
};

TEST_F(Building, from_template_to_verdict) {
  campaign();
  auto const written = isolaw({"example", "case", "--building"});
  ASSERT_EQ(written.code, 0) << written;
  EXPECT_EQ(read_file(directory() / "case/building.toml").find(isolaw({"building", "--template"}).out.substr(0, 200)),
            0u);
  auto text = read_file(directory() / "case/building.toml");
  auto const change = [&](std::string const& from, std::string const& to) {
    auto const at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  change("draws = 500", "draws = 40");
  change("base_shear_over_weight = 0.1", "base_shear_over_weight = 1.0");
  change("floor_acceleration_g = 0.25", "floor_acceleration_g = 2.5");
  change("laws = []", "laws = [\"bilinear\"]");
  write("case/building.toml", text);
  Words const command{"building", "case/building.toml", "--from", "lot", "--out", "B"};
  auto const output = isolaw(command);
  ASSERT_EQ(output.code, 0) << output;
  auto const& answer = output.out;
  EXPECT_TRUE(answer.starts_with("No answer yet: 40 draws do not tell whether the building with Bilinear keeps its "))
      << output;
  EXPECT_TRUE(contains(answer, "with Bilinear the bounds cover ")) << output;
  // A limit that is not kept ends the command with 1. The runs are those of the store.
  auto narrow = text;
  narrow.replace(narrow.find("clearance_mm = 250"), 18, "clearance_mm = 1.5");
  write("case/narrow.toml", narrow);
  auto const refused = isolaw({"building", "case/narrow.toml", "--from", "lot", "--out", "B"});
  EXPECT_EQ(refused.code, 1) << refused;
  EXPECT_TRUE(refused.out.starts_with("No: with Bilinear the building does not keep its limit on corner displacement."))
      << refused;
  EXPECT_TRUE(contains(refused.out, "NOT KEPT")) << refused;
  ASSERT_EQ(isolaw(command).code, 0);
  EXPECT_TRUE(contains(output.out, "energy error at most"));
  auto const json = this->json("B/building.json");
  EXPECT_EQ(json["laws"][0]["id"], "bilinear");
  EXPECT_EQ(json["laws"][0]["draws"], 40);
  EXPECT_GT(json["laws"][0]["peak_mm"]["p84"], json["laws"][0]["peak_mm"]["p16"]);
  EXPECT_LT(json["laws"][0]["energy_error"], 2e-3);
  for (auto const* key : {"inside", "lower", "upper"}) EXPECT_TRUE(json["laws"][0]["coverage"].contains(key));
  EXPECT_EQ(json["motions"].size(), 7u);
  EXPECT_EQ(output.out.find(json["verdict"].get<std::string>()), 0u);
  EXPECT_EQ(json["plan"]["bearings"].size(), 28u);
  EXPECT_EQ(json["laws"][0]["histories"].size(), 7u);
  // Quantities that have bounds appear under `coverage`. For every other quantity, the text in `uncovered` says why
  // there are no bounds.
  for (auto const& row : json["quantities"])
    EXPECT_NE(row["uncovered"].is_null(), !json["laws"][0]["coverage"]["of"].contains(row["key"])) << row;
  EXPECT_TRUE(json["laws"][0]["coverage"]["of"].contains("roof_acceleration_g"));
  for (std::size_t at = output.out.find("\nisolator_mm") + 1, rows = 0; rows < 14; ++rows) {
    auto const line = output.out.substr(at, output.out.find('\n', at) - at);
    std::istringstream cells(line);
    EXPECT_EQ(std::distance(std::istream_iterator<std::string>(cells), {}), 10) << line;
    at += line.size() + 1;
  }
  auto const page = read_file(directory() / "B/building.html");
  EXPECT_TRUE(contains(page, json["verdict"].get<std::string>()));
  for (auto const* file : {"tables/building.csv", "tables/coverage.csv", "tables/checks.csv", "tables/building.tex",
                           "figures/building_histograms.gp", "figures/building_variance.dat"})
    EXPECT_GT(read_file(directory() / "B" / file).size(), 100u) << file;
  // The same command, given again, must leave the files as they are. The same study in another directory and without
  // figures must give the same results.
  auto const before = read_file(directory() / "B/building.json");
  EXPECT_EQ(isolaw(command + Words{"--jobs", "3"}).code, 0);
  EXPECT_EQ(isolaw(Words{"building", "case/building.toml", "--from", "lot", "--out", "F", "--figures", "none"}).code,
            0);
  EXPECT_FALSE(std::filesystem::exists(directory() / "F/figures"));
  EXPECT_TRUE(read_file(directory() / "F/building.json") == before);
  expect_refused(isolaw(command + Words{"--figures", "some"}), {"some", "none"});
  EXPECT_EQ(read_file(directory() / "B/building.json"), before);
  EXPECT_EQ(read_file(directory() / "B/building.html"), page);
  change("seed = 1", "seed = 2");
  write("case/building.toml", text);
  expect_refused(isolaw(command), {"building.sqlite", "another building", "--fresh"});
  EXPECT_EQ(isolaw(command + Words{"--fresh"}).code, 0);
  expect_refused(isolaw(command + Words{"--fresh", "--arrange"}), {"--arrange", "3 tested devices for 28 bearings"});
  auto const nominal = isolaw(Words{"building", "case/building.toml", "--from", "lot", "--out", "N", "--nominal"});
  EXPECT_EQ(nominal.code, 0) << nominal;
  EXPECT_EQ(nominal.out.find("law,motion,outcome,isolator_mm"), 0u) << nominal;
  EXPECT_TRUE(contains(nominal.out, "bilinear,motion-7-x,completed,")) << nominal;
  EXPECT_TRUE(contains(nominal.err, "warning: From the calibration: ")) << nominal;
  EXPECT_TRUE(contains(read_file(directory() / "N/histories/bilinear-7.csv"), "acceleration_5_y [mm/s2]"));
  EXPECT_FALSE(std::filesystem::exists(directory() / "N/building.sqlite"));
  // The building file names a device that the campaign does not have, so no output may be written.
  write("case/none.toml", text + "\n[[bearing]]\nx_m = 0.0\ny_m = 0.0\nis = \"nobody\"\n");
  expect_refused(isolaw({"building", "case/none.toml", "--from", "lot", "--out", "Z", "--nominal"}),
                 {"no device 'nobody'"});
  EXPECT_FALSE(std::filesystem::exists(directory() / "Z"));
  // --arrange places the tested devices, so the plan must have three places for the three devices.
  change("along = 7", "along = 3");
  change("across = 4", "across = 1");
  write("case/building.toml", text);
  auto const arranged = isolaw(command + Words{"--fresh", "--arrange"});
  EXPECT_LE(arranged.code, 1) << arranged;  // three bearings do not keep the limits of 28
  EXPECT_TRUE(contains(arranged.out, "eccentricity of stiffness"));
}

// A study whose parts are computed one by one and then merged must equal, byte by byte, a study computed on one
// machine.
class BuildingParts : public Building {
 protected:
  static constexpr int parts = 5;
  void SetUp() override {
    Building::SetUp();
    campaign();
    example_without_limits();
    set("draws = 500", "draws = 40");
    set("laws = []", "laws = [\"bilinear\"]");
  }
  void set(std::string const& from, std::string const& to) const {
    auto text = read("case/building.toml");
    auto const at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write("case/building.toml", text.replace(at, from.size(), to));
  }
  static Words study(std::string const& out, Words const& more = {}) {
    return Words{"building", "case/building.toml", "--from", "lot", "--out", out} + more;
  }
  static Words part(int number, Words const& more = {}) {
    return study(fmt::format("P{}", number), Words{"--part", fmt::format("{}/{}", number, parts)} + more);
  }
  void compute(std::vector<int> const& numbers) {
    for (int const number : numbers)
      expect_message(isolaw(part(number)), 0, {fmt::format("part {} of 5: ", number), "isolaw merge OUT PARTS..."});
  }
  void change(fs::path const& store, std::string const& sql) const {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path(store).c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
    sqlite3_close(db);
  }
  static std::string json_text(std::string const& json, std::string const& key) {
    return Json::parse(json)[key].get<std::string>();
  }
  void expect_as_one_machine() {
    if (!exists("W")) {
      ASSERT_EQ(isolaw(study("W", {"--jobs", "3"})).code, 0);
    }
    for (auto const* name : {"building.json", "building.sqlite"})
      EXPECT_TRUE(read(fs::path("O") / name) == read(fs::path("W") / name)) << name << " differs";
  }
};

TEST_F(BuildingParts, in_any_order_one_twice_and_one_continued_are_what_one_machine_computes) {
  compute({4, 2, 5, 1, 3});
  std::vector<int> sizes;
  for (int number = 1; number <= parts; ++number)
    sizes.push_back(stored_rows(path(fmt::format("P{}/building.sqlite", number)), "runs"));
  // Each of seven motions needs 84 analyses. They are dealt to the parts in turn, in blocks of 16 and a last one of 4.
  // So the parts may differ in size, but by no more than two blocks.
  EXPECT_EQ(sizes[0] + sizes[1] + sizes[2] + sizes[3] + sizes[4], 7 * 84);
  EXPECT_LE(std::ranges::max(sizes) - std::ranges::min(sizes), 16 + 16);
  // The test deletes rows, as if part 3 had been stopped. The command of part 3, given again with another number of
  // threads, computes these rows again.
  auto const whole = read("P3/building.sqlite");
  change("P3/building.sqlite", "DELETE FROM runs WHERE place BETWEEN 3 AND 40");
  ASSERT_EQ(isolaw(part(3, {"--jobs", "2"})).code, 0);
  EXPECT_EQ(stored_rows(path("P3/building.sqlite"), "runs"), sizes[2]);
  EXPECT_TRUE(read("P3/building.sqlite") == whole);
  ASSERT_EQ(isolaw(study("again", {"--part", "2/5", "--jobs", "2"})).code, 0);
  EXPECT_EQ(query(path("again/building.sqlite"), "SELECT * FROM runs"),
            query(path("P2/building.sqlite"), "SELECT * FROM runs"));
  auto const o = isolaw({"merge", "O", "P5", "P3", "again", "P1", "P2/building.sqlite", "P4"});
  expect_message(o, 0, {"588 runs copied, ", " there already to O/building.sqlite"});
  expect_as_one_machine();
  EXPECT_EQ(o.out, isolaw(study("W")).out);
}

TEST_F(BuildingParts, that_are_missing_are_named_and_added_later) {
  compute({1, 2, 4, 5});
  auto const o = isolaw({"merge", "O", "P1", "P2", "P3", "P4", "P5"});
  expect_message(o, 1, {"P3/building.sqlite: not there", "not complete: ", "of part 3/5 (", "isolaw merge O PARTS..."});
  EXPECT_FALSE(exists("O/building.json"));
  EXPECT_EQ(o.out.find("part,law,motion,analysis\n3,bilinear,motion-1-x,factor "), 0u) << o;
  compute({3});
  EXPECT_EQ(count_of("\n", o.out), 1u + static_cast<unsigned>(stored_rows(path("P3/building.sqlite"), "runs")));
  expect_message(isolaw({"merge", "O", "P3", "--copy-only"}), 0, {" copied"});
  EXPECT_FALSE(exists("O/building.json"));
  expect_message(isolaw({"merge", "O"}), 0, {"0 runs copied", "isolaw building BUILDING.toml --from CAMPAIGN --out O"});
  ASSERT_EQ(isolaw(study("O")).code, 0);
  expect_as_one_machine();
}

TEST_F(BuildingParts, of_another_study_build_or_instruction_set_are_refused_and_nothing_is_changed) {
  compute({1, 2});
  auto const refused = [&](std::string const& what) {
    ASSERT_EQ(isolaw(study("X", {"--part", "2/5", "--fresh"})).code, 0);
    expect_refused(isolaw({"merge", "O", "P1", "X"}),
                   {"X/building.sqlite: of another study than P1/building.sqlite: ", what, "parts of one study"});
    EXPECT_FALSE(exists("O/building.sqlite"));
  };
  set("seed = 1", "seed = 2");
  refused("seed: 1 in P1/building.sqlite, 2 in X/building.sqlite");
  set("seed = 2", "seed = 1");
  auto const motion = read("case/motion-3-x.csv");
  auto const line = motion.find("\n1.00,") + 1;
  write("case/motion-3-x.csv", motion.substr(0, line) + "1.00,0.123456" + motion.substr(motion.find('\n', line)));
  refused("other values of motion motion-3-x");
  write("case/motion-3-x.csv", motion);
  ASSERT_EQ(isolaw({"calibrate", "a.csv", "b.csv", "--laws", "bilinear", "--runs", "1", "--analysis", "full",
                    "--replicates", "0", "--figures", "none", "--out", "lot", "--fresh"})
                .code,
            0);
  refused("another lot of bilinear");
  fs::copy(path("P2"), path("B"));
  change("B/building.sqlite", "UPDATE maker SET build = '0123456789ab'");
  expect_refused(isolaw({"merge", "O", "P1", "B"}),
                 {"B/building.sqlite: computed by isolaw ", "build 0123456789ab; this is ", "merge of one build"});
  fs::copy(path("P2"), path("I"));
  change("I/building.sqlite", "UPDATE maker SET instruction_set = 'abacus'");
  expect_refused(isolaw({"merge", "O", "P1", "I"}),
                 {"I/building.sqlite: computed with instruction set abacus", "ISOLAW_SIMD=abacus"});
  EXPECT_FALSE(exists("O/building.sqlite"));
}

TEST_F(BuildingParts, that_were_cut_off_or_changed_are_found_out) {
  compute({1, 2});
  auto const bytes = read("P2/building.sqlite");
  for (auto const size :
       {bytes.size() / 2, bytes.size() - 4096, bytes.size() - 1, std::size_t{4096}, std::size_t{50}, std::size_t{0}}) {
    write("T/building.sqlite", std::string_view(bytes).substr(0, size));
    auto const o = isolaw({"merge", "O", "P1", "T"});
    expect_refused(o, {"T/building.sqlite", size > 0 ? "damaged" : "an empty file"});
    EXPECT_FALSE(exists("O/building.sqlite")) << size;
  }
  write("T/building.sqlite", bytes);
  ASSERT_EQ(isolaw({"merge", "O", "T"}).code, 1);
  change("T/building.sqlite", "UPDATE runs SET measured = zeroblob(length(measured))");
  expect_refused(isolaw({"merge", "O", "P1", "T"}),
                 {"T/building.sqlite: run ", "has other numbers than when it was computed"});
  auto const checked = isolaw({"check", "T"});
  EXPECT_EQ(checked.code, 1) << checked;
  EXPECT_TRUE(contains(checked.out, "has other numbers than when it was computed")) << checked;
  EXPECT_EQ(isolaw({"check", "P1"}).code, 0);
  change("T/building.sqlite", "UPDATE runs SET place = place + 1000");
  expect_refused(isolaw({"merge", "O", "T"}), {"T/building.sqlite: run ", "does not belong to this study"});
  change("T/building.sqlite", "UPDATE runs SET place = place - 1000, measured = x'0000000000000000'");
  expect_refused(isolaw({"merge", "O", "T"}), {"T/building.sqlite: run ", "does not belong to this study"});
}

TEST_F(BuildingParts, are_named_as_they_may_be_and_know_what_they_are) {
  compute({1});
  expect_refused(isolaw(study("P1")), {"P1/building.sqlite", "part 1/5 there, all of it now"});
  expect_refused(isolaw(study("P1", {"--part", "2/5"})), {"part 1/5 there, part 2/5 now"});
  expect_refused(isolaw(study("X", {"--part", "6/5"})), {"--part", "K/N, part K of N"});
  expect_refused_as_object(isolaw(part(1, {"--json"})), {"--json: a part has no answers"});
  ASSERT_EQ(isolaw(study("Y", {"--part", "2/3"})).code, 0);
  expect_refused(isolaw({"merge", "O", "P1", "Y"}), {"Y/building.sqlite: is part 2/3", "parts of one deal"});
  expect_refused(isolaw({"merge", "P1", "Y"}), {"P1/building.sqlite: is part 1/5 itself"});
  expect_refused(isolaw({"merge", "P1", "P1"}), {"P1: is the directory that is merged into"});
  int const directory = ::open(path("P1").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(directory, LOCK_EX | LOCK_NB), 0);
  expect_refused(isolaw(part(1)), {"P1: another isolaw works in this directory"});
  close(directory);
}

// merge --fresh must replace the store in O only after it has checked and copied everything that takes its place.
TEST_F(BuildingParts, that_start_over_replace_no_part_and_nothing_whole_by_less) {
  compute({1, 2, 3, 4, 5});
  ASSERT_EQ(isolaw({"merge", "O", "P1", "P2", "P3", "P4", "P5"}).code, 0);
  auto const whole = read("O/building.sqlite"), part = read("P1/building.sqlite"), json = read("O/building.json");
  auto const refused = [&](Words const& words, Words const& said) {
    expect_message(isolaw(words + Words{"--fresh"}), 2, said);
    EXPECT_TRUE(read("O/building.sqlite") == whole);
    EXPECT_TRUE(read("O/building.json") == json);
    EXPECT_TRUE(read("P1/building.sqlite") == part);
  };
  refused({"merge", "P1", "P2"}, {"P1/building.sqlite: is part 1/5 itself", "another directory"});
  refused({"merge", "O", "P1", "p2"}, {"p2/building.sqlite: is not there, and O/building.sqlite was to be replaced"});
  refused({"merge", "O", "P1", "P2"}, {"O/building.sqlite: has every run, and is left as it is"});
  fs::copy(path("P2"), path("X"));
  change("X/building.sqlite", "UPDATE runs SET measured = zeroblob(length(measured))");
  refused({"merge", "O", "P1", "P2", "P3", "P4", "P5", "X"}, {"X/building.sqlite: run ", "--part K/N --fresh"});
  // The study is complete and answered, so merge without parts repeats the answer.
  auto const answered = isolaw({"merge", "O"});
  expect_message(answered, 0, {"0 runs copied", "were answered: O/building.html"});
  EXPECT_EQ(answered.out, json_text(json, "verdict") + "\n");
  EXPECT_TRUE(isolaw({"merge", "O", "--json"}).out == json + "\n");
  // A killed program may leave an empty store. A merge must refuse the empty store, and merge --fresh must replace it
  // and remove the results of the former study.
  write("O/building.sqlite", "");
  write("O/building.sqlite.part", "left");
  expect_refused(isolaw({"merge", "O", "P1"}), {"O/building.sqlite", "an empty file", "--fresh"});
  expect_message(isolaw({"merge", "O", "P1", "--fresh"}), 1, {"runs copied"});
  EXPECT_FALSE(exists("O/building.sqlite.part"));
  EXPECT_FALSE(exists("O/building.json") || exists("O/building.html") || exists("O/tables/building.csv"));
  expect_message(isolaw({"merge", "O", "P1", "P2", "P3", "P4", "P5"}), 0, {" there already"});
  EXPECT_TRUE(read("O/building.sqlite") == whole);
  EXPECT_TRUE(read("O/building.json") == json);
}

TEST_F(BuildingParts, that_were_cut_off_are_not_taken_for_whole_by_their_own_command) {
  compute({1});
  auto const bytes = read("P1/building.sqlite");
  for (auto const size : {bytes.size() / 2, bytes.size() - 100, std::size_t{0}}) {
    write("P1/building.sqlite", std::string_view(bytes).substr(0, size));
    expect_refused(isolaw(part(1)), {"P1/building.sqlite", size > 0 ? "damaged" : "an empty file", "--fresh"});
  }
  ASSERT_EQ(isolaw(part(1, {"--fresh"})).code, 0);
  EXPECT_TRUE(read("P1/building.sqlite") == bytes);
}

TEST_F(BuildingParts, of_a_script_end_as_one_machine_also_after_a_loss) {
  if (std::system("command -v make >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no make here (isolaw.sh installs it): the script cannot be run";
  auto const printed = isolaw({"parts", "case/building.toml", "3", "--to", "make", "--campaign", "lot", "--out", "O"});
  ASSERT_EQ(printed.code, 0) << printed;
  write("script", printed.out);
  auto const run = [&] {
    return Process({"make", "-f", "script", "-k"}, directory(), path("out"), path("err")).wait();
  };
  EXPECT_TRUE(contains(run().err, "588 runs copied"));
  expect_as_one_machine();
  fs::remove_all(path("O"));
  fs::remove_all(path("O.parts/2"));
  EXPECT_TRUE(contains(run().err, "588 runs copied"));
  expect_as_one_machine();
  auto const slurm = isolaw({"parts", "case/building.toml", "3", "--to", "slurm", "--campaign", "lot"});
  for (auto const* part : {"building --part \"$1/$count\"", "$kept/building.sqlite", "--time=10 ", "--array="})
    EXPECT_TRUE(contains(slurm.out, part));
}

// A building study repeats the warnings that the calibration gave about its law.
TEST_F(Building, carries_the_doubts_of_the_calibration) {
  campaign();
  // The search box excludes the device's yield displacement, so the search ends at a bound and the output names it.
  ASSERT_EQ(isolaw({"calibrate", "a.csv", "b.csv", "c.csv", "--laws", "bilinear", "--analysis", "full", "--runs", "1",
                    "--replicates", "40", "--set", "bilinear.xy=14:30", "--figures", "none", "--out", "doubtful"})
                .code,
            0);
  example_without_limits();
  auto text = read_file(directory() / "case/building.toml");
  text.replace(text.find("draws = 500"), 11, "draws = 10");
  text.replace(text.find("laws = []"), 9, "laws = [\"bilinear\"]");
  text.replace(text.find("[[motion]]", text.find("[[motion]]") + 5), std::string::npos, "");
  write("case/building.toml", text);
  auto const output =
      isolaw({"building", "case/building.toml", "--from", "doubtful", "--out", "B", "--figures", "none"});
  ASSERT_EQ(output.code, 0) << output;
  EXPECT_TRUE(contains(output.out, "warning: From the calibration: Bilinear: ")) << output;
  EXPECT_TRUE(contains(output.out, "xy at its lower bound")) << output;
  EXPECT_TRUE(contains(output.out, "warning: 1 motion: codes accept the mean over 7 motions or more")) << output;
  auto const json = this->json("B/building.json");
  EXPECT_TRUE(contains(json["laws"][0]["doubts"].dump(), "xy at its lower bound"));
  EXPECT_TRUE(contains(json["warnings"].dump(), "xy at its lower bound"));
  EXPECT_TRUE(contains(read_file(directory() / "B/building.html"), "xy at its lower bound"));
}

// Ctrl-C stops a study as it stops a campaign: the store keeps what is finished, the exit code is 1, the message has
// the command that continues, and there are no results.
TEST_F(BuildingParts, that_are_interrupted_end_as_a_campaign_does) {
  set("draws = 40", "draws = 20000");
  auto const command = study("I", {"--figures", "none"});
  Process process(Words{ISOLAW_BINARY} + command, directory(), path("out"), path("err"));
  for (int i = 0; i < 6000 && !(exists("I/building.sqlite") && stored_rows(path("I/building.sqlite"), "runs") > 0); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  process.send(SIGINT);
  expect_message(process.wait(), 1,
                 {"interrupted: ", " finished runs are kept in I/building.sqlite",
                  "to continue: ", "building case/building.toml --from lot --out I"});
  EXPECT_FALSE(exists("I/building.json"));
  EXPECT_GT(stored_rows(path("I/building.sqlite"), "runs"), 0);
}

// A building replaces a law that has no two-dimensional form by springs in several directions around a circle. Each
// spring follows the law in its own direction. If the campaign fitted such springs, the building uses their parameters.
// Otherwise the springs take the parameters of the law itself, and the output says so.
TEST_F(Building, takes_the_springs_that_the_campaign_fitted) {
  campaign();
  Words const fit{"calibrate",  "a.csv", "b.csv",  "c.csv", "--laws",       "bilinear,power-masing",
                  "--analysis", "full",  "--runs", "1",     "--replicates", "0",
                  "--figures",  "none",  "--out"};
  ASSERT_EQ(isolaw(fit + Words{"G"}).code, 0);
  ASSERT_EQ(isolaw(fit + Words{"W", "--bidirectional", "springs"}).code, 0);
  example_without_limits();
  auto text = read_file(directory() / "case/building.toml");
  text.replace(text.find("draws = 500"), 11, "draws = 2");
  text.replace(text.find("laws = []"), 9, "laws = [\"power-masing\"]");
  text.replace(text.find("along = 7"), 9, "along = 2");
  text.replace(text.find("across = 4"), 10, "across = 1");
  text.replace(text.find("step_s = 0.005"), 14, "step_s = 0.02");
  for (auto const* key : {"mass_Mg = 700.0", "mass_Mg = 700.0"}) text.replace(text.find(key), 15, "mass_Mg = 30.0");
  text.replace(text.find("[[motion]]", text.find("[[motion]]") + 5), std::string::npos, "");
  write("case/building.toml", text);
  auto const under = [&](std::string const& from) {
    auto const output =
        isolaw({"building", "case/building.toml", "--from", from, "--out", "B" + from, "--figures", "none"});
    EXPECT_EQ(output.code, 0) << output;
    return std::pair(output.out, json("B" + from + "/building.json"));
  };
  auto const [given, of_given] = under("G");
  auto const [fitted, of_fitted] = under("W");
  EXPECT_EQ(of_given["laws"][0]["form"], "springs as given");
  EXPECT_EQ(of_fitted["laws"][0]["form"], "springs");
  EXPECT_TRUE(contains(given, "isolaw calibrate --bidirectional springs fits them")) << given;
  EXPECT_FALSE(contains(fitted, "--bidirectional")) << fitted;
  EXPECT_TRUE(contains(of_fitted["assumed"].dump(), "with parameters fitted as such"));
  EXPECT_NE(of_given["laws"][0]["quantities"]["isolator_mm"]["nominal"],
            of_fitted["laws"][0]["quantities"]["isolator_mm"]["nominal"]);
  // bilinear has a two-dimensional form, so the campaign fitted springs only for power-masing. The fitted springs must
  // fit no worse than springs with the law's own parameters.
  auto const summary = json("W/summary.json");
  EXPECT_EQ(summary["settings"]["bidirectional"], "springs");
  for (auto const& law : summary["laws"])
    for (auto const& device : law["devices"]) {
      EXPECT_EQ(device["springs_objective"].is_null(), law["id"] == "bilinear") << device["name"];
      if (law["id"] == "bilinear") continue;
      EXPECT_LE(device["springs_objective"], device["springs_given_objective"]);
    }
  EXPECT_TRUE(json("G/summary.json")["laws"][1]["devices"][0]["springs_objective"].is_null());
  EXPECT_EQ(isolaw({"check", "W"}).code, 0);
  // simulate must use the fitted springs too, both for a device and for the law of the lot.
  write("m.csv", "time [s],east [mm],north [mm]\n0,0,0\n0.5,20,5\n1,-20,10\n1.5,0,0\n");
  for (auto const* device : {"a", "lot"}) {
    Words const words{"simulate",      "power-masing", "--from",          "W",         "--device",
                      device,          "--motion",     "m.csv",           "--columns", "disp=east",
                      "--second-disp", "north",        "--bidirectional", "springs"};
    auto const o = isolaw(words);
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_TRUE(contains(o.err, "as the campaign stored them")) << o;
    EXPECT_NE(o.out, isolaw(words + Words{"--springs", "given"}).out);
  }
  // Campaign G was computed without springs. The same command with --bidirectional springs adds them with their
  // analyses. The store then equals that of W, which had springs from the start.
  expect_message(isolaw(fit + Words{"G", "--bidirectional", "springs"}), 0, {"grows by laws fitted as springs"});
  EXPECT_TRUE(read_file(directory() / "G/campaign.sqlite") == read_file(directory() / "W/campaign.sqlite"));
}

TEST_F(Building, refuses) {
  expect_refused(isolaw({"building"}), {"isolaw building", "BUILDING.toml --from CAMPAIGN", "--template"});
  write("b.toml", "[building]\ndraws = 0\n");
  expect_refused(isolaw({"building", "b.toml", "--from", "nowhere"}), {"b.toml:2", "draws", "[base]", "no motions"});
}

// The building file states a scale beside each of its motions. A motion that the user gives by --motion is used without
// any scale, and the command must say so.
TEST_F(Building, says_that_motions_of_the_command_line_are_not_scaled) {
  campaign();
  example_without_limits();
  auto text = read_file(directory() / "case/building.toml");
  text.replace(text.find("laws = []"), 9, "laws = [\"bilinear\"]");
  write("case/building.toml", text);
  Words const nominal{"building", "case/building.toml", "--from", "lot", "--out", "B", "--nominal"};
  auto const own = isolaw(nominal), given = isolaw(nominal + Words{"--motion", "case/motion-1-x.csv"});
  ASSERT_EQ(own.code, 0) << own;
  ASSERT_EQ(given.code, 0) << given;
  EXPECT_FALSE(contains(own.err, "--motion")) << own;
  EXPECT_TRUE(contains(
      given.err,
      "1 motion of --motion is used as given, with scale 1, in place of 7 motions of case/building.toml, which had scale 0.5"))
      << given;
}

// If standard error is not a terminal, a study prints a line of progress only every 30 s. This study ends before the
// first such line, so none may appear.
TEST_F(Building, prints_no_progress_for_a_short_study) {
  campaign();
  example_without_limits();
  auto text = read_file(directory() / "case/building.toml");
  text.replace(text.find("draws = 500"), 11, "draws = 4");
  text.replace(text.find("laws = []"), 9, "laws = [\"bilinear\"]");
  write("case/building.toml", text);
  auto const o = isolaw({"building", "case/building.toml", "--from", "lot", "--out", "B", "--figures", "none"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_FALSE(contains(o.err, "% done")) << o;
}

}  // namespace
}  // namespace isolaw::cli_test
