// Tests the reading of ground accelerations as databases and programs write them, and files that isolaw refuses because
// it would have to guess.
#include "isolaw/data/channels/ground_motion.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "contains.hpp"
#include "isolaw/base/error.hpp"

namespace isolaw::data::testing {
namespace {

std::string at2(std::string const& counts = "NPTS=     12, DT=   .0050 SEC", std::string const& unit = "UNITS OF G") {
  return "PEER NGA STRONG MOTION DATABASE RECORD\nA place, 1/1/1990\nACCELERATION TIME SERIES IN " + unit + "\n" +
         counts + "\n  -.1000000E-02  .2000000E-02   .3E-02  0.004 0.005\n .006 .007 .008 .009 .010\n .011 .012\n";
}

std::string columns(std::string const& header, int samples = 20, double step = 0.01, char delimiter = ',') {
  auto text = header + "\n";
  for (int i = 0; i < samples; ++i) text += fmt::format("{:.3f}{}{:.5f}\n", i * step, delimiter, 0.1 * std::sin(i));
  return text;
}

StatedMotion const keys{.how_step = "step", .how_unit = "unit", .where = " of the keys"};

std::string complaint(std::string const& bytes, StatedMotion const& stated = {}) {
  try {
    read_ground_motion_text(bytes, "g.txt", stated);
  } catch (Error const& error) {
    return error.what();
  }
  return {};
}

TEST(GroundMotion, peer_files_are_read_with_their_step_and_unit) {
  for (auto const* counts :
       {"NPTS=     12, DT=   .0050 SEC", "NPTS= 12, DT= .005 SEC,   ", "   12    .0050    NPTS, DT"}) {
    auto const motion = read_ground_motion_text(at2(counts), "g.AT2");
    ASSERT_EQ(motion.acceleration_mm_s2.size(), 12u) << counts;
    EXPECT_EQ(motion.step_s, 0.005) << counts;
    EXPECT_NEAR(motion.acceleration_mm_s2[0], -1e-3 * 9806.65, 1e-9);
    EXPECT_NEAR(motion.acceleration_mm_s2[11], 0.012 * 9806.65, 1e-9);
  }
  EXPECT_NEAR(read_ground_motion_text(at2("NPTS= 12, DT= .01 SEC", "UNITS OF CM/S2"), "g").acceleration_mm_s2[11], 0.12,
              1e-12);
}

std::string values_of_width(int width, std::vector<double> const& values, int decimals) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{:{}.{}f}", values[i], width, decimals) + ((i + 1) % 8 == 0 ? "\n" : "");
  return text + "\n";
}

// Twelve values. When written with a fixed width, some of them follow the one before without a blank.
std::vector<double> const twelve{1.5, -1234.567, -2345.678, 3.0, 4.25, -5.0, 6.0, 7.0, 8.0, -9.5, 10.0, -11.0};

TEST(GroundMotion, files_of_esm_state_their_step_and_unit) {
  std::string esm =
      "EVENT_NAME: X\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 12\nUNITS: cm/s^2\nDATA_TYPE: ACCELERATION\nUSER5: \n";
  for (double const a : twelve) esm += fmt::format("{:.6f}\n", a);
  auto const motion = read_ground_motion_text(esm, "g.asc");
  EXPECT_EQ(motion.step_s, 0.005);
  ASSERT_EQ(motion.acceleration_mm_s2.size(), 12u);
  EXPECT_NEAR(motion.acceleration_mm_s2[1], -12345.67, 1e-9);
  EXPECT_TRUE(contains(motion.recognised, "ESM, 12 samples every 0.005 s"));
  EXPECT_TRUE(contains(complaint(esm + "1.0\n"), "13 values; allowed: 12 values, as the head of the file says"));
}

// The head of the file says that 6182761 counts of the instrument are 3920 gal (cm/s2). The mean of all counts stands
// for zero acceleration.
TEST(GroundMotion, files_of_k_net_are_counts_about_the_zero_of_an_instrument) {
  std::string const head =
      "Origin Time       2000/01/01 00:00:00\nSampling Freq(Hz) 100Hz\nDir.              E-W\n"
      "Scale Factor      3920(gal)/6182761\nMemo.             \n";
  auto const motion = read_ground_motion_text(
      head +
          "   -9000    -8000    -7000    -6000    -9000    -8000    -7000    -6000 \n   -9000    -8000    -7000    -6000 \n",
      "g.EW");
  EXPECT_EQ(motion.step_s, 0.01);
  ASSERT_EQ(motion.acceleration_mm_s2.size(), 12u);
  double const count = 10.0 * 3920.0 / 6182761.0;
  EXPECT_NEAR(motion.acceleration_mm_s2[0], -1500.0 * count, 1e-9);
  ASSERT_TRUE(motion.zero_mm_s2);
  EXPECT_NEAR(*motion.zero_mm_s2, -7500.0 * count, 1e-9);
}

TEST(GroundMotion, files_of_csmip_hold_velocity_behind_the_acceleration) {
  auto const text =
      "Corrected accelerogram\nof a station\n    12 points of accel data equally spaced at   .020 sec, in cm/sec2.  (8f10.3)\n" +
      values_of_width(10, twelve, 3) + "    12 points of veloc data equally spaced at .020 sec, in cm/sec. (8f10.3)\n" +
      values_of_width(10, twelve, 3);
  auto const motion = read_ground_motion_text(text, "g.v2");
  EXPECT_EQ(motion.step_s, 0.02);
  ASSERT_EQ(motion.acceleration_mm_s2.size(), 12u);
  EXPECT_NEAR(motion.acceleration_mm_s2[2], -23456.78, 1e-9);
  EXPECT_TRUE(
      contains(complaint(text + text), "2 components of acceleration; allowed: one component; try: the number"));
  EXPECT_EQ(read_ground_motion_text(text + text, "g.v2", {}, 2).acceleration_mm_s2, motion.acceleration_mm_s2);
}

// The peaks are those that the heads of the files state.
TEST(GroundMotion, files_of_agencies_as_they_were_recorded) {
  auto const motions = std::filesystem::path(ISOLAW_DATA_DIR) / "ground-motions";
  if (!std::filesystem::exists(motions)) GTEST_SKIP() << "measured data are not here: " << motions;
  struct {
    char const* file;
    std::size_t count;
    double step_s, peak_cm_s2;
  } const files[]{{"dmg/nc1091100/ce36456p_CE36456.V2#1", 3251, 0.02, 267.957},
                  {"dmg/ci15481673/CIWLT.V2#2", 15029, 0.02, 0.0},
                  {"smc/nc216859/0111a.smc", 6001, 0.005, 104.408}};
  for (auto const& [file, count, step_s, peak] : files) {
    auto const motion = read_ground_motion(motions / file);
    EXPECT_NEAR(motion.step_s, step_s, 1e-12) << file;
    if (count > 0) {
      EXPECT_EQ(motion.acceleration_mm_s2.size(), count) << file;
    }
    double most = 0.0;
    for (double const a : motion.acceleration_mm_s2) most = std::max(most, std::abs(a) / 10.0);
    if (peak > 0.0) {
      EXPECT_NEAR(most, peak, 0.01) << file;
    }
    EXPECT_LT(most, 1000.0) << file;
  }
  EXPECT_THROW(read_ground_motion(folder / "dmg/nc1091100/ce36456p_CE36456.V2"), Error);
  EXPECT_THROW(read_ground_motion(folder / "usc/ci3144585/017m30lw.e0a"), Error);
}

TEST(GroundMotion, files_of_smc_state_their_rate_among_fifty_numbers) {
  std::string text = "2 CORRECTED ACCELEROGRAM\n";
  for (int i = 1; i < 11; ++i) text += "*\n";
  for (int i = 0; i < 48; ++i)
    text += fmt::format("{:10}", i == 15 ? 2 : i == 16 ? 12 : -32768) + ((i + 1) % 8 == 0 ? "\n" : "");
  for (int i = 0; i < 50; ++i)
    text += fmt::format("{:15.7E}", i == 1 ? 200.0 : 1.7e38) + ((i + 1) % 5 == 0 ? "\n" : "");
  text += "|\n| a comment of 12.5\n" + values_of_width(10, twelve, 3);
  auto const motion = read_ground_motion_text(text, "g.smc");
  EXPECT_EQ(motion.step_s, 0.005);
  ASSERT_EQ(motion.acceleration_mm_s2.size(), 12u);
  EXPECT_NEAR(motion.acceleration_mm_s2[1], -12345.67, 1e-9);
  EXPECT_FALSE(motion.zero_mm_s2);
}

TEST(GroundMotion, of_the_measured_databases) {
  auto const file = std::filesystem::path(ISOLAW_DATA_DIR) / "ground-motion-elcentro1940/IELC180.AT2";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  auto const motion = read_ground_motion(file);
  EXPECT_EQ(motion.acceleration_mm_s2.size(), 4000u);
  EXPECT_EQ(motion.step_s, 0.01);
  double peak = 0.0;
  for (double const a : motion.acceleration_mm_s2) peak = std::max(peak, std::abs(a) / gravity_mm_s2);
  EXPECT_NEAR(peak, 0.3129, 1e-4);  // the peak that the database states
}

TEST(GroundMotion, columns_are_read_by_the_units_of_their_header) {
  struct {
    char const* unit;
    double mm_s2;
  } const written[]{{"[m/s2]", 1e3},   {"(m/s^2)", 1e3}, {"[g]", 9806.65}, {"[gal]", 10.0},
                    {"[cm/s2]", 10.0}, {"[mm/s2]", 1.0}, {"[in/s2]", 25.4}};
  for (auto const& [unit, mm_s2] : written) {
    auto const motion = read_ground_motion_text(columns(fmt::format("time [s],acceleration {}", unit)), "g.csv");
    ASSERT_EQ(motion.acceleration_mm_s2.size(), 20u) << unit;
    EXPECT_NEAR(motion.step_s, 0.01, 1e-12) << unit;
    EXPECT_NEAR(motion.acceleration_mm_s2[2], 0.09093 * mm_s2, 1e-9 * mm_s2) << unit;
  }
  EXPECT_NEAR(read_ground_motion_text(columns("t [ms];a [g]", 20, 10.0, ';'), "g.csv").step_s, 0.01, 1e-12);
  std::string one = "acceleration [g]\n";
  for (int i = 0; i < 20; ++i) one += fmt::format("{:.4f}\n", 0.1 * std::cos(i));
  EXPECT_EQ(read_ground_motion_text(one, "g.csv", {.step_s = 0.02}).step_s, 0.02);
  EXPECT_TRUE(contains(complaint(one, keys), "no column of time")) << complaint(one);
  EXPECT_TRUE(contains(complaint(one, keys), "try: step of the keys")) << complaint(one);
}

// A file without a header is refused until the user states its unit. The user must also state the step of time, unless
// the first column is time.
TEST(GroundMotion, rows_without_a_header_are_read_as_the_user_states) {
  std::string one, two, with_two_channels;
  for (int i = 0; i < 20; ++i) {
    one += fmt::format("{:.4f}\n", 0.1 * std::cos(i));
    two += fmt::format("{:.3f} {:.4f}\n", 0.02 * i, 0.1 * std::cos(i));
    with_two_channels += fmt::format("{:.3f} {:.4f} {:.4f}\n", 0.02 * i, 0.1 * std::cos(i), 0.1);
  }
  StatedMotion both = keys;
  both.step_s = 0.02, both.unit = "m/s2";
  for (auto const& text : {one, two, "time,acceleration\n" + two, "acceleration\n" + one}) {
    auto const motion = read_ground_motion_text(text, "g.txt", both);
    EXPECT_EQ(motion.acceleration_mm_s2.size(), 20u);
    EXPECT_NEAR(motion.acceleration_mm_s2[1], 54.0, 1e-9);
    EXPECT_NEAR(motion.step_s, 0.02, 1e-12);
    bool const timed = text.find(two) != std::string::npos;
    EXPECT_TRUE(contains(complaint(text, keys), timed ? "try: unit of the keys" : "try: step and unit of the keys"))
        << complaint(text, keys);
  }
  auto const timed = read_ground_motion_text(two, "g.txt", {.unit = "m/s2"});
  EXPECT_NEAR(timed.step_s, 0.02, 1e-12);
  EXPECT_NEAR(timed.acceleration_mm_s2[1], 54.0, 1e-9);
  // Two columns of accelerations hold no time.
  std::string unlike;
  for (int i = 0; i < 20; ++i) unlike += fmt::format("{:.4f} {:.4f}\n", 0.1 * std::cos(i), 0.1 * std::sin(i));
  EXPECT_TRUE(contains(complaint(unlike, {.unit = "m/s2"}), "2 columns that may be the acceleration"));
  EXPECT_TRUE(contains(complaint(one, {.unit = "m/s2"}), "no column of time; "));
  EXPECT_TRUE(contains(complaint(two, {.step_s = 0.01, .unit = "g"}), "samples every 0.02 s, and a step of 0.01 s"));
  EXPECT_TRUE(contains(complaint(with_two_channels, both), "3 columns that may be the acceleration"));
  EXPECT_TRUE(contains(complaint(columns("time [s],a [g]"), {.unit = "m/s2"}), "it is not the stated 'm/s2'"));
  EXPECT_TRUE(contains(complaint(at2(), {.unit = "gal"}), "it is not the stated 'gal'"));
  EXPECT_TRUE(contains(complaint(one, {.step_s = 0.02, .unit = "furlong"}), "the unit 'furlong'"));
  EXPECT_NEAR(
      read_ground_motion_text(at2("NPTS= 12, DT= .005 SEC", "FURLONGS"), "g", {.unit = "g"}).acceleration_mm_s2[11],
      0.012 * 9806.65, 1e-9);
}

TEST(GroundMotion, what_is_wrong_is_refused_with_its_place) {
  auto const says = [](std::string const& bytes, std::string const& words, StatedMotion const& stated = {}) {
    EXPECT_TRUE(contains(complaint(bytes, stated), words)) << complaint(bytes, stated);
  };
  says(at2("NPTS=     13, DT=   .0050 SEC"), "g.txt: 12 values; allowed: 13 values, as the head of the file says");
  says(at2("NPTS= 12, DT= .005 SEC", "FURLONGS"), "no unit of the acceleration");
  says(at2() + " nan\n", "g.txt:8: 'nan' is no number");
  says(at2() + " 1.0 broken\n", "'broken' is no number");
  says(at2(), "g.txt: samples every 0.005 s, and a step of 0.02 s is stated", {.step_s = 0.02});
  says(columns("time [s],displacement [mm]"), "no column with a unit of acceleration");
  says(columns("time,acceleration [g]"), "column 'time' has no unit of time");
  auto text = columns("time [s],acceleration [g]");
  says(text + "0.200,nan\n", "g.txt:22: 'nan' is no number");
  says(text + "0.500,0.1\n", "the times are not equally spaced");
  says(columns("time [s],acceleration [g]", 5), "5 samples; allowed: 10 or more");
  std::string still = "time [s],acceleration [g]\n";
  for (int i = 0; i < 20; ++i) still += fmt::format("{:.2f},0.0\n", 0.01 * i);
  says(still, "an acceleration of zero throughout");
  std::string two = "time [s],ax [g],ay [g]\n";
  for (int i = 0; i < 20; ++i) two += fmt::format("{:.2f},0.1,0.2\n", 0.01 * i);
  says(two, "several columns of acceleration: 'ax [g]', 'ay [g]'");
  says("", "empty");
}

}  // namespace
}  // namespace isolaw::data::testing
