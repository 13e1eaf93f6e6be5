#include "isolaw/data/cycles/swing_sizes.hpp"
#include "isolaw/data/cycles/swings.hpp"
#include "isolaw/data/properties/swing_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace isolaw::data {
namespace {

struct SampledMotion {
  std::vector<double> time_s, disp_mm;
};
SampledMotion sampled_motion(double interval_s, double end_s, double (*disp_mm)(double)) {
  SampledMotion h;
  auto const count = static_cast<std::size_t>(std::lround(end_s / interval_s)) + 1;
  for (std::size_t i = 0; i < count; ++i) {
    h.time_s.push_back(interval_s * static_cast<double>(i));
    h.disp_mm.push_back(disp_mm(h.time_s.back()));
  }
  return h;
}
double unit_sine(double t) {
  return std::sin(2.0 * std::numbers::pi * t);
}

// Returns the weighted mean of |computed - measured| divided by the weighted standard deviation of the measured force.
double misfit(std::vector<double> const& weights, std::vector<double> const& measured,
              std::vector<double> const& computed) {
  double const sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  double mean = 0.0, off = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    mean += weights[i] / sum * measured[i];
    off += weights[i] / sum * std::abs(computed[i] - measured[i]);
  }
  for (std::size_t i = 0; i < weights.size(); ++i)
    variance += weights[i] / sum * (measured[i] - mean) * (measured[i] - mean);
  return off / std::sqrt(variance);
}

// The record has ninety small cycles and then ten cycles with ten times their amplitude. The measured force equals the
// displacement. One computed force is a fifth too large in the large cycles, from 90 s on. The other computed force is
// a fifth too large in the small cycles. The expected misfits come from another program, for samples every 2.5 ms.
TEST(Swings, WeighTheLargeCyclesOfAnIrregularRecord) {
  auto const h = sampled_motion(0.0025, 100.0, [](double t) { return (t <= 90.0 ? 10.0 : 100.0) * unit_sine(t); });
  auto too_large = h.disp_mm, small_too_large = h.disp_mm;
  for (std::size_t i = 0; i < h.time_s.size(); ++i) (h.time_s[i] >= 90.0 ? too_large : small_too_large)[i] *= 1.2;
  auto const weights = [&](Weighting weighting) { return sample_weights(h.disp_mm, h.time_s, weighting); };
  EXPECT_NEAR(misfit(weights(Weighting::time), h.disp_mm, too_large), 0.054538, 1e-6);
  EXPECT_NEAR(misfit(weights(Weighting::travel), h.disp_mm, too_large), 0.125089, 1e-6);
  EXPECT_NEAR(misfit(weights(Weighting::swing), h.disp_mm, too_large), 0.128577, 1e-6);
  EXPECT_NEAR(misfit(weights(Weighting::time), h.disp_mm, small_too_large), 0.049086, 2e-6);
}

// The weight of a sample is its interval of 5 ms times the half range over the duration of its swing. That is 10 mm in
// 0.25 s = 40 mm/s before 10 s, and 100 mm in 0.5 s = 200 mm/s afterwards.
TEST(Swings, CountByHalfRangeOverDuration) {
  auto const h = sampled_motion(0.005, 20.0,
                                [](double t) { return t <= 10.0 ? 10.0 * unit_sine(2.0 * t) : 100.0 * unit_sine(t); });
  auto const weights = sample_weights(h.disp_mm, h.time_s, Weighting::swing);
  EXPECT_NEAR(weights[1000], 0.005 * 40.0, 1e-9);   // at 5 s
  EXPECT_NEAR(weights[3000], 0.005 * 200.0, 1e-9);  // at 15 s
  EXPECT_EQ(weights.front(), 0.0);
  EXPECT_EQ(weights.back(), 0.0);
}

TEST(Swings, OfOneAmplitudeWeighAsTime) {
  auto const h = sampled_motion(0.005, 10.0, [](double t) { return 100.0 * unit_sine(t); });
  auto too_large = h.disp_mm;
  for (auto& force : too_large) force *= 1.2;
  auto const found = swings(h.disp_mm, h.time_s);
  EXPECT_EQ(found.size(), 19u);
  double const by_time = misfit(sample_weights(h.disp_mm, h.time_s, Weighting::time), h.disp_mm, too_large);
  double const by_swing = misfit(sample_weights(h.disp_mm, h.time_s, Weighting::swing), h.disp_mm, too_large);
  EXPECT_NEAR(by_swing, by_time, 1e-3 * by_time);
}

TEST(Swings, OfARecordWithoutTimeAreMeasuredInSamples) {
  std::vector<double> const disp{0, 10, 0, -10, 0, 10, 0};
  auto const found = swings(disp, {});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].first, 1u);
  EXPECT_EQ(found[0].last, 3u);
  EXPECT_EQ(found[0].half_range_mm, 10.0);
  EXPECT_EQ(found[0].duration, 2.0);
}

TEST(Swings, LeaveOutReturnsOfLessThanAFortiethOfTheRange) {
  std::vector<double> const disp{0, 10, 9.6, 10, -10, -9.4, -10, 10, 0};  // returns below 20 / 40 = 0.5 are left out
  auto const found = swings(disp, {});
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].first, 1u);  // the first of two equal extremes
  EXPECT_EQ(found[0].last, 4u);
  EXPECT_EQ(found[1].last, 5u);
}

TEST(Swings, AMotionWithoutTwoTurningPointsIsWeighedByTime) {
  std::vector<double> const pulse{0, 5, 10, 5, 0}, time{0, 1, 3, 4, 5};
  EXPECT_TRUE(swings(pulse, time).empty());
  EXPECT_EQ(sample_weights(pulse, time, Weighting::swing), sample_weights(pulse, time, Weighting::time));
  std::vector<double> const rest(20, 3.0);
  EXPECT_TRUE(swings(rest, {}).empty());
  EXPECT_TRUE(swings({}, {}).empty());
  EXPECT_TRUE(sample_weights({}, {}, Weighting::swing).empty());
}

// The second motion is the first with a rest of 60 s in the middle of a swing. The rest must have no weight and must
// not change the half range or the duration of the swing that it interrupts.
TEST(Swings, DoNotCountRest) {
  auto const moving = sampled_motion(0.01, 5.0, [](double t) { return 100.0 * unit_sine(t); });
  auto held = sampled_motion(0.01, 65.0, [](double t) {
    return 100.0 * unit_sine(t < 2.5 ? t : t < 62.5 ? 2.5 : t - 60.0);
  });
  for (std::size_t i = 250; i < 6250; i += 2) held.disp_mm[i] += 0.5;  // tremor of less than 1 % of the range
  auto const found = swings(held.disp_mm, held.time_s), expected = swings(moving.disp_mm, moving.time_s);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].half_range_mm, expected[i].half_range_mm, 1e-9);
    // The samples at both ends of the hold count as rest, so durations may differ by two intervals of 0.01 s.
    EXPECT_NEAR(found[i].duration, expected[i].duration, 0.02) << i;
  }
  auto const weights = sample_weights(held.disp_mm, held.time_s, Weighting::swing);
  EXPECT_EQ(weights[3000], 0.0);  // at 30 s
}

TEST(Swings, TheWayToALargerLevelIsOneSwing) {
  std::vector<double> disp;
  for (int i = 0; i <= 400; ++i)
    disp.push_back((i <= 200 ? 30.0 : 100.0) * std::sin(2.0 * std::numbers::pi * i / 100.0));
  auto const found = swings(disp, {});
  auto const up = std::ranges::find(found, 65.0, [](Swing const& s) { return std::round(s.half_range_mm); });
  ASSERT_NE(up, found.end());
  EXPECT_NEAR(disp[up->first], -30.0, 1e-9);
  EXPECT_NEAR(disp[up->last], 100.0, 1e-9);
}

// The force is x + 30 cos(2 pi t). Half a loop, 200 mm wide and 30 kN high, has the area pi / 2 * 100 * 30 kN mm.
TEST(SwingProperties, OfAnEllipse) {
  auto const h = sampled_motion(0.001, 10.0, [](double t) { return 100.0 * unit_sine(t); });
  std::vector<double> force;
  for (std::size_t i = 0; i < h.time_s.size(); ++i)
    force.push_back(h.disp_mm[i] + 30.0 * std::cos(2.0 * std::numbers::pi * h.time_s[i]));
  auto const found = swing_properties(h.disp_mm, force, h.time_s);
  ASSERT_TRUE(found);
  auto const swings_counted = 2.0 * static_cast<double>(found->pairs);
  EXPECT_EQ(found->pairs, 18u);  // 19 swings between 20 turning points
  EXPECT_NEAR(found->force_kN / swings_counted, 200.0, 1e-6);
  EXPECT_NEAR(found->energy_kN_mm / swings_counted, 4712.39, 0.1);
  EXPECT_NEAR(found->K_kN_per_mm, 1.0, 1e-9);
  EXPECT_NEAR(found->damping_percent, 15.0, 1e-3);
  auto moved = force;
  for (auto& f : moved) f += 7.0;
  EXPECT_NEAR(swing_properties(h.disp_mm, moved, h.time_s)->damping_percent, found->damping_percent, 1e-9);
  EXPECT_NEAR(swing_properties(h.disp_mm, moved, h.time_s)->K_kN_per_mm, found->K_kN_per_mm, 1e-12);
  // If the device moves further to the positive side, the damping must still be finite.
  auto uneven = h.disp_mm;
  for (auto& x : uneven) x *= x > 0.0 ? 1.1 : 0.9;
  EXPECT_TRUE(std::isfinite(swing_properties(uneven, force, h.time_s)->damping_percent));
}

// The cycles of 100 mm are softer than those of 10 mm. The properties must be those of the cycles of 100 mm.
TEST(SwingProperties, AreThoseOfTheLargestSwings) {
  auto const h = sampled_motion(0.0025, 100.0, [](double t) { return (t <= 90.0 ? 10.0 : 100.0) * unit_sine(t); });
  std::vector<double> force;
  for (std::size_t i = 0; i < h.time_s.size(); ++i) force.push_back((h.time_s[i] <= 90.0 ? 5.0 : 1.0) * h.disp_mm[i]);
  auto const found = swing_properties(h.disp_mm, force, h.time_s);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->amplitude_mm, 100.0, 0.1);
  EXPECT_NEAR(found->K_kN_per_mm, 1.0, 1e-9);
  EXPECT_FALSE(swing_properties({{0, 1, 0}}, {{0, 1, 0}}, {}));
}

// Around the turns of a slow swing the displacement changes little, for longer than a fast swing lasts. These samples
// must not be taken for a rest, so they must have weight.
TEST(Swings, CountTheTurnsOfSlowSwingsAmongFastOnes) {
  auto const h = sampled_motion(
      0.01, 35.0, [](double t) { return t < 20.0 ? 10.0 * unit_sine(2.0 * t) : 100.0 * unit_sine(0.2 * (t - 20.0)); });
  auto const weights = sample_weights(h.disp_mm, h.time_s, Weighting::swing);
  std::size_t near_turns = 0;
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (h.time_s[i] > 22.0 && h.time_s[i] < 33.0 && std::abs(h.disp_mm[i]) > 98.0) {
      ++near_turns;
      EXPECT_GT(weights[i], 0.0) << h.time_s[i];
    }
  EXPECT_GT(near_turns, 50u);
}

// The record has cycles of 30 mm and then of 100 mm. The swing that leads from the small cycles to the large ones must
// count as large.
TEST(SwingSizes, TakeTheWayUpToALargerLevelForLarge) {
  auto const h = sampled_motion(0.01, 10.0, [](double t) { return (t < 5.0 ? 30.0 : 100.0) * unit_sine(t); });
  FitRecord record{.time_s = h.time_s, .disp_mm = h.disp_mm, .vel_mm_s = std::vector<double>(h.time_s.size())};
  record.force_kN = h.disp_mm;
  std::array const tests{record};
  auto const sizes = swing_sizes(tests, Weighting::time);
  EXPECT_TRUE(sizes.shows_larger_swings);
  auto const at = [&](double t) { return static_cast<std::size_t>(std::lround(t / 0.01)); };
  auto const& test = sizes.tests.front();
  EXPECT_GT(test.small[at(3.0)], 0.0);
  EXPECT_EQ(test.large[at(3.0)], 0.0);
  EXPECT_GT(test.large[at(5.1)], 0.0);  // on the way from -30 to 100 mm
  EXPECT_EQ(test.small[at(5.1)], 0.0);
  EXPECT_GT(test.large[at(8.0)], 0.0);
  // Small and large swings together have the weight of all of them.
  auto const total = [](std::vector<double> const& w) { return std::accumulate(w.begin(), w.end(), 0.0); };
  auto const all = scored_swings(record);
  EXPECT_NEAR(total(test.small) + total(test.large),
              total(weights_within(all, record.disp_mm, record.time_s, Weighting::time)), 1e-9);
}

TEST(SwingSizes, DoNotTellWithoutTwoLargeAndFourSmallSwings) {
  auto const told = [](double small_until, double end) {
    SampledMotion h;
    for (double t = 0.0; t <= end; t += 0.01) {
      h.time_s.push_back(t);
      h.disp_mm.push_back((t < small_until ? 30.0 : 100.0) * unit_sine(t));
    }
    FitRecord record{.time_s = h.time_s, .disp_mm = h.disp_mm, .vel_mm_s = std::vector<double>(h.time_s.size())};
    std::array const tests{record};
    return swing_sizes(tests, Weighting::time).shows_larger_swings;
  };
  EXPECT_TRUE(told(5.0, 7.0));
  EXPECT_FALSE(told(5.0, 5.5));    // only one swing of 100 mm
  EXPECT_FALSE(told(2.0, 7.0));    // only three swings of 30 mm
  EXPECT_FALSE(told(0.0, 7.0));    // all swings have one amplitude
  EXPECT_FALSE(told(98.0, 99.8));  // the large swings hold less than a twentieth of the time
}

FitRecord five_cycles(double amplitude_mm) {
  FitRecord record;
  for (double t = 0.0; t <= 5.0; t += 0.01) {
    record.time_s.push_back(t);
    record.disp_mm.push_back(amplitude_mm * unit_sine(t));
    record.vel_mm_s.push_back(0.0);
  }
  return record;
}

// Swings of up to 0.7 of the largest displacement are small, the others large. The amplitude of the first test is 0.68
// times that of the second test, so its swings must be small. With 0.72 times that amplitude, its swings must be large.
TEST(SwingSizes, PartAtSevenTenthsOfTheLargestDisplacement) {
  for (double const amplitude_mm : {68.0, 72.0}) {
    std::array const tests{five_cycles(amplitude_mm), five_cycles(100.0)};
    auto const sizes = swing_sizes(tests, Weighting::time);
    EXPECT_EQ(sizes.tests[0].small.empty(), amplitude_mm > 70.0) << amplitude_mm;
    EXPECT_EQ(sizes.tests[0].large.empty(), amplitude_mm < 70.0) << amplitude_mm;
  }
}

// Small and large are relative to the largest displacement over all tests of a device. One test may therefore have only
// small swings and another only large ones.
TEST(SwingSizes, AreThoseOfAllTestsOfADevice) {
  auto const small = five_cycles(30.0), large = five_cycles(100.0);
  std::array const tests{small, large};
  auto const sizes = swing_sizes(tests, Weighting::time);
  EXPECT_TRUE(sizes.shows_larger_swings);
  EXPECT_FALSE(sizes.tests[0].small.empty());
  EXPECT_TRUE(sizes.tests[0].large.empty());
  EXPECT_TRUE(sizes.tests[1].small.empty());
  EXPECT_FALSE(sizes.tests[1].large.empty());
}

}  // namespace
}  // namespace isolaw::data
