// Tests `isolaw conditions` on its example, whose records follow closed formulas, and on lot files with mistakes.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

class Conditions : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    ASSERT_EQ(isolaw({"example", "ex", "--conditions"}).code, 0);
  }
  // Runs `isolaw conditions` on the lot file of the example, in which `by` replaces `part`.
  Outcome with(std::string const& part, std::string const& by, Words const& more = {}) {
    auto text = read("ex/lot.toml");
    auto const at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    write("ex/changed.toml", text.replace(at, part.size(), by));
    return isolaw(Words{"conditions", "ex/changed.toml"} + more);
  }
  // Replaces the design conditions in the text of a lot file by a range of frequencies alone.
  static std::string only_rate(std::string text, std::string_view range_Hz = "[0.35, 0.65]") {
    auto const begin = text.find("design = { temperature-C");
    return text.replace(begin, text.find('\n', begin) - begin,
                        fmt::format("design = {{ frequency-Hz = {} }}", range_Hz));
  }
  static void near(Json const& value, double wanted, double relative) {
    EXPECT_NEAR(value.get<double>(), wanted, relative * std::abs(wanted));
  }
  static Json find(Json const& rows, std::string const& quantity, std::string const& effect,
                   std::string const& level = "") {
    for (auto const& row : rows)
      if (row["quantity"] == quantity && (effect.empty() || row["effect"] == effect) &&
          (level.empty() || row["level"] == level))
        return row;
    ADD_FAILURE() << quantity << ' ' << effect << ' ' << level;
    return {};
  }
};

TEST_F(Conditions, of_the_example_are_those_of_its_formulas) {
  auto const o = isolaw({"conditions", "ex/lot.toml", "--json", "--out", "C"});
  ASSERT_EQ(o.code, 1) << o;  // one limit of the rule set is not kept
  EXPECT_EQ(read("C/conditions.json"), o.out);
  auto const j = Json::parse(o.out);
  EXPECT_EQ(j["tests"].size(), 26u);
  EXPECT_TRUE(j["refused"].empty());
  constexpr double stiffness = 1e-8, energy = 2e-4;
  auto const cold = find(j["levels"], "K_eff", "temperature", "-20 C");
  near(cold["factor"]["lambda"], 1.313436434, stiffness);
  near(cold["factor"]["mean"]["low"], 1.291890605, 1e-7);
  near(cold["factor"]["device"]["high"], 1.357612093, 1e-7);
  near(cold["factor"]["system"]["low"], 1.293068286, 1e-7);
  ASSERT_EQ(cold["ratios"].size(), 3u);
  EXPECT_EQ(cold["ratios"][1]["device"], "P2");
  near(cold["ratios"][1]["lambda"], 0.874677545 / 0.662182831, stiffness);
  EXPECT_EQ(cold["factor"]["status"], "shown");
  near(find(j["levels"], "K_eff", "rate", "2 Hz")["factor"]["lambda"], 1.067708704, stiffness);
  near(find(j["levels"], "K_eff", "load", "4000 kN")["factor"]["lambda"], 0.811377958, stiffness);
  near(find(j["levels"], "damping", "ageing", "14 days at 70 C")["factor"]["lambda"], 0.890483635, energy);
  auto const scragging = find(j["levels"], "K_eff", "scragging")["factor"];
  near(scragging["lambda"], 1.294167673, stiffness);
  EXPECT_EQ(scragging["devices"], 5);
  near(find(j["levels"], "energy", "scragging")["factor"]["lambda"], 1.286876661, 1e-3);
  near(find(j["levels"], "K_eff", "cycles")["factor"]["lambda"], 0.917871090, stiffness);
  near(find(j["design"], "K_eff", "temperature")["max"]["lambda"], 1.269113038, stiffness);
  near(find(j["design"], "K_eff", "temperature")["min"]["lambda"], 0.848178179, stiffness);
  for (auto const& row : j["dependence"])
    if (row["load_variation"] == true) near(row["devices"][0]["ratio"], 1.12574803, stiffness);
  auto const bounds = find(j["bounds"], "K_eff", "");
  near(bounds["max"]["factor"], 1.869155861, stiffness);
  EXPECT_EQ(bounds["max"]["status"], "interpolated");
  EXPECT_EQ(bounds["max"]["share_shown"], 1.0);
  EXPECT_TRUE(bounds["max"]["interval"].is_null());
  near(bounds["min"]["factor"], 0.705430235, stiffness);
  EXPECT_EQ(bounds["min"]["status"], "extrapolated");
  near(bounds["min"]["share_shown"], 0.528110688, 1e-7);
  near(find(j["bounds"], "energy", "")["max"]["factor"], 1.859391152, 1e-3);
  near(find(j["bounds"], "energy", "")["min"]["factor"], 0.665827352, 1e-3);
  ASSERT_EQ(j["recovery"].size(), 3u);
  near(j["recovery"][0]["share"], 0.109861229, 1e-6);
  near(j["recovery"][2]["share"], 0.582008293, 1e-6);
  // Drift of the properties can be checked only on devices with a second reference test. P4 and P5 have one, but the
  // devices that show the effect of temperature have none.
  EXPECT_EQ(j["drift_not_checked"], Json({"temperature"}));
  EXPECT_EQ(j["straightness_not_checked"], Json::array());
  near(j["tests"][0]["heating_K"], 0.169213 * std::exp(0.03 + 0.002), 1e-3);
  for (auto const& test : j["tests"])
    if (test["device"] == "P6") {
      near(test["K_eff_kN_per_mm"], 0.603681447, stiffness);
      EXPECT_EQ(test["role"], "combined");
    }
}

// The page makes its table of tests from the keys that `isolaw test-keys` lists. A lot file must accept each of them.
TEST_F(Conditions, have_keys_that_are_listed_for_the_page) {
  auto const listed = Json::parse(isolaw({"test-keys", "P1_T-20C_2000kN_aged.csv", "device-01.csv"}).out);
  std::vector<std::string> found;
  for (auto const& row : listed["test"]) found.push_back(row["key"]);
  for (auto const* key : {"order", "started", "temperature-C", "temperature-of", "load-kN", "rest-h", "conditioned-h",
                          "stands-for", "fit", "specimen", "scale"})
    EXPECT_TRUE(std::ranges::find(found, key) != found.end()) << key;
  auto const& temperature = listed["test"][1];
  EXPECT_EQ(temperature["label"], "Temperature");
  EXPECT_EQ(temperature["unit"], "°C");
  EXPECT_EQ(temperature["kind"], "number");
  EXPECT_TRUE(contains(temperature["help"].get<std::string>(), "-100 to 200"));
  EXPECT_EQ(listed["aged"].size(), 2U);
  EXPECT_EQ(listed["proposed"].dump(), R"([{"device":"P1","temperature-C":-20.0,"load-kN":2000.0,"aged":true},)"
                                       R"({"device":"device-01","temperature-C":null,"load-kN":null,"aged":false}])");
}

// `init` proposes the tests of devices in comments. If a person removes the devices that `init` wrote and uncomments
// the proposal, the lot file gives the factors of the example's closed formulas.
TEST_F(Conditions, are_proposed_by_init_from_the_names) {
  Words files;
  for (auto const* name :
       {"P1--20C", "P1-0C", "P1-20C", "P1-40C", "P2--20C", "P2-20C", "P3--20C", "P3-20C", "P4-3000kN", "P4-aged"})
    files.push_back(fmt::format("ex/{}.csv", name));
  auto const o = isolaw(Words{"init", "--out", "ex/new.toml"} + files);
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "new.toml ends with a proposal, as comments to be checked")) << o;
  auto const written = read("ex/new.toml");
  // In the proposal, the test at the reference comes first. Lines that a person must fill in are commented out twice.
  EXPECT_TRUE(contains(written, "# name = 'P2-20C'\n# order = 1\n")) << written;
  EXPECT_TRUE(contains(written, "# name = 'P2--20C'\n# order = 2\n")) << written;
  EXPECT_TRUE(contains(written, "\n# # rest-h = 0.0"));
  EXPECT_TRUE(contains(written, "\n# # design = { "));
  ASSERT_EQ(isolaw({"inspect", "ex/new.toml"}).code, 0);
  auto const first = written.find("\n[[device]]"), proposal = written.find("# [conditions]");
  ASSERT_LT(first, proposal) << written;
  ASSERT_NE(proposal, std::string::npos) << written;
  std::string text = written.substr(0, first + 1);
  std::istringstream lines(written.substr(proposal));
  for (std::string line; std::getline(lines, line);) text += (line.starts_with("# ") ? line.substr(2) : line) + '\n';
  write("ex/new.toml", text);
  auto const read_back = isolaw({"conditions", "ex/new.toml", "--json"});
  ASSERT_EQ(read_back.code, 1) << read_back << text;  // a test of P4 is refused, because it states no temperature
  auto const j = Json::parse(read_back.out);
  auto const cold = find(j["levels"], "K_eff", "temperature", "-20 C")["factor"];
  EXPECT_EQ(cold["devices"], 3);
  near(cold["lambda"], 1.313436434, 1e-8);
  EXPECT_EQ(j["tests"].size(), 8u);
  ASSERT_EQ(j["refused"].size(), 1u) << j["refused"];
  EXPECT_EQ(j["refused"][0]["device"], "P4");
  EXPECT_TRUE(contains(j["refused"][0]["reason"].get<std::string>(), "no temperature is stated"));
  EXPECT_TRUE(contains(text, "# aged = { days = 0.0, at-C = 0.0 }")) << text;
}

// Nothing is proposed if the names of files state no condition, or if each name belongs to another device.
TEST_F(Conditions, are_not_proposed_from_other_names) {
  write("ex/A.csv", read("ex/P1-20C.csv"));
  write("ex/A-2.csv", read("ex/P2-20C.csv"));
  ASSERT_EQ(isolaw({"init", "ex/A.csv", "ex/A-2.csv", "ex/P3-20C.csv", "--out", "ex/new.toml"}).code, 0);
  EXPECT_FALSE(contains(read("ex/new.toml"), "conditions"));
}

// If the reference is cycles 1 to 3, its value is the mean over these cycles.
TEST_F(Conditions, of_a_mean_of_cycles) {
  auto text = read("ex/lot.toml");
  auto const at = text.find("cycle = 3 }");
  ASSERT_NE(at, std::string::npos);
  write("ex/mean.toml", text.replace(at, 9, "cycle = \"1-3\""));
  auto const j = Json::parse(isolaw({"conditions", "ex/mean.toml", "--json"}).out);
  near(find(j["levels"], "K_eff", "scragging")["factor"]["lambda"], 1.154984254, 1e-8);
  near(find(j["levels"], "K_eff", "cycles")["factor"]["lambda"], 0.819157114, 1e-8);
}

TEST_F(Conditions, are_written_as_tables_and_figures) {
  write("C/figures/mine.gp", "# not isolaw's\n");
  auto const o = isolaw({"conditions", "ex/lot.toml", "--out", "C"});
  ASSERT_EQ(o.code, 1) << o;  // one limit of the rule set is not kept
  auto const lines = [&](std::string const& file) {
    std::vector<std::string> all;
    std::istringstream text(read(file));
    for (std::string line; std::getline(text, line);) all.push_back(line);
    return all;
  };
  auto const has = [](std::vector<std::string> const& all, std::string const& start) {
    return std::ranges::any_of(all, [&](auto const& line) { return line.starts_with(start); });
  };
  auto const factors = lines("C/tables/conditions.csv");
  EXPECT_TRUE(has(factors, "property,effect,level,at,unit,aged [d],at [C],factor [-],status,devices")) << factors[0];
  EXPECT_TRUE(has(factors, "K_eff,temperature,-20 C,-20,C,,,1.31344,shown,3,0,0,1.29189,1.33534,1.2707,1.35761,"));
  EXPECT_TRUE(has(factors, "K_eff,ageing,14 days at 70 C,,,14,70,1.07339,shown,1,"));
  EXPECT_TRUE(has(factors, "K_eff,temperature,smallest over the design,,,,,0.848178,extrapolated,3,0.0018003,"));
  EXPECT_TRUE(has(factors, "K_eff,all together,largest over the design,,,,,1.86916,interpolated,"));
  // 25 tests have five cycles and one has ten.
  auto const cycles = lines("C/tables/observations.csv");
  EXPECT_EQ(cycles.size(), 1u + 25 * 5 + 10);
  EXPECT_TRUE(has(cycles, "P5,ten-cycles,1,1,20,0.5,2000,100,,,,reference,,10,scragged,0.62194,"));
  EXPECT_TRUE(contains(read("C/tables/conditions.tex"), "temperature & 1.269 (1.254 to 1.285) & interpolated & 0.848"));
  // The logarithm of the mean factor is a straight line over the square of the load. This is the point of the curve at
  // 1500 kN, half way between 1000 kN and the reference.
  auto const of_figure = lines("C/figures/conditions.dat");
  auto const middle = std::ranges::find_if(of_figure, [](auto const& line) { return line.starts_with("1500 "); });
  ASSERT_NE(middle, of_figure.end());
  EXPECT_NEAR(std::stod(middle->substr(5)), std::pow(1.047155510, (4.0 - 2.25) / (4.0 - 1.0)), 1e-8);
  EXPECT_TRUE(contains(read("C/figures/factors.dat"), "\"temperature\" 1.26911"));
  EXPECT_TRUE(contains(read("C/figures/mine.gp"), "not isolaw's"));
  write("C/figures/front.gp", "# A figure of isolaw: of a campaign in the same directory\n");
  EXPECT_EQ(isolaw({"conditions", "ex/lot.toml", "--out", "C"}).code, 1);
  EXPECT_TRUE(contains(read("C/figures/front.gp"), "of a campaign"));
}

// The interval of an interpolated bound includes the drift of the properties and the error of the straight line between
// the tests. All outputs must show the same interval.
TEST_F(Conditions, have_one_interval_of_a_bound_in_all_outputs) {
  auto text = read("ex/lot.toml");
  auto const begin = text.find("design = { temperature-C");
  write("ex/changed.toml",
        text.replace(begin, text.find('\n', begin) - begin, "design = { temperature-C = [-15, 45] }"));
  auto const o = isolaw({"conditions", "ex/changed.toml", "--out", "C"});
  ASSERT_LE(o.code, 1) << o;
  auto const bound = Json::parse(read("C/conditions.json"))["bounds"][0];
  double const factor = bound["max"]["factor"], low = bound["max"]["interval"]["low"],
               high = bound["max"]["interval"]["high"];
  EXPECT_LT(low, factor);
  EXPECT_TRUE(
      contains(read("C/tables/conditions.csv"),
               fmt::format("K_eff,all together,largest over the design,,,,,{:.6g},interpolated,,,,{:.6g},{:.6g},",
                           factor, low, high)));
  EXPECT_TRUE(
      contains(read("C/tables/conditions.tex"),
               fmt::format(" & all together & {:.3f} ({:.3f} to {:.3f}) & interpolated & ", factor, low, high)));
  EXPECT_TRUE(contains(o.out, fmt::format("upper  {:.3f} ({:.3f} to {:.3f}, 95 %), interpolated", factor, low, high)));
  double const value = bound["value_at_reference"];
  EXPECT_EQ(bound["devices"], 5);
  EXPECT_TRUE(contains(o.out, fmt::format("at reference {:.4g} kN/mm, mean of 5 devices: {:.4g} to {:.4g} kN/mm", value,
                                          value * bound["min"]["factor"].get<double>(), value * factor)))
      << o;
}

TEST_F(Conditions, show_the_part_of_an_effect_that_tests_cover) {
  auto const o = with("temperature-C = [-15, 45]", "temperature-C = [-35, 45]", {"--out", "C"});
  EXPECT_TRUE(contains(o.out, "upper  at least ")) << o;
  EXPECT_TRUE(contains(o.out, "temperature   >1.313  NOT COVERED")) << o;
  EXPECT_TRUE(contains(read("C/tables/conditions.tex"), " & all together & at least "));
}

TEST_F(Conditions, as_text_begin_with_the_bounds) {
  auto const o = isolaw({"conditions", "ex/lot.toml", "--details"});
  ASSERT_LE(o.code, 1) << o;
  for (auto const* part :
       {"upper  1.869", "lower  0.705", "extrapolated on 3 devices", "1.313", "as stated, not measured", "combined"})
    EXPECT_TRUE(contains(o.out, part)) << part << o;
}

TEST_F(Conditions, without_details_leave_the_tests_out) {
  auto const o = isolaw({"conditions", "ex/lot.toml"});
  EXPECT_TRUE(contains(o.out, "No effect is shown by 1 test")) << o;
  EXPECT_TRUE(contains(o.out, "P6 acceptance")) << o;
  EXPECT_FALSE(contains(o.out, "combined")) << o;
  EXPECT_TRUE(contains(o.out, "no interval, because rate, load, ageing, cycles have none")) << o;
}

TEST_F(Conditions, that_no_test_covers_leave_the_bound_open) {
  auto const o = with("temperature-C = [-15, 45]", "temperature-C = [-35, 45]");
  EXPECT_EQ(o.code, 0) << o;
  // The factors of all other effects have the product 1.473. The factor at the coldest test is 1.313. Multiplied, they
  // give 1.934, the least that the bound can be.
  EXPECT_TRUE(contains(o.out, "at least 1.934, NOT COVERED: temperature")) << o;
  auto const years = with("aged = { days = 14, at-C = 70 } }", "years = 60, service-temperature-C = 20 }");
  EXPECT_TRUE(contains(years.out, "NOT COVERED: ageing")) << years;
}

// Commands other than `conditions` use a single record of each device: that of the acceptance test or, if none is
// named, of the first test at the reference temperature.
TEST_F(Conditions, leave_one_record_for_each_device_to_other_commands) {
  auto const o = isolaw({"inspect", "ex/lot.toml", "--json"});
  auto const j = Json::parse(o.out);
  ASSERT_EQ(j["devices"].size(), 6u);
  EXPECT_EQ(j["devices"][0]["file"], "P1-20C.csv");
  EXPECT_EQ(j["devices"][4]["file"], "P5-ten-cycles.csv");
  EXPECT_EQ(j["devices"][5]["file"], "P6-acceptance.csv");
}

TEST_F(Conditions, are_refused_with_the_line_and_what_is_allowed) {
  struct Case {
    char const *part, *by, *said;
  };
  for (auto const& [part, by, said] : {
           Case{"temperature-C = 20, frequency-Hz = 0.5,", "frequency-Hz = 0.5,", "a reference without a temperature"},
           Case{"cycle = 3", "cycle = \"3-1\"", "a number of a cycle from 1"},
           Case{"cycle = 3", "cycle = 3, cycles = 4", "cycles"},
           Case{"temperature-C = [-15, 45]", "temperature-C = [45, -15]",
                "temperature-C in design is [ 45, -15 ], and that is no range"},
           Case{"rest = \"full\"", "rest = \"long\"", "\"full\", or hours above 0"},
           Case{"rest = \"full\"", "years = 50", "years"},
           Case{"at-C = 70 } }", "at-C = 170 } }", "0 to 100"},
           Case{"order = 2", "order = 1", "the order of another test"},
           Case{"order = 2\n", "", "a test without its order"},
           Case{"order = 2\n", "order = 2\naged = { days = 14 }\n", "days or at-C is missing"},
           Case{"order = 2\n", "order = 2\naged = {}\n", "days or at-C is missing"},
           Case{"order = 2\n", "order = 2\naged = { days = 0, at-C = 70 }\n", "above 0"},
           Case{"order = 2\n", "order = 2\ntemperature-of = \"skin\"\n", "core, surface, chamber"},
           Case{"rest-h = 24", "rest-h = -1", "0 or more"},
           Case{"[conditions]", "[conditions]\nactivation-energy-kJ-mol = 90\n",
                "activation energy without its source"},
       }) {
    auto const o = with(part, by);
    EXPECT_EQ(o.code, 2) << part << " -> " << by << o;
    EXPECT_TRUE(contains(o.err, said)) << said << o;
    EXPECT_TRUE(contains(o.err, "changed.toml:")) << o;
  }
  auto const unknown = with("[conditions]\n", "[conditions]\nrules = \"ntc2018\"\n");
  EXPECT_TRUE(contains(unknown.err, "allowed: aashto, asce-7-22, en-15129, ")) << unknown;
  EXPECT_TRUE(contains(unknown.err, "try: ntc-2018")) << unknown;
  auto const devices = isolaw({"conditions", "ex/lot.toml", "--plan", "--devices", "0"});
  EXPECT_TRUE(contains(devices.err, "1 to 100")) << devices;
  auto const check = isolaw({"check", "ex/lot.toml"});
  EXPECT_EQ(check.code, 2) << check;
  EXPECT_TRUE(contains(check.err, "isolaw conditions ex/lot.toml")) << check;
  auto const without = isolaw({"conditions", "ex/P1-20C.csv"});
  EXPECT_EQ(without.code, 2) << without;
}

TEST_F(Conditions, have_one_complaint_about_one_mistake) {
  for (auto const& [part, by, said] : std::initializer_list<std::array<char const*, 3>>{
           {"order = 2\n", "order = \"2026-03-01\"\n", "order: "},
           {"order = 2\n", "started = \"2026-03-01\"\n", "a date with a time of day"},
           {"[conditions]", "[condition]", "unknown key 'condition'"},
           {"[conditions]\n", "[conditions]\nrules = \"ntc2018\"\n", "rules: no built-in rule set 'ntc2018'"},
           {"name = \"P1\"", "name = \"P1\"\nsize = 600", "size"},
       }) {
    auto const o = with(part, by);
    EXPECT_EQ(o.code, 2) << o;
    EXPECT_EQ(count_of("isolaw: ", o.err), 1u) << o;
    EXPECT_TRUE(contains(o.err, "isolaw: ex/changed.toml:")) << o;
    EXPECT_TRUE(contains(o.err, said)) << said << o;
  }
}

// If tests state conditions but the file has no table [conditions], a single complaint names the missing table, however
// many tests there are.
TEST_F(Conditions, need_their_table) {
  auto const o = with("[conditions]", "[no-conditions]");
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_EQ(count_of("the file has no table [conditions]", o.err), 1u) << o;
}

TEST_F(Conditions, of_the_example_raise_no_doubt_about_a_record) {
  EXPECT_FALSE(contains(isolaw({"conditions", "ex/lot.toml"}).out, "The test "));
}

// A condition that the reference leaves out must be the same in all tests.
TEST_F(Conditions, that_the_reference_leaves_out_must_agree) {
  auto const o = with(" load-kN = 2000,", "");
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(contains(o.err, "load-kN is not stated, and the tests differ in it")) << o;
  auto const none = with("temperature-C = 20, frequency-Hz", "temperature-C = 70, frequency-Hz");
  EXPECT_EQ(none.code, 2) << none;
  EXPECT_TRUE(contains(none.err, "no test agrees with the reference")) << none;
}

// A test that cannot be read may have stretched the device to any strain. The first cycles of later tests then do not
// count as those of a new device. Two tests must not name the same file.
TEST_F(Conditions, of_refused_tests_count_as_history) {
  auto const missing = with("file = \"P1-20C.csv\"", "file = \"P1-none.csv\"", {"--json"});
  EXPECT_EQ(missing.code, 1) << missing;
  auto const j = Json::parse(missing.out);
  EXPECT_EQ(j["refused"].size(), 1u);
  for (auto const& test : j["tests"])
    if (test["device"] == "P1") {
      EXPECT_EQ(test["history"], "disturbed") << test;
      EXPECT_EQ(test["role"], "no reference test") << test;
    }
  auto const twice = with("file = \"P2-20C.csv\"", "file = \"P1-20C.csv\"");
  EXPECT_EQ(twice.code, 1) << twice;
  for (auto const* refused :
       {"warning: The test 20C of P2 (changed.toml:52) is not used: the record of this test is also "
        "that of the test 20C of P1",
        "is not used: the record of this test is also that of the test 20C of P2"})
    EXPECT_TRUE(contains(twice.out, refused)) << twice;
}

TEST_F(Conditions, name_a_test_that_cannot_be_used) {
  auto const o = with("rest-h = 24\n", "rest-h = 24\nload-kN = 2000\n");
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(
      o.out,
      "warning: The test -20C of P1 (changed.toml:26) is not used: load-kN is stated, and the record has a channel for the load"))
      << o;
}

// Table 11.9.IV of the Italian code limits the change of stiffness and damping to 20 %, and to 15 % between loads.
TEST_F(Conditions, are_held_to_the_limits_of_the_rule_set) {
  auto const o = isolaw({"conditions", "ex/lot.toml", "--json"});
  EXPECT_EQ(o.code, 1) << o;
  auto const j = Json::parse(o.out);
  auto const row = [&](std::string const& effect, std::string const& quantity, bool variation = false) {
    for (auto const& each : j["dependence"])
      if (each["effect"] == effect && each["quantity"] == quantity && each["load_variation"] == variation) return each;
    ADD_FAILURE() << effect << ' ' << quantity;
    return Json();
  };
  auto const cold = row("temperature", "K_eff");
  EXPECT_EQ(cold["verdict"], "fail");
  std::map<std::string, double> const wanted{{"P1", 1.268584351}, {"P2", 1.275580787}, {"P3", 1.263204308}};
  for (auto const& device : cold["devices"]) {
    if (device["at"] == -15.0) {
      EXPECT_EQ(device["verdict"], "fail");
      near(device["ratio"], wanted.at(device["device"]), 1e-7);
    } else {
      EXPECT_EQ(device["verdict"], "not assessed");
      EXPECT_EQ(device["reason"], "extrapolated");
    }
  }
  for (auto const* quantity : {"K_eff", "damping"}) EXPECT_EQ(row("ageing", quantity)["verdict"], "pass");
  near(row("ageing", "K_eff")["devices"][0]["ratio"], 1.073392673, 1e-7);
  auto const slow = row("rate", "K_eff");
  EXPECT_EQ(slow["verdict"], "pass");
  near(slow["devices"][0]["ratio"], 0.927280900, 1e-7);
  auto const loads = row("load", "K_eff", true);
  EXPECT_EQ(loads["verdict"], "pass");
  near(loads["devices"][0]["ratio"], 1.12574803, 1e-7);
  // The reference, whose factor is 1, may be either end of the range.
  for (auto const& [range, other, verdict] :
       {std::tuple{"[2000, 4000]", "4000 kN", "fail"}, {"[1000, 2000]", "1000 kN", "pass"}}) {
    auto const changed = Json::parse(with("load-kN = [1000, 3000]", std::string("load-kN = ") + range, {"--json"}).out);
    double const factor = find(changed["levels"], "K_eff", "load", other)["factor"]["lambda"];
    auto const& limits = changed["dependence"];
    auto const own = std::ranges::find_if(limits, [](Json const& each) { return each["load_variation"] == true; });
    ASSERT_NE(own, limits.end()) << range;
    EXPECT_EQ((*own)["verdict"], verdict) << range;
    near((*own)["devices"][0]["ratio"], 1.0 + std::abs(factor - 1.0), 1e-7);
  }
  auto const text = isolaw({"conditions", "ex/lot.toml"});
  EXPECT_TRUE(contains(text.out, "warning: K_eff under temperature: FAIL: ")) << text;
}

// If only the table [conditions] names a rule set, all commands must judge its limits in the same way.
TEST_F(Conditions, have_one_verdict_in_every_command) {
  auto text = read("ex/lot.toml");
  auto const move_rules = [&](std::string const& instead) {
    auto moved = text;
    std::string const rules = "rules = \"ntc-2018\"\n", table = "[conditions]\n";
    moved.replace(moved.find(rules), rules.size(), instead);
    return moved.insert(moved.find(table) + table.size(), rules);
  };
  write("ex/changed.toml", move_rules(""));
  EXPECT_EQ(isolaw({"conditions", "ex/changed.toml"}).code, 1);
  auto const inspected = isolaw({"inspect", "ex/changed.toml", "--json"});
  EXPECT_EQ(inspected.code, 1) << inspected;
  auto const result = Json::parse(inspected.out)["result"];
  EXPECT_EQ(result["word"], "FAIL");
  EXPECT_EQ(result["mark_is_red"], false);  // grey, because the example was computed, not measured
  ASSERT_EQ(result["failing"].size(), 1u) << result;
  EXPECT_EQ(result["failing"][0]["device"], "P2");
  EXPECT_EQ(result["failing"][0]["remark"], "K_eff under temperature +27.6 %, limit 20 % of ntc-2018");
  EXPECT_TRUE(contains(result["sentence"].get<std::string>(), "otherwise no verdict: no rule set")) << result;
  auto const calibrated = isolaw({"calibrate", "ex/changed.toml", "--out", "C", "--laws", "bilinear", "--runs", "1",
                                  "--figures", "none", "--replicates", "0"});
  EXPECT_EQ(calibrated.code, 1) << calibrated;
  EXPECT_TRUE(contains(calibrated.out, "FAIL: 1 of 6 devices fails: P2 K_eff under temperature +27.6 %")) << calibrated;
  // K_eff goes up to 1.869 times its value at reference.
  EXPECT_TRUE(contains(isolaw({"inspect", "ex/changed.toml"}).out, "mean properties alone is not permitted, because"));
  // A second rule set, in [acceptance], that has no verified limit must not change the verdict.
  write("ex/changed.toml", move_rules("rules = \"asce-7-22\"\n"));
  auto const other = isolaw({"inspect", "ex/changed.toml", "--json"});
  EXPECT_EQ(other.code, 1) << other;
  EXPECT_EQ(Json::parse(other.out)["result"]["failing"], result["failing"]);
  // This lot keeps all limits on the effects of conditions. isolaw must still give no verdict, because nothing else was
  // judged.
  write("ex/changed.toml", only_rate(move_rules("")));
  auto const kept = isolaw({"inspect", "ex/changed.toml", "--json"});
  EXPECT_EQ(kept.code, 0) << kept;
  EXPECT_EQ(Json::parse(kept.out)["result"]["word"], Json());
}

TEST_F(Conditions, that_are_refused_give_every_command_the_same_exit_code) {
  EXPECT_EQ(with("rest-h = 24\n", "rest-h = 24\nload-kN = 2000\n").code, 1);
  write("ex/changed.toml", only_rate(read("ex/changed.toml")));
  for (auto const* command : {"conditions", "inspect"}) EXPECT_EQ(isolaw({command, "ex/changed.toml"}).code, 1);
}

TEST_F(Conditions, of_a_set_that_nobody_verified_are_information) {
  auto rules = isolaw({"rules", "ntc-2018"}).out;
  auto const line = rules.find("verified_by = ");
  rules.replace(line, rules.find('\n', line) - line, "verified_by = \"\"");
  write("ex/copy.toml", rules);
  auto const o = with("rules = \"ntc-2018\"", "rules = \"copy.toml\"", {"--json"});
  EXPECT_EQ(o.code, 0) << o;
  for (auto const& row : Json::parse(o.out)["dependence"]) EXPECT_NE(row["verdict"], "fail");
}

// The design conditions in this lot file leave out ageing, which AASHTO's rule set asks for.
TEST_F(Conditions, that_rules_ask_for_are_not_covered_or_assumed) {
  write("ex/lot.toml", [&] {
    auto text = read("ex/lot.toml");
    std::string const aged = ", aged = { days = 14, at-C = 70 } }\n";
    auto const at = text.find(aged);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, aged.size(), " }\nrules = \"aashto\"\n");
  }());
  auto const open = isolaw({"conditions", "ex/lot.toml"});
  EXPECT_TRUE(contains(open.out, "upper  at least 1.741, NOT COVERED: ageing")) << open;
  EXPECT_TRUE(contains(open.out, "as aashto says (not verified)")) << open;
  EXPECT_TRUE(
      contains(open.out,
               "warning: The effect of ageing is NOT COVERED: the rule set asks for it, and the design states no "
               "range of it."))
      << open;
  auto const o = with("rules = \"aashto\"\n", "rules = \"aashto\"\nassume = [\"ageing\"]\n", {"--json"});
  ASSERT_LE(o.code, 1) << o;
  auto const j = Json::parse(o.out);
  auto const bound = find(j["bounds"], "K_eff", "")["max"];
  near(bound["factor"], 1.869155861 / 1.073392673 * 1.2, 1e-8);
  EXPECT_EQ(bound["status"], "assumed");
  EXPECT_EQ(bound["assumed"], Json({"ageing"}));
  EXPECT_EQ(find(j["design"], "K_eff", "ageing")["assumed"]["verified"], false);
  EXPECT_EQ(j["combination"]["form"], "each");
  auto const text = isolaw({"conditions", "ex/changed.toml"});
  EXPECT_TRUE(contains(text.out,
                       "warning: The effect of ageing on K_eff is ASSUMED: factors 1.200 and 1.000, the default of "
                       "aashto, as commonly quoted: ageing, high damping rubber, which nobody has verified."))
      << text;
}

TEST_F(Conditions, cannot_be_assumed_without_a_default) {
  auto const o = with("[conditions]\n", "[conditions]\nassume = [\"rate\"]\n");
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(contains(o.err, "'rate'")) << o;
  EXPECT_TRUE(contains(o.err, "no effect, because the rule set ntc-2018 has no default factors")) << o;
}

// A contract may ask that each factor be adjusted before the factors are multiplied, here by 0.66.
TEST_F(Conditions, combine_as_the_rule_file_says) {
  write(
      "ex/contract.toml",
      "id = \"contract\"\ntitle = \"Contract\"\nedition = \"1\"\nsource = \"none\"\nverified_by = \"\"\n[formulas]\nstiffness = "
      "\"peak_to_peak\"\ndamping = \"peak_to_peak\"\n[cycles]\none = 3\n[combination]\nform = \"each\"\nadjust = 0.66\n");
  auto const o = with("rules = \"ntc-2018\"", "rules = \"contract.toml\"", {"--json"});
  ASSERT_LE(o.code, 1) << o;
  auto const bound = find(Json::parse(o.out)["bounds"], "K_eff", "");
  near(bound["max"]["factor"], 1.532771265, 1e-8);
  near(bound["min"]["factor"], 0.798044329, 1e-8);
}

// ASCE 7 gives one factor for the environment, here at most 1 + 0.75 (1.3 - 1) and at least 1 - 0.75 (1 - 0.9). It is
// used only if no test shows an effect of temperature, ageing or contamination.
TEST_F(Conditions, of_the_environment_stand_in_for_tests) {
  write("ex/contract.toml", R"(id = "contract"
title = "Contract"
edition = "1"
source = "none"
verified_by = ""
[formulas]
stiffness = "peak_to_peak"
damping = "peak_to_peak"
[cycles]
one = 3
[factors]
system_factor = 0.75
[[factor]]
quantity = "K_eff"
environment_min = 0.9
environment_max = 1.3
[[effect]]
name = "rate"
)");
  auto text = read("ex/lot.toml");
  std::string const rules = "rules = \"ntc-2018\"";
  text.replace(text.find(rules), rules.size(), "rules = \"contract.toml\"");
  write("ex/with.toml", text);
  write("ex/without.toml", only_rate(text));
  auto const without = Json::parse(isolaw({"conditions", "ex/without.toml", "--json"}).out);
  auto const environment = find(without["design"], "K_eff", "environment");
  EXPECT_EQ(environment["max"]["status"], "assumed");
  EXPECT_EQ(environment["assumed"]["rules"], "contract");
  auto const bound = find(without["bounds"], "K_eff", "");
  near(bound["max"]["factor"], 1.225 * 1.012476273, 1e-8);
  near(bound["min"]["factor"], 0.925 * 0.983407573, 1e-8);
  EXPECT_EQ(bound["max"]["assumed"], Json::array({"environment"}));
  auto const with = Json::parse(isolaw({"conditions", "ex/with.toml", "--json"}).out);
  for (auto const& row : with["design"]) EXPECT_NE(row["effect"], "environment");
}

// ntc-2018 permits an analysis with mean properties if they change by at most 20 %. Here K_eff goes up to 1.869 times
// its value at reference.
TEST_F(Conditions, decide_on_an_analysis_with_mean_properties) {
  auto const mean = Json::parse(isolaw({"conditions", "ex/lot.toml", "--json"}).out)["mean_properties"];
  EXPECT_EQ(mean["permitted"], false);
  EXPECT_EQ(mean["quantity"], "K_eff");
  near(mean["farthest_percent"], 86.9155861, 1e-6);
  write("ex/changed.toml", only_rate(read("ex/lot.toml")));
  EXPECT_EQ(Json::parse(isolaw({"conditions", "ex/changed.toml", "--json"}).out)["mean_properties"]["permitted"], true);
}

// isolaw must question numbers that can hardly be true, and must not use tests that contradict one another.
TEST_F(Conditions, question_what_cannot_be) {
  auto const tonf = with("file = \"P2-20C.csv\"\n", "file = \"P2-20C.csv\"\nforce-factor = 0.102\n");
  EXPECT_TRUE(contains(tonf.out, "is 0.0997 times the median of the reference tests")) << tonf;
  EXPECT_TRUE(contains(tonf.out, "The devices disagree on the effect of temperature at -20 C")) << tonf;
  auto const thick = with("rubber-thickness-mm = 208.0", "rubber-thickness-mm = 104.0");
  EXPECT_EQ(thick.code, 2) << thick;
  EXPECT_TRUE(contains(thick.err, "devices of different size: rubber-thickness-mm 104 of P1 and 208 of P2")) << thick;
  auto text = read("ex/lot.toml");
  auto const first = text.find("temperature-C", text.find("name = \"P4\""));
  write("ex/changed.toml", text.insert(first, "aged = { days = 28, at-C = 70 }\n"));
  auto const younger = isolaw({"conditions", "ex/changed.toml"});
  EXPECT_TRUE(contains(younger.out, "it states no ageing, and the device was aged 28 days before")) << younger;
  EXPECT_TRUE(contains(younger.out, "it states an ageing of 14 days, and the device was aged 28 days before"))
      << younger;
}

// If a test's name, or the behaviour of rubber, contradicts the temperature or load that the lot file states, all
// outputs must question this statement.
TEST_F(Conditions, question_statements_that_contradict_names_or_rubber) {
  EXPECT_FALSE(contains(isolaw({"conditions", "ex/lot.toml"}).out, "has a name that says"));
  auto text = read("ex/lot.toml");
  auto const change = [](std::string all, std::string const& part, std::string const& by) {
    for (auto at = all.find(part); at != std::string::npos; at = all.find(part, at + by.size()))
      all.replace(at, part.size(), by);
    return all;
  };
  // The stated temperatures of the tests at -20 C and at 40 C are exchanged.
  write("ex/changed.toml", change(change(change(text, "temperature-C = -20\n", "temperature-C = x\n"),
                                         "temperature-C = 40\n", "temperature-C = -20\n"),
                                  "temperature-C = x\n", "temperature-C = 40\n"));
  auto const swapped = isolaw({"conditions", "ex/changed.toml"});
  EXPECT_TRUE(contains(swapped.out, "The test -20C of P1")) << swapped;
  EXPECT_TRUE(contains(swapped.out, "has a name that says -20 C, and the lot file states 40 C")) << swapped;
  EXPECT_TRUE(contains(swapped.out, "K_eff rises with the temperature: its factor is")) << swapped;
  EXPECT_TRUE(contains(swapped.out, "The bounds rest on tests with a doubt: temperature (P1 -20C, P1 40C, P2 -20C"))
      << swapped;
  auto const load = with("load-kN = 2000", "load-kN = 204");
  EXPECT_EQ(load.code, 2) << load;  // no test agrees with the reference any more
  auto const channel = with("name = \"P2\"\n", "name = \"P2\"\nchannel-scale = { load = 0.102 }\n");
  EXPECT_TRUE(
      contains(channel.out, "The vertical load of 20C of P2 (changed.toml:53) is 0.102 times that of the reference"))
      << channel;
}

TEST_F(Conditions, question_missing_and_misplaced_tests) {
  auto const gap = with("order = 4\ntemperature-C = 40", "order = 5\ntemperature-C = 40");
  EXPECT_TRUE(contains(gap.out, "The last test of P1 has the order 5, and the lot file has 4 tests of it.")) << gap;
  EXPECT_FALSE(contains(gap.out, "The bounds rest on")) << gap;
  auto const virgin = with("name = \"0C\"", "name = \"0C virgin\"");
  EXPECT_TRUE(contains(virgin.out, "has a name that says virgin, and the lot file states tests before it")) << virgin;
  EXPECT_TRUE(contains(virgin.out, "The bounds rest on tests with a doubt: temperature (P1 0C virgin).")) << virgin;
}

// The tests show how much stiffer a new device is (scragging). If the design states no `rest`, the bounds leave this
// effect out, and the output must say so.
TEST_F(Conditions, name_the_effects_that_the_design_leaves_out) {
  EXPECT_FALSE(contains(isolaw({"conditions", "ex/lot.toml"}).out, "leave it out"));
  auto const o = with("rest = \"full\", ", "");
  EXPECT_TRUE(contains(o.out,
                       "The tests show an effect of scragging: K_eff has the factor 1.294 at cycle 1, new. The "
                       "design states no rest, so the bounds leave it out."))
      << o;
}

// P2 was tested cold before its reference test. So the first cycle of its reference test is not that of a new device.
TEST_F(Conditions, name_devices_with_other_histories) {
  EXPECT_FALSE(contains(isolaw({"conditions", "ex/lot.toml"}).out, "has not the same history"));
  auto text = read("ex/lot.toml");
  auto const put = [&](std::string const& part, std::string const& by, std::size_t from = 0) {
    auto const at = text.find(part, from);
    ASSERT_NE(at, std::string::npos) << part;
    text.replace(at, part.size(), by);
  };
  put("cycle = 3", "cycle = 1");
  auto const device = text.find("name = \"P2\"");
  put("order = 1\n", "order = x\n", device);
  put("order = 2\n", "order = 1\n", device);
  put("order = x\n", "order = 2\nrest-h = 24\n", device);
  write("ex/changed.toml", text);
  auto const o = isolaw({"conditions", "ex/changed.toml"});
  EXPECT_TRUE(contains(o.out, "history on all devices: first after rest on P2, virgin on P1")) << o;
}

TEST_F(Conditions, name_the_ageing_that_was_tested) {
  auto const o = with("aged = { days = 14, at-C = 70 } }", "aged = { days = 28, at-C = 70 } }");
  EXPECT_TRUE(contains(o.out, "The effect of ageing is NOT COVERED")) << o;
  EXPECT_TRUE(contains(o.out, "; tested: 14 days at 70 C.")) << o;
}

// P4 alone was tested at 0.1 and 2 Hz. Its two reference tests differ by 1 %, which gives the factors of rate an
// interval. This interval holds for P4 only, and the output must say so.
TEST_F(Conditions, say_that_an_interval_is_that_of_one_device) {
  constexpr std::string_view said =
      "A single device shows the effect of rate. The interval of the bounds contains only";
  auto text = only_rate(read("ex/lot.toml"), "[0.1, 2]");
  write("ex/changed.toml", text);
  EXPECT_FALSE(contains(isolaw({"conditions", "ex/changed.toml"}).out, said));
  std::string const again = "file = \"P4-again.csv\"\n";
  write("ex/changed.toml", text.replace(text.find(again), again.size(), again + "force-factor = 1.01\n"));
  auto const o = isolaw({"conditions", "ex/changed.toml"});
  EXPECT_TRUE(contains(o.out, said)) << o;
}

// Cycles before the reference cycle belong to the effect of scragging. If design cycles included them, they would count
// twice.
TEST_F(Conditions, refuse_design_cycles_before_the_reference_cycle) {
  auto const o = with("cycles = 10", "cycles = 1");
  EXPECT_EQ(o.code, 2) << o;
  EXPECT_TRUE(contains(o.err, "changed.toml:13: ")) << o;
  EXPECT_TRUE(contains(o.err, "cycles is 1, and the last cycle of the reference is 3")) << o;
}

// The results on conditions are part of the summary of a campaign. They are computed from the store alone.
TEST_F(Conditions, are_part_of_a_campaign) {
  auto const made = isolaw({"calibrate", "ex/lot.toml", "--out", "C", "--laws", "bilinear", "--runs", "1", "--figures",
                            "none", "--replicates", "0"});
  ASSERT_LE(made.code, 1) << made;
  auto const summary = Json::parse(read("C/summary.json"));
  near(find(summary["conditions"]["bounds"], "K_eff", "")["max"]["factor"], 1.869155861, 1e-8);
  auto const own = Json::parse(isolaw({"conditions", "ex/lot.toml", "--json"}).out);
  auto members = own;
  members.erase("schema"), members.erase("title");
  auto of_summary = summary["conditions"];
  auto const& bounds = of_summary["bound_laws"][0];
  // The lot was not analysed, so the bound laws belong to a single device.
  EXPECT_TRUE(bounds["device"].is_string() && bounds["obstacle"].is_null()) << bounds;
  near(bounds["upper"]["K_eff_factor"], 1.869155861, 1e-8);
  double const D = 208.0;  // amplitude of the reference tests in mm; a cycle has 200 steps
  near(bounds["upper"]["K_eff_kN_per_mm"],
       (bounds["upper"]["force_kN"][50].get<double>() - bounds["upper"]["force_kN"][150].get<double>()) / (2.0 * D),
       1e-3);
  of_summary.erase("bound_laws");
  EXPECT_EQ(of_summary, members);
  for (auto const& file : {"ex/P1--20C.csv", "ex/lot.toml"}) std::filesystem::remove(path(file));
  EXPECT_EQ(Json::parse(isolaw({"conditions", "C", "--json"}).out), own);
  ASSERT_LE(isolaw({"report", "C", "--figures", "none"}).code, 1);
  EXPECT_EQ(Json::parse(read("C/summary.json"))["conditions"], summary["conditions"]);
}

// P1 to P3 lose their reference tests at 20 C. Their cold tests can then only be compared with the reference tests of
// P4 and P5.
TEST_F(Conditions, without_a_reference_test_compare_with_other_devices) {
  auto text = read("ex/lot.toml");
  for (auto const* device : {"P1", "P2", "P3"}) {
    auto const file = text.find(fmt::format("file = \"{}-20C.csv\"", device));
    ASSERT_NE(file, std::string::npos) << text;
    auto const begin = text.rfind("[[device.test]]", file), end = text.find("[[device", file);
    text.erase(begin, end - begin);
  }
  write("ex/changed.toml", text);
  auto const o = isolaw({"conditions", "ex/changed.toml", "--json"});
  ASSERT_LE(o.code, 1) << o;
  auto const j = Json::parse(o.out);
  auto const cold = find(j["levels"], "K_eff", "temperature", "-20 C")["factor"];
  EXPECT_EQ(cold["status"], "unpaired");
  // The reference forces of P4 and P5 are those of the example's formulas, without a deviation of the device.
  near(cold["lambda"], std::cbrt(0.920443205 * 0.874677545 * 0.887009150) / 0.677589534, 1e-7);
  EXPECT_FALSE(cold["device"].is_null());
}

TEST_F(Conditions, of_several_compounds_ask_which_is_meant) {
  auto const unclear = with("name = \"P1\"\n", "name = \"P1\"\ncompound = \"B\"\n");
  EXPECT_EQ(unclear.code, 2) << unclear;
  EXPECT_TRUE(contains(unclear.err, "devices with compound B (as P1), none (as P2)")) << unclear;
  write("ex/lot.toml", read("ex/changed.toml"));
  auto const o = with("[conditions]\n", "[conditions]\ncompound = \"B\"\n", {"--json"});
  ASSERT_LE(o.code, 1) << o;
  auto const j = Json::parse(o.out);
  EXPECT_EQ(find(j["levels"], "K_eff", "temperature", "-20 C")["factor"]["devices"], 1);
  EXPECT_EQ(find(j["design"], "K_eff", "rate")["max"]["status"], "not covered");
}

TEST_F(Conditions, of_scaled_specimens_say_so) {
  auto text = read("ex/lot.toml");
  std::string const scaled = "specimen = \"scaled\"\nscale = 0.3\n";
  for (std::size_t at = 0; (at = text.find("temperature-C = -20", at)) != std::string::npos; at += scaled.size() + 1)
    text.insert(at, scaled);
  write("ex/changed.toml", text);
  auto const mixed = Json::parse(isolaw({"conditions", "ex/changed.toml", "--json"}).out);
  for (auto const& row : mixed["levels"]) EXPECT_NE(row["level"], "-20 C");
  for (auto const& test : mixed["tests"])
    if (test["temperature_C"] == -20.0) {
      EXPECT_EQ(test["role"], "scaled specimen");
    }
}

TEST_F(Conditions, with_starts_need_no_order) {
  auto text = read("ex/lot.toml");
  // The tests of P5: a reference test, then others after 1, 24 and 168 h of rest. Each lasts 20 s or less.
  auto const p5 = text.find("name = \"P5\""), p6 = text.find("name = \"P6\"");
  auto part = text.substr(p5, p6 - p5);
  for (auto const* start :
       {"2026-03-01T09:00:00", "2026-03-01T10:00:20", "2026-03-02T10:00:30", "2026-03-09T10:00:40"}) {
    auto const order = part.find("order = ");
    ASSERT_NE(order, std::string::npos) << part;
    part.replace(order, part.find('\n', order) - order, std::string("started = ") + start);
  }
  for (std::size_t rest; (rest = part.find("rest-h")) != std::string::npos;)
    part.erase(rest, part.find('\n', rest) + 1 - rest);
  write("ex/changed.toml", text.replace(p5, p6 - p5, part));
  auto const o = isolaw({"conditions", "ex/changed.toml", "--json"});
  ASSERT_LE(o.code, 1) << o;
  auto const recovery = Json::parse(o.out)["recovery"];
  ASSERT_EQ(recovery.size(), 3u) << recovery;
  near(recovery[0]["rest_h"], 1.0, 1e-6);
  near(recovery[1]["rest_h"], 24.0, 1e-3);
  near(recovery[2]["rest_h"], 168.0, 1e-3);
}

}  // namespace
}  // namespace isolaw::cli_test
