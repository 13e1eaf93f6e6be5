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
  // Calibrates three bilinear devices. Each was tested in blocks at 50 and 100 mm, and its force has a small third
  // harmonic.
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
  // Writes the example of a building without its limits, which the bearings of the campaign would not keep.
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
  // If the building does not keep a limit, the exit code is 1. This second command computes no runs but takes those
  // that the first command stored.
  auto narrow = text;
  narrow.replace(narrow.find("clearance_mm = 250.0"), 20, "clearance_mm = 1.5");
  write("case/narrow.toml", narrow);
  auto const refused = isolaw({"building", "case/narrow.toml", "--from", "lot", "--out", "B"});
  EXPECT_EQ(refused.code, 1) << refused;
  EXPECT_TRUE(refused.out.starts_with("No: with Bilinear the building does not keep its limit on corner displacement."))
      << refused;
  EXPECT_TRUE(contains(refused.out, "NOT KEPT: nominal")) << refused;
  Words const alone{"building", "case/narrow.toml", "--from", "lot", "--out", "A", "--nominal"};
  auto const refused_alone = isolaw(alone);
  EXPECT_EQ(refused_alone.code, 1) << refused_alone;
  EXPECT_TRUE(
      contains(refused_alone.err,
               "No: with Bilinear the building does not keep its limit on corner displacement; this is the "
               "nominal building alone, and neither the bound analyses nor the scatter of the lot were looked at."))
      << refused_alone;
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
  EXPECT_LE(arranged.code, 1) << arranged;  // three bearings need not keep limits that were set for 28
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
      expect_message(isolaw(part(number)), 0,
                     {fmt::format("part {} of 5 is finished: ", number), "isolaw merge OUT PARTS..."});
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
  // Each of seven motions needs 84 analyses, which are divided into five blocks of 16 and one of 4. The parts take the
  // blocks in turn, so the sizes of the parts may differ, but by no more than two blocks.
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
  expect_message(answered, 0, {"0 runs copied", "all runs and answers are there: O/building.html"});
  EXPECT_EQ(answered.out, json_text(json, "verdict") + "\n");
  EXPECT_TRUE(isolaw({"merge", "O", "--json"}).out == json + "\n");
  // A command that was killed may leave an empty store. A merge must refuse it, and merge --fresh must replace it
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
  write("b.toml", "[building]\ndraws = -1\n");
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
  EXPECT_TRUE(contains(given.err, "Beyond that the law is extrapolated")) << given;
  EXPECT_TRUE(contains(
      given.err,
      "1 motion of --motion is used as given, with scale 1, in place of 7 motions of case/building.toml, which had scale 0.5"))
      << given;
}

// If no bearing is drawn, there are no draws to show, and none are computed.
TEST_F(Building, without_draws_shows_none) {
  campaign();
  example_without_limits();
  auto text = read_file(directory() / "case/building.toml");
  text.replace(text.find("laws = []"), 9, "laws = [\"bilinear\"]");
  text.replace(text.find("is = \"draw\""), 11, "is = \"lot\"");
  write("case/building.toml", text);
  auto const o = isolaw({"building", "case/building.toml", "--from", "lot", "--out", "B", "--figures", "none"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "No bearing is drawn from the lot")) << o;
  for (auto const* draws : {"95 %", "kept by", "fractiles", "lot motion", "nan"})
    EXPECT_FALSE(contains(o.out, draws)) << o;
  EXPECT_EQ(stored_rows(path("B/building.sqlite"), "runs"), 7 * 44);
  auto const json = this->json("B/building.json");
  EXPECT_TRUE(json["draws"].is_null() && json["laws"][0]["coverage"].is_null());
  EXPECT_FALSE(contains(read("B/tables/building.tex"), "Draws"));
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

// A file of one column without a header states neither its step nor its unit. The user states them, by options or in
// the building file; a part remembers the options for the merge.
TEST_F(Building, takes_step_and_unit_of_a_motion_as_stated) {
  campaign();
  example_without_limits();
  auto text = read("case/building.toml");
  text.replace(text.find("draws = 500"), 11, "draws = 2");
  text.replace(text.find("laws = []"), 9, "laws = [\"bilinear\"]");
  text.erase(text.find("[[motion]]", text.find("[[motion]]") + 5));
  write("case/building.toml", text);
  std::string column;
  std::istringstream rows(read("case/motion-1-x.csv"));
  for (std::string row; std::getline(rows, row);)
    if (auto const comma = row.find(','); std::isdigit(row.front()) != 0) column += row.substr(comma + 1) + "\n";
  write("one.txt", column);
  Words const study{"building", "case/building.toml", "--from", "lot", "--figures", "none"};
  Words const stated{"--motion", "one.txt", "--motion-dt", "0.01", "--motion-unit", "m/s2"};
  expect_refused(isolaw(study + Words{"--motion", "one.txt"}),
                 {"one.txt: no column with a unit", "try: --motion-dt SECONDS and --motion-unit UNIT"});
  expect_refused(isolaw(study + Words{"--motion-dt", "0.01"}), {"--motion-dt: is given alone"});
  expect_refused(isolaw(study + Words{"--motion", "one.txt", "--motion-dt", "0.01", "--motion-unit", "mm"}),
                 {"--motion-unit: 'mm'", "m/s2"});
  auto const whole = isolaw(study + stated + Words{"--out", "W"});
  ASSERT_EQ(whole.code, 0) << whole;
  ASSERT_EQ(isolaw(study + Words{"--motion", "case/motion-1-x.csv", "--out", "T"}).code, 0);
  EXPECT_EQ(json("W/building.json")["laws"][0]["peak_mm"], json("T/building.json")["laws"][0]["peak_mm"]);
  for (auto const* part : {"1/2", "2/2"})
    ASSERT_EQ(isolaw(study + stated + Words{"--part", part, "--out", std::string("P") + part[0]}).code, 0);
  ASSERT_EQ(isolaw({"merge", "O", "P1", "P2", "--figures", "none"}).code, 0);
  EXPECT_TRUE(read("O/building.json") == read("W/building.json"));
  auto const script = isolaw(Words{"parts", "case/building.toml", "2", "--to", "make", "--campaign", "lot"} + stated);
  EXPECT_TRUE(contains(script.out, "--motion-dt") && contains(script.out, "--motion-unit")) << script;
  text.replace(text.find("x = \"motion-1-x.csv\""), 20, "x = \"../one.txt\"");
  text.erase(text.find("y = \"motion-1-y.csv\""), 20);
  text.replace(text.find("scale = 0.5"), 11, "scale = 1.0");
  write("case/building.toml", text);
  expect_refused(isolaw(study + Words{"--out", "F"}), {"one.txt: ", "try: step_s and unit in its [[motion]]"});
  write("case/building.toml", text + "\nstep_s = 0.01\nunit = \"m/s2\"\n");
  ASSERT_EQ(isolaw(study + Words{"--out", "F"}).code, 0);
  EXPECT_EQ(json("F/building.json")["laws"][0]["peak_mm"], json("T/building.json")["laws"][0]["peak_mm"]);
}

// These tests use wrong building files and wrong motions. isolaw must refuse each with one complaint, which names the
// place and the fault, or compute the study and report a finding.
class WrongBuilding : public Building {
 protected:
  static constexpr char const* grid = "[grid]\nalong = 2\nacross = 1\nspacing_x_m = 6.0\nspacing_y_m = 6.0\n";
  static std::string text() {
    return std::string("[building]\ndraws = 2\nlower = 0.9\nupper = 1.1\nstep_s = 0.02\nrest_s = 0.0\n") +
           "laws = [\"bilinear\"]\n[base]\nmass_Mg = 400.0\ngyration_m = 5.0\n" + grid +
           "[plan]\nleft_m = -4.0\nright_m = 4.0\nfront_m = -3.0\nback_m = 3.0\n[[motion]]\nx = \"m.csv\"\n";
  }
  static std::string motion(int samples = 200, double step_s = 0.01, double peak = 2.0,
                            std::string const& names = "time [s],acceleration [m/s2]") {
    auto rows = names + "\n";
    for (int i = 0; i < samples; ++i)
      rows += fmt::format("{:.4f},{:.5g}\n", i * step_s,
                          peak * std::sin(0.1 * i) * std::sin(std::numbers::pi * (i + 1) / samples));
    return rows;
  }
  static std::string peer(std::string const& last) {
    return "PEER\nA\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 12, DT= .005 SEC\n .1 .2 .3 .1 .2 .3 .1 .2 .3 .1 .2" +
           last + "\n";
  }
};

TEST_F(WrongBuilding, files_are_refused_each_by_one_complaint) {
  campaign();
  fs::create_directory(path("empty"));
  ASSERT_EQ(
      isolaw({"calibrate", "a.csv", "--laws", "bilinear", "--runs", "1", "--analysis", "none", "--out", "bare"}).code,
      0);
  struct Row {
    char const* name;
    std::pair<std::string, std::string> change;  // in the building file the second text replaces the first
    std::string where, found;
    std::string motion = {};  // content of m.csv if it differs from the usual one
    Words words = {};         // further words of the command
  };
  auto const with = [](std::string const& line, std::string const& more) {
    return std::pair(line, line + "\n" + more);
  };
  std::string const x = "x = \"m.csv\"", mass = "mass_Mg = 400.0", draws = "draws = 2", laws = "[\"bilinear\"]",
                    floors = "[floors]\ncount = 2\nmass_Mg = 1\ngyration_m = 5\nperiod_y_s = 0.5\nperiod_x_s = ",
                    endless(100'000, 'x');
  std::pair<std::string, std::string> const none;
  Row const rows[]{
      {"mass in kg by another key", with(mass, "mass_kg = 400000"), "b.toml:10", "unknown key 'mass_kg'"},
      {"mass negative", {mass, "mass_Mg = -400.0"}, "b.toml:9", "mass_Mg: -400"},
      {"mass zero", {mass, "mass_Mg = 0"}, "b.toml:9", "mass_Mg: 0"},
      {"mass missing", {mass + "\n", ""}, "b.toml:8", "[base] has no mass_Mg"},
      {"mass with its unit", {mass, "mass_Mg = \"400 t\""}, "b.toml:9", "'400 t' is not a number"},
      {"mass nan", {mass, "mass_Mg = nan"}, "b.toml:9", "mass_Mg: nan"},
      {"mass inf", {mass, "mass_Mg = inf"}, "b.toml:9", "mass_Mg: inf"},
      {"mass in a list", {mass, "mass_Mg = [400.0]"}, "b.toml:9", "[400.0] is not a number"},
      {"mass tiny", {"gyration_m = 5.0", "gyration_m = 1e-6"}, "base", "a radius of gyration of 0.001 mm"},
      {"gyration in mm", {"gyration_m = 5.0", "gyration_m = 5000.0"}, "b.toml:16", "radius of gyration of 5000 m"},
      {"mass beside the plan", with(mass, "x_m = 500"), "b.toml:17", "centre of mass of [base] at (500, 0) m"},
      {"key misspelt", {draws, "drawz = 2"}, "b.toml:2", "unknown key 'drawz'"},
      {"key twice", with(draws, draws), "b.toml:3", "draws"},
      {"table twice", {"[grid]", "[base]"}, "b.toml:11", "base"},
      {"lower missing", {"lower = 0.9\n", ""}, "b.toml:1", "[building] has no lower"},
      {"lower above one", {"lower = 0.9", "lower = 1.2"}, "b.toml:3", "lower: 1.2"},
      {"decimal comma", {"lower = 0.9", "lower = 0,9"}, "b.toml:3", "','"},
      {"draws negative", {draws, "draws = -1"}, "b.toml:2", "draws: -1"},
      {"draws broken", {draws, "draws = 2.5"}, "b.toml:2", "2.5 is not a whole number"},
      {"draws of many populations", with(draws, "populations = 10000\ndraws_of_each = 10000"), "b.toml:1",
       "100000002 buildings"},
      {"damping in percent", with(draws, "damping = 5"), "b.toml:3", "damping: 5"},
      {"step in ms", {"step_s = 0.02", "step_s = 20"}, "b.toml:5", "step_s: 20"},
      {"rest endless", {"rest_s = 0.0", "rest_s = 1e9"}, "b.toml:6", "rest_s: 1000000000"},
      {"law unknown", {laws, "[\"bilinaer\"]"}, "b.toml:7", "no such law"},
      {"law twice", {laws, "[\"bilinear\", \"bilinear\"]"}, "b.toml:7", "'bilinear'"},
      {"law not calibrated", {laws, "[\"bouc-wen\"]"}, "lot, law bouc-wen", "not in this campaign"},
      {"law is a number", {laws, "[3]"}, "b.toml:7", "3 is not text"},
      {"no bearings", {grid, ""}, "b.toml:1", "no bearings"},
      {"no list of bearings", {"[building]", "bearing = 3\n[building]"}, "b.toml:1", "'bearing' is no list of tables"},
      {"grid of none", {"along = 2", "along = 0"}, "b.toml:12", "along: 0"},
      {"grid beyond the plan", {"along = 2", "along = 3"}, "b.toml:16", "bearing 1 at (-6, 0) m stands outside"},
      {"plan with swapped edges", {"left_m = -4.0", "left_m = 5.0"}, "b.toml:16", "edges in the wrong order"},
      {"plan in mm", {"left_m = -4.0", "left_m = -4000000"}, "b.toml:17", "left_m: -4000000"},
      {"bearing without place", {"[plan]", "[[bearing]]\nx_m = 1.0\n[plan]"}, "b.toml:16", "[[bearing]] has no y_m"},
      {"device unknown", {"spacing_y_m = 6.0", "spacing_y_m = 6.0\nis = \"D99\""}, "law bilinear", "no device 'D99'"},
      {"floors negative", {"[plan]", floors + "0.5\ncount = -2\n[plan]"}, "b.toml:22", "count"},
      {"period in ms", {"[plan]", floors + "500\n[plan]"}, "b.toml:21", "period_x_s: 500"},
      {"no base", {"[base]\nmass_Mg = 400.0\ngyration_m = 5.0\n", ""}, "b.toml:1", "no [base]"},
      {"bracket missing", {"[base]", "[base"}, "b.toml:8", "expected ']'"},
      {"quote missing", {x, "x = \"m.csv"}, "b.toml:22", "string"},
      {"no TOML", {text(), "hello"}, "b.toml:1", "Error while parsing"},
      {"JSON", {text(), "{\"building\": {}}"}, "b.toml:1", "saw '{'"},
      {"nested endlessly", {text(), "a = " + std::string(5000, '[')}, "b.toml:1", "nested deeper"},
      {"title endless", with(draws, "title = \"" + endless + "\""), "b.toml:3", "100000 bytes long"},
      {"title of control characters", with(draws, "title = \"a\\u001b[31m\""), "b.toml:3", "control characters"},
      {"file endless", with(draws, std::string(2'000'000, '#')), "b.toml", "above 1 MiB"},
      {"no motion", {"[[motion]]\n" + x + "\n", ""}, "b.toml:1", "no motions"},
      {"motion is a table", {"[[motion]]", "[motion]"}, "b.toml:21", "'motion' is no list of tables"},
      {"motion without x", {x, "y = \"m.csv\""}, "b.toml:21", "[[motion]] has no x"},
      {"motion without name", {x, "x = \"\""}, "b.toml:22", "x: ''"},
      {"motion is a number", {x, "x = 3"}, "b.toml:22", "3 is not text"},
      {"motion not there", {x, "x = \"none.csv\""}, "none.csv", "no such file"},
      {"motion is a folder", {x, "x = \"empty\""}, "empty", "is a directory"},
      {"motion is a device", {x, "x = \"/dev/zero\""}, "/dev/zero", "is a device"},
      {"scale zero", with(x, "scale = 0"), "b.toml:23", "scale: 0"},
      {"scale too large", with(x, "scale = 1e9"), "b.toml:23", "scale: 1000000000"},
      {"step is another", with(x, "step_s = 0.02"), "m.csv", "a step of 0.02 s is stated"},
      {"unit is another", with(x, "unit = \"g\""), "m.csv", "not the stated 'g'"},
      {"unit unknown", with(x, "unit = \"furlong/s2\""), "b.toml:23", "'furlong/s2'"},
      {"empty", none, "m.csv", "is empty", "\n"},
      {"header alone", none, "m.csv", "no rows of numbers", "time [s],acceleration [g]\n"},
      {"one sample", none, "m.csv", "1 sample", motion(1)},
      {"nan", none, "m.csv:202", "'nan' is no number", motion() + "2.0,nan\n"},
      {"word", none, "m.csv:202", "'off' is no number", motion() + "2.0,off\n"},
      {"gap in time", none, "m.csv", "sample 200 is at 1.99 s and sample 201 at 2.5 s", motion() + "2.5,0.1\n"},
      {"time goes back", none, "m.csv", "sample 200 is at 1.99 s and sample 201 at 1 s", motion() + "1.0,0.1\n"},
      {"time stands", none, "m.csv", "the time does not increase", motion(200, 0.0)},
      {"no motion in it", none, "m.csv", "zero throughout", motion(200, 0.01, 0.0)},
      {"no unit", none, "m.csv", "no column with a unit", motion(200, 0.01, 2.0, "time [s],acceleration")},
      {"unit of length", none, "m.csv", "no column with a unit", motion(200, 0.01, 2.0, "time [s],disp [mm]")},
      {"two accelerations", none, "m.csv", "several columns", motion(200, 0.01, 2.0, "a [g],b [g]")},
      {"value huge", none, "motion 'm'", "an acceleration of", motion(200, 0.01, 1e30)},
      {"step too long", none, "motion 'm'", "a step of 20 s", motion(200, 20.0)},
      {"PEER cut short", none, "m.csv", "11 values", peer("")},
      {"PEER with stars", none, "m.csv:5", "'****' is no number", peer(" ****")},
      {"page of a portal", none, "m.csv", "no rows of numbers", "<!DOCTYPE html>\n<html><body>log in</body></html>\n"},
      {"workbook", none, "m.csv", "binary file", std::string("PK\3\4\0\0", 6)},
      {"component of another file", {x, "x = \"m.csv#2\""}, "m.csv#2", "component"},
      {"two steps", with(x, "y = \"n.csv\""), "n.csv", "samples every 0.02 s"},
      {"campaign without analysis", none, "bare, law bilinear", "no analysis was made", {}, {"--from", "bare"}},
      {"campaign not there", none, "nowhere/campaign.sqlite", "no such file", {}, {"--from", "nowhere"}},
      {"option without a file", none, "motion", "''", {}, {"--motion", ""}},
      {"option of three files", none, "motion", "'m.csv,m.csv,m.csv'", {}, {"--motion", "m.csv,m.csv,m.csv"}}};
  write("n.csv", motion(100, 0.02));
  for (auto const& row : rows) {
    SCOPED_TRACE(row.name);
    auto changed = text();
    auto const at = changed.find(row.change.first);
    ASSERT_NE(at, std::string::npos);
    write("b.toml", changed.replace(at, row.change.first.size(), row.change.second));
    write("m.csv", row.motion == "\n" ? "" : row.motion.empty() ? motion() : row.motion);
    Words command{"building", "b.toml", "--json", "--out", "O"};
    if (row.words.empty() || row.words.front() != "--from") command = command + Words{"--from", "lot"};
    auto const o = isolaw(command + row.words);
    auto const complaints = expect_refused_as_object(o, {})["error"]["complaints"];
    ASSERT_EQ(complaints.size(), 1u) << o;
    EXPECT_EQ(complaints[0]["where"], row.where) << o;
    EXPECT_TRUE(contains(complaints[0]["found"].get<std::string>(), row.found)) << o;
    EXPECT_FALSE(complaints[0]["allowed"].get<std::string>().empty()) << o;
    EXPECT_FALSE(exists("O"));
  }
  for (auto const* file : {"none.toml", "empty", "/dev/zero"}) {
    auto const o = isolaw({"building", file, "--from", "lot", "--json"});
    EXPECT_EQ(expect_refused_as_object(o, {file})["error"]["complaints"].size(), 1u) << o;
  }
}

TEST_F(WrongBuilding, values_that_may_be_meant_are_computed_with_a_finding) {
  campaign();
  struct Row {
    std::string change, to, finding;
    std::string motion = {};
  } const rows[]{{"mass_Mg = 400.0", "mass_Mg = 400000.0", "period-implausible"},
                 {"mass_Mg = 400.0", "mass_Mg = 0.4", "period-implausible"},
                 {"", "", "ground-too-strong", motion(200, 0.01, 200.0)},
                 {"scale = 1.0", "scale = 100.0", "ground-too-strong"},
                 {"", "", "displacement-beyond-tests", motion(400, 0.02, 5.0)},
                 {"x = \"m.csv\"", "x = \"m.csv\"\ny = \"n.csv\"", "ground-padded"},
                 {"", "", "ground-off-zero", motion() + "2.0,9\n2.01,9\n2.02,9\n2.03,9\n2.04,9\n"}};
  write("n.csv", motion(150));
  for (auto const& row : rows) {
    SCOPED_TRACE(row.finding);
    auto changed = text() + "scale = 1.0\n";
    write("b.toml", changed.replace(changed.find(row.change), row.change.size(), row.to));
    write("m.csv", row.motion.empty() ? motion() : row.motion);
    auto const o =
        isolaw({"building", "b.toml", "--from", "lot", "--json", "--figures", "none", "--out", "O", "--fresh"});
    ASSERT_EQ(o.code, 0) << o;
    EXPECT_TRUE(contains(Json::parse(o.out)["findings"].dump(), "\"" + row.finding + "\"")) << o;
    auto const nominal = isolaw({"building", "b.toml", "--from", "lot", "--nominal", "--out", "N"});
    EXPECT_EQ(nominal.code, 0) << nominal;
    // The finding ground-padded is a note, all others are warnings.
    EXPECT_TRUE(contains(nominal.err, std::string(row.finding) == "ground-padded" ? "note: the motion" : "warning: "))
        << nominal;
  }
}

}  // namespace
}  // namespace isolaw::cli_test
