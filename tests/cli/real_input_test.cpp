// Tests with measured records. The records lie beside the repository and are never copied into it. Where they are
// missing, the tests are skipped.
#include <cmath>

#include "cli/run.hpp"
#include "isolaw/campaign/settings.hpp"

namespace isolaw::cli_test {
namespace {

Words const reduced_into_O{"--runs", "1", "--population", "20", "--generations", "4", "--out", "O"};

class RealInput : public InFreshDirectory {
 protected:
  void expect_finite_objectives(std::string const& device, double most) {
    auto const summary = json("O/summary.json");
    ASSERT_EQ(summary["laws"].size(), summary["settings"]["laws"].size());
    ASSERT_GE(summary["laws"].size(), campaign::parse_laws(campaign::usual_laws).size());
    for (auto const& law : summary["laws"]) {
      auto const& fit = law["devices"].at(0);
      EXPECT_EQ(fit["name"], device);
      EXPECT_EQ(fit["status"], "ok") << law["id"];
      ASSERT_TRUE(fit["objective"]["best"].is_number()) << law["id"];
      EXPECT_GT(fit["objective"]["best"].get<double>(), 0.0);
      EXPECT_LT(fit["objective"]["best"].get<double>(), most) << law["id"];
      for (auto const* error : {"K_eff_error_percent", "energy_error_percent", "damping_error_percent"})
        EXPECT_TRUE(fit[error].is_number()) << law["id"] << error;
    }
  }
};

class Bearing : public RealInput {
 protected:
  fs::path const file = data / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
};

TEST_F(Bearing, inspect_recognises_columns_units_and_cycles_and_says_that_time_is_missing) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const o = isolaw({"inspect", file});
  EXPECT_EQ(o.code, 0) << o;
  for (auto const* part :
       {"disp: column 2 'displacement_cm', by its name; unit cm",
        "force: column 3 'force_tonf', by its name; unit tonf", "column 1 'sample' counts samples, it is no time",
        "no time column: rate-dependent laws need --dt SECONDS"})
    EXPECT_TRUE(contains(o.out, part));
  auto const timed = isolaw({"inspect", file, "--dt", "0.00214823", "--json"});
  ASSERT_EQ(timed.code, 0) << timed;
  auto const found = Json::parse(timed.out);
  EXPECT_EQ(found["samples"], 19767);
  // The record states no time. Its sampling interval follows from the test's 0.5 Hz, so a cycle must take 2 s.
  EXPECT_NEAR(found["samples_per_cycle"].get<double>() * 0.00214823, 2.0, 0.01);
  ASSERT_EQ(found["blocks"].size(), 3u);
  for (auto const& block : found["blocks"]) EXPECT_EQ(block["cycles"].size(), 7u);
}

// The record is averaged over nine samples and reduced to every ninth. The bearing is virgin at its start. Other
// programs gave the expected objectives; docs/league.md has more of them.
TEST_F(Bearing, laws_reach_what_is_known_of_them) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  struct Known {
    std::string law;
    double most;
  };
  std::vector<Known> const known{{"power-masing", 0.0252 * 1.02}, {"gallardo", 0.036}, {"kikuchi-aiken", 0.050}};
  auto const o = isolaw({"calibrate", file, "--laws", "power-masing,gallardo,kikuchi-aiken", "--dt", "0.00214823",
                         "--smooth", "9", "--samples-per-cycle", "103", "--weights", "time", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  auto const summary = json("O/summary.json");
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_EQ(summary["laws"][i]["id"], known[i].law);
    EXPECT_LE(summary["laws"][i]["devices"][0]["objective"]["best"].get<double>(), known[i].most) << known[i].law;
  }
}

TEST_F(Bearing, calibrates_with_all_laws) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const o = isolaw(Words{"calibrate", file, "--laws", "all", "--dt", "0.00214823"} + reduced_into_O);
  EXPECT_EQ(o.code, 0) << o;
  expect_finite_objectives("cyclic-24-49-98pct", 1.0);
}

TEST_F(Bearing, without_a_sampling_interval_the_two_laws_that_need_velocity_are_refused) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const o = isolaw(Words{"calibrate", file} + reduced_into_O);
  EXPECT_EQ(o.code, 1) << o;
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"]) {
    auto const& fit = law["devices"].at(0);
    bool const needs_time = !laws::find_law(law["id"].get<std::string>()).info.traits.rate_independent;
    EXPECT_EQ(fit["status"], needs_time ? "refused" : "ok") << law["id"];
    EXPECT_EQ(contains(fit["message"].get<std::string>(), "--dt SECONDS"), needs_time) << law["id"];
  }
}

class FrictionDamper : public RealInput {
 protected:
  fs::path const packed = data / "friction-damper-arts/ds2_0.5Hz_30lb_1in.json.xz";
  // Converts the record's rows [time s, displacement in, friction force kip, ...] to CSV.
  void convert() {
    Process unpack({"xz", "--decompress", "--stdout", packed}, directory(), path("damper.json"), path("xz.err"));
    auto const unpacked = unpack.wait();
    ASSERT_EQ(unpacked.code, 0) << unpacked;
    auto const record = Json::parse(unpacked.out);
    ASSERT_EQ(record["displacement units"], "in");
    ASSERT_EQ(record["friction force units"], "kip");
    std::string text = "time [s],displacement [in],force [kip]\n";
    for (auto const& row : record["data"])
      text += fmt::format("{},{},{}\n", row[0].get<double>(), row[1].get<double>(), row[2].get<double>());
    write("damper.csv", text);
  }
};

bool have_xz() {
  return std::system("xz --version > /dev/null 2>&1") == 0;
}

TEST_F(FrictionDamper, inspects_and_calibrates_after_a_plain_conversion) {
  if (!fs::exists(packed)) GTEST_SKIP() << "measured data are not here: " << packed;
  if (!have_xz()) GTEST_SKIP() << "xz is not installed";
  convert();
  auto const inspected = isolaw({"inspect", "damper.csv", "--json"});
  ASSERT_EQ(inspected.code, 0) << inspected;
  auto const found = Json::parse(inspected.out);
  EXPECT_EQ(found["units"]["disp"], "in");
  EXPECT_EQ(found["units"]["force"], "kip");
  EXPECT_EQ(found["samples"], 14337);
  auto const reported = found["reported"];
  auto const block = found["blocks"][reported["block"].get<std::size_t>() - 1];
  int counted = 0;
  for (auto const& cycle : block["cycles"])
    if (cycle["counts"]) {
      ++counted;
      EXPECT_NEAR(cycle["amplitude_mm"].get<double>(), 25.4, 0.5);  // the nominal amplitude, 1 in
    }
  EXPECT_EQ(counted, 3);
  auto const o = isolaw(Words{"calibrate", "damper.csv"} + reduced_into_O);
  EXPECT_EQ(o.code, 0) << o;
  expect_finite_objectives("damper", 2.0);
}

// Each record has seven cycles: two smaller ones, at 1/4 and 3/4 of the nominal amplitude, then three at the nominal
// amplitude, and then two smaller ones again. isolaw must count only the three.
TEST_F(FrictionDamper, every_record_is_read_as_it_is_and_has_its_three_cycles) {
  if (!fs::exists(packed)) GTEST_SKIP() << "measured data are not here: " << packed;
  if (!have_xz()) GTEST_SKIP() << "xz is not installed";
  struct Expected {
    char const* name;
    double frequency_Hz, amplitude_in;
  };
  for (auto const& test : {Expected{"ds2_0.25Hz_36lb_1in", 0.25, 1.0}, Expected{"ds2_0.5Hz_30lb_0.5in", 0.5, 0.5},
                           Expected{"ds2_0.5Hz_30lb_1in", 0.5, 1.0}, Expected{"ds2_0.5Hz_30lb_1.5in", 0.5, 1.5},
                           Expected{"ds2_1Hz_36lb_1in", 1.0, 1.0}}) {
    SCOPED_TRACE(test.name);
    auto const file = packed.parent_path() / (test.name + std::string(".json.xz"));
    Process unpack({"xz", "--decompress", "--stdout", file}, directory(), path("damper.json"), path("xz.err"));
    ASSERT_EQ(unpack.wait().code, 0);
    auto const o = isolaw({"inspect", "damper.json", "--columns", "time=1,disp=2,force=3", "--units",
                           "time=s,disp=in,force=kip", "--json"});
    ASSERT_EQ(o.code, 0) << o;
    auto const found = Json::parse(o.out);
    auto const rows = json("damper.json")["data"];
    EXPECT_EQ(found["samples"], rows.size());
    ASSERT_EQ(found["blocks"].size(), 1u);
    auto const& block = found["blocks"][0];
    EXPECT_NEAR(block["frequency_Hz"].get<double>(), test.frequency_Hz, 0.01 * test.frequency_Hz);
    int counted = 0;
    for (auto const& cycle : block["cycles"]) {
      if (cycle["counts"] == false) continue;
      ++counted;
      // Computes extremes and energy of the cycle from the rows of the file. isolaw's cycle begins and ends at most one
      // sample from the first and last of these rows.
      double largest = -1e9, least = 1e9, energy = 0.0;
      auto const first = static_cast<std::size_t>(std::lround(cycle["first"].get<double>()));
      auto const last = static_cast<std::size_t>(std::lround(cycle["last"].get<double>()));
      for (auto i = first; i <= last; ++i) {
        double const x = 25.4 * rows[i][1].get<double>(), F = 4.4482216152605 * rows[i][2].get<double>();
        largest = std::max(largest, x);
        least = std::min(least, x);
        if (i > first)
          energy +=
              (F + 4.4482216152605 * rows[i - 1][2].get<double>()) / 2.0 * (x - 25.4 * rows[i - 1][1].get<double>());
      }
      EXPECT_NEAR(cycle["d_plus_mm"].get<double>(), largest, 1e-6);
      EXPECT_NEAR(cycle["d_minus_mm"].get<double>(), least, 1e-6);
      EXPECT_NEAR(cycle["energy_kN_mm"].get<double>(), energy, 0.005 * energy);
      EXPECT_NEAR(cycle["amplitude_mm"].get<double>(), 25.4 * test.amplitude_in, 0.02 * 25.4 * test.amplitude_in);
    }
    EXPECT_EQ(counted, 3);
    EXPECT_EQ(block["cycles"].size(), 7u);
  }
}

}  // namespace
}  // namespace isolaw::cli_test
