// Tests records that hold several tests of one device. Each test is cut into cycles and cleaned as if it were alone.
// All tests together decide whether samples are weighed by time or by swing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/properties/swing_properties.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {
namespace {

// Returns three cycles of this amplitude, with an elliptic loop of 0.8 kN/mm.
TestRecord cyclic(double amplitude_mm, double period_s = 2.0, int samples_per_cycle = 200) {
  Values values;
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples_per_cycle;
    values.time_s.push_back(period_s * i / samples_per_cycle);
    values.disp_mm.push_back(amplitude_mm * std::sin(phase));
    values.force_kN.push_back(0.8 * amplitude_mm * std::sin(phase) + 0.2 * amplitude_mm * std::cos(phase));
  }
  return record_of_values("record", std::move(values));
}

// This motion only rises, so it has no swings.
TestRecord monotonic() {
  Values values;
  for (int i = 0; i <= 200; ++i) {
    values.time_s.push_back(0.01 * i);
    values.disp_mm.push_back(0.25 * i);
    values.force_kN.push_back(0.2 * i - 3e-4 * i * i);
  }
  return record_of_values("ramp", std::move(values));
}

TestRecord joined_record(std::vector<TestRecord> const& tests) {
  std::vector<NamedTest> named;
  for (std::size_t i = 0; i < tests.size(); ++i)
    named.push_back({.name = std::string(1, static_cast<char>('a' + i)), .record = tests[i]});
  return record_of_tests(std::move(named));
}

std::vector<double> part(std::vector<double> const& values, TestRange const& range) {
  auto const found = range.slice(values);
  return {found.begin(), found.end()};
}

TEST(TestsOfADevice, StandOneAfterAnotherAndComeApartAgain) {
  auto const small = cyclic(50.0), large = cyclic(100.0, 3.0);
  auto const record = joined_record({small, large});
  ASSERT_EQ(record.starts, (std::vector<std::size_t>{0, small.size()}));
  EXPECT_EQ(record.size(), small.size() + large.size());
  EXPECT_EQ(record.tests[1].name, "b");
  EXPECT_EQ(record.tests[1].sha256, large.sha256);
  EXPECT_TRUE(std::ranges::is_sorted(record.time_s, std::ranges::less_equal{})) << "time goes on";
  auto const apart = tests_of(record);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].disp_mm, small.disp_mm);
  EXPECT_EQ(apart[1].force_kN, large.force_kN);
  EXPECT_TRUE(apart[1].starts.empty() && apart[1].tests.empty());
  EXPECT_EQ(joined_record({small}).starts, std::vector<std::size_t>{}) << "one test is a record like any other";
}

TEST(TestsOfADevice, NeedNamesOfTheirOwnAndTimeInAllOrNone) {
  EXPECT_THROW(record_of_tests({{"a", cyclic(50.0)}, {"a", cyclic(60.0)}}), Error);
  auto timeless = cyclic(50.0);
  timeless.time_s.clear();
  EXPECT_THROW(joined_record({cyclic(50.0), timeless}), Error);
  EXPECT_THROW(joined_record({cyclic(50.0), cyclic(50.0)}), Error) << "one record twice";
  EXPECT_THROW(joined_record({joined_record({cyclic(50.0), cyclic(60.0)}), cyclic(70.0)}), Error);
}

// If the tests have no time, the cleaned record numbers the samples instead. The numbers go on from one test of the
// device to the next.
TEST(TestsOfADevice, AreCountedOnWithoutTime) {
  auto const without_time = [](TestRecord record) {
    record.time_s.clear();
    return record;
  };
  auto const both = clean(joined_record({without_time(cyclic(50.0)), without_time(cyclic(60.0))}), {});
  EXPECT_TRUE(std::ranges::is_sorted(both.time_s, std::ranges::less_equal{}));
  EXPECT_EQ(both.time_s[both.starts[1]], 601.0);
}

// If the device's record is taken as a motion, each test must have the velocities that it has alone.
TEST(TestsOfADevice, AreMotionsOfTheirOwn) {
  auto const small = cyclic(50.0), large = cyclic(100.0);
  auto const both = motion_of(joined_record({small, large}));
  EXPECT_EQ(both.starts, (std::vector<std::size_t>{0, small.size()}));
  auto const alone = motion_of(large).vel_mm_s;
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(both.vel_mm_s[small.size() + i], alone[i], 1e-9) << i;
}

TEST(TestsOfADevice, LoseTheLoadThatNotAllHaveAndSaySo) {
  auto loaded = cyclic(50.0);
  loaded.load_kN.assign(loaded.size(), 1000.0);
  auto const both = joined_record({loaded, cyclic(60.0)});
  EXPECT_TRUE(both.load_kN.empty());
  EXPECT_TRUE(std::ranges::any_of(both.recognised, [](Finding const& one) {
    return one.word("text").find("vertical load is left out") != std::string_view::npos;
  }));
}

TEST(TestsOfADevice, KeepFaultsWarningsAndCorrectionsOfEach) {
  auto first = cyclic(50.0), second = cyclic(60.0);
  second.faults = {{.kind = FaultKind::spike, .channel = "force", .samples = {3}}};
  second.warnings = {{.kind = FindingKind::channel_interpolated}};
  second.corrections = {{.kind = FindingKind::friction_removed}};
  auto const record = joined_record({first, second});
  ASSERT_EQ(record.faults.size(), 1u);
  EXPECT_EQ(record.faults[0].samples, std::vector<std::size_t>{first.size() + 3});
  EXPECT_EQ(record.warnings.back().word("part"), "b");
  ASSERT_EQ(record.corrections.size(), 1u);
  EXPECT_EQ(record.corrections[0].word("part"), "b");
}

// A fault in one test must not change the other tests of the device.
TEST(TestsOfADevice, AreFaultyEachByItself) {
  auto const first = cyclic(50.0);
  auto second = cyclic(60.0);
  second.faults = {{.kind = FaultKind::stuck,
                    .channel = "displacement",
                    .samples = {300},
                    .finding = {.kind = FindingKind::signal_stuck, .words = {{"channel", "displacement"}}}}};
  auto const record = joined_record({first, second});
  auto const properties = cyclic_properties(record);
  EXPECT_EQ(properties.blocks[0].counted().size(), 3u);
  EXPECT_TRUE(properties.blocks[1].counted().empty());
  auto const apart = tests_of(record);
  EXPECT_TRUE(apart[0].faults.empty());
  ASSERT_EQ(apart[1].faults.size(), 1u);
  EXPECT_EQ(apart[1].faults[0].samples, std::vector<std::size_t>{300});
  std::vector<int> blocks;
  for (auto const& step : clean(record, {}).cleaning)
    if (step.kind == FindingKind::faulty_not_scored)
      blocks.insert(blocks.end(), step.blocks.begin(), step.blocks.end());
  EXPECT_EQ(blocks, std::vector<int>{2});
}

TEST(TestsOfADevice, AreCutIntoCyclesEachByItself) {
  auto const small = cyclic(50.0), large = cyclic(100.0, 3.0);
  auto const both = cyclic_properties(joined_record({small, large}));
  auto const one = cyclic_properties(small), two = cyclic_properties(large);
  ASSERT_EQ(both.blocks.size(), 2u);
  EXPECT_EQ(both.blocks[0].number, 1);
  EXPECT_EQ(both.blocks[1].number, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(both.blocks[0].cycles[i].energy_kN_mm, one.blocks[0].cycles[i].energy_kN_mm);
    EXPECT_NEAR(both.blocks[1].cycles[i].K_eff_kN_per_mm, two.blocks[0].cycles[i].K_eff_kN_per_mm, 1e-12);
    EXPECT_NEAR(both.blocks[1].cycles[i].Q_d_kN, two.blocks[0].cycles[i].Q_d_kN, 1e-9);
    EXPECT_EQ(both.blocks[1].cycles[i].first, two.blocks[0].cycles[i].first + static_cast<double>(small.size()));
  }
  ASSERT_TRUE(both.reported.has_value());
  EXPECT_EQ(both.reported->block, 2) << "the block of largest amplitude, in whichever test";
  EXPECT_NEAR(swing_properties(joined_record({large, small}))->amplitude_mm, 100.0, 1e-9);
}

// The device has the properties of its cyclic test, although the other test has no cycles.
TEST(TestsOfADevice, OneCyclicTestIsEnoughForProperties) {
  auto const both = cyclic_properties(joined_record({monotonic(), cyclic(80.0)}));
  EXPECT_TRUE(both.refusal.empty());
  EXPECT_NEAR(both.reported.value().amplitude_mm, 80.0, 1e-9);
}

TEST(TestsOfADevice, AreCleanedEachByItself) {
  auto const small = cyclic(50.0, 2.0, 800), large = cyclic(100.0, 3.0, 400);
  CleanOptions const options{.smooth = 3, .center = true};
  auto const both = clean(joined_record({small, large}), options);
  auto const one = clean(small, options), two = clean(large, options);
  ASSERT_EQ(both.starts, (std::vector<std::size_t>{0, one.size()}));
  auto const ranges = test_ranges(both.starts, both.size());
  EXPECT_EQ(part(both.disp_mm, ranges[0]), one.disp_mm);
  EXPECT_EQ(part(both.force_kN, ranges[1]), two.force_kN);
  for (std::size_t i = 0; i < two.size(); ++i)
    EXPECT_NEAR(part(both.vel_mm_s, ranges[1])[i], two.vel_mm_s[i], 1e-9 * 314.0);
  EXPECT_EQ(both.dead_band_mm, std::max(one.dead_band_mm, two.dead_band_mm));
}

// If all swings of a device are alike, the cleaned record states no weights, and its samples count by time. This is so
// for each of the two tests alone. Together they have two amplitudes, so the samples must be weighed by the size and
// duration of their swings (Weighting::swing).
TEST(TestsOfADevice, DecideTogetherHowSamplesCount) {
  auto const small = cyclic(50.0), large = cyclic(100.0);
  EXPECT_TRUE(clean(small, {}).weights.empty());
  auto const both = clean(joined_record({small, large}), {});
  ASSERT_EQ(both.weights.size(), both.size());
  auto const ranges = test_ranges(both.starts, both.size());
  auto const alone = clean(large, {.weights = Weighting::swing}).weights;
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_NEAR(part(both.weights, ranges[1])[i], alone[i], 1e-9);
  EXPECT_TRUE(clean(joined_record({small, cyclic(50.5)}), {}).weights.empty()) << "all swings are alike";
  EXPECT_TRUE(clean(joined_record({small, large}), {.weights = Weighting::time}).weights.empty());
}

TEST(TestsOfADevice, ATestWithoutSwingsCountsByItsTimeAndSaysSo) {
  auto const both = clean(joined_record({monotonic(), cyclic(100.0), cyclic(50.0)}), {});
  auto const first = test_ranges(both.starts, both.size())[0];
  auto const weights = part(both.weights, first);
  EXPECT_NEAR(weights[5], 0.01, 1e-12) << "the sampling interval";
  auto const of_first = std::ranges::find_if(both.cleaning, [](Finding const& step) {
    return step.kind == FindingKind::samples_weighed && step.word("part") == "a";
  });
  ASSERT_NE(of_first, both.cleaning.end());
  EXPECT_EQ(of_first->word("weights"), "time");
}

TEST(TestsOfADevice, BlocksAreNumberedThroughTheDevice) {
  CleanOptions options;
  options.scored.blocks = parse_numbers("--fit-blocks", "2");
  auto const both = clean(joined_record({cyclic(50.0), cyclic(100.0)}), options);
  auto const ranges = test_ranges(both.starts, both.size());
  EXPECT_EQ(std::ranges::count(part(both.scored, ranges[0]), 1.0), 0);
  EXPECT_GT(std::ranges::count(part(both.scored, ranges[1]), 1.0), 590);
  EXPECT_EQ(part(both.block, ranges[1])[100], 2.0);
}

}  // namespace
}  // namespace isolaw::data
