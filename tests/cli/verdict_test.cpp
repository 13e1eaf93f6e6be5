// Tests what the terminal says of verdicts, of design values and of inputs that are not what they seem, such as a
// copied record.
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class Terminal : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("lot/D1.csv", csv(record()));  // K_eff is 0.7 kN/mm
    write("lot/D2.csv", csv(record({.stiffness_kN_per_mm = 0.7})));
  }
};

TEST_F(Terminal, a_pass_of_a_device_says_what_was_not_compared) {
  auto const o = isolaw(Words{"inspect", "lot"} + held_to("K_eff=0.8,disp=100") + Words{"--lot-size", "2"});
  EXPECT_TRUE(contains(o.out, "pass on 1 of 5 (K_eff; not assessed: damping, K_v, ")) << o;
  EXPECT_FALSE(contains(o.out, "  pass\n")) << o;
  auto const one = isolaw(Words{"inspect", "lot/D1.csv"} + held_to("K_eff=0.8,disp=100"));
  EXPECT_TRUE(contains(one.out, "device: pass on 1 of 5 (K_eff; not assessed: damping, K_v, ")) << one;
}

TEST_F(Terminal, a_single_device_shows_the_line_of_the_lot_that_fails) {
  auto const o = isolaw(Words{"inspect", "lot/D1.csv"} + held_to("K_eff=0.7,disp=100") + Words{"--lot-size", "20"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "fail          sample size                1 devices, limit 4 or more of 20")) << o;
}

TEST_F(Terminal, a_signed_set_without_comparable_values_assesses_nothing) {
  write("mine.toml",
        "id = \"mine\"\ntitle = \"Contract\"\nedition = \"1\"\nsource = \"none\"\nverified_by = \"me\"\n"
        "[formulas]\nstiffness = \"peak_to_peak\"\ndamping = \"peak_to_peak\"\n"
        "[cycles]\none = 3\n"
        "[test]\nfrequencies_Hz = [5.0]\nfrequency_tolerance_percent = 1.0\n"
        "[[limit]]\nquantity = \"K_eff\"\napplies_to = \"each\"\nwithin_percent = 20\nclause = \"1\"\n");
  auto const o =
      isolaw({"inspect", "lot", "--rules", "mine.toml", "--design", "K_eff=0.7,Q_d=20,disp=100", "--lot-size", "2"});
  EXPECT_EQ(o.err, "") << o;
  EXPECT_EQ(count_of("not assessed\n", o.out), 2u) << o;
  EXPECT_FALSE(contains(o.out, "information\n")) << o;
}

// The verdict on a lot holds for one condition. Temperatures of 20 and 21 °C count as one condition, 20 and -10 °C do
// not.
TEST_F(Terminal, tests_under_different_conditions_give_the_lot_no_verdict) {
  auto const said = [&](int temperature_C, std::string const& alike = {}) {
    write("lot.toml", fmt::format("[acceptance]\n{}\n[[device]]\nfile = 'lot/D1.csv'\ntemperature-C = 20\n"
                                  "[[device]]\nfile = 'lot/D2.csv'\ntemperature-C = {}\n",
                                  alike, temperature_C));
    return isolaw(Words{"inspect", "lot.toml"} + held_to("K_eff=0.8,disp=100") + Words{"--lot-size", "2"}).out;
  };
  EXPECT_TRUE(contains(said(-10),
                       "The devices were tested under different conditions; temperature -10 to 20 °C (alike within 2 "
                       "°C). Tolerances: isolaw's own."));
  EXPECT_TRUE(contains(said(-10), "one condition for all tests"));
  EXPECT_FALSE(contains(said(21), "different conditions"));
  EXPECT_FALSE(contains(said(-10, "alike-temperature-C = 30"), "different conditions"));
  EXPECT_TRUE(contains(said(21, "alike-temperature-C = 0.5"), "(alike within 0.5 °C). Tolerances: as stated for this"));
  expect_refused(isolaw({"inspect", "lot.toml", "--alike-temperature-C", "-1"}),
                 {"--alike-temperature-C", "0 to 1000"});
}

TEST_F(Terminal, a_temperature_in_the_header_counts) {
  write("lot/D1.csv", "Temperature: 40 °C\n" + csv(record()));
  write("lot/D2.csv", "Temperature: 0 °C\n" + csv(record({.stiffness_kN_per_mm = 0.52})));
  auto const o = isolaw(Words{"inspect", "lot"} + held_to("K_eff=0.7,disp=100") + Words{"--lot-size", "2"});
  EXPECT_TRUE(contains(o.out, "different conditions; temperature 0 to 40 °C")) << o;
}

TEST_F(Terminal, calibrate_and_report_end_with_the_verdict) {
  Words const quick{"--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1"};
  auto const o = isolaw(Words{"calibrate", "lot", "--out", "O"} + quick + held_to("K_eff=0.72,disp=100") +
                        Words{"--lot-size", "2"});
  EXPECT_EQ(o.code, 1) << o;
  auto const line =
      "FAIL: NTC 2018: 1 of 2 devices fails: D2 K_eff +25.0 %; pass on 1 of 6 requirements; not assessed: ";
  EXPECT_TRUE(contains(o.out, line)) << o;
  EXPECT_TRUE(contains(isolaw({"report", "O"}).out, line));
  EXPECT_TRUE(contains(isolaw({"report", "O", "--rules", "asce-7-22"}).out,
                       "ASCE/SEI 7-22: no verdict, the limits of this set are not verified"));
  EXPECT_EQ(Json::parse(isolaw({"report", "O", "--json"}).out)["devices"].size(), 2u);
}

// A result is INCOMPLETE and not a pass if one of the requirements is not assessed.
TEST_F(Terminal, an_inspection_says_pass_fail_or_incomplete_first_everywhere) {
  write("mine.toml",
        "id = \"mine\"\ntitle = \"Contract\"\nedition = \"1\"\nsource = \"none\"\nverified_by = \"me\"\n"
        "[formulas]\nstiffness = \"peak_to_peak\"\ndamping = \"peak_to_peak\"\n[cycles]\none = 3\n"
        "[[limit]]\nquantity = \"K_eff\"\napplies_to = \"each\"\nwithin_percent = 20\n"
        "[[limit]]\nquantity = \"K_v\"\napplies_to = \"each\"\nlower_percent = -30\n");
  auto const found = [&](std::string const& design, std::string const& first, int code) {
    auto const o = isolaw(Words{"inspect", "lot", "--rules", "mine.toml", "--design", design, "--out", "I"});
    EXPECT_EQ(o.code, code) << o;
    EXPECT_TRUE(o.out.starts_with(first)) << o;
    auto const file = json("I/inspection.json");
    EXPECT_TRUE(first.starts_with(file["result"]["word"].get<std::string>() + ": ")) << file["result"];
    auto const page = page_data(read("I/inspection.html"));
    EXPECT_EQ(page["result"], file["result"]);
    return file;
  };
  auto const open = found("K_eff=0.8", "INCOMPLETE: Contract: pass on 1 of 2 requirements; not assessed: K_v\n", 0);
  EXPECT_EQ(open["result"]["mark"], "INCOMPLETE");
  EXPECT_EQ(open["result"]["requirements"],
            Json::parse(R"([{"name": "K_eff", "verdict": "pass"}, {"name": "K_v", "verdict": "not assessed"}])"));
  for (auto const& device : open["devices"]) {
    EXPECT_EQ(device["verdict_brief"], "pass on 1 of 2");
    EXPECT_EQ(device["verdict_text"], "pass on 1 of 2 (K_eff; not assessed: K_v)");
  }
  auto const failing = found("K_eff=0.72", "FAIL: Contract: 1 of 2 devices fails: D2 K_eff +25.0 %; pass on 0 of 2", 1);
  EXPECT_EQ(failing["result"]["failing"], Json::parse(R"([{"device": "D2", "remark": "K_eff +25.0 %"}])"));
  auto const none = isolaw({"inspect", "lot", "--json"});
  EXPECT_TRUE(Json::parse(none.out)["result"]["word"].is_null());
  EXPECT_TRUE(isolaw({"inspect", "lot"}).out.starts_with("No verdict: no rule set\n"));
  auto const one = isolaw({"inspect", "lot/D1.csv", "--rules", "mine.toml", "--design", "K_eff=0.8"});
  EXPECT_TRUE(one.out.starts_with("INCOMPLETE: Contract: ")) << one;
}

// twin.csv is a copy of D1.csv, not the test of a third device. It must get no verdict and must not count as tested.
TEST_F(Terminal, a_copy_of_a_record_has_no_verdict_of_its_own_and_is_no_further_device_tested) {
  fs::copy_file(path("lot/D1.csv"), path("lot/twin.csv"));
  auto const o =
      isolaw(Words{"inspect", "lot", "--out", "I"} + held_to("K_eff=0.8,disp=100") + Words{"--lot-size", "3"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "  not assessed: the same record as D1\n")) << o;
  EXPECT_TRUE(contains(o.out, "fail          sample size                2 devices, limit 3 or more of 3")) << o;
  // The words stand in the line of the device and in the warning on the lot.
  EXPECT_EQ(count_of("the same record", o.out), 2u) << o;
  auto const file = json("I/inspection.json"), page = page_data(read("I/inspection.html"));
  for (auto const* found : {&file, &page}) {
    auto const& devices = (*found)["devices"];
    EXPECT_EQ(devices[2]["copy_of"], "D1");
    EXPECT_EQ(devices[2]["verdict"], "not assessed");
    EXPECT_EQ(devices[2]["verdict_text"], "not assessed: the same record as D1");
    for (auto const& line : devices[2]["assessments"]) EXPECT_NE(line["verdict"], "pass") << line;
    EXPECT_EQ(devices[0]["findings"][0]["devices"], Json::parse(R"(["D1", "twin"])"));
    EXPECT_EQ(devices[1]["warnings"], Json::array());
    EXPECT_EQ(devices[2]["findings"][0]["kind"], "same-record");
    EXPECT_EQ((*found)["assessment"]["lot"]["tested"], 2);
  }
  EXPECT_EQ(file["result"]["not_assessed"], Json::parse(R"([{"device": "twin", "remark": "the same record as D1"}])"));
  std::istringstream tests(read("I/tables/tests.csv"));
  for (std::string line; std::getline(tests, line);)
    EXPECT_FALSE(line.starts_with("twin") && contains(line, "pass")) << line;
}

TEST_F(Terminal, a_refused_device_leaves_an_inspection_incomplete) {
  write("lot/D3.csv", "time [s],disp [mm],force [kN]\n0,1,2\n1,1,2\n2,1,2\n");
  auto const o = isolaw(Words{"inspect", "lot"} + held_to("K_eff=0.8,disp=100"));
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(o.out.starts_with("INCOMPLETE: ")) << o;
  EXPECT_TRUE(contains(o.out.substr(0, o.out.find('\n')), "without a verdict: D3")) << o;
}

TEST_F(Terminal, design_values_without_a_rule_set_are_asked_about) {
  auto const o = isolaw({"inspect", "lot/D1.csv", "--design", "K_eff=0.8"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(
      o.err,
      "design values K_eff=0.8: without a rule set no device is checked against them; try: --rules NAME, one of "))
      << o;
  EXPECT_TRUE(contains(o.err, "ntc-2018")) << o;
  EXPECT_EQ(isolaw(Words{"inspect", "lot/D1.csv"} + held_to("K_eff=0.8,disp=100")).err, "");
}

TEST_F(Terminal, the_example_lot_is_marked_as_not_measured) {
  ASSERT_EQ(isolaw({"example", "E"}).code, 0);
  auto const o = isolaw(Words{"inspect", "E/lot.toml", "--json"} + held_to("K_eff=0.62,damping=19.5,disp=208"));
  EXPECT_EQ(Json::parse(o.out)["result"]["mark"], "NOT MEASURED");
}

TEST_F(Terminal, a_damping_below_one_percent_is_asked_about) {
  auto const said = isolaw(Words{"inspect", "lot/D1.csv"} + held_to("damping=0.127")).err;
  EXPECT_TRUE(contains(said, "--design damping=0.127: damping is in percent"));
  EXPECT_TRUE(contains(said, "try: damping=12.7"));
  EXPECT_EQ(isolaw(Words{"inspect", "lot/D1.csv"} + held_to("damping=12.7")).err, "");
}

TEST_F(Terminal, a_lot_file_in_a_directory_of_records_is_named_not_used) {
  EXPECT_EQ(isolaw({"inspect", "lot"}).err, "");
  write("lot/lot.toml", "[[device]]\nname = \"mine\"\nfile = \"D1.csv\"\n");
  auto const o = isolaw({"inspect", "lot"});
  EXPECT_TRUE(
      contains(o.err, "lot holds a lot file, which is not used: its records are read as they are; try: lot/lot.toml"));
  EXPECT_TRUE(contains(o.out, "lot: 2 devices"));
  EXPECT_EQ(isolaw({"inspect", "lot/lot.toml"}).err, "");
}

// Except for rounding, the displacement of this record is never negative. No cycle may be printed with -0, with tiny
// numbers such as 1e-13, or with nine digits in a row.
TEST_F(Terminal, partial_and_one_sided_cycles_print_bounded_numbers) {
  auto samples = record({.samples = 701});
  for (auto& s : samples) s.disp_mm = 0.5 * (1e-13 - s.disp_mm + 100.0), s.force_kN = 0.5 * (-s.force_kN + 70.0);
  write("side.csv", csv(samples, header, [](std::size_t, Sample const& s) {
          return fmt::format("{:.4f},{:.17g},{:.17g}", s.time_s, s.disp_mm, s.force_kN);
        }));
  auto const o = isolaw({"inspect", "side.csv"});
  EXPECT_EQ(o.code, 0) << o;
  auto const blocks = o.out.substr(o.out.find("Block 1"));
  EXPECT_FALSE(contains(blocks, "-0 mm")) << blocks;
  EXPECT_FALSE(contains(blocks, "e-1")) << blocks;
  for (std::size_t digits = 0, i = 0; i < blocks.size(); ++i) {
    digits = blocks[i] >= '0' && blocks[i] <= '9' ? digits + 1 : 0;
    ASSERT_LT(digits, 9u) << blocks;
  }
  EXPECT_TRUE(contains(blocks, "         - ")) << blocks;  // the cell of K- is empty
  for (auto const& cycle : Json::parse(isolaw({"inspect", "side.csv", "--json"}).out)["blocks"][0]["cycles"])
    EXPECT_TRUE(cycle["K_minus_kN_per_mm"].is_null()) << cycle;
}

// A spreadsheet would read a cell such as "+20 %" as a formula, unless an apostrophe stood in front. Limits therefore
// begin with a word.
TEST_F(Terminal, limits_of_the_tables_begin_with_a_word) {
  isolaw(Words{"inspect", "lot", "--out", "I"} + held_to("K_eff=0.7,damping=10,disp=100"));
  auto const table = read("I/tables/tests.csv");
  EXPECT_TRUE(contains(table, ",from -20 % to +20 %,")) << table;
  EXPECT_FALSE(contains(table, "'")) << table;
}

TEST_F(Terminal, blocks_of_a_history_without_cycles_cannot_be_chosen) {
  auto samples = record();
  for (auto& s : samples) s.disp_mm = s.time_s * 10.0, s.force_kN = 5.0 * s.time_s + std::sin(s.time_s);
  write("pull.csv", csv(samples));
  for (auto const* block : {"1", "2"}) {
    auto const o = isolaw({"calibrate", "pull.csv", "--out", "P", "--laws", "bilinear", "--runs", "1", "--population",
                           "4", "--generations", "1", "--fit-blocks", block});
    EXPECT_NE(o.code, 0) << o;
    EXPECT_TRUE(contains(o.err, "it has no cycles to choose among")) << o;
  }
}

}  // namespace
}  // namespace isolaw::cli_test
