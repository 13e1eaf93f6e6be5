// Tests which block of a record decides the verdict on a device. A faulty block, or one in which the device has lost
// its force, must not decide it.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "isolaw/data/read.hpp"
#include "isolaw/study/acceptance.hpp"
#include "isolaw/study/lot_conditions.hpp"
#include "isolaw/study/verdict.hpp"
#include "isolaw/wording/table.hpp"
#include "motions.hpp"

namespace isolaw::study {
namespace {

using data::testing::Motion;
using rules::Verdict;

DeviceAcceptance assessed(data::Properties const& properties, std::string const& design) {
  std::vector<DeviceAcceptance> devices;
  AssessedTest const test{.device = "D01", .properties = &properties};
  assess_lot(rules::find_rule_set("ntc-2018"), rules::parse_design(design), std::nullopt, {test}, devices);
  return devices.front();
}

data::Properties read(Motion const& motion, std::vector<double> load_kN = {}) {
  return data::cyclic_properties(
      data::record_of_values("test", {motion.disp_mm, motion.force_kN, motion.time_s, std::move(load_kN)}));
}

TEST(Blocks, ADeviceThatLostFortyPercentOfItsForceDoesNotPass) {
  auto motion = Motion().sine(150.0, 0.5, 4).end().loop();
  auto const sound = read(motion);
  auto const design = "K_eff=" + std::to_string(sound.reported->K_eff_kN_per_mm) +
                      ",damping=" + std::to_string(sound.reported->damping_percent) + ",disp=150";
  EXPECT_EQ(device_verdict(assessed(sound, design)).verdict, Verdict::pass);
  for (std::size_t i = 600; i < motion.force_kN.size(); ++i) motion.force_kN[i] *= 0.601;
  auto const acceptance = assessed(read(motion), design);
  EXPECT_EQ(device_verdict(acceptance).verdict, Verdict::not_assessed);
  EXPECT_EQ(acceptance.withheld, "cycle 4 of block 1 has lost 40 % of the force");
  for (auto const& line : acceptance.assessments) EXPECT_NE(line.verdict, Verdict::pass) << line.quantity;
}

TEST(Blocks, AVerdictDoesNotRestOnAFaultyBlock) {
  auto motion = Motion().sine(50.0, 0.5, 3).sine(100.0, 0.5, 3).end().loop();
  for (std::size_t i = 840; i < 860; ++i) motion.force_kN[i] = 0.0;
  auto const properties = read(motion);
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 1);
  auto const K = std::to_string(properties.reported->K_eff_kN_per_mm);
  for (auto const& design : {"K_eff=" + K, "K_eff=" + K + ",disp=100"}) {
    auto const acceptance = assessed(properties, design);
    EXPECT_EQ(acceptance.block, 2) << design;
    EXPECT_EQ(acceptance.withheld, "block 2 is faulty: the force is interrupted");
    EXPECT_EQ(device_verdict(acceptance).verdict, Verdict::not_assessed);
  }
  auto const at_50 = assessed(properties, "K_eff=" + K + ",disp=50");
  EXPECT_EQ(at_50.block, 1);
  EXPECT_EQ(device_verdict(at_50).verdict, Verdict::pass);
}

TEST(Blocks, TheVariationOverLoadsIsAssessedAndTheDesignLoadChooses) {
  Motion motion;
  std::vector<double> load;
  for (double const kN : {1000.0, 3000.0, 2000.0}) {
    motion.sine(150.0, 0.5, 4).hold(0.0, 60.0);
    load.resize(motion.disp_mm.size(), kN);
  }
  motion.end().loop();
  load.push_back(2000.0);
  auto const properties = read(motion, load);
  auto const acceptance = assessed(properties, "K_eff=0.7,damping=16.7,disp=150,load=2000");
  EXPECT_EQ(acceptance.block, 3);
  auto const found =
      std::ranges::find(acceptance.assessments, "K_eff over vertical load", &rules::Assessment::quantity);
  ASSERT_NE(found, acceptance.assessments.end());
  EXPECT_EQ(found->verdict, Verdict::pass) << found->reason;
}

// The record has two blocks of one amplitude. The sound block has the design load, the faulty block another load.
TEST(Blocks, AFaultyBlockOfAnotherLoadIsNotChosen) {
  auto motion = Motion().sine(150.0, 0.5, 4).sine(150.0, 0.5, 4).end().loop();
  std::vector<double> load(motion.disp_mm.size(), 2000.0);
  for (std::size_t i = 0; i < 800; ++i) load[i] = 1000.0;
  for (std::size_t i = 440; i < 460; ++i) motion.force_kN[i] = 0.0;
  auto const properties = read(motion, load);
  ASSERT_FALSE(properties.blocks[0].fault.empty());
  EXPECT_EQ(assessed(properties, "disp=150,load=2000").block, 2);
  EXPECT_EQ(assessed(properties, "disp=150,load=1000").block, 1);
}

// Before the cycles of 100 mm, one device made two cycles of 110 mm and the other six. Everything else is the same.
TEST(Lot, DevicesWithOtherEarlierCyclesWereTestedUnderOtherConditions) {
  auto const lot = [](int cycles_of_one, int cycles_of_other) {
    Summary summary;
    for (int const cycles : {cycles_of_one, cycles_of_other}) {
      auto& device = summary.devices.emplace_back();
      device.properties = read(Motion().sine(110.0, 0.5, cycles).sine(100.0, 0.5, 3).end().loop());
      device.acceptance = assessed(device.properties, "disp=100");
      EXPECT_EQ(device.acceptance.block, 2);
    }
    return summary;
  };
  EXPECT_EQ(conditions_differ(lot(3, 3)), std::nullopt);
  EXPECT_EQ(conditions_differ(lot(3, 4)), std::nullopt);
  auto differing = lot(2, 6);
  auto const found = conditions_differ(differing);
  ASSERT_TRUE(found);
  EXPECT_EQ(
      wording::sentence(*found),
      "The devices were tested under different conditions; 2 to 6 earlier cycles of this amplitude or a larger "
      "one (alike within 1). Tolerances: isolaw's own. Part of the spread of the devices comes from that, and the "
      "lot has no verdict, since a verdict holds for one condition.");
  differing.asked.alike.earlier_cycles = 4.0;
  EXPECT_EQ(conditions_differ(differing), std::nullopt);
  differing.acceptance.rules.same_condition.earlier_cycles = 3.0;
  EXPECT_TRUE(conditions_differ(differing)) << "the rule set comes first";
  differing.devices[1].copy_of = "D1";
  EXPECT_EQ(conditions_differ(differing), std::nullopt);
}

// With two devices at about 100 mm and two at about 200 mm, the usual amplitude is that of one of the devices. Devices
// that were tested at another amplitude must be named.
TEST(Lot, OutliersAreSoughtAmongDevicesOfOneAmplitude) {
  auto const usual = usual_amplitude({100.0, 200.0, 101.0, 201.0}, {}, {});
  EXPECT_EQ(usual.mm, 101.0);
  EXPECT_TRUE(usual.has(100.0));
  EXPECT_FALSE(usual.has(200.0));
  EXPECT_TRUE(usual_amplitude({100.0, 108.0}, {}, {.amplitude_percent = 10.0}).has(108.0));
  std::vector<data::Properties> properties;
  std::vector<AssessedTest> tests;
  for (double const amplitude : {100.0, 100.0, 100.0, 100.0, 150.0})
    properties.push_back(read(Motion().sine(amplitude, 0.5, 3).end().loop()));
  for (auto const& one : properties)
    tests.push_back({.device = "D" + std::to_string(tests.size() + 1), .properties = &one});
  std::vector<DeviceAcceptance> devices;
  auto const lot = assess_lot({}, {}, std::nullopt, tests, devices).lot;
  EXPECT_TRUE(lot.quantities.front().outliers.empty());
  EXPECT_EQ(lot.quantities.front().outlier_note, "not compared, as tested at another amplitude: D5");
}

}  // namespace
}  // namespace isolaw::study
