// Tests lot files: every key, the message about every mistake with its line, and how isolaw writes such a file.
#include "isolaw/campaign/lot_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/base/error.hpp"
#include "setting_samples.hpp"

namespace isolaw::campaign {
namespace {

using testing::expect_same;

class LotFileTest : public testing::Folder {
 protected:
  Lot read(std::string_view text, LotFileOptions const& options = {}) const {
    return read_lot_file(write("lot.toml", text), options);
  }

  // Returns the messages about a wrong lot file, one per line, without the folder's name, or "" if the file can be
  // read.
  std::string complaints(std::string_view text) const {
    try {
      read(text);
    } catch (Error const& error) {
      std::string said = error.what();
      auto const prefix = folder.string() + "/";
      for (auto at = said.find(prefix); at != std::string::npos; at = said.find(prefix)) said.erase(at, prefix.size());
      return said;
    }
    return "";
  }
  // Returns the messages about a lot file with one device and with `lines` in its table [calibrate]. The first of these
  // lines is line 3 of the file.
  std::string calibrate(std::string_view lines) const {
    return complaints(
        fmt::format("title = \"lot\"\n[calibrate]\n{}\n[[device]]\nname = \"A\"\nfile = \"a.csv\"\n", lines));
  }
  std::string device(std::string_view lines) const {  // the first of the lines is line 4
    return complaints(fmt::format("[[device]]\nname = \"A\"\nfile = \"a.csv\"\n{}\n", lines));
  }
};

void expect_parts(std::string const& said, std::vector<std::string> const& parts) {
  for (auto const& part : parts)
    EXPECT_NE(said.find(part), std::string::npos) << "'" << part << "' is missing in: " << said;
}

TEST_F(LotFileTest, SaysEverything) {
  auto const lot = read(R"(title = "Lot 7 – Prüfung"

[calibrate]
laws = ["abe", "bilinear"]
method = "ga"
integration = "paper"
runs = 5
population = 40
generations = 30
stagnation-tolerance = 1e-6
seed = 77
box = "published"
set = ["bilinear.K1=1.5", "vaiana.gamma1+=free"]
smooth = 5
samples-per-cycle = 100
center = true

[read]
units = { disp = "cm" }
dt = 0.01
sheet = 3
test = 2

[[device]]
name = "A"
file = "records/a.csv"
serial = "0001"
lot = "L7"
test-date = 2023-05-11
temperature-C = 21
rubber-thickness-mm = 208.0
rubber-area-mm2 = 282743.5
columns = { time = 1, disp = "Weg, horizontal", force = "Kraft" }
units = { force = "tonf" }
flip-force = true
sheet = "Prüfung 2"
test = "all"

[[device]]
name = "B"
files = ["b1.csv", "b2.csv"]
test-date = "May 2023"
dt = 0.002
columns = "disp=2,force=3"
)");
  EXPECT_EQ(lot.title, "Lot 7 – Prüfung");
  Settings expected;
  expected.laws = {"abe", "bilinear"};
  expected.integration = laws::Integration::paper;
  expected.runs = 5;
  expected.method = Method::genetic;
  expected.genetic.population = 40;
  expected.genetic.generations = 30;
  expected.genetic.stagnation_tolerance = 1e-6;
  expected.seed = 77;
  expected.box = fit::BoxKind::published;
  expected.overrides = {fit::parse_override("bilinear.K1=1.5"), fit::parse_override("vaiana.gamma1+=free")};
  expected.clean = {.smooth = 5, .samples_per_cycle = 100, .center = true};
  expect_same(lot.settings, expected);

  ASSERT_EQ(lot.devices.size(), 2u);
  auto const& a = lot.devices[0];
  EXPECT_EQ(a.name, "A");
  ASSERT_EQ(a.tests[0].files.size(), 1u);
  EXPECT_EQ(a.tests[0].files[0], folder / "records/a.csv");
  EXPECT_EQ(a.shown_file(), "records/a.csv");
  EXPECT_EQ(a.info.serial, "0001");
  EXPECT_EQ(a.info.lot, "L7");
  EXPECT_EQ(a.info.test_date, "2023-05-11");
  EXPECT_EQ(a.info.temperature_C, 21.0);
  EXPECT_EQ(a.info.rubber_thickness_mm, 208.0);
  EXPECT_EQ(a.info.rubber_area_mm2, 282743.5);
  using enum data::Channel;
  EXPECT_EQ(a.tests[0].read.columns,
            (std::map<data::Channel, std::string>{{time, "1"}, {disp, "Weg, horizontal"}, {force, "Kraft"}}));
  // Device A has no unit of displacement of its own, so the unit in [read] applies.
  EXPECT_EQ(a.tests[0].read.units, (std::map<data::Channel, std::string>{{disp, "cm"}, {force, "tonf"}}));
  EXPECT_EQ(a.tests[0].read.dt_s, 0.01);
  EXPECT_TRUE(a.tests[0].read.flip_force);
  EXPECT_EQ(a.tests[0].read.sheet, "Prüfung 2");
  EXPECT_EQ(a.tests[0].read.test, "all");
  auto const& b = lot.devices[1];
  EXPECT_EQ(b.tests[0].files, (std::vector<std::filesystem::path>{folder / "b1.csv", folder / "b2.csv"}));
  EXPECT_EQ(b.info.test_date, "May 2023");
  EXPECT_EQ(b.info.temperature_C, std::nullopt);
  EXPECT_EQ(b.tests[0].read.dt_s, 0.002);
  EXPECT_EQ(b.tests[0].read.columns, (std::map<data::Channel, std::string>{{disp, "2"}, {force, "3"}}));
  EXPECT_FALSE(b.tests[0].read.flip_force);
  EXPECT_EQ(b.tests[0].read.sheet, "3");
  EXPECT_EQ(b.tests[0].read.test, "2");
}

TEST_F(LotFileTest, TheShortestFileHasTheDefaults) {
  auto const lot = read("[[device]]\nfile = \"device-04.csv\"\n");
  ASSERT_EQ(lot.devices.size(), 1u);
  EXPECT_EQ(lot.devices[0].name, "device-04");
  expect_same(lot.settings, Settings{});
}

TEST_F(LotFileTest, ThinningIsANumberOrAll) {
  EXPECT_EQ(
      read("[calibrate]\nsamples-per-cycle = \"all\"\n[[device]]\nfile = \"a.csv\"\n").settings.clean.samples_per_cycle,
      std::nullopt);
  EXPECT_EQ(
      read("[calibrate]\nsamples-per-cycle = 50\n[[device]]\nfile = \"a.csv\"\n").settings.clean.samples_per_cycle, 50);
  EXPECT_EQ(read("[calibrate]\nlaws = \"all\"\n[[device]]\nfile = \"a.csv\"\n").settings.laws, parse_laws("all"));
  EXPECT_EQ(read("[calibrate]\nlaws = \"abe,vaiana\"\n[[device]]\nfile = \"a.csv\"\n").settings.laws,
            parse_laws("abe,vaiana"));
}

// --- mistakes in a lot file ---

TEST_F(LotFileTest, SyntaxErrorsHaveTheirLine) {
  expect_parts(complaints("title = \"lot\"\n[[device]]\nname = A\n"), {"lot.toml:3", "TOML"});
  expect_parts(complaints("[[device]]\nname = \"A\"\nname = \"B\"\n"), {"lot.toml:3"});
}

TEST_F(LotFileTest, AFileThatIsNotThereIsNamed) {
  try {
    read_lot_file(folder / "absent.toml");
    FAIL();
  } catch (Error const& error) {
    expect_parts(error.what(), {"absent.toml"});
  }
}

TEST_F(LotFileTest, UnknownKeysHaveTheirLineAndTheKnownOnes) {
  expect_parts(complaints("titel = \"lot\"\n[[device]]\nfile = \"a.csv\"\n"),
               {"lot.toml:1", "'titel'", "title", "calibrate", "device"});
  expect_parts(calibrate("runs = 3\npopulaton = 100"), {"lot.toml:4", "'populaton'", "[calibrate]", "population"});
  expect_parts(device("serial = \"1\"\nrubber-thickness = 208"),
               {"lot.toml:5", "'rubber-thickness'", "[[device]]", "rubber-thickness-mm"});
  expect_parts(complaints("[read]\nunit = { disp = \"cm\" }\n[[device]]\nfile = \"a.csv\"\n"),
               {"lot.toml:2", "'unit'", "[read]", "units"});
}

TEST_F(LotFileTest, WrongTypesHaveTheirLine) {
  expect_parts(calibrate("runs = \"many\""), {"lot.toml:3: runs: 'many' is not a whole number", "1 to 100000"});
  expect_parts(calibrate("runs = 2.5"), {"lot.toml:3: runs: 2.5 is not a whole number"});
  expect_parts(calibrate("runs = true"), {"lot.toml:3: runs: true is not a whole number"});
  expect_parts(calibrate("center = \"yes\""), {"lot.toml:3: center: 'yes'", "true or false"});
  expect_parts(calibrate("center = 1"), {"lot.toml:3: center: 1;", "true or false"});
  expect_parts(calibrate("box = 1"), {"lot.toml:3: box: 1;", "published, auto"});
  expect_parts(calibrate("laws = 3"), {"lot.toml:3: laws: 3 is not text"});
  expect_parts(calibrate("laws = [\"abe\",\n3]"), {"lot.toml:4: laws: 3 is not text"});
  expect_parts(calibrate("samples-per-cycle = [200]"), {"lot.toml:3: samples-per-cycle: [200]", "all"});
  expect_parts(device("temperature-C = \"cold\""), {"lot.toml:4: temperature-C: 'cold' is not a number"});
  expect_parts(device("serial = 17"), {"lot.toml:4: serial: 17 is not text"});
  expect_parts(device("columns = 3"), {"lot.toml:4: columns: 3;", "a table, or text"});
  expect_parts(device("columns = { time = true }"), {"lot.toml:4: columns: time: true is neither"});
  expect_parts(complaints("calibrate = 3\n[[device]]\nfile = \"a.csv\"\n"), {"lot.toml:1", "'calibrate'", "table"});
}

TEST_F(LotFileTest, ValuesThatAreNotAllowedHaveTheirLine) {
  expect_parts(calibrate("laws = [\"abe\",\n\"nope\"]"), {"lot.toml:4", "laws", "no such law", "hwang-wu"});
  expect_parts(calibrate("integration = \"rk4\""), {"lot.toml:3", "integration", "'rk4'", "converged, paper"});
  expect_parts(calibrate("box = \"wide\""), {"lot.toml:3", "box", "'wide'", "published, auto"});
  expect_parts(calibrate("set = [\"bilinear.K1=2:1\"]"), {"lot.toml:3", "set", "lower < upper"});
  expect_parts(calibrate("set = [\"bilinear.K9=2\"]"), {"lot.toml:3", "set", "'K9'", "K1, K2, xy"});
  expect_parts(calibrate("samples-per-cycle = \"some\""), {"lot.toml:3", "samples-per-cycle", "'some'", "all"});
  expect_parts(device("units = { disp = \"parsec\" }"), {"lot.toml:4", "units", "parsec"});
  expect_parts(device("units = { disp = \"cm,force=tonf\" }"),
               {"lot.toml:4", "units", "disp: 'cm,force=tonf' is more than one unit", "one unit for each channel",
                "\"disp=mm,force=kN\""});
  expect_parts(device("columns = { weight = 3 }"), {"lot.toml:4", "columns", "weight"});
}

TEST_F(LotFileTest, OptionsOfTheGeneticAlgorithmChooseIt) {
  auto const method = [&](std::string const& text) {
    return read("[calibrate]\n" + text + "\n[[device]]\nname = \"A\"\nfile = \"a.csv\"\n").settings.method;
  };
  EXPECT_EQ(method(""), Method::best);
  EXPECT_EQ(method("runs = 2"), Method::best);
  EXPECT_EQ(method("population = 40"), Method::genetic);
  EXPECT_EQ(method("stagnation-tolerance = 1e-4"), Method::genetic);
  EXPECT_EQ(method("method = \"ga\""), Method::genetic);
  expect_parts(calibrate("method = \"best\"\ngenerations = 30"),
               {"lot.toml:4: generations: belongs to method ga, but the method is best"});
}

// The error message must name every value that is not allowed, with its line.
TEST_F(LotFileTest, NumbersThatAreNotAllowedHaveTheirLine) {
  expect_parts(calibrate("runs = 0"), {"lot.toml:3", "runs", "0"});
  expect_parts(calibrate("seed = 1\npopulation = 7"), {"lot.toml:4", "population", "7"});
  expect_parts(calibrate("generations = 0"), {"lot.toml:3", "generations", "0"});
  expect_parts(calibrate("smooth = 4"), {"lot.toml:3", "smooth", "4"});
  expect_parts(calibrate("samples-per-cycle = 5"), {"lot.toml:3", "samples", "5"});
  expect_parts(calibrate("method = \"pso\""), {"lot.toml:3", "method", "pso"});
  expect_parts(calibrate("seed = -1"), {"lot.toml:3", "seed", "-1"});
}

TEST_F(LotFileTest, DevicesThatAreNoneHaveTheirLine) {
  expect_parts(complaints("title = \"lot\"\n"), {"lot.toml", "no devices", "[[device]]"});
  expect_parts(complaints("device = 3\n"), {"lot.toml", "[[device]]"});
  expect_parts(complaints("title = \"lot\"\n[[device]]\nname = \"A\"\n"), {"lot.toml:2", "without a file"});
  expect_parts(complaints("[[device]]\nfile = \"a.csv\"\n[[device]]\nfile = \"sub/a.csv\"\n"),
               {"lot.toml:3", "'a'", "a name of its own"});
  expect_parts(complaints("[[device]]\nfiles = []\n"), {"lot.toml:1", "without a file"});
}

// --- lot files that may do harm ---

TEST_F(LotFileTest, FilesOutsideTheFolderHaveTheirLine) {
  std::string const rest = "a file in the folder of the lot file or below it";
  std::filesystem::create_directory_symlink("/", folder / "link");
  for (std::string const file : {"../b.csv", "sub/../../b.csv", "/etc/passwd", "link/etc/passwd"})
    expect_parts(complaints("[[device]]\nname = \"A\"\nfile = \"" + file + "\"\n"),
                 {"lot.toml:3: file: '" + file + "' leads outside, to /", rest, "--allow-outside"});
  std::filesystem::create_symlink("nowhere/yet.csv", folder / "dangling.csv");
  expect_parts(complaints("[[device]]\nfile = \"dangling.csv\"\n"), {"leads outside, to nowhere/yet.csv"});
  std::filesystem::create_symlink("circle.csv", folder / "circle.csv");
  expect_parts(complaints("[[device]]\nfile = \"circle.csv\"\n"), {"leads outside"});
  expect_parts(complaints("[[device]]\nname = \"A\"\nfiles = [\n  \"a.csv\",\n  \"../b.csv\"\n]\n"),
               {"lot.toml:5: files: '../b.csv' leads outside"});
  EXPECT_EQ(read("[[device]]\nfile = \"../b.csv\"\n", {.allow_outside = true}).devices.size(), 1u);
}

// A rule file outside the folder must give the same message whether or not it exists.
TEST_F(LotFileTest, RulesOutsideTheFolderHaveTheirLine) {
  std::vector<std::string> const built_in{"known"};
  auto const lot = [](std::string const& name) {
    return "[acceptance]\nrules = \"" + name + "\"\n[[device]]\nfile = \"a.csv\"\n";
  };
  for (std::string const name : {"../secret.toml", "sub/../../secret.toml", "/etc/passwd"})
    expect_parts(complaints(lot(name)), {"lot.toml:2: rules: '" + name + "' leads outside, to /",
                                         "a built-in rule set, or a file in the folder of the lot file or below it"});
  std::ofstream(folder / "own.toml") << "title = \"own\"\n";
  auto const own = read(lot("own.toml"), {.built_in_rules = built_in});
  EXPECT_TRUE(own.rules_are_file);
  EXPECT_EQ(own.acceptance.rules_file, (folder / "own.toml").string());
  auto const known = read(lot("known"), {.built_in_rules = built_in});
  EXPECT_FALSE(known.rules_are_file);
  EXPECT_EQ(known.acceptance.rules_file, "known");
  EXPECT_EQ(read(lot("../x.toml"), {.allow_outside = true}).acceptance.rules_file, (folder / "../x.toml").string());
  expect_parts(complaints(lot("")), {"lot.toml:2: rules: ''"});
}

TEST_F(LotFileTest, ValuesOfADeviceThatCannotBeAreRefused) {
  expect_parts(device("rubber-thickness-mm = -1"), {"lot.toml:4: rubber-thickness-mm: -1; allowed: ", "above 0"});
  expect_parts(device("rubber-thickness-mm = 0"), {"rubber-thickness-mm: 0"});
  expect_parts(device("rubber-area-mm2 = inf"), {"lot.toml:4: rubber-area-mm2: inf; allowed: ", "above 0"});
  expect_parts(device("temperature-C = nan"), {"lot.toml:4: temperature-C: nan; allowed: degrees Celsius"});
  expect_parts(device("temperature-C = -300"), {"temperature-C: -300"});
  EXPECT_EQ(device("temperature-C = -20.5\nrubber-thickness-mm = 160\nrubber-area-mm2 = 1e6"), "");
  for (auto const* name : {"", "  "})
    expect_parts(complaints(fmt::format("[[device]]\nname = \"{}\"\nfile = \"a.csv\"\n", name)),
                 {"lot.toml:2: name: empty; allowed: a name"});
}

TEST_F(LotFileTest, AParameterSetTwiceIsRefused) {
  expect_parts(calibrate("set = [\"bilinear.K1=1\", \"bilinear.K1=2\"]"),
               {"lot.toml:3: set: bilinear.K1 is set twice: bilinear.K1=1 and bilinear.K1=2"});
  EXPECT_EQ(calibrate("set = [\"bilinear.K1=1\", \"bilinear.K2=2\"]"), "");
}

TEST_F(LotFileTest, WholeNumbersBeyondAnyRangeSayTheRange) {
  expect_parts(calibrate("smooth = 1000000000001"),
               {"lot.toml:3: smooth: 1000000000001 is out of range; allowed: an odd number"});
  expect_parts(calibrate("generations = 9000000000"), {"generations: 9000000000 is out of range", "1 to 20000"});
  expect_parts(calibrate("jobs = -9000000000"), {"'jobs' is -9000000000, out of range", "0 to 4096"});
}

TEST_F(LotFileTest, FilesInTheFolderMayTakeAnyWayThere) {
  write("sub/a.csv", "x");
  std::filesystem::create_symlink("sub/a.csv", folder / "within.csv");
  for (std::string const file : {"sub/../a.csv", "sub/a.csv", "./a.csv", "within.csv", "..a.csv"})
    EXPECT_EQ(complaints("[[device]]\nfile = \"" + file + "\"\n"), "");
  EXPECT_EQ(complaints("[[device]]\nfile = \"" + (folder / "sub/a.csv").string() + "\"\n"), "");
}

TEST_F(LotFileTest, ResultsStayBelowTheCurrentDirectory) {
  for (std::string const out : {"/tmp/x", "../x", "a/../../x", ".", ""})
    expect_parts(
        calibrate("out = \"" + out + "\""),
        {"lot.toml:3: out: '" + out + "' is not below the current directory", "--out DIR on the command line"});
  EXPECT_EQ(calibrate("out = \"out/x\""), "");
  EXPECT_EQ(read("[calibrate]\nout = \"/tmp/x\"\n[[device]]\nfile = \"a.csv\"\n", {.other_out = true}).devices.size(),
            1u);
}

TEST_F(LotFileTest, ControlCharactersAreRefused) {
  expect_parts(complaints("title = \"a\\nb\"\n[[device]]\nfile = \"a.csv\"\n"),
               {"lot.toml:1: title: 'a\\nb' holds control characters", "printable text"});
  for (std::string const key : {"serial", "lot", "test-date"})
    expect_parts(device(key + " = \"\\u001b[31mred\""), {"lot.toml:4: " + key + ": '\\x1b[31mred' holds control"});
  expect_parts(complaints("[[device]]\nname = \"x\\u202ey\"\nfile = \"a.csv\"\n"), {"lot.toml:2: name: 'x\\u202ey'"});
  expect_parts(complaints("[[device]]\nfile = [\"a.csv\", \"b\\u0007\"]\n"), {"lot.toml:2: file: 'b\\x07'"});
  auto const said = complaints("\"k\\u001b\" = 1\n[[device]]\nfile = \"a.csv\"\n");
  expect_parts(said, {"unknown key 'k\\x1b'"});
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
}

TEST_F(LotFileTest, NamesHaveALongestLength) {
  EXPECT_EQ(device("serial = \"" + std::string(longest_name, 'x') + "\""), "");
  expect_parts(device("serial = \"" + std::string(longest_name + 1, 'x') + "\""),
               {"lot.toml:4: serial: ", "is 513 bytes long", "512 or fewer"});
}

// toml++ reads nested tables by recursion, so a hundred thousand levels would overflow its stack. isolaw must refuse
// such a file before toml++ reads it.
TEST_F(LotFileTest, DeepNestingIsRefused) {
  std::string const found = "nested deeper than any lot file needs";
  auto const repeated = [](std::string_view part, std::size_t times) {
    std::string text;
    for (std::size_t i = 0; i < times; ++i) text += part;
    return text;
  };
  expect_parts(complaints("\n" + repeated("a.", 1'000'000) + "a = 1\n"), {"lot.toml:2: ", found});
  expect_parts(complaints("[" + repeated("a.", 1'000'000) + "a]\n"), {"lot.toml:1: ", found});
  expect_parts(complaints("a = " + repeated("[", 1'000'000)), {found});
  expect_parts(complaints("a = " + repeated("{a.a.a=[\n", 200'000)), {"lot.toml:", found});
  expect_parts(complaints("a = \"\"\"\"\\\"\"\"\"\nb = 'x' # '\n" + repeated("a.", 1'000'000) + "a = 1\n"),
               {"lot.toml:3: ", found});
  // Brackets and dots in text and comments do not count as nesting.
  EXPECT_EQ(complaints("title = \"" + repeated("[{.", 150) + "\" # " + repeated("[{.", 200) +
                       "\n[[device]]\nfile = \"a.csv\"\n"),
            "");
}

TEST_F(LotFileTest, DevicesHaveALargestNumber) {
  std::string text;
  for (std::size_t i = 0; i < most_devices; ++i) text += fmt::format("[[device]]\nfile = \"{}.csv\"\n", i);
  EXPECT_EQ(read_lot_text(text, folder / "lot.toml").devices.size(), most_devices);
  expect_parts(complaints(text + "[[device]]\nfile = \"x.csv\"\n"), {"10001 devices", "10000 or fewer"});
}

TEST_F(LotFileTest, ADeviceHasALargestNumberOfFiles) {
  std::string files;
  for (int i = 0; i < 1001; ++i) files += "\"a.csv\",";
  expect_parts(complaints("[[device]]\nfiles = [" + files + "]\n"),
               {"lot.toml:2: 'files' lists 1001 values", "1000 or fewer"});
}

TEST_F(LotFileTest, ALargeOrSpecialFileIsNotRead) {
  auto const file = write("large.toml", "x");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // a sparse file takes no space on disk
  auto const said = [](std::filesystem::path const& path) -> std::string {
    try {
      read_lot_file(path);
    } catch (Error const& error) {
      return error.what();
    }
    return "";
  };
  expect_parts(said(file), {"large.toml: is 1048576.00 MiB large, above 16 MiB", "a lot file in TOML"});
  expect_parts(said("/dev/zero"), {"/dev/zero: is a device"});
  expect_parts(said(folder), {"is a directory"});
}

TEST_F(LotFileTest, ManyMistakesAreSaidInPart) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += fmt::format("k{} = 1\n", i);
  auto const said = complaints(text + "[[device]]\nfile = \"a.csv\"\n");
  EXPECT_EQ(std::ranges::count(said, '\n'), 50);
  expect_parts(said, {"and more of the kind"});
}

TEST_F(LotFileTest, EveryProblemIsSaidAtOnce) {
  auto const said = complaints(
      "titel = 1\n[calibrate]\nruns = \"x\"\nbox = \"wide\"\nlows = \"all\"\n[[device]]\nname = \"A\"\n"
      "[[device]]\nfile = \"b.csv\"\ncolour = 3\n");
  expect_parts(said, {"lot.toml:1", "'titel'", "lot.toml:3", "runs: 'x'", "lot.toml:4", "'wide'", "lot.toml:5",
                      "'lows'", "lot.toml:6", "without a file", "lot.toml:10", "'colour'"});
  EXPECT_EQ(std::ranges::count(said, '\n'), 5) << said;
}

// --- lot files that isolaw writes ---

void expect_same(DeviceInput const& a, DeviceInput const& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.tests[0].files, b.tests[0].files);
  EXPECT_EQ(a.info.serial, b.info.serial);
  EXPECT_EQ(a.info.lot, b.info.lot);
  EXPECT_EQ(a.info.test_date, b.info.test_date);
  EXPECT_EQ(a.info.temperature_C, b.info.temperature_C);
  EXPECT_EQ(a.info.rubber_thickness_mm, b.info.rubber_thickness_mm);
  EXPECT_EQ(a.info.rubber_area_mm2, b.info.rubber_area_mm2);
  EXPECT_EQ(a.vertical.file, b.vertical.file);
  EXPECT_EQ(a.vertical.stated_kN_per_mm, b.vertical.stated_kN_per_mm);
  EXPECT_TRUE(a.vertical.loads == b.vertical.loads);
  EXPECT_TRUE(a.vertical.read == b.vertical.read);
  EXPECT_EQ(a.tests[0].read.columns, b.tests[0].read.columns);
  EXPECT_EQ(a.tests[0].read.units, b.tests[0].read.units);
  EXPECT_EQ(a.tests[0].read.dt_s, b.tests[0].read.dt_s);
  EXPECT_EQ(a.tests[0].read.flip_force, b.tests[0].read.flip_force);
  EXPECT_EQ(a.tests[0].read.sheet, b.tests[0].read.sheet);
  EXPECT_EQ(a.tests[0].read.test, b.tests[0].read.test);
}

TEST_F(LotFileTest, WrittenDevicesReadBack) {
  Lot lot;
  lot.title = "O'Brien's \"lot\" <1>, second line – ½";
  DeviceInput first;
  first.name = "A \"1\"\\x";
  first.tests[0].files = {folder / "records" / "a 'b'.csv"};
  first.tests[0].shown_file = "records/a 'b'.csv";
  first.info = {.serial = "0001",
                .lot = "L\\\"7",
                .test_date = "2023-05-11",
                .temperature_C = -3.25,
                .rubber_thickness_mm = 208.0,
                .rubber_area_mm2 = 0.1 + 0.2};
  using enum data::Channel;
  first.tests[0].read.columns = {{time, "1"}, {disp, "Weg, horizontal"}, {force, "Kraft \"x\""}};
  first.tests[0].read.units = {{disp, "cm"}, {force, "tonf"}};
  first.tests[0].read.dt_s = 0.00214823;
  first.tests[0].read.flip_force = true;
  first.tests[0].read.sheet = "2, \"x\"";
  first.tests[0].read.test = "all";
  DeviceInput second;
  second.tests[0].read.sheet = "2";
  second.tests[0].read.test = "12";
  second.name = "ß";
  second.tests[0].files = {folder / "b1.csv", folder / "b2.csv"};
  second.tests[0].shown_file = "b1.csv, b2.csv";
  DeviceInput elsewhere;
  elsewhere.name = "elsewhere";
  elsewhere.tests[0].files = {"/data/somewhere/else.csv"};
  elsewhere.tests[0].shown_file = "/data/somewhere/else.csv";
  second.vertical.file = folder / "b-v.csv";
  second.vertical.shown_file = "b-v.csv";
  second.vertical.read.units = {{data::Channel::load, "MN"}};
  second.vertical.read.rows = data::RowRange{.first = 2, .last = {}};
  second.vertical.loads = data::LoadRange{0.1 + 0.2, 1234567.0};
  elsewhere.vertical.stated_kN_per_mm = 1234.5;
  lot.devices = {first, second, elsewhere};
  auto const text = lot_file_text(lot, folder);
  auto const back = read(text, {.allow_outside = true});
  EXPECT_EQ(back.title, lot.title);
  ASSERT_EQ(back.devices.size(), 3u) << text;
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(back.devices[i], lot.devices[i]);
    EXPECT_EQ(back.devices[i].shown_file(), lot.devices[i].shown_file());
  }
  EXPECT_EQ(text.find(folder.string()), std::string::npos) << "names below the folder are relative: " << text;
  EXPECT_EQ(lot_file_text(back, folder), text);
}

TEST_F(LotFileTest, WhatAllDevicesShareIsSaidOnceKeyByKey) {
  Lot lot;
  lot.title = "lot";
  for (std::string const name : {"a", "b"}) {
    DeviceInput device;
    device.name = name;
    device.tests[0].files = {folder / (name + ".csv")};
    device.tests[0].shown_file = name + ".csv";
    device.tests[0].read.columns = {{data::Channel::force, name == "a" ? "2" : "3"}};
    device.tests[0].read.units = {{data::Channel::force, "kN"}};
    device.tests[0].read.flip_force = name == "a";
    device.tests[0].read.corrections.skew_s = 0.004;
    lot.devices.push_back(device);
  }
  auto const text = lot_file_text(lot, folder);
  auto const back = read(text);
  EXPECT_EQ(back.read.corrections, lot.devices[0].tests[0].read.corrections) << text;
  EXPECT_EQ(back.read.units, lot.devices[0].tests[0].read.units) << text;
  EXPECT_TRUE(back.read.columns.empty()) << text;
  EXPECT_FALSE(back.read.flip_force) << text;
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(back.devices[i].tests[0].read, lot.devices[i].tests[0].read) << text;
}

TEST_F(LotFileTest, WrittenAcceptanceReadsBack) {
  Lot lot;
  lot.title = "lot";
  lot.devices.resize(1);
  lot.devices[0].name = "a";
  lot.devices[0].tests[0].files = {folder / "a.csv"};
  lot.rules_are_file = true;
  lot.acceptance = {.rules = {},
                    .rules_file = (folder / "own.toml").string(),
                    .design = "K_eff=1.2",
                    .lot_size = 28,
                    .alike = {.temperature_C = 3.5, .load_percent = 12.0}};
  auto const text = lot_file_text(lot, folder);
  EXPECT_EQ(text.find(folder.string()), std::string::npos) << text;
  EXPECT_EQ(read(text).acceptance, lot.acceptance) << text;
  lot.rules_are_file = false;
  lot.acceptance.rules_file = "known";
  EXPECT_EQ(read(lot_file_text(lot, folder), {.built_in_rules = {"known"}}).acceptance, lot.acceptance);
}

// A lot file that isolaw writes must give the same lot when read.
TEST_F(LotFileTest, WrittenSettingsReadBack) {
  Lot lot;
  lot.title = "lot";
  DeviceInput device;
  device.name = "A";
  device.tests[0].files = {folder / "a.csv"};
  device.tests[0].shown_file = "a.csv";
  lot.devices = {device};
  lot.settings.seed = 9;
  lot.settings.runs = 4;
  lot.settings.box = fit::BoxKind::published;
  lot.settings.clean = {.smooth = 7, .samples_per_cycle = std::nullopt, .center = false};
  lot.settings.complete();
  expect_same(read(lot_file_text(lot, folder)).settings, lot.settings);

  lot.settings.clean.center = true;
  lot.settings.laws = {"abe", "vaiana"};
  lot.settings.integration = laws::Integration::paper;
  lot.settings.method = Method::genetic;
  lot.settings.genetic.population = 40;
  lot.settings.genetic.generations = 30;
  lot.settings.overrides = {fit::parse_override("bilinear.K1=1.5")};
  expect_same(read(lot_file_text(lot, folder)).settings, lot.settings);
}

TEST_F(LotFileTest, EverySettingReadsBackAndIsRefusedAtItsLine) {
  for (auto const& setting : setting_table()) {
    if (setting.stored_only) continue;
    SCOPED_TRACE(setting.key);
    Lot lot;
    lot.devices.resize(1);
    lot.devices[0].name = "a";
    lot.devices[0].tests[0].files = {folder / "a.csv"};
    lot.settings = isolaw::testing::with(setting, isolaw::testing::another(setting));
    auto const text = lot_file_text(lot, folder);
    EXPECT_TRUE(text.find("\n" + setting.option() + " = ") != std::string::npos) << text;
    expect_same(read(text).settings, lot.settings);
    expect_parts(calibrate("\n" + setting.option() + " = \"?\""), {"lot.toml:4: " + setting.option() + ": "});
  }
}

TEST(LotOfFiles, NamesDevicesAfterTheirFiles) {
  auto const lot = lot_of_files({"x/a.csv", "x/b.csv", "y/a.csv", "z/y/a.csv"});
  ASSERT_EQ(lot.devices.size(), 4u);
  EXPECT_EQ(lot.devices[0].name, "a");
  EXPECT_EQ(lot.devices[1].name, "b");
  EXPECT_EQ(lot.devices[2].name, "y/a");
  std::set<std::string> names;
  for (auto const& device : lot.devices) {
    EXPECT_TRUE(names.insert(device.name).second) << device.name;
    EXPECT_EQ(device.tests[0].files.size(), 1u);
  }
  EXPECT_EQ(lot.devices[1].shown_file(), "b.csv");
}

// A comma before three digits may group thousands, so 1,200 mm is ambiguous and isolaw leaves the value to the user.
TEST_F(LotFileTest, NumbersOfAFileThatMayBeGroupedAreLeftToAPerson) {
  DeviceInfo info;
  auto left = take_device_facts({{"rubber-area-mm2", "282,743 mm2"}, {"rubber-thickness-mm", "1,200 mm"}}, info);
  EXPECT_EQ(left.size(), 2u);
  EXPECT_FALSE(info.rubber_area_mm2 || info.rubber_thickness_mm);
  left = take_device_facts({{"rubber-area-mm2", "2827,43 cm2"}, {"rubber-thickness-mm", "20,8 cm"}}, info);
  EXPECT_TRUE(left.empty());
  EXPECT_DOUBLE_EQ(info.rubber_area_mm2.value(), 282743.0);
  EXPECT_DOUBLE_EQ(info.rubber_thickness_mm.value(), 208.0);
}

TEST_F(LotFileTest, AFileLeftOutStaysACommentWhateverItsName) {
  auto lot = lot_of_files({folder / "a.csv"});
  auto const text = lot_file_text(
      lot, folder,
      {.open_keys = false, .stated = {}, .left_out = {{folder / "b\n[[device]]\nfile='x'.csv", "no record"}}});
  EXPECT_EQ(read(text).devices.size(), 1u) << text;
}

}  // namespace
}  // namespace isolaw::campaign
