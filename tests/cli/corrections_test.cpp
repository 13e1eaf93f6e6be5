// A test rig changes the measured force, and options correct this. The records have a known disturbance. With the
// matching option every command must give the properties of the undisturbed device and say that it corrected the
// record.
#include "cli/loops.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

constexpr double amplitude_mm = 100.0, frequency_Hz = 0.5, interval_s = 0.005, load_kN = 2000.0;
constexpr double omega = 2.0 * std::numbers::pi * frequency_Hz;

// The rig may change the force: by a delay, by friction, by the inertia of a moving mass, and by a factor.
struct Rig {
  double late_s = 0.0, friction_kN = 0.0, mass_kg = 0.0, factor = 1.0;
};

// Returns four and a half cycles of a device with F = 0.8 x + 0.02 v under a vertical load of 2000 kN. The formula
// gives the force at any time, so a delay of the force is exact.
std::string rig_record(Rig const& rig) {
  std::string text = "time [s],displacement [mm],force [kN],vertical load [kN]\n";
  for (int i = 0; i <= 1800; ++i) {
    double const t = interval_s * i, then = t - rig.late_s;
    double const v = omega * amplitude_mm * std::cos(omega * t);
    double const device =
        0.8 * amplitude_mm * std::sin(omega * then) + 0.02 * omega * amplitude_mm * std::cos(omega * then);
    double const inertia = -1e-6 * rig.mass_kg * omega * omega * amplitude_mm * std::sin(omega * t);
    double const friction = std::abs(v) < 1e-6 ? 0.0 : std::copysign(rig.friction_kN, v);
    text += fmt::format("{:.4f},{:.6f},{:.6f},{:g}\n", t, amplitude_mm * std::sin(omega * t),
                        (device + inertia + friction) * rig.factor, load_kN);
  }
  return text;
}

struct Case {
  std::string option, key, value;
  Rig rig;
  std::string sentence;
};

std::vector<Case> cases() {
  return {{"--skew-ms", "skew-ms", "12.5", {.late_s = 0.0125}, "force moved back by 12.5 ms"},
          {"--skew-ms", "skew-ms", "-20", {.late_s = -0.020}, "force moved forward by 20 ms"},
          {"--rig-friction", "rig-friction", "8", {.friction_kN = 8.0}, "the rig's friction of 8 kN was subtracted"},
          {"--rig-friction-coefficient",
           "rig-friction-coefficient",
           "0.004",
           {.friction_kN = 8.0},
           "the rig's friction of 0.004 times the vertical load"},
          {"--moving-mass",
           "moving-mass",
           "5000",
           {.mass_kg = 5000.0},
           "the inertia of a moving mass of 5000 kg was subtracted"},
          {"--force-factor", "force-factor", "0.5", {.factor = 2.0}, "force multiplied by 0.5"}};
}

class Corrections : public InFreshDirectory {
 protected:
  Json inspected(Words const& words) {
    auto const o = isolaw(Words{"inspect", "--json"} + words);
    EXPECT_EQ(o.code, 0) << o;
    return Json::parse(o.out);
  }
  // Expects K_eff = 0.8 kN/mm within 0.001 kN/mm and the energy pi 0.02 omega D^2 of the term 0.02 v within 0.1 %. A
  // disturbance that was left uncorrected would change one of them by 4 % or more (expect_disturbed).
  static void expect_device(Json const& device) {
    auto const& cycle = cycle_of(device, 1, 2);
    double const energy = std::numbers::pi * 0.02 * omega * amplitude_mm * amplitude_mm;
    EXPECT_NEAR(cycle["K_eff_kN_per_mm"].get<double>(), 0.8, 0.001);
    EXPECT_NEAR(cycle["energy_kN_mm"].get<double>(), energy, 0.001 * energy);
  }
  // Expects K_eff or the energy to be off by 4 % or more.
  static void expect_disturbed(Json const& device) {
    auto const& cycle = cycle_of(device, 1, 2);
    double const energy = std::numbers::pi * 0.02 * omega * amplitude_mm * amplitude_mm;
    double const stiffer = cycle["K_eff_kN_per_mm"].get<double>() / 0.8 - 1.0;
    double const more = cycle["energy_kN_mm"].get<double>() / energy - 1.0;
    EXPECT_GT(std::max(std::abs(stiffer), std::abs(more)), 0.04);
  }
};

TEST_F(Corrections, an_undisturbed_record_needs_none) {
  write("true.csv", rig_record({}));
  auto const device = inspected({"true.csv"});
  expect_device(device);
  EXPECT_TRUE(device["corrections"].empty());
}

TEST_F(Corrections, inspect_gives_back_the_device_and_says_what_was_done) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.option + " " + c.value);
    write("rig.csv", rig_record(c.rig));
    expect_disturbed(inspected({"rig.csv"}));
    auto const device = inspected({"rig.csv", c.option, c.value});
    expect_device(device);
    ASSERT_EQ(device["corrections"].size(), 1u);
    EXPECT_TRUE(contains(device["corrections"][0].get<std::string>(), c.sentence));
    auto const text = isolaw({"inspect", "rig.csv", c.option, c.value});
    EXPECT_TRUE(contains(text.out, "\nCorrected, as asked for\n  " + c.sentence)) << text;
  }
}

// If a verdict rests on a correction that the user asked for, the outputs must say what the verdict would be without
// it.
TEST_F(Corrections, outputs_say_what_the_verdict_would_be_without_them) {
  write("rig.csv", rig_record({.late_s = 0.0125}));
  Words const judged{"--rules", "ntc-2018", "--design", "K_eff=0.8,damping=3.9,disp=100", "--lot-size", "1"};
  auto const plain = Json::parse(isolaw(Words{"inspect", "--json", "rig.csv"} + judged).out);
  auto const corrected = inspected(Words{"rig.csv", "--skew-ms", "12.5"} + judged);
  auto const K = cycle_of(plain, 1, 3)["K_eff_kN_per_mm"].get<double>();
  auto const damping = cycle_of(plain, 1, 3)["damping_percent"].get<double>();
  auto const of_kind = [](Json const& findings, std::string const& kind) {
    for (auto const& finding : findings)
      if (finding["kind"] == kind) return finding;
    return Json();
  };
  auto const values = of_kind(corrected["findings"], "values-uncorrected");
  ASSERT_FALSE(values.is_null()) << corrected["findings"];
  EXPECT_NEAR(values["each"][0]["numbers"]["K_eff_kN_per_mm"].get<double>(), K, 1e-6);
  EXPECT_NEAR(values["each"][0]["numbers"]["damping_percent"].get<double>(), damping, 1e-4);
  EXPECT_TRUE(of_kind(plain["findings"], "values-uncorrected").is_null());

  EXPECT_TRUE(corrected["as_corrected"].get<bool>());
  EXPECT_TRUE(contains(corrected["verdict_brief"].get<std::string>(), "pass as corrected on "));
  EXPECT_FALSE(plain["as_corrected"].get<bool>());

  ASSERT_LE(isolaw(Words{"calibrate", "rig.csv", "--skew-ms", "12.5", "--out", "O"} + smallest_search + judged).code,
            1);
  auto const verdict = of_kind(json("O/summary.json")["warnings"], "verdict-rests-on-corrections");
  ASSERT_FALSE(verdict.is_null()) << read("O/summary.json");
  EXPECT_TRUE(verdict["certificate"].get<bool>());
  EXPECT_TRUE(contains(verdict["sentence"].get<std::string>(), "Without them it would be FAIL, not INCOMPLETE"))
      << verdict["sentence"];
  EXPECT_TRUE(contains(isolaw({"report", "O", "--details"}).out, "The verdict rests on the corrections by hand of"));
}

// The force is so late that the device seems to give energy back. isolaw must refuse the record as it is, and accept it
// if the user asks for the correction.
TEST_F(Corrections, make_a_record_usable_that_would_be_refused_without_them) {
  write("rig.csv", rig_record({.late_s = 0.040}));
  EXPECT_NE(isolaw({"inspect", "rig.csv"}).code, 0);
  auto const device = inspected({"rig.csv", "--skew-ms", "40"});
  expect_device(device);
  auto const text = device["findings"].dump();
  EXPECT_TRUE(contains(text, "without the corrections by hand there would be no properties")) << text;
  EXPECT_TRUE(contains(text, "gives back")) << text;
}

// A device without a complete cycle has no values to compare, but its corrections are named all the same.
TEST_F(Corrections, of_a_record_without_a_cycle_are_named_with_the_verdict) {
  auto rows = rig_record({.late_s = 0.0125});
  std::size_t end = 0;
  for (int line = 0; line < 150; ++line) end = rows.find('\n', end) + 1;
  write("short.csv", rows.substr(0, end));
  auto const text = isolaw({"inspect", "short.csv", "--skew-ms", "12.5", "--rules", "ntc-2018", "--design",
                            "K_eff=0.8,damping=3.9,disp=100", "--lot-size", "1", "--details"})
                        .out;
  EXPECT_FALSE(contains(text, "by hand of  the")) << text;
}

// --force-factor converts the force from the scale in which the rig records it. This is no correction, so the values
// "without corrections" include the factor. A repair that found no spike is no correction either.
TEST_F(Corrections, a_factor_and_a_repair_of_nothing_change_no_verdict) {
  write("rig.csv", rig_record({.factor = 2.0}));
  for (auto const& device :
       {inspected({"rig.csv", "--force-factor", "0.5"}), inspected({"rig.csv", "--repair", "spikes"})})
    for (auto const& finding : device["findings"])
      EXPECT_FALSE(contains(finding["sentence"].get<std::string>(), "without the corrections")) << finding;
}

TEST_F(Corrections, calibrate_keeps_them_in_store_and_report) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.option + " " + c.value);
    write("rig.csv", rig_record(c.rig));
    auto const o = isolaw(Words{"calibrate", "rig.csv", "--out", "O", "--fresh", c.option, c.value} + smallest_search);
    EXPECT_EQ(o.code, 0) << o;
    auto const stored = query(path("O/campaign.sqlite"), "SELECT corrections FROM device").at(0);
    EXPECT_TRUE(contains(stored, "\"option\":\"" + c.option + "\"")) << stored;
    EXPECT_EQ(isolaw({"report", "O", "--out", "P"}).code, 0);
    auto const device = page_data(read("P/report.html"))["devices"][0];
    expect_device(device);
    EXPECT_TRUE(contains(device["corrections"].dump(), c.sentence));
    auto const other = isolaw(Words{"calibrate", "rig.csv", "--out", "O"} + smallest_search);
    expect_refused(other, {"rig: its file is read in another way", "--fresh"});
  }
}

TEST_F(Corrections, init_writes_them_and_calibrate_reads_them_back) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.option + " " + c.value);
    write("rig.csv", rig_record(c.rig));
    auto const output = isolaw({"init", "rig.csv", "--force", c.option, c.value});
    EXPECT_EQ(output.code, 0) << output;
    EXPECT_TRUE(contains(read("lot.toml"), c.key + " = " + c.value)) << read("lot.toml");
    expect_device(inspected({"lot.toml"}));
    EXPECT_EQ(isolaw(Words{"calibrate", "lot.toml", "--out", "L", "--fresh"} + smallest_search).code, 0);
    EXPECT_EQ(isolaw(Words{"calibrate", "rig.csv", "--out", "C", "--fresh", c.option, c.value} + smallest_search).code,
              0);
    for (auto const* rows : {"SELECT * FROM series", "SELECT name, file, sha256, corrections, cleaning FROM device"})
      EXPECT_EQ(query(path("L/campaign.sqlite"), rows), query(path("C/campaign.sqlite"), rows)) << rows;
    auto const again = isolaw(Words{"calibrate", "lot.toml", "--out", "C"} + smallest_search);
    EXPECT_EQ(again.code, 0) << "the same campaign, continued: " << again;
  }
}

TEST_F(Corrections, the_lot_file_has_the_same_keys_for_all_devices_and_for_one) {
  for (auto const& c : cases()) {
    SCOPED_TRACE(c.option + " " + c.value);
    write("rig.csv", rig_record(c.rig));
    auto const key = c.key + " = " + c.value + "\n";
    write("lot.toml", "[read]\n" + key + "[[device]]\nfile = \"rig.csv\"\n");
    expect_device(inspected({"lot.toml"}));
    write("lot.toml",
          "[[device]]\nfile = \"rig.csv\"\n" + key + "[[device]]\nname = \"as it is\"\nfile = \"rig.csv\"\n");
    auto const found = inspected({"lot.toml"});
    expect_device(found["devices"][0]);
    expect_disturbed(found["devices"][1]);
    EXPECT_TRUE(found["devices"][1]["corrections"].empty());
  }
  // The force factor in [[device]] overrides the one in [read], and the command line overrides both.
  write("double.csv", rig_record({.factor = 2.0}));
  write("fourfold.csv", rig_record({.factor = 4.0}));
  write("lot.toml",
        "[read]\nforce-factor = 0.5\n[[device]]\nfile = \"double.csv\"\n[[device]]\nfile = \"fourfold.csv\"\n"
        "force-factor = 0.25\n");
  auto const found = inspected({"lot.toml"});
  for (auto const& device : found["devices"]) expect_device(device);
  auto const third = inspected({"lot.toml", "--force-factor", "1"});
  EXPECT_NEAR(cycle_of(third["devices"][0], 1, 2)["K_eff_kN_per_mm"].get<double>(), 1.6, 0.002);
  EXPECT_NEAR(cycle_of(third["devices"][1], 1, 2)["K_eff_kN_per_mm"].get<double>(), 3.2, 0.004);
}

TEST_F(Corrections, several_are_made_together) {
  write("rig.csv", rig_record({.late_s = 0.01, .mass_kg = 3000.0, .factor = 2.0}));
  auto const device =
      // The moving mass is 3000 kg. The force is recorded at twice its value, so the record has the inertia of 6000 kg.
      inspected({"rig.csv", "--skew-ms", "10", "--moving-mass", "6000", "--force-factor", "0.5"});
  EXPECT_EQ(device["corrections"].size(), 3u);
  // The correction of the delay also moves the inertia force by 10 ms, although that force was not late. K_eff must
  // hardly change.
  auto const& cycle = cycle_of(device, 1, 2);
  EXPECT_NEAR(cycle["K_eff_kN_per_mm"].get<double>(), 0.8, 0.002);
}

TEST_F(Corrections, wrong_values_are_refused_with_what_is_allowed) {
  write("rig.csv", rig_record({}));
  expect_refused(isolaw({"inspect", "rig.csv", "--skew-ms", "1500"}), {"--skew-ms: 1500 ms", "-1000 to 1000 ms"});
  expect_refused(isolaw({"inspect", "rig.csv", "--rig-friction", "-1"}), {"--rig-friction: -1 kN", "0 to 100000 kN"});
  expect_refused(isolaw({"inspect", "rig.csv", "--rig-friction-coefficient", "0.5"}), {"0.5", "0 to 0.2"});
  expect_refused(isolaw({"inspect", "rig.csv", "--moving-mass", "x"}), {"--moving-mass: 'x' is not a number"});
  expect_refused(isolaw({"inspect", "rig.csv", "--force-factor", "-1"}), {"--force-factor: -1", "--flip-force"});
  expect_refused(isolaw({"init", "rig.csv", "--rig-friction", "1", "--rig-friction-coefficient", "0.01"}),
                 {"--rig-friction: given with --rig-friction-coefficient", "one of the two"});
  EXPECT_FALSE(exists("lot.toml"));
  write("bare.csv", csv_without_time());
  expect_refused(isolaw({"inspect", "bare.csv", "--skew-ms", "5"}),
                 {"--skew-ms for a record without time", "--dt SECONDS"});
  expect_refused(isolaw({"inspect", "bare.csv", "--rig-friction-coefficient", "0.01"}), {"without a vertical load"});
  write("lot.toml", "[read]\nskew-ms = 1500\n[[device]]\nfile = \"rig.csv\"\nforce-factor = \"x\"\n");
  expect_refused(isolaw({"inspect", "lot.toml"}),
                 {"skew-ms: 1500 ms", "-1000 to 1000 ms", "lot.toml:5", "force-factor"});
}

}  // namespace
}  // namespace isolaw::cli_test
