// For each kind of bad input the message must say where it is, what was found, what is allowed and what to try.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"
#include "isolaw/campaign/settings.hpp"

namespace isolaw::cli_test {
namespace {

Words const small_into_O{"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1", "--out", "O"};

class BadInput : public InFreshDirectory {
 protected:
  // Expects that inspect and calibrate refuse the file with the same message, and that calibrate makes no output
  // directory.
  void expect_refusal(std::string const& file, std::vector<std::string> const& parts, Words const& options = {}) {
    SCOPED_TRACE(file);
    expect_refused(isolaw(Words{"inspect", file} + options), parts);
    auto const o = isolaw(Words{"calibrate", file} + small_into_O + options);
    expect_refused(o, parts);
    EXPECT_TRUE(contains(o.err, "its one device is not usable"));
    EXPECT_FALSE(exists("O"));
  }
  Outcome calibrate(Words const& files, Words const& more = {}) {
    return isolaw(Words{"calibrate"} + files + small_into_O + more);
  }
};

TEST_F(BadInput, no_such_file) {
  expect_refusal("nope.csv", {"nope.csv: no such file", "allowed: delimited text"});
}

TEST_F(BadInput, directory) {
  fs::create_directory(path("folder.csv"));
  auto const o = calibrate({"folder.csv"});
  EXPECT_EQ(o.code, 2);
  EXPECT_TRUE(contains(o.err, "folder.csv")) << o;
  EXPECT_TRUE(contains(o.err, "without test records")) << o;
  EXPECT_FALSE(exists("O"));
}

TEST_F(BadInput, file_without_permission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  write("closed.csv", csv(record()));
  fs::permissions(path("closed.csv"), fs::perms::none);
  expect_refusal("closed.csv", {"closed.csv: cannot be read", "ermission denied", "allowed: delimited text"});
}

TEST_F(BadInput, empty_file) {
  write("empty.csv", "");
  expect_refusal("empty.csv", {"empty.csv: is empty", "allowed: delimited text"});
}

TEST_F(BadInput, file_without_a_row_of_numbers) {
  write("blank.csv", "\n\n\n");
  expect_refusal("blank.csv",
                 {"blank.csv: no rows of numbers in 3 lines", "allowed: two or more columns", "try: export"});
  write("header.csv", std::string(header) + "\n");
  expect_refusal("header.csv", {"header.csv: no rows of numbers", "allowed: two or more columns"});
}

TEST_F(BadInput, too_few_samples) {
  auto const samples = record();
  write("two.csv", csv({samples[0], samples[1]}));
  expect_refusal("two.csv", {"two.csv: 2 samples", "allowed: 3 or more"});
}

TEST_F(BadInput, missing_force_column) {
  write("nocol.csv", csv(record(), "time [s],displacement [mm]", [](std::size_t, Sample const& s) {
          return fmt::format("{:.4f},{:.5f}", s.time_s, s.disp_mm);
        }));
  expect_refusal("nocol.csv", {"nocol.csv:1: no column is recognised as the horizontal force",
                               "allowed: columns 1 'time [s]', 2 'displacement [mm]'", "try: --columns force=NUMBER"});
}

TEST_F(BadInput, missing_displacement_column) {
  write("nocol.csv", csv(record(), "time [s],temperature [C],force [kN]"));
  expect_refusal("nocol.csv", {"nocol.csv:1: no column is recognised as the horizontal displacement",
                               "2 'temperature [C]'", "try: --columns disp=NUMBER"});
}

TEST_F(BadInput, two_columns_that_may_be_the_force_are_asked_about) {
  write("twice.csv", csv(record(), "displacement [mm],force A [kN],force B [kN]"));
  expect_refusal("twice.csv",
                 {"twice.csv:1: column 2 'force A [kN]', column 3 'force B [kN]' may each be the horizontal force",
                  "--columns force=2 or --columns force=3"});
}

TEST_F(BadInput, unknown_unit) {
  write("unit.csv", csv(record(), "time [s],displacement [mm],force [pound]"));
  expect_refusal("unit.csv", {"unit.csv:1: unknown unit 'pound' of column 3 'force [pound]'",
                              "allowed: kN, N, MN, tonf", "try: --units force=kN"});
  EXPECT_EQ(isolaw({"inspect", "unit.csv", "--units", "force=kN"}).code, 0);
}

TEST_F(BadInput, no_unit) {
  write("unit.csv", csv(record(), "time,displacement,force"));
  expect_refusal(
      "unit.csv",
      {"unit.csv:1: column 1 'time' (time) has no unit; allowed: s, ms, min, d; try: --units time=s, with the column's unit",
       "column 2 'displacement' (disp) has no unit", "column 3 'force' (force) has no unit"});
  EXPECT_EQ(isolaw({"inspect", "unit.csv", "--units", "time=s,disp=mm,force=kN"}).code, 0);
}

TEST_F(BadInput, nan_cell) {
  write("nan.csv", csv_with_line(101, "0.9900,nan,12.0"));
  expect_refusal("nan.csv", {"nan.csv:101: 'nan' in column 2 'displacement [mm]' is not a finite number",
                             "allowed: a finite number", "try: --rows 101:, the rows behind it"});
}

TEST_F(BadInput, text_cell) {
  write("text.csv", csv_with_line(55, "0.5300,12.0,off"));
  expect_refusal("text.csv", {"text.csv:55: 'off' in column 3 'force [kN]' is not a number",
                              "allowed: a number with a decimal point", "try: --rows 55:, the rows behind it"});
}

TEST_F(BadInput, empty_cell) {
  write("hole.csv", csv_with_line(101, "0.9900,,12.0"));
  expect_refusal("hole.csv", {"hole.csv:101: column 2 'displacement [mm]' is empty", "allowed: a number",
                              "try: --rows 101:, the rows behind it"});
}

TEST_F(BadInput, row_of_another_width) {
  write("wide.csv", csv_with_line(101, "0.9900,12.0,3.0,4.0"));
  expect_refusal("wide.csv", {"wide.csv:101: 4 columns", "allowed: 3 columns", "try: --rows 101:, the rows behind it"});
}

TEST_F(BadInput, every_bad_line_is_listed_up_to_a_few) {
  write("bad.csv",
        csv(record(), header, [](std::size_t i, Sample const& s) { return i % 100 == 50 ? "0,nan,1" : row(s); }));
  auto const o = isolaw({"inspect", "bad.csv"});
  expect_refused(o, {"bad.csv:52: ", "bad.csv:152: "});
  EXPECT_TRUE(contains(o.err, "more"));
}

TEST_F(BadInput, overload_value) {
  for (std::string const value : {"9.9E37", "99999"}) {
    write("over.csv", csv_with_line(101, "0.9900,12," + value));
    expect_refusal("over.csv", {"over.csv:101: ", "in column 3 'force [kN]' looks like an overload of the sensor",
                                "allowed: measured values", "try: --rows A:B or --to SECONDS"});
  }
}

TEST_F(BadInput, time_that_goes_back) {
  auto const at = record()[99];
  write("back.csv", csv_with_line(101, row({.time_s = 0.9, .disp_mm = at.disp_mm, .force_kN = at.force_kN})));
  expect_refusal("back.csv", {"back.csv:101: time goes back from 0.98 to 0.9 s", "allowed: time that increases",
                              "--columns time=none"});
  EXPECT_EQ(isolaw({"inspect", "back.csv", "--columns", "time=none", "--dt", "0.01"}).code, 0);
}

TEST_F(BadInput, time_that_stands_still) {
  write("still.csv", csv_with_line(101, "0.9800,12,3"));
  expect_refusal("still.csv", {"still.csv:101: time 0.98 s is repeated", "allowed: time that increases"});
}

TEST_F(BadInput, constant_force) {
  auto samples = record();
  for (auto& s : samples) s.force_kN = 5.0;
  write("const.csv", csv(samples));
  expect_refusal("const.csv", {"const.csv: force is constant: column 3 'force [kN]' holds 5 kN in all 601 samples",
                               "allowed: a channel that moves", "try: --columns force=NUMBER"});
}

TEST_F(BadInput, constant_displacement) {
  auto samples = record();
  for (auto& s : samples) s.disp_mm = 5.0;
  write("const.csv", csv(samples));
  expect_refusal("const.csv",
                 {"disp is constant: column 2", "allowed: a channel that moves", "try: --columns disp=NUMBER"});
}

TEST_F(BadInput, swapped_force_and_displacement) {
  auto samples = record();
  for (auto& s : samples) std::swap(s.disp_mm, s.force_kN);
  write("swap.csv", csv(samples));
  expect_refusal("swap.csv", {"swap.csv: force and displacement seem swapped: energy per cycle -", "stiffness ",
                              "allowed: a device that dissipates energy and resists displacement",
                              "try: --columns disp=3,force=2 --units disp=mm,force=kN"});
  auto const mended =
      isolaw({"inspect", "swap.csv", "--columns", "disp=3,force=2", "--units", "disp=mm,force=kN", "--json"});
  ASSERT_EQ(mended.code, 0) << mended;
  write("good.csv", csv(record()));
  EXPECT_EQ(Json::parse(mended.out)["cycles"], Json::parse(isolaw({"inspect", "good.csv", "--json"}).out)["cycles"]);
}

TEST_F(BadInput, flipped_sign_and_how_to_mend_it) {
  auto samples = record();
  for (auto& s : samples) s.force_kN = -s.force_kN;
  write("flip.csv", csv(samples));
  expect_refusal("flip.csv", {"flip.csv: the force's sign is flipped: energy per cycle -", "stiffness -",
                              "allowed: a device that dissipates energy", "try: --flip-force"});
  write("good.csv", csv(record()));
  auto const mended = isolaw({"inspect", "flip.csv", "--flip-force", "--json"});
  ASSERT_EQ(mended.code, 0) << mended;
  EXPECT_EQ(Json::parse(mended.out)["cycles"], Json::parse(isolaw({"inspect", "good.csv", "--json"}).out)["cycles"]);
  EXPECT_EQ(calibrate({"flip.csv"}, {"--flip-force"}).code, 0);
  expect_refused(isolaw({"inspect", "good.csv", "--flip-force"}),
                 {"the force's sign is flipped", "try: leave --flip-force out"});
}

TEST_F(BadInput, workbook) {
  write("book.xlsx",
        "PK\x03\x04" + std::string(26, '\0') + "[Content_Types].xml xl/workbook.xml" + std::string(500, '\x01'));
  expect_refusal("book.xlsx",
                 {"book.xlsx: the archive is damaged", "allowed: a workbook as Excel writes it", "try: save it again"});
}

TEST_F(BadInput, other_binary_file) {
  write("bin.csv", std::string("abc\0\1\2", 6));
  expect_refusal("bin.csv", {"bin.csv: is a binary file (byte 4 is 0)", "allowed: delimited text", "try: export"});
}

TEST_F(BadInput, sampling_interval_that_is_none) {
  write("notime.csv", csv_without_time());
  for (auto const* value : {"0", "-1", "nan", "inf"}) {
    auto const o = isolaw({"inspect", "notime.csv", "--dt", value});
    expect_refused(o, {"--dt", value, "allowed: a positive number of seconds"});
  }
  write("good.csv", csv(record()));
  expect_refusal("good.csv",
                 {"good.csv: --dt 0.1 is given, but column 1 'time [s]' is the time", "try: leave --dt out"},
                 {"--dt", "0.1"});
}

TEST_F(BadInput, more_columns_rows_or_characters_than_any_test_has) {
  std::string wide = "1";
  for (int i = 0; i < 1000; ++i) wide += ",2";
  write("wide.csv", wide + "\n" + wide + "\n");
  expect_refusal("wide.csv", {"wide.csv: 1001 columns", "allowed: 1000 or fewer", "try: export time"});
  write("line.csv", csv(record()) + std::string(100'000, '7') + "\n");
  expect_refusal("line.csv", {"line.csv:603: a line of 100000 characters", "allowed: 32768 or fewer", "try: export"});
  write("rows.csv", std::string(10'000'001, '\n'));
  expect_refusal("rows.csv", {"rows.csv: 10000001 rows", "allowed: 10000000 or fewer", "try: thin the record"});
}

TEST_F(BadInput, units_that_make_no_isolator_are_warned_of) {
  auto const inspected = [&](std::string const& head) {
    write("units.csv", csv(record(), head));
    auto const o = isolaw({"inspect", "units.csv"});
    EXPECT_EQ(o.code, 0) << o;
    return o.out;
  };
  EXPECT_FALSE(contains(inspected(header), "any isolator"));
  auto const stiff = inspected("time [s],displacement [mm],force [MN]");
  EXPECT_TRUE(contains(stiff, "stiffer than any isolator. Are displacements really in mm and forces in MN?"));
  EXPECT_TRUE(contains(stiff, "--units disp=UNIT,force=UNIT"));
  EXPECT_TRUE(contains(inspected("time [s],displacement [m],force [N]"), "softer than any isolator"));
  EXPECT_TRUE(contains(inspected("time [s],displacement [m],force [MN]"), "no isolator goes that far"));
}

// --- records whose cyclic properties are refused, but laws are fitted ---------------------------------------------

TEST_F(BadInput, fewer_than_20_samples_per_cycle_refuses_the_cyclic_properties_only) {
  write("few.csv", csv(record({.samples = 46, .per_cycle = 15})));
  auto const inspected = isolaw({"inspect", "few.csv"});
  EXPECT_EQ(inspected.code, 0) << inspected;
  EXPECT_TRUE(contains(inspected.out, "No cyclic properties: 15.0 samples per cycle, fewer than the 20"));
  auto const o = calibrate({"few.csv"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(count_of("few: 15.0 samples per cycle", o.out), 1u) << "said once\n" << o;
  auto const fit = json("O/summary.json")["laws"][0]["devices"][0];
  EXPECT_TRUE(fit["objective"]["best"].is_number());
  EXPECT_TRUE(fit["K_eff_error_percent"].is_null());
  EXPECT_TRUE(contains(read("O/tables/cycles.csv"), "fewer than the 20"));
}

TEST_F(BadInput, twenty_samples_per_cycle_are_enough) {
  write("enough.csv", csv(record({.samples = 61, .per_cycle = 20})));
  auto const o = isolaw({"inspect", "enough.csv", "--json"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(Json::parse(o.out)["refusal"].is_null()) << o;
}

TEST_F(BadInput, less_than_one_cycle_refuses_the_cyclic_properties_only) {
  write("part.csv", csv(record({.samples = 90})));
  auto const inspected = isolaw({"inspect", "part.csv", "--json"});
  ASSERT_EQ(inspected.code, 0) << inspected;
  auto const found = Json::parse(inspected.out);
  EXPECT_TRUE(contains(found["properties_refusal"].get<std::string>(), "less than one complete cycle"));
  ASSERT_EQ(found["blocks"].size(), 1u);
  ASSERT_FALSE(found["blocks"][0]["cycles"].empty());
  for (auto const& cycle : found["blocks"][0]["cycles"]) {
    EXPECT_EQ(cycle["counts"], false);
    EXPECT_TRUE(contains(cycle["reason"].get<std::string>(), "partial")) << cycle;
  }
  EXPECT_TRUE(found["reported"].is_null());
  auto const o = calibrate({"part.csv"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "less than one complete cycle"));
  auto const fit = json("O/summary.json")["laws"][0]["devices"][0];
  EXPECT_TRUE(fit["objective"]["best"].is_number());
  EXPECT_TRUE(fit["energy_error_percent"].is_null());
}

// --- records without time ----------------------------------------------------------------------------------------

TEST_F(BadInput, without_time_the_two_rate_dependent_laws_are_refused_and_the_others_run) {
  write("notime.csv", csv_without_time());
  auto const o =
      isolaw({"calibrate", "notime.csv", "--runs", "1", "--population", "8", "--generations", "2", "--out", "O"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "not identified"));
  auto const details = unwrapped(isolaw({"report", "O", "--details", "--figures", "none"}).out);
  auto const summary = json("O/summary.json");
  EXPECT_EQ(summary["devices"][0]["status"], "ok");
  for (auto const& law : summary["laws"]) {
    auto const& fit = law["devices"][0];
    bool const needs_time = !laws::find_law(law["id"].get<std::string>()).info.traits.rate_independent;
    EXPECT_EQ(fit["status"], needs_time ? "refused" : "ok") << law["id"];
    EXPECT_EQ(fit["objective"]["best"].is_null(), needs_time);
    if (!needs_time) continue;
    EXPECT_TRUE(contains(fit["message"].get<std::string>(), "no time channel"));
    EXPECT_TRUE(contains(fit["message"].get<std::string>(),
                         "allowed: rate-independent laws (bilinear, vaiana, bouc-wen, abe, abe-y0"));
    EXPECT_TRUE(contains(fit["message"].get<std::string>(), "try: --dt SECONDS"));
    EXPECT_TRUE(contains(details, law["name"].get<std::string>() + " was not identified on notime"));
    EXPECT_TRUE(contains(read("O/tables/objective.csv"), law["id"].get<std::string>() + ",notime,,,,0,0,"));
  }
  EXPECT_TRUE(contains(read("O/report.html"), "no time channel"));
}

TEST_F(BadInput, with_a_sampling_interval_all_laws_run_as_with_a_time_column) {
  write("notime.csv", csv_without_time());
  auto const run = [&](Words const& input, std::string const& out) {
    return isolaw(Words{"calibrate"} + input +
                  Words{"--runs", "1", "--population", "8", "--generations", "2", "--out", out});
  };
  auto const o = run({"notime.csv", "--dt", "0.01"}, "O");
  EXPECT_EQ(o.code, 0) << o;
  fs::create_directory(path("other"));
  write("other/notime.csv", csv(record()));
  ASSERT_EQ(run({"other/notime.csv"}, "P").code, 0);
  auto const with_dt = json("O/summary.json")["laws"], with_time = json("P/summary.json")["laws"];
  ASSERT_EQ(with_dt.size(), campaign::parse_laws(campaign::usual_laws).size());
  for (std::size_t l = 0; l < with_dt.size(); ++l)
    EXPECT_NEAR(with_dt[l]["objective"]["best"].get<double>(), with_time[l]["objective"]["best"].get<double>(), 1e-9)
        << with_dt[l]["id"];
}

// --- searches without a finite force -----------------------------------------------------------------------------

// A run may succeed although some of its parameter sets gave no finite force. Every output states how many.
TEST_F(BadInput, parameter_sets_without_a_finite_force_are_counted_and_said) {
  write("a.csv", csv(record()));
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "bouc-wen", "--set", "bouc-wen.beta=-0.05:0.05", "--runs", "2",
                         "--population", "20", "--generations", "3", "--out", "O"});
  EXPECT_EQ(o.code, 0) << o;
  auto const fit = json("O/summary.json")["laws"][0]["devices"][0];
  auto const failed = fit["failed_evaluations"].get<int>();
  EXPECT_GT(failed, 0);
  EXPECT_LT(failed, 120);
  EXPECT_EQ(fit["evaluations"], 120);
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT sum(failed_evaluations) FROM run"), Words{std::to_string(failed)});
  EXPECT_TRUE(contains(o.out, fmt::format("{} of 120 parameter sets", failed)));
  EXPECT_TRUE(contains(read("O/tables/objective.csv"), fmt::format(",120,{},", failed)));
  EXPECT_TRUE(contains(read("O/report.html"), fmt::format("\"failed_evaluations\":{}", failed)));
}

TEST_F(BadInput, a_law_without_any_finite_force_is_a_failed_law_not_a_failed_campaign) {
  // With these fixed parameters an exponential of vaiana overflows, whatever its free parameters are.
  write("a.csv", csv(record()));
  auto const o = isolaw({"calibrate", "a.csv", "--laws", "vaiana,bilinear", "--set", "vaiana.beta1+=1", "--set",
                         "vaiana.beta2+=1e9", "--runs", "2", "--population", "8", "--generations", "2", "--out", "O"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "Vaiana: 2 of 2 runs failed"));
  auto const laws = json("O/summary.json")["laws"];
  auto const& failed = laws[0]["devices"][0];
  EXPECT_EQ(failed["status"], "failed");
  EXPECT_EQ(failed["failed_runs"], 2);
  EXPECT_TRUE(contains(failed["message"].get<std::string>(), "finite force"));
  for (auto const* key : {"mean", "std", "best"}) EXPECT_TRUE(failed["objective"][key].is_null());
  EXPECT_TRUE(laws[0]["objective"]["mean"].is_null());
  EXPECT_EQ(laws[0]["on_front"], false);
  EXPECT_EQ(laws[1]["devices"][0]["status"], "ok");
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT DISTINCT law, outcome, objective FROM run WHERE law = 'vaiana'"),
            Words{"vaiana|no_finite_value|NULL"});
  EXPECT_EQ(failed["evaluations"], 16);
  EXPECT_EQ(failed["failed_evaluations"], 16);
  EXPECT_EQ(query(path("O/campaign.sqlite"),
                  "SELECT message, evaluations, failed_evaluations FROM run WHERE law = 'vaiana' AND number = 1"),
            Words{"none of the first 8 parameter sets gave a finite force|8|8"});
  EXPECT_EQ(isolaw({"report", "O"}).code, 1);
}

// --- bad records in a lot ----------------------------------------------------------------------------------------

TEST_F(BadInput, one_bad_device_of_three_does_not_stop_the_others_and_is_named_everywhere) {
  write("a.csv", csv(record()));
  write("bad.csv", csv_with_line(101, "0.9900,nan,12.0"));
  write("c.csv", csv(record({.amplitude_mm = 90.0})));
  auto const o = calibrate({"a.csv", "bad.csv", "c.csv"});
  std::string const reason = "bad.csv:101: 'nan' in column 2 'displacement [mm]' is not a finite number";
  expect_message(o, 1, {"bad: refused", reason});
  EXPECT_TRUE(contains(o.out, "3 devices (1 refused)"));
  EXPECT_TRUE(contains(o.out, "bad was refused: bad.csv:101"));
  auto const summary = json("O/summary.json");
  ASSERT_EQ(summary["devices"].size(), 3u);
  EXPECT_EQ(summary["devices"][1]["status"], "refused");
  EXPECT_TRUE(contains(summary["devices"][1]["message"].get<std::string>(), reason));
  for (auto const i : {0u, 2u}) EXPECT_EQ(summary["devices"][i]["status"], "ok");
  ASSERT_EQ(summary["laws"][0]["devices"].size(), 2u);
  EXPECT_EQ(summary["laws"][0]["devices"][1]["name"], "c");
  EXPECT_TRUE(contains(read("O/report.html"), reason));
  EXPECT_TRUE(contains(read("O/tables/cycles.csv"), reason));
  EXPECT_TRUE(contains(query(path("O/campaign.sqlite"), "SELECT status, message FROM device WHERE name = 'bad'").at(0),
                       "refused|" + reason));
  EXPECT_EQ(isolaw({"report", "O"}).code, 1);
}

TEST_F(BadInput, a_bad_device_changes_nothing_for_the_others) {
  write("a.csv", csv(record()));
  write("bad.csv", "");
  ASSERT_EQ(calibrate({"a.csv", "bad.csv"}).code, 1);
  auto const with = json("O/summary.json")["laws"][0]["devices"];
  ASSERT_EQ(calibrate({"a.csv"}, {"--fresh"}).code, 0);
  EXPECT_EQ(json("O/summary.json")["laws"][0]["devices"], with);
}

TEST_F(BadInput, all_bad_devices_leave_nothing_that_looks_like_a_result) {
  write("empty.csv", "");
  write("bad.csv", csv_with_line(101, "0.9900,nan,12.0"));
  auto const o = calibrate({"empty.csv", "bad.csv", "nope.csv"});
  expect_refused(o,
                 {"none of its 3 devices is usable", "empty.csv: is empty", "bad.csv:101: ", "nope.csv: no such file"});
  EXPECT_FALSE(exists("O"));
}

TEST_F(BadInput, a_lot_file_among_records_is_refused) {
  write("a.csv", csv(record()));
  write("lot.toml", "[[device]]\nfile = \"a.csv\"\n");
  expect_refused(calibrate({"lot.toml", "a.csv"}),
                 {"lot.toml: a lot file together with other inputs", "one lot file alone, or records"});
}

}  // namespace
}  // namespace isolaw::cli_test
