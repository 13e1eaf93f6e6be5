// Tests the plan, the values at reference and the rule file of `isolaw conditions` on its example.
#include <cmath>
#include <numbers>

#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class ConditionsPlan : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    ASSERT_EQ(isolaw({"example", "ex", "--conditions"}).code, 0);
  }
  // Writes the lot file of the example with `part` replaced, and returns its name.
  std::string with(std::string const& part, std::string const& by) {
    auto text = read("ex/lot.toml");
    auto const at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    write("ex/changed.toml", text.replace(at, part.size(), by));
    return "ex/changed.toml";
  }
  Json json_of(Words const& more) {
    auto const o = isolaw(Words{"conditions"} + more + Words{"--json"});
    EXPECT_LE(o.code, 1) << o;
    return Json::parse(o.out);
  }
  static void near(Json const& value, double wanted, double relative) {
    EXPECT_NEAR(value.get<double>(), wanted, relative * std::abs(wanted));
  }
  // Returns a text for each planned test: the device, the effect, and the conditions that differ from the reference.
  static std::vector<std::string> texts(Json const& plan) {
    std::vector<std::string> all;
    for (auto const& test : plan) {
      auto text = fmt::format("{} {}", test["device"].get<std::string>(),
                              test["is_reference"] == true ? "reference" : test["effect"].get<std::string>());
      if (test["temperature_C"] != 20.0) text += fmt::format(" {:g} C", test["temperature_C"].get<double>());
      if (test["frequency_Hz"] != 0.5) text += fmt::format(" {:g} Hz", test["frequency_Hz"].get<double>());
      if (test["load_kN"] != 2000.0) text += fmt::format(" {:g} kN", test["load_kN"].get<double>());
      if (!test["aged_days"].is_null()) text += fmt::format(" {:.6g} d", test["aged_days"].get<double>());
      if (test["cycles"] != 3) text += fmt::format(" {} cycles", test["cycles"].get<int>());
      all.push_back(text);
    }
    return all;
  }
};
using Texts = std::vector<std::string>;

// P1 was stretched beyond the reference strain in its last test. Further tests of P1 could not be compared with its
// earlier ones, so the plan must not use P1.
TEST_F(ConditionsPlan, leaves_out_a_device_that_was_stretched_farther) {
  auto const last = "order = 4\ntemperature-C = 40\n";
  auto const plan =
      json_of({with(last, fmt::format("{}channel-scale = {{ disp = 1.5 }}\n", last)), "--devices", "6"})["plan"];
  EXPECT_FALSE(plan.empty());
  for (auto const& text : texts(plan)) EXPECT_FALSE(text.starts_with("P1 ")) << text;
}

// P4 was aged, so it cannot be tested at other frequencies any more.
TEST_F(ConditionsPlan, of_the_example_has_twelve_tests) {
  auto const plan = json_of({"ex/lot.toml"})["plan"];
  EXPECT_EQ(texts(plan),
            (Texts{"P1 temperature -15 C", "P2 temperature -15 C", "P1 temperature 45 C", "P2 temperature 45 C",
                   "P1 rate 0.35 Hz", "P2 rate 0.35 Hz", "P1 rate 0.65 Hz", "P2 rate 0.65 Hz", "P1 load 1000 kN",
                   "P1 load 3000 kN", "P1 ageing 14 d", "P1 cycles 10 cycles"}));
  EXPECT_EQ(plan[0]["status"], "interpolated");
  EXPECT_EQ(plan[0]["devices"], 3);
  EXPECT_EQ(plan[1]["status_after"], "shown");
  EXPECT_EQ(plan[1]["devices_after"], 2);
  EXPECT_EQ(plan[2]["status"], "extrapolated");
  EXPECT_EQ(plan[8]["status"], "shown");
  EXPECT_EQ(plan[8]["devices"], 1);
  auto const o = isolaw({"conditions", "ex/lot.toml", "--plan"});
  EXPECT_LE(o.code, 1) << o;
  for (auto const* part : {"until 2 devices show", "\n12 tests.", "No factor is assumed", "extrapolated on 3 devices"})
    EXPECT_TRUE(contains(o.out, part)) << part << o;
}

TEST_F(ConditionsPlan, is_for_as_many_devices_as_asked) {
  auto const one = json_of({"ex/lot.toml", "--devices", "1"})["plan"];
  EXPECT_EQ(texts(one), (Texts{"P1 temperature -15 C", "P1 temperature 45 C", "P1 rate 0.35 Hz", "P1 rate 0.65 Hz"}));
  // Every end of temperature and frequency needs six devices. The plan takes the devices with a reference test first,
  // without P4, which was aged. Then come P6, which first needs a reference test, and a new device.
  auto const six = texts(json_of({"ex/lot.toml", "--devices", "6"})["plan"]);
  EXPECT_EQ(Texts(six.begin(), six.begin() + 8),
            (Texts{"P1 temperature -15 C", "P2 temperature -15 C", "P3 temperature -15 C", "P5 temperature -15 C",
                   "P6 reference", "P6 temperature -15 C", "new 1 reference", "new 1 temperature -15 C"}));
  EXPECT_EQ(std::ranges::count(six, "P6 reference"), 1);
  // Five devices show scragging already. The reference test of "new 1" shows scragging on a sixth, so the plan needs no
  // test for it.
  for (auto const& text : six) EXPECT_FALSE(contains(text, "scragging")) << text;
  auto const refused = isolaw({"conditions", "ex/lot.toml", "--devices", "0"});
  EXPECT_EQ(refused.code, 2) << refused;
  EXPECT_EQ(isolaw({"conditions", "ex/lot.toml", "--devices", "3"}).code, 2);
}

// Without its ageing test, P4 can be tested at other frequencies. It comes before P1, because it was already tested for
// the effect of frequency.
TEST_F(ConditionsPlan, counts_the_tests_that_show_what_was_assumed) {
  with("[conditions]\n", "[conditions]\nrules = \"aashto\"\nassume = [\"ageing\"]\n");
  auto text = read("ex/changed.toml");
  auto const file = text.find("file = \"P4-aged.csv\""), begin = text.rfind("[[device.test]]", file);
  write("ex/changed.toml", text.erase(begin, text.find("[[device", file) - begin));
  auto const plan = json_of({"ex/changed.toml"})["plan"];
  Texts ageing, rate;
  for (auto const& text_of : texts(plan)) {
    if (contains(text_of, "ageing")) ageing.push_back(text_of);
    if (contains(text_of, "rate 0.35")) rate.push_back(text_of);
  }
  EXPECT_EQ(ageing, (Texts{"P1 ageing 14 d", "P2 ageing 14 d"}));
  EXPECT_EQ(rate, (Texts{"P4 rate 0.35 Hz", "P1 rate 0.35 Hz"}));
  for (auto const& test : plan) EXPECT_EQ(test["status"] == "assumed", test["effect"] == "ageing") << test;
  auto const o = isolaw({"conditions", "ex/changed.toml", "--plan"});
  EXPECT_TRUE(contains(o.out, "\n2 of them turn an assumed factor into a shown one.")) << o;
}

TEST_F(ConditionsPlan, names_effects_that_no_test_can_be_named_for) {
  auto const part = "aged = { days = 14, at-C = 70 } }";
  auto const unclear = with(part, "years = 60, service-temperature-C = 20 }");
  EXPECT_EQ(json_of({unclear})["not_in_plan"], Json::parse(R"([{"effect":"ageing","reason":"no activation energy"}])"));
  EXPECT_TRUE(contains(isolaw({"conditions", unclear, "--plan"}).out, "No test of ageing: no activation energy"));
  // With an activation energy of 90 kJ/mol, 100.9527 days at 70 C stand for 60 years at 20 C. P4 was aged for 14 days
  // at 70 C, and its ageing can be continued.
  write("ex/lot.toml", read("ex/changed.toml"));
  auto const known =
      with("[conditions]\n", "[conditions]\nactivation-energy-kJ-mol = 90\nactivation-energy-source = \"a test\"\n");
  auto const plan = texts(json_of({known})["plan"]);
  for (auto const* test : {"P4 ageing 100.953 d", "P1 ageing 100.953 d"})
    EXPECT_EQ(std::ranges::count(plan, test), 1) << test;
}

TEST_F(ConditionsPlan, without_a_design_is_empty) {
  auto text = read("ex/lot.toml");
  auto const at = text.find("design = { temp");
  write("ex/changed.toml", text.erase(at, text.find('\n', at) - at));
  EXPECT_TRUE(json_of({"ex/changed.toml"})["plan"].empty());
  EXPECT_TRUE(contains(isolaw({"conditions", "ex/changed.toml", "--plan"}).out, "No condition is stated"));
}

TEST_F(ConditionsPlan, converts_the_acceptance_test_to_reference) {
  auto const j = json_of({"ex/lot.toml"});
  auto const& rows = j["at_reference"];
  ASSERT_EQ(rows.size(), 3u) << rows;
  auto const& stiffness = rows[0];
  EXPECT_EQ(stiffness["device"], "P6");
  EXPECT_EQ(stiffness["quantity"], "K_eff");
  near(stiffness["measured"], 0.603681447, 1e-8);
  near(stiffness["at_reference"], 0.677266527, 1e-8);
  EXPECT_TRUE(stiffness["low"].is_null());
  EXPECT_TRUE(stiffness["obstacle"].is_null());
  ASSERT_EQ(stiffness["factors"].size(), 2u);
  auto const& warm = stiffness["factors"][0];
  EXPECT_EQ(warm["effect"], "temperature");
  near(warm["lambda"], 0.961251217, 1e-8);
  EXPECT_EQ(warm["status"], "interpolated");
  EXPECT_EQ(warm["devices"], 3);
  EXPECT_EQ(warm["records"].size(), 6u) << "P1 to P3, at 20 and 40 C";
  for (auto const& test : j["tests"]) {
    bool const of_three = test["device"] < "P4", at_20_or_40 = test["temperature_C"] >= 20.0;
    EXPECT_EQ(std::ranges::count(warm["records"], test["sha256"]), of_three && at_20_or_40 ? 1 : 0) << test["file"];
  }
  near(stiffness["factors"][1]["lambda"], 0.927280900, 1e-8);
  EXPECT_EQ(stiffness["factors"][1]["records"].size(), 3u) << "P4 at 0.1 Hz, and its two reference tests";
  near(rows[1]["measured"], 16542.272955, 2e-4);
  near(rows[1]["at_reference"], 19890.261899, 2e-4);
  // Damping is E/(2 pi K D^2), with D = 208 mm.
  near(rows[2]["at_reference"], 100.0 * 19890.261899 / (2.0 * std::numbers::pi * 0.677266527 * 208.0 * 208.0), 2e-4);
  auto const o = isolaw({"conditions", "ex/lot.toml", "--at-reference"});
  EXPECT_LE(o.code, 1) << o;
  for (auto const* part : {"P6, test acceptance: 26 C, 0.1 Hz, 2000 kN", "0.6037", "0.6773",
                           "interpolated on 3 devices, 6 records", "no interval, because too few devices show rate"})
    EXPECT_TRUE(contains(o.out, part)) << part << o;
}

TEST_F(ConditionsPlan, converts_with_an_interval_and_names_obstacles) {
  // At 0.5 Hz the test of P6 differs from the reference in temperature alone. The interval of the logarithm of the
  // factor then has the half width 0.014331821.
  write("ex/P6-acceptance.csv", read("ex/P1-40C.csv"));
  auto file = read("ex/P6-acceptance.csv");
  // The record must not be the same as that of P1.
  write("ex/P6-acceptance.csv", file.replace(0, file.find('\n'), "# another record"));
  auto const rows = json_of({"ex/lot.toml"})["at_reference"];
  ASSERT_EQ(rows.size(), 3u);
  near(rows[0]["measured"], 0.606563886, 1e-8);
  near(rows[0]["at_reference"], 0.606563886 / 0.961251217, 1e-8);
  near(rows[0]["low"], 0.606563886 / 0.961251217 * std::exp(-0.014331821), 1e-7);
  near(rows[0]["high"], 0.606563886 / 0.961251217 * std::exp(0.014331821), 1e-7);
  auto const hot = json_of({with("temperature-C = 26", "temperature-C = 46")})["at_reference"];
  EXPECT_TRUE(hot[0]["at_reference"].is_null());
  EXPECT_EQ(hot[0]["obstacle"], "temperature");
  EXPECT_EQ(hot[0]["factors"][0]["status"], "extrapolated");
  EXPECT_TRUE(contains(isolaw({"conditions", "ex/changed.toml", "--at-reference"}).out,
                       "no value at reference, because the factor of temperature is extrapolated"));
  EXPECT_TRUE(json_of({with("temperature-C = 26", "temperature-C = 21")})["at_reference"].empty());
}

// If the lot file names no acceptance test of a device, its first test at 20 C is taken, as other commands do.
TEST_F(ConditionsPlan, takes_the_test_that_other_commands_take) {
  auto text = read("ex/lot.toml");
  auto const file = text.find("file = \"P4-reference.csv\""), begin = text.rfind("[[device.test]]", file);
  write("ex/changed.toml", text.erase(begin, text.find("[[device.test]]", file) - begin));
  auto const rows = json_of({"ex/changed.toml"})["at_reference"];
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0]["device"], "P4");
  EXPECT_EQ(rows[0]["test"], "slow");
  auto const inspected = Json::parse(isolaw({"inspect", "ex/changed.toml", "--json"}).out);
  EXPECT_EQ(inspected["devices"][3]["file"], "P4-slow.csv");
}

TEST_F(ConditionsPlan, writes_the_measured_factors_as_a_rule_file) {
  auto const o = isolaw({"conditions", "ex/lot.toml", "--write-rules", "Measured 1.toml"});
  ASSERT_LE(o.code, 1) << o;
  auto const text = read("Measured 1.toml");
  auto const back = isolaw({"rules", "Measured 1.toml"});
  EXPECT_EQ(back.code, 0) << back;
  EXPECT_EQ(back.out, text);
  for (auto const* part :
       {"id = \"measured-1\"", "verified_by = \"\"", "one = 3", "default_max = 1.26911304", "default_min = 0.848178179",
        "form = \"product\"", "#   P4, slow: ", "smallest: extrapolated on 3 devices"})
    EXPECT_TRUE(contains(text, part)) << part << text;
  EXPECT_EQ(count_of("[[effect]]", text), 24u) << "six effects on four properties";
  for (auto const& test : json_of({"ex/lot.toml"})["tests"])
    EXPECT_EQ(contains(text, test["sha256"].get<std::string>().substr(0, 12)), test["role"] != "combined")
        << test["file"];
  EXPECT_EQ(isolaw({"conditions", "ex/lot.toml", "--write-rules", "Measured 1.toml"}).code, 2);
  EXPECT_EQ(read("Measured 1.toml"), text);
  // The written file can be used as the rule set of a lot.
  auto const used = isolaw({"inspect", "ex/P1-20C.csv", "--rules", "Measured 1.toml"});
  EXPECT_EQ(used.code, 0) << used;
  EXPECT_TRUE(contains(used.out, "no verdict")) << used;
}

TEST_F(ConditionsPlan, writes_no_factor_that_no_test_covers) {
  auto const lot = with("temperature-C = [-15, 45]", "temperature-C = [-35, 45]");
  ASSERT_LE(isolaw({"conditions", lot, "--write-rules", "m.toml"}).code, 1);
  auto const text = read("m.toml");
  EXPECT_TRUE(contains(text, "# temperature from -35 to 45 C: no test covers the factors of K_eff")) << text;
  EXPECT_FALSE(contains(text, "name = \"temperature\"")) << text;
  EXPECT_EQ(isolaw({"rules", "m.toml"}).code, 0);
}

}  // namespace
}  // namespace isolaw::cli_test
