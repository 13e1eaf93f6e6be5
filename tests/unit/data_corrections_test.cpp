// Tests corrections, which remove effects of the rig from a record, describe what they did, and refuse impossible
// values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "finding_text.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/data/signals/corrections.hpp"
#include "motions.hpp"
#include "refusal.hpp"

namespace isolaw::data::testing {
namespace {

// Returns five cycles of 208 mm at 0.5 Hz of a bearing whose stiffness falls exponentially with the distance from each
// reversal. The force is late by `late_s`.
TestRecord bearing(double late_s = 0.0) {
  Motion fine;
  fine.dt_s = 0.0005;
  fine.hold(0.0, 0.5).sine(208.0, 0.5, 5).hold(0.0, 1.0).loop();
  auto const shift = std::lround(late_s / fine.dt_s);
  TestRecord record;
  record.file = "bearing.csv";
  auto const size = static_cast<long>(fine.disp_mm.size());
  for (long i = 0; i < size; i += 10) {
    record.time_s.push_back(fine.time_s[static_cast<std::size_t>(i)]);
    record.disp_mm.push_back(fine.disp_mm[static_cast<std::size_t>(i)]);
    record.force_kN.push_back(fine.force_kN[static_cast<std::size_t>(std::clamp(i - shift, 0L, size - 1))]);
    record.load_kN.push_back(3000.0);
  }
  return record;
}

Cycle reported(TestRecord const& record) {
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(properties.reported) << text_of(properties.refusal);
  return properties.reported.value_or(Cycle{});
}

void expect_same(Cycle const& a, Cycle const& b, double share) {
  EXPECT_NEAR(a.damping_percent, b.damping_percent, share * b.damping_percent);
  EXPECT_NEAR(a.energy_kN_mm, b.energy_kN_mm, share * b.energy_kN_mm);
  EXPECT_NEAR(a.K_eff_kN_per_mm, b.K_eff_kN_per_mm, share * b.K_eff_kN_per_mm);
}

std::string refusal(Corrections const& corrections, TestRecord record = bearing()) {
  return refusal_of([&] { correct(record, corrections); });
}

// The correction of an early force leaves the first samples without a force, so these samples are dropped. The numbers
// of faulty samples must change accordingly.
TEST(Corrections, ASkewMovesFaultsWithTheirSamples) {
  auto record = bearing();
  auto const size = record.size();
  record.faults = {{.kind = FaultKind::spike, .channel = "force", .samples = {3, 300}},
                   {.kind = FaultKind::spike, .channel = "displacement", .samples = {4}}};
  correct(record, {.skew_s = -0.05});
  ASSERT_LT(record.size(), size);
  ASSERT_EQ(record.faults.size(), 1u);
  EXPECT_EQ(record.faults[0].samples, std::vector<std::size_t>{300 - (size - record.size())});
}

TEST(Corrections, NoneLeaveTheRecordAlone) {
  auto record = bearing();
  auto const before = record.force_kN;
  correct(record, {});
  EXPECT_FALSE(Corrections{}.any());
  EXPECT_EQ(record.force_kN, before);
  EXPECT_TRUE(record.corrections.empty() && record.recognised.empty());
}

TEST(Corrections, ASkewedForceIsMovedBack) {
  auto const truth = reported(bearing());
  for (double const late : {0.0200, 0.0125, -0.0100}) {  // 0.0125 s is no multiple of the sampling interval of 0.005 s
    auto record = bearing(late);
    EXPECT_GT(std::abs(reported(record).damping_percent - truth.damping_percent), 1.0);
    auto const size = record.size();
    correct(record, {.skew_s = late});
    expect_same(reported(record), truth, 0.003);
    EXPECT_LT(record.size(), size);
    EXPECT_EQ(record.size(), record.time_s.size());
    EXPECT_EQ(record.size(), record.force_kN.size());
    EXPECT_EQ(record.size(), record.load_kN.size());
    ASSERT_EQ(record.corrections.size(), 1u);
    EXPECT_EQ(record.recognised, record.corrections);
    EXPECT_EQ(record.corrections[0].word("option"), "--skew-ms");
  }
}

TEST(Corrections, FrictionOfTheRigIsTakenOff) {
  auto const truth = reported(bearing());
  auto record = bearing();
  for (std::size_t i = 1; i + 1 < record.size(); ++i) {
    double const motion = record.disp_mm[i + 1] - record.disp_mm[i - 1];
    record.force_kN[i] += motion > 0.0 ? 15.0 : motion < 0.0 ? -15.0 : 0.0;
  }
  EXPECT_GT(reported(record).damping_percent, truth.damping_percent + 4.0);
  auto by_load = record;
  correct(record, {.friction_kN = 15.0});
  expect_same(reported(record), truth, 1e-3);
  EXPECT_EQ(record.force_kN.front(), 0.0) << "at rest before the test";
  EXPECT_EQ(text_of(record.corrections), "the rig's friction of 15 kN was subtracted in the direction of the motion");
  correct(by_load, {.friction_coefficient = 0.005});
  EXPECT_EQ(by_load.force_kN, record.force_kN);
}

// Near a peak, noise of displacement makes the direction of motion seem to change from sample to sample. The friction
// that isolaw subtracts must not change its sign with this noise, whether the rig has friction or not.
TEST(Corrections, FrictionTakenOffLeavesThePeaksToTheForce) {
  auto const truth = bearing();
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (double const of_the_rig : {0.0, 8.0}) {
    auto record = truth;
    for (std::size_t i = 1; i + 1 < record.size(); ++i) {
      double const motion = record.disp_mm[i + 1] - record.disp_mm[i - 1];
      record.force_kN[i] += motion > 0.0 ? of_the_rig : motion < 0.0 ? -of_the_rig : 0.0;
    }
    for (double& x : record.disp_mm) x += noise(random);
    correct(record, {.friction_kN = 8.0});
    auto const wanted = cyclic_properties(truth).blocks, found = cyclic_properties(record).blocks;
    ASSERT_EQ(wanted.size(), found.size());
    for (std::size_t b = 0; b < wanted.size(); ++b)
      for (std::size_t c = 0; c < wanted[b].cycles.size(); ++c) {
        auto const &was = wanted[b].cycles[c], &is = found[b].cycles[c];
        if (!was.counts()) continue;
        EXPECT_NEAR(is.F_plus_kN, was.F_plus_kN, 2.0) << of_the_rig << ' ' << c;
        EXPECT_NEAR(is.F_minus_kN, was.F_minus_kN, 2.0) << of_the_rig << ' ' << c;
      }
  }
}

TEST(Corrections, InertiaOfAMovingMassIsTakenOff) {
  auto const truth = reported(bearing());
  auto record = bearing();
  double const omega = pi, mass = 5000.0;
  for (std::size_t i = 0; i < record.size(); ++i) record.force_kN[i] -= mass * omega * omega * record.disp_mm[i] * 1e-6;
  EXPECT_NEAR(truth.K_eff_kN_per_mm - reported(record).K_eff_kN_per_mm, 0.049, 0.001);
  correct(record, {.moving_mass_kg = mass});
  // The mass lowers the stiffness by 0.049 kN/mm. The test allows 1 % of this as error.
  EXPECT_NEAR(reported(record).K_eff_kN_per_mm, truth.K_eff_kN_per_mm, 0.0005);
  EXPECT_NE(text_of(record.corrections).find("moving mass of 5000 kg"), std::string::npos);
}

TEST(Corrections, TheInertiaOfANoisyMotionIsNoNoise) {
  auto record = bearing();
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (double& x : record.disp_mm) x += noise(generator);
  auto const before = record.force_kN;
  correct(record, {.moving_mass_kg = 5000.0});
  // Take the largest correction while the device moves steadily. The jerks at the start and the end of the motion have
  // larger inertia forces.
  double largest = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i)
    if (record.time_s[i] > 1.0 && record.time_s[i] < 10.0)
      largest = std::max(largest, std::abs(record.force_kN[i] - before[i]));
  EXPECT_GT(largest, 0.99 * 0.0493 * 208.0);
  // Without averaging, noise of 0.02 mm would change the inertia force by 10 kN: 0.02 mm times sqrt(6) times the mass,
  // over the sampling interval squared.
  EXPECT_LT(largest, 1.02 * 0.0493 * 208.0);
}

TEST(Corrections, DoubleShearHalvesTheForceLastOfAll) {
  auto record = bearing();
  for (double& F : record.force_kN) F *= 2.0;
  auto const truth = reported(bearing());
  for (std::size_t i = 1; i + 1 < record.size(); ++i) {
    double const motion = record.disp_mm[i + 1] - record.disp_mm[i - 1];
    record.force_kN[i] += motion > 0.0 ? 15.0 : motion < 0.0 ? -15.0 : 0.0;
  }
  correct(record, {.friction_kN = 15.0, .force_factor = 0.5});  // the load cell feels 15 kN of friction
  expect_same(reported(record), truth, 1e-3);
  EXPECT_EQ(record.corrections.size(), 2u);
}

TEST(Corrections, AreValidated) {
  EXPECT_EQ(refusal({.skew_s = 0.01}), "");
  EXPECT_EQ(refusal({.skew_s = 1.5}),
            "--skew-ms: 1500 ms; allowed: -1000 to 1000 ms; try: positive where the force is later than displacement");
  EXPECT_NE(refusal({.friction_kN = -1.0}).find("--rig-friction: -1 kN"), std::string::npos);
  EXPECT_NE(refusal({.friction_coefficient = 0.5}).find("--rig-friction-coefficient: 0.5"), std::string::npos);
  EXPECT_NE(refusal({.moving_mass_kg = -2.0}).find("--moving-mass: -2 kg"), std::string::npos);
  EXPECT_NE(refusal({.force_factor = -1.0}).find("--flip-force"), std::string::npos);
  EXPECT_NE(refusal({.force_factor = std::numeric_limits<double>::quiet_NaN()}), "");
  EXPECT_NE(refusal({.friction_kN = 1.0, .friction_coefficient = 0.01}).find("one of the two"), std::string::npos);
  auto const both = refusal({.skew_s = 2.0, .moving_mass_kg = -1.0});
  EXPECT_NE(both.find("--skew-ms"), std::string::npos);
  EXPECT_NE(both.find("--moving-mass"), std::string::npos) << "all that is wrong at once";
}

TEST(Corrections, CountTheSamplesLostToASkew) {
  auto const said = [](double skew_s) {
    auto record = bearing();  // one sample each 0.005 s
    auto const before = record.size();
    correct(record, {.skew_s = skew_s});
    return std::pair(before - record.size(), text_of(record.corrections));
  };
  auto const [one, of_one] = said(0.004);
  EXPECT_EQ(one, 1u);
  EXPECT_NE(of_one.find("; 1 sample without a force dropped"), std::string::npos) << of_one;
  auto const [two, of_two] = said(0.009);
  EXPECT_EQ(two, 2u);
  EXPECT_NE(of_two.find("; 2 samples without a force dropped"), std::string::npos) << of_two;
}

TEST(Corrections, NeedTheirChannels) {
  auto record = bearing();
  record.time_s.clear();
  record.load_kN.clear();
  EXPECT_NE(refusal({.skew_s = 0.01}, record).find("--skew-ms for a record without time"), std::string::npos);
  EXPECT_NE(refusal({.moving_mass_kg = 1.0}, record).find("--dt SECONDS"), std::string::npos);
  EXPECT_NE(refusal({.friction_coefficient = 0.01}, record).find("without a vertical load"), std::string::npos);
  EXPECT_EQ(refusal({.friction_kN = 1.0}, record), "");
  TestRecord tiny = bearing();
  for (auto* channel : {&tiny.time_s, &tiny.disp_mm, &tiny.force_kN, &tiny.load_kN}) channel->resize(4);
  EXPECT_NE(refusal({.skew_s = 0.5}, tiny).find("--skew-ms"), std::string::npos);
  EXPECT_EQ(refusal({.friction_kN = 1.0, .moving_mass_kg = 1.0}, tiny), "");
}

}  // namespace
}  // namespace isolaw::data::testing
