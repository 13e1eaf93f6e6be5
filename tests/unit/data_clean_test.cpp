// Tests the cleaning of records: moving average, velocity, thinning, centring.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/data/clean.hpp"

namespace isolaw::data {
namespace {

using std::numbers::pi;
using Values = std::vector<double>;

// --- moving average ---

TEST(MovingAverage, ShrinksAtTheEnds) {
  EXPECT_EQ(moving_average({1, 2, 6, 4, 10}, 3), (Values{1, 3, 4, 20.0 / 3.0, 10}));
  EXPECT_EQ(moving_average({1, 2, 6, 4, 10}, 5), (Values{1, 3, 4.6, 20.0 / 3.0, 10}));
  EXPECT_EQ(moving_average({1, 2, 6, 4, 10}, 99), (Values{1, 3, 4.6, 20.0 / 3.0, 10}));
  EXPECT_EQ(moving_average({1, 2, 6}, 1), (Values{1, 2, 6}));
  EXPECT_EQ(moving_average({1, 2}, 5), (Values{1, 2}));
  EXPECT_EQ(moving_average({}, 5), Values{});
}

TEST(MovingAverage, KeepsALineAndShiftsAParabolaByItsCurvature) {
  Values line, parabola;
  for (int i = 0; i < 101; ++i) {
    line.push_back(3.0 * i - 7.0);
    parabola.push_back(1.0 * i * i);
  }
  auto const straight = moving_average(line, 7);
  auto const curved = moving_average(parabola, 7);
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_NEAR(straight[i], line[i], 1e-12);
    double const h = std::min({3.0, static_cast<double>(i), 100.0 - static_cast<double>(i)});
    EXPECT_NEAR(curved[i], parabola[i] + h * (h + 1.0) / 3.0, 1e-9);  // h (h + 1) / 3 is the mean of k^2 over k = -h..h
  }
}

TEST(MovingAverage, IsAsExactAsADirectSumFarAlongARecord) {
  Values values;
  for (int i = 0; i < 200000; ++i) values.push_back(1e6 + std::sin(0.01 * i));
  auto const averages = moving_average(values, 11);
  for (std::size_t i = 199000; i < 199990; ++i) {
    double sum = 0.0;
    for (std::size_t k = i - 5; k <= i + 5; ++k) sum += values[k] - 1e6;
    // The tolerance is four times the distance between neighbouring doubles near 1e6, which is 1.2e-10.
    EXPECT_NEAR(averages[i] - 1e6, sum / 11.0, 5e-10);
  }
}

// --- velocity ---

TEST(CentralDifference, IsExactForQuadraticsOnUnevenTime) {
  Values const time{0.0, 0.1, 0.25, 0.3, 0.7, 0.75, 1.5};
  Values x;
  for (double const t : time) x.push_back(5.0 * t * t - 3.0 * t + 2.0);
  auto const velocity = central_difference(time, x);
  ASSERT_EQ(velocity.size(), time.size());
  for (std::size_t i = 0; i < time.size(); ++i) EXPECT_NEAR(velocity[i], 10.0 * time[i] - 3.0, 1e-12) << i;
}

TEST(CentralDifference, OfShortRecords) {
  EXPECT_EQ(central_difference({}, {}), Values{});
  EXPECT_EQ(central_difference({1.0}, {2.0}), Values{0.0});
  EXPECT_EQ(central_difference({1.0, 3.0}, {2.0, 6.0}), (Values{2.0, 2.0}));
}

// Returns three cycles of a sine with an amplitude of 100 mm and a frequency of 0.5 Hz.
TestRecord sine(int samples_per_cycle, bool with_time = true) {
  TestRecord record;
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const angle = 2.0 * pi * i / samples_per_cycle;
    record.disp_mm.push_back(100.0 * std::sin(angle));
    record.force_kN.push_back(80.0 * std::sin(angle + 0.3));
    if (with_time) record.time_s.push_back(5.0 + 2.0 * i / samples_per_cycle);
  }
  return record;
}

TEST(Clean, LeavesAShortRecordAlone) {
  auto const raw = sine(100);
  auto const record = clean(raw, {});
  EXPECT_EQ(record.disp_mm, raw.disp_mm);
  EXPECT_EQ(record.force_kN, raw.force_kN);
  EXPECT_EQ(record.time_s, raw.time_s);
  EXPECT_EQ(record.vel_mm_s, central_difference(raw.time_s, raw.disp_mm));
  EXPECT_EQ(wording::remarks(record.cleaning),
            (std::vector<std::string>{
                "no smoothing", "all samples kept: 100.0 per cycle is less than twice the 200 asked for",
                "velocity comes from central differences of the averaged displacement, with the recorded times"}));
}

TEST(Clean, AveragesDisplacementAndForceAlike) {
  auto const raw = sine(100);
  auto const record = clean(raw, {.smooth = 5});
  EXPECT_EQ(record.disp_mm, moving_average(raw.disp_mm, 5));
  EXPECT_EQ(record.force_kN, moving_average(raw.force_kN, 5));
  EXPECT_EQ(
      text_of(record.cleaning.front()),
      "displacement and force averaged over 5 samples, fewer at the ends: this removes 0.39 % of a sine of the test's frequency and 3.5 % of its third harmonic");
}

TEST(Clean, ThinsAfterAveragingOverWhatIsDropped) {
  auto const raw = sine(1000);
  auto const record = clean(raw, {});  // every fifth sample is kept
  ASSERT_EQ(record.size(), 601u);
  auto const averaged = moving_average(raw.disp_mm, 5);
  auto const force = moving_average(raw.force_kN, 5);
  auto const velocity = central_difference(raw.time_s, averaged);  // velocities are computed before samples are dropped
  for (std::size_t i = 0; i < record.size(); ++i) {
    EXPECT_EQ(record.time_s[i], raw.time_s[5 * i]);
    EXPECT_EQ(record.disp_mm[i], averaged[5 * i]);
    EXPECT_EQ(record.force_kN[i], force[5 * i]);
    EXPECT_EQ(record.vel_mm_s[i], velocity[5 * i]);
  }
  EXPECT_EQ(
      text_of(record.cleaning.back()),
      "thinned from 1000.0 to 200.0 samples per cycle: every 5th of 3001 samples kept (601), each the average of 5");
}

TEST(Clean, AnEvenStepAveragesOverTheNextOddWindow) {
  auto const raw = sine(850);
  auto const record = clean(raw, {});  // every fourth sample is kept, each the average of five
  ASSERT_EQ(record.size(), 638u);
  auto const averaged = moving_average(raw.disp_mm, 5);
  EXPECT_EQ(record.disp_mm[100], averaged[400]);
}

TEST(Clean, KeepsEverythingWhenAskedOrWhenThereAreNoCycles) {
  auto const all = clean(sine(1000), {.samples_per_cycle = std::nullopt});
  EXPECT_EQ(all.size(), 3001u);
  TestRecord ramp;
  for (int i = 0; i < 5000; ++i) {
    ramp.disp_mm.push_back(0.01 * i);
    ramp.force_kN.push_back(0.02 * i);
  }
  auto const kept = clean(ramp, {});
  EXPECT_EQ(kept.size(), 5000u);
  EXPECT_EQ(text_of(kept.cleaning[1]),
            "all samples kept: the record has no cycles, so samples per cycle are not defined");
}

TEST(Clean, KeepsEverySampleOfARecordThatIsNotCyclic) {
  TestRecord quake;
  double x = 0.0, v = 0.0;
  for (int i = 0; i < 8000; ++i) {  // an oscillator under a ground motion of three frequencies that fades
    double const t = 0.005 * i;
    double const ground = std::exp(-t / 6.0) * (std::sin(9.1 * t) + 1.3 * std::sin(3.7 * t + 1.0) + std::sin(1.3 * t));
    v += 0.005 * (3000.0 * ground - 0.6 * v - 16.0 * x);
    x += 0.005 * v;
    quake.time_s.push_back(t);
    quake.disp_mm.push_back(x);
    quake.force_kN.push_back(0.5 * x + 0.05 * v);
  }
  auto const kept = clean(quake, {});
  EXPECT_EQ(kept.size(), 8000u);
  EXPECT_EQ(text_of(kept.cleaning[1]),
            "all samples kept: the record has no cycles, so samples per cycle are not defined");
}

TEST(Clean, WithoutTimeCountsTheSamplesOfTheFile) {
  auto const record = clean(sine(1000, false), {});
  EXPECT_FALSE(record.has_time());
  ASSERT_EQ(record.size(), 601u);
  EXPECT_EQ(record.time_s[0], 0.0);
  EXPECT_EQ(record.time_s[7], 35.0);
}

TEST(Clean, CentresOnTheReportedCycleOnlyWhenAsked) {
  auto raw = sine(100);
  for (double& x : raw.disp_mm) x += 4.0;
  for (double& F : raw.force_kN) F -= 6.0;
  raw.force_kN[20] = 500.0;  // a spike in cycle 1, which must not matter: the reported cycle is cycle 3
  EXPECT_EQ(clean(raw, {}).disp_mm, raw.disp_mm);
  auto const record = clean(raw, {.center = true});
  EXPECT_NEAR(record.disp_mm[0], 0.0, 1e-9);
  // The force's peaks may lie between two samples, so the centre of the force is exact to 0.1 kN only.
  EXPECT_NEAR(record.force_kN[250], raw.force_kN[250] + 6.0, 0.1);
  EXPECT_TRUE(text_of(record.cleaning.front()).starts_with("centred: 4 mm subtracted from displacement and -6"));
  EXPECT_TRUE(text_of(record.cleaning.front()).ends_with("(max + min) / 2 over cycle 3 of block 1"))
      << text_of(record.cleaning.front());
}

// The record has a block of two cycles at 50 mm and a block of two cycles at 100 mm, with 1000 samples a cycle. Only
// the second cycle at 100 mm is scored, which means that it counts in the objective.
TEST(Clean, KeepsTheChosenPartThroughSmoothingAndThinning) {
  TestRecord raw;
  for (int i = 0; i <= 4000; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 1000.0;
    raw.time_s.push_back(0.002 * i);
    raw.disp_mm.push_back((i < 2000 ? 50.0 : 100.0) * std::sin(phase));
    raw.force_kN.push_back(raw.disp_mm.back() + 20.0 * std::cos(phase));
  }
  Selection const second{parse_numbers("--fit-blocks", "2"), parse_numbers("--fit-cycles", "2")};
  for (auto const& [options, step] : std::vector<std::pair<CleanOptions, std::size_t>>{
           {{.samples_per_cycle = std::nullopt, .scored = second}, 1},
           {{.smooth = 51, .samples_per_cycle = std::nullopt, .scored = second}, 1},
           {{.samples_per_cycle = 200, .scored = second}, 5},
           {{.smooth = 51, .samples_per_cycle = 100, .scored = second}, 10},
           {{.samples_per_cycle = 140, .scored = second}, 7}}) {
    auto const record = clean(raw, options);
    ASSERT_EQ(record.size(), 4000 / step + 1);
    ASSERT_EQ(record.scored.size(), record.size()) << "smooth " << options.smooth << ", step " << step;
    for (std::size_t i = 0; i < record.size(); ++i) {
      if (i * step == 3000) continue;  // this sample lies on the boundary; rounding decides
      EXPECT_EQ(record.is_scored(i), i * step > 3000) << "smooth " << options.smooth << ", sample " << i * step;
    }
  }
  EXPECT_TRUE(clean(raw, {}).scored.empty());
}

}  // namespace
}  // namespace isolaw::data
