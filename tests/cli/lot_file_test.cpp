// Tests the keys of lot.toml. isolaw must report each mistake in the file with its line.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class LotFile : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record()));
    write("b.csv", csv(record({.amplitude_mm = 90.0})));
  }
  static constexpr char const* device = "[[device]]\nname = \"a\"\nfile = \"a.csv\"\n";
  Outcome run(std::string const& lot, Words const& more = {}) {
    write("lot.toml", lot);
    return isolaw(Words{"calibrate", "lot.toml", "--out", "O", "--fresh"} + more);
  }
  // Runs calibrate with options that limit the search, whatever the lot file says. If isolaw misses a mistake, the test
  // then loses little time.
  Outcome run_limited(std::string const& lot) {
    return run(lot, {"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1"});
  }
  // Runs calibrate with a lot file that itself limits the search.
  Outcome run_small(std::string const& rest) {
    return run("[calibrate]\nlaws = \"bilinear\"\nruns = 1\npopulation = 4\ngenerations = 1\n" + rest);
  }
};

TEST_F(LotFile, carries_the_options_of_the_command_line) {
  auto const o = run(
      "title = \"T\"\n[calibrate]\nlaws = [\"bilinear\", \"abe\"]\nmethod = \"ga\"\nintegration = \"paper\"\nruns = 2\n"
      "population = 6\ngenerations = 3\nseed = 42\nbox = \"published\"\nset = [\"bilinear.K2=0.4\"]\nsmooth = 3\n"
      "samples-per-cycle = \"all\"\ncenter = true\n" +
      std::string(device));
  EXPECT_EQ(o.code, 0) << o;
  auto const s = json("O/summary.json");
  EXPECT_EQ(s["title"], "T");
  EXPECT_EQ(s["seed"], 42);
  auto const& settings = s["settings"];
  EXPECT_EQ(settings["laws"], Json({"bilinear", "abe"}));
  EXPECT_EQ(settings["integration"], "paper");
  EXPECT_EQ(settings["runs"], 2);
  EXPECT_EQ(settings["population"], 6);
  EXPECT_EQ(settings["generations"], 3);
  EXPECT_EQ(settings["box"], "published");
  EXPECT_EQ(settings["set"], Json::array({"bilinear.K2=0.4"}));
  EXPECT_EQ(settings["smooth"], 3);
  EXPECT_EQ(settings["samples-per-cycle"], "all");
  EXPECT_EQ(settings["center"], true);
}

TEST_F(LotFile, command_line_wins_over_it) {
  auto const o =
      run("[calibrate]\nlaws = \"all\"\nruns = 20\nseed = 42\nset = \"bilinear.K2=0.4\"\n" + std::string(device),
          {"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1", "--seed", "7", "--set",
           "bilinear.K2=0.6"});
  EXPECT_EQ(o.code, 0) << o;
  auto const s = json("O/summary.json");
  EXPECT_EQ(s["seed"], 7);
  EXPECT_EQ(s["settings"]["runs"], 1);
  EXPECT_EQ(s["laws"].size(), 1u);
  EXPECT_EQ(s["settings"]["set"], Json::array({"bilinear.K2=0.6"}));
}

TEST_F(LotFile, what_it_says_of_a_device_lands_in_the_store) {
  auto const o = run_small(std::string(device) +
                           "serial = \"S 1\"\nlot = \"L7\"\ntest-date = 2024-03-01\ntemperature-C = 21.5\n"
                           "rubber-thickness-mm = 208\nrubber-area-mm2 = 282743.0\n\n"
                           "[[device]]\nname = \"b\"\nfile = \"b.csv\"\ntest-date = \"spring 2024\"\n");
  EXPECT_EQ(o.code, 0) << o;
  auto const store = path("O/campaign.sqlite");
  EXPECT_EQ(
      query(
          store,
          "SELECT name, file, serial, lot, test_date, CAST(temperature_C AS TEXT), CAST(rubber_thickness_mm AS TEXT), CAST(rubber_area_mm2 AS TEXT) FROM device ORDER BY id"),
      (Words{"a|a.csv|S 1|L7|2024-03-01|21.5|208.0|282743.0", "b|b.csv|||spring 2024|NULL|NULL|NULL"}));
}

TEST_F(LotFile, several_files_of_a_device_are_one_history) {
  auto const o = run_small("[[device]]\nname = \"long\"\nfiles = [\"a.csv\", \"b.csv\"]\n");
  EXPECT_EQ(o.code, 0) << o;
  auto const store = path("O/campaign.sqlite");
  EXPECT_EQ(query(store, "SELECT count FROM series WHERE kind = 'raw' AND channel = 'disp_mm'"), Words{"1202"});
  EXPECT_EQ(json("O/summary.json")["devices"][0]["file"], "a.csv, b.csv");
  EXPECT_EQ(count_of("long,", read("O/tables/cycles.csv")), 6u);  // three cycles in each of the two files
  EXPECT_TRUE(
      contains(query(store, "SELECT recognised FROM device").at(0), "b.csv continues the history with 601 samples"));
}

TEST_F(LotFile, one_bad_file_of_several_refuses_the_device_by_that_files_name) {
  write("b.csv", csv_with_line(101, "0.9900,nan,12.0"));
  auto const o = run_small(std::string(device) + "[[device]]\nname = \"long\"\nfiles = [\"a.csv\", \"b.csv\"]\n");
  expect_message(o, 1, {"long: refused", "b.csv:101: 'nan'"});
}

TEST_F(LotFile, files_with_and_without_time_do_not_make_one_history) {
  write("notime.csv", csv_without_time());
  auto const o = run_small(std::string(device) + "[[device]]\nname = \"long\"\nfiles = [\"a.csv\", \"notime.csv\"]\n");
  expect_message(o, 1,
                 {"long: refused", "notime.csv: only some of the device's files have a time channel",
                  "allowed: all of them or none", "dt = SECONDS"});
}

TEST_F(LotFile, reading_is_set_for_all_devices_and_for_one) {
  write("c.csv", csv(record(), "A,B,C"));
  write("d.csv", csv(record(), "t,x,y"));
  auto const o = run_small(
      "[read]\ncolumns = \"time=1,disp=2,force=3\"\nunits = { time = \"s\", disp = \"mm\", force = \"kN\" }\n"
      "[[device]]\nfile = \"c.csv\"\n[[device]]\nfile = \"d.csv\"\nunits = { force = \"tonf\" }\n"
      "columns = { force = 'y' }\n");
  EXPECT_EQ(o.code, 0) << o;
  auto const properties = read("O/tables/cycles.csv");
  EXPECT_TRUE(contains(properties, "c,1,3,yes,,yes,,0.5,2,100,100,-100,70,-70,0.7,"));
  EXPECT_TRUE(
      // 70 tonf are 686.5 kN, so the stiffness at 100 mm is 6.865 kN/mm.
      contains(properties, "d,1,3,yes,,yes,,0.5,2,100,100,-100,686.465,-686.465,6.86"));
}

TEST_F(LotFile, devices_are_named_after_their_files_when_they_have_no_name) {
  EXPECT_EQ(run_small("[[device]]\nfile = \"a.csv\"\n").code, 0);
  EXPECT_EQ(json("O/summary.json")["devices"][0]["name"], "a");
}

TEST_F(LotFile, syntax_error_names_the_line) {
  expect_refused(run("title = \"x\"\n[calibrate]\nruns = \n" + std::string(device)),
                 {"lot.toml:3: ", "allowed: a lot file in TOML", "try: isolaw init"});
}

TEST_F(LotFile, missing_lot_file_is_said_to_be_missing) {
  auto const o = isolaw({"calibrate", "nope.toml"});
  expect_refused(o, {"nope.toml", "isolaw init FILES"});
  EXPECT_EQ(o.err.find(":0:"), std::string::npos) << "a file that is not there has no line 0\n" << o;
}

TEST_F(LotFile, unknown_key_names_line_and_allowed_keys) {
  expect_refused(run("[calibrate]\nrunz = 3\n" + std::string(device)),
                 {"lot.toml:2: unknown key 'runz' in [calibrate]",
                  "allowed: analysis, bidirectional, box, center, channel-scale, columns",
                  "runs, samples-per-cycle, score-blocks, seed"});
  expect_refused(run(std::string(device) + "colour = \"red\"\n"),
                 {"lot.toml:4: unknown key 'colour' in [[device]]",
                  "allowed: K_v, channel-scale, columns, date-order, dt, file", "temperature-C, test, test-date"});
  expect_refused(run("foo = 1\n" + std::string(device)),
                 {"lot.toml:1: unknown key 'foo'", "allowed: acceptance, calibrate, conditions, device, read, title"});
  expect_refused(
      run("[read]\nskip = 1\n" + std::string(device)),
      {"lot.toml:2: unknown key 'skip' in [read]",
       "channel-scale, columns, date-order, dt, flip-force, footer, force-factor, from, half-cycles, missing, moving-mass, repair, rig-friction, rig-friction-coefficient, rows, sheet, skew-ms, test, thousands, to, units"});
}

TEST_F(LotFile, wrong_type_names_the_line) {
  expect_refused(run("[calibrate]\npopulation = \"many\"\n" + std::string(device)),
                 {"lot.toml:2: population: 'many' is not a whole number", "an even number from 4 to 100000"});
  expect_refused(run("[calibrate]\npopulation = 20.5\n" + std::string(device)),
                 {"lot.toml:2: population: 20.5 is not a whole number", "an even number from 4 to 100000"});
  expect_refused(run("[calibrate]\nbox = 3\n" + std::string(device)), {"lot.toml:2: box: 3; allowed: published, auto"});
  expect_refused(run("[calibrate]\ncenter = \"yes\"\n" + std::string(device)),
                 {"lot.toml:2: center: 'yes'; allowed: true or false"});
  expect_refused(run("[calibrate]\nset = 3\n" + std::string(device)), {"lot.toml:2: set: 3 is not text"});
  expect_refused(run("calibrate = 3\n" + std::string(device)),
                 {"lot.toml:1: 'calibrate' is not a table", "[calibrate]"});
  expect_refused(run(std::string(device) + "temperature-C = \"warm\"\n"),
                 {"lot.toml:4: temperature-C: 'warm' is not a number"});
  expect_refused(run(std::string(device) + "test-date = 3\n"), {"lot.toml:4: test-date: 3 is not text"});
  expect_refused(run(std::string(device) + "columns = 3\n"), {"lot.toml:4: columns: 3; allowed: a table, or text"});
}

TEST_F(LotFile, true_is_no_number_and_1_is_not_true) {
  expect_refused(run_limited("[calibrate]\nruns = true\n" + std::string(device)),
                 {"lot.toml:2: runs: true is not a whole number; allowed: 1 to 100000"});
  expect_refused(run_limited("[calibrate]\ncenter = 1\n" + std::string(device)),
                 {"lot.toml:2: center: 1; allowed: true or false"});
  expect_refused(run_limited(std::string(device) + "columns = { disp = true }\n"),
                 {"lot.toml:4: columns: disp: true is neither", "a name or a 1-based number"});
}

TEST_F(LotFile, values_that_are_not_allowed_name_the_line) {
  expect_refused(run("[calibrate]\nbox = \"wide\"\n" + std::string(device)),
                 {"lot.toml:2: ", "'wide'", "published, auto"});
  expect_refused(
      run("[calibrate]\nset = \"bilinear.K2=3:1\"\n" + std::string(device)),
      {"lot.toml:2: ", "the lower bound 3 is not below the upper bound 1", "lower < upper", "bilinear.K2=1:3"});
  expect_refused(run(std::string(device) + "units = { force = \"stone\" }\n"),
                 {"lot.toml:4: ", "'stone'", "kN, N, MN"});
  expect_refused(run(std::string(device) + "columns = { displ = 1 }\n"),
                 {"lot.toml:4: ", "'displ'", "time, disp, force, load"});
}

TEST_F(LotFile, unknown_law_and_parameter_are_named_with_their_line) {
  expect_refused(run("[calibrate]\nlaws = \"bilinear,nope\"\n" + std::string(device)),
                 {"lot.toml:2: ", "'nope'", "no such law", "bilinear, jankowski"});
  expect_refused(run("[calibrate]\nset = \"bilinear.K9=3\"\n" + std::string(device)),
                 {"lot.toml:2: ", "bilinear", "'K9'", "K1, K2, xy"});
}

TEST_F(LotFile, numbers_out_of_range_name_the_line) {
  expect_refused(run("[calibrate]\npopulation = 7\n" + std::string(device)),
                 {"lot.toml:2: ", "population", "7", "an even number"});
  expect_refused(run("[calibrate]\nsmooth = 4\n" + std::string(device)),
                 {"lot.toml:2: ", "smooth", "4", "an odd number"});
  expect_refused(run("[calibrate]\nruns = 0\n" + std::string(device)), {"lot.toml:2: ", "runs", "0", "1 to 100000"});
  expect_refused(run("[calibrate]\nsamples-per-cycle = 5\n" + std::string(device)),
                 {"lot.toml:2: ", "samples-per-cycle", "5", "20 or more, or all"});
  expect_refused(run("[calibrate]\nmethod = \"pso\"\n" + std::string(device)),
                 {"lot.toml:2: ", "method", "'pso'", "ga"});
}

TEST_F(LotFile, seed_below_zero_is_refused) {
  expect_refused(run_limited("[calibrate]\nseed = -1\n" + std::string(device)), {"lot.toml:2: ", "seed", "-1"});
}

TEST_F(LotFile, every_problem_is_said_at_once) {
  auto const o =
      run("[calibrate]\nrunz = 3\nbox = \"wide\"\n" + std::string(device) + "colour = 1\n\n[[device]]\nname = \"b\"\n");
  expect_refused(o, {"lot.toml:2: ", "lot.toml:3: ", "lot.toml:7: ", "lot.toml:9: a device without a file"});
}

TEST_F(LotFile, no_devices) {
  for (std::string const text : {"", "title = \"x\"\n", "device = []\n", "[device]\nfile = \"a.csv\"\n"})
    expect_refused(run(text), {"lot.toml", "no devices", "one [[device]] table for each device", "isolaw init"});
}

TEST_F(LotFile, two_devices_of_one_name) {
  expect_refused(run(std::string(device) + device), {"lot.toml", "two devices are named 'a'", "a name of its own"});
  expect_refused(run(std::string(device) + "[[device]]\nfile = \"x/a.csv\"\n"), {"two devices are named 'a'"});
}

TEST_F(LotFile, device_without_a_file) {
  expect_refused(run("[[device]]\nname = \"a\"\n"),
                 {"lot.toml:1: a device without a file", "file = \"...\" or files = [...]"});
}

TEST_F(LotFile, missing_record_is_refused_by_its_name_in_the_lot_file) {
  write("sub/lot.toml", "[[device]]\nname = \"a\"\nfile = \"gone.csv\"\n");
  expect_refused(isolaw({"calibrate", "sub/lot.toml", "--out", "O"}), {"gone.csv: no such file"});
  EXPECT_FALSE(exists("O"));
}

TEST_F(LotFile, with_byte_order_mark_and_windows_line_ends_is_read) {
  EXPECT_EQ(
      run("\xEF\xBB\xBF[calibrate]\r\nlaws = \"bilinear\"\r\nruns = 1\r\npopulation = 4\r\ngenerations = 1\r\n[[device]]\r\nfile = \"a.csv\"\r\n")
          .code,
      0);
}

}  // namespace
}  // namespace isolaw::cli_test
