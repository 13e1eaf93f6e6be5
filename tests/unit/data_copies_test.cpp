// Tests that a record which was made from another one is found, and that tests of two devices are not taken for copies.
#include "isolaw/data/signals/copies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace isolaw::data {
namespace {

constexpr double peak_kN = 100.0;

// Returns nine cycles at three amplitudes, with 100 samples a cycle. The loop is smooth and has noise of 0.2 % of the
// peak.
TestRecord device(unsigned seed, double hardening = 0.1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  TestRecord record;
  for (int i = 0; i < 900; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 100.0, amplitude = 50.0 * (1 + i / 300);
    double const x = amplitude * std::sin(phase), s = x / 150.0;
    record.time_s.push_back(0.02 * i);
    record.disp_mm.push_back(x + 0.05 * normal(random));
    record.force_kN.push_back(peak_kN * ((0.9 - hardening) * s + hardening * s * s * s) +
                              0.3 * amplitude / 150.0 * peak_kN * std::cos(phase) + 0.2 * normal(random));
  }
  return record;
}

TestRecord changed(TestRecord record, std::function<void(double& time, double& disp, double& force)> const& change) {
  for (std::size_t i = 0; i < record.size(); ++i) change(record.time_s[i], record.disp_mm[i], record.force_kN[i]);
  return record;
}

TestRecord sampled(TestRecord const& record, double first, double step) {
  TestRecord result;
  auto const at = [](std::vector<double> const& values, double place) {
    auto const i = static_cast<std::size_t>(place);
    return std::lerp(values[i], values[i + 1], place - static_cast<double>(i));
  };
  for (double place = first; place < static_cast<double>(record.size() - 1); place += step) {
    result.time_s.push_back(at(record.time_s, place));
    result.disp_mm.push_back(at(record.disp_mm, place));
    result.force_kN.push_back(at(record.force_kN, place));
  }
  return result;
}

bool found(TestRecord const& one, TestRecord const& other) {
  auto const a = trace_of(one), b = trace_of(other);
  EXPECT_EQ(is_altered_copy(a, b), is_altered_copy(b, a));
  return is_altered_copy(a, b);
}

TEST(Copies, AreFoundHoweverTheyWereAltered) {
  auto const original = device(1);
  EXPECT_TRUE(found(original, changed(original, [](double&, double& x, double& f) { x *= 0.97, f *= 1.03; })));
  EXPECT_TRUE(found(original, changed(original, [](double& t, double&, double&) { t += 7.3; })));
  EXPECT_TRUE(found(original, sampled(original, 0.0, 2.0)));
  EXPECT_TRUE(found(original, sampled(original, 41.0, 1.0))) << "its beginning was cut off";
  EXPECT_TRUE(found(original, sampled(original, 0.3, 1.0)));
  EXPECT_TRUE(found(original, sampled(original, 0.0, 1.37)));
  EXPECT_TRUE(found(original, sampled(original, 0.0, 0.45)));
  auto without_time = sampled(original, 0.0, 2.0);
  without_time.time_s.clear();
  EXPECT_TRUE(found(original, without_time));
  for (double const percent : {0.1, 0.3, 1.0}) {
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, percent / 100.0 * peak_kN);
    EXPECT_TRUE(found(original, changed(original, [&](double&, double&, double& f) { f = 1.03 * f + noise(random); })))
        << percent;
  }
}

// Devices of one make may differ only by the noise of their records. Agreement of the forces within the noise is
// therefore no sign of a copy.
TEST(Copies, AreNotSeenInTestsOfTwoDevices) {
  std::vector<Trace> traces;
  for (unsigned seed = 1; seed <= 40; ++seed) traces.push_back(trace_of(device(seed, 0.1 + 0.02 * (seed % 4))));
  for (std::size_t i = 0; i < traces.size(); ++i)
    for (std::size_t j = i + 1; j < traces.size(); ++j)
      EXPECT_FALSE(is_altered_copy(traces[i], traces[j])) << i << ' ' << j;
  EXPECT_FALSE(is_altered_copy(traces[0], trace_of({})));
}

}  // namespace
}  // namespace isolaw::data
