// Measured records. They lie beside the repository in the workshop and are never copied into it: without them, skipped.
#include <cmath>

#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

fs::path const data = ISOLAW_DATA_DIR;
Words const reduced{"--runs", "1", "--population", "20", "--generations", "4", "--out", "O"};

class RealInput : public InFreshDirectory {
 protected:
  void expect_finite_objectives(std::string const& device, double most) {
    auto const summary = json("O/summary.json");
    ASSERT_EQ(summary["laws"].size(), 7u);
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
  // 0.5 Hz: that is what makes the sampling interval.
  EXPECT_NEAR(found["samples_per_cycle"].get<double>() * 0.00214823, 2.0, 0.01);
  ASSERT_EQ(found["blocks"].size(), 3u);
  for (auto const& block : found["blocks"]) EXPECT_EQ(block["cycles"].size(), 7u);
}

TEST_F(Bearing, calibrates_with_all_laws) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const o = isolaw(Words{"calibrate", file, "--laws", "all", "--dt", "0.00214823"} + reduced);
  EXPECT_EQ(o.code, 0) << o;
  expect_finite_objectives("cyclic-24-49-98pct", 1.0);
}

TEST_F(Bearing, without_a_sampling_interval_the_two_laws_that_need_velocity_are_refused) {
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const o = isolaw(Words{"calibrate", file} + reduced);
  EXPECT_EQ(o.code, 1) << o;
  auto const summary = json("O/summary.json");
  for (auto const& law : summary["laws"]) {
    auto const& fit = law["devices"].at(0);
    bool const needs_time = law["id"] == "jankowski" || law["id"] == "hwang-wu";
    EXPECT_EQ(fit["status"], needs_time ? "refused" : "ok") << law["id"];
    EXPECT_EQ(contains(fit["message"].get<std::string>(), "--dt SECONDS"), needs_time) << law["id"];
  }
}

class FrictionDamper : public RealInput {
 protected:
  fs::path const packed = data / "friction-damper-arts/ds2_0.5Hz_30lb_1in.json.xz";
  // Rows [time s, displacement in, friction force kip, ...] as CSV.
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
      EXPECT_NEAR(cycle["amplitude_mm"].get<double>(), 25.4, 0.5);  // 1 in, after the ramp
    }
  EXPECT_EQ(counted, 3);
  auto const o = isolaw(Words{"calibrate", "damper.csv"} + reduced);
  EXPECT_EQ(o.code, 0) << o;
  expect_finite_objectives("damper", 2.0);
}

}  // namespace
}  // namespace isolaw::cli_test
