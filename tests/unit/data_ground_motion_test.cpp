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

std::string complaint(std::string const& bytes, std::optional<double> step_s = {}) {
  try {
    read_ground_motion_text(bytes, "g.txt", step_s);
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
  EXPECT_EQ(read_ground_motion_text(one, "g.csv", 0.02).step_s, 0.02);
  EXPECT_TRUE(contains(complaint(one), "no column of time")) << complaint(one);
  EXPECT_TRUE(contains(complaint(one), "try: --ground-motion-dt")) << complaint(one);
}

TEST(GroundMotion, what_is_wrong_is_refused_with_its_place) {
  auto const says = [](std::string const& bytes, std::string const& words, std::optional<double> step_s = {}) {
    EXPECT_TRUE(contains(complaint(bytes, step_s), words)) << complaint(bytes, step_s);
  };
  says(at2("NPTS=     13, DT=   .0050 SEC"), "g.txt: 12 values; allowed: NPTS = 13, as line 4 says");
  says(at2("NPTS= 12, DT= .005 SEC", "FURLONGS"), "no unit of the acceleration");
  says(at2() + " nan\n", "g.txt:8: 'nan' is no number");
  says(at2() + " 1.0 broken\n", "'broken' is no number");
  says(at2(), "--ground-motion-dt: 0.02 s, and g.txt has samples every 0.005 s", 0.02);
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
