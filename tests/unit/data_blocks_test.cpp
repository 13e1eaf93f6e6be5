// Blocks of cycles: where they end, and that a fault or a failure takes the block in which it lies and no other.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/data/read.hpp"
#include "motions.hpp"

namespace isolaw::data::testing {
namespace {

using Counts = std::vector<int>;

Motion stages(std::vector<double> const& amplitudes) {
  Motion motion;
  for (double const amplitude : amplitudes) motion.sine(amplitude, 0.5, 3);
  return motion.end().loop();
}

TestRecord record_of(Motion const& motion, std::vector<double> load_kN = {}) {
  return record_of_values("test", {motion.disp_mm, motion.force_kN, motion.time_s, std::move(load_kN)});
}

std::string texts(std::vector<Finding> const& findings) {
  std::string all;
  for (auto const& finding : findings) all += text_of(finding) + "\n";
  return all;
}

bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

TEST(Blocks, EndWhereTheVerticalLoadChanges) {
  for (double const rest_s : {0.0, 60.0}) {
    Motion motion;
    std::vector<double> load;
    for (double const kN : {1000.0, 3000.0, 2000.0}) {
      motion.sine(150.0, 0.5, 4).hold(0.0, rest_s);
      while (load.size() < motion.disp_mm.size())
        load.push_back(kN + 20.0 * std::sin(pi * motion.time_s[load.size()]));
    }
    motion.end().loop();
    load.push_back(2000.0);
    auto const properties = cyclic_properties(record_of(motion, load));
    ASSERT_EQ(properties.blocks.size(), 3u) << rest_s;
    for (auto const& block : properties.blocks) {
      ASSERT_EQ(block.counted().size(), 4u);
      double const expected = block.number == 1 ? 1000.0 : block.number == 2 ? 3000.0 : 2000.0;
      // The first cycle after a rest has the load of its motion, not that of the rest before it.
      for (auto const* cycle : block.counted()) EXPECT_NEAR(*cycle->N_mean_kN, expected, 0.01 * expected);
    }
  }
}

TEST(Blocks, DoNotEndWhereOneCycleHasAnotherLoadOrNone) {
  auto const motion = Motion().sine(150.0, 0.5, 6).end().loop();
  std::vector<double> once(motion.disp_mm.size(), 1000.0), none(motion.disp_mm.size());
  for (std::size_t i = 400; i < 600; ++i) once[i] = 1300.0;
  for (std::size_t i = 0; i < none.size(); ++i) none[i] = 0.3 * std::sin(0.01 * static_cast<double>(i * i));
  EXPECT_EQ(counted_per_block(segment(motion.disp_mm, motion.time_s, {}, once)), Counts{6});
  EXPECT_LE(counted_per_block(segment(motion.disp_mm, motion.time_s, {}, none)).size(), 6u);
}

TEST(Blocks, EndAtARestBetweenSetsOfCycles) {
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 3).hold(0.0, 30.0).sine(100.0, 0.5, 4).end().cut()),
            (Counts{3, 4}));
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 3).hold(0.0, 1.5).sine(100.0, 0.5, 4).end().cut()), Counts{7});
  Motion each;  // a rest after every cycle belongs to the protocol
  for (int k = 0; k < 8; ++k) each.sine(100.0, 0.5, 1).hold(0.0, 10.0);
  EXPECT_EQ(counted_per_block(each.end().cut()), Counts{8});
}

TEST(Blocks, SpikesAreFoundInASmallStageBeforeALargeOne) {
  auto motion = stages({5.0, 50.0, 100.0});
  double const K = cyclic_properties(record_of(motion)).find(1, 3)->K_eff_kN_per_mm;
  for (std::size_t const at : {230u, 430u}) motion.force_kN[at] += 1.6;  // less than a twentieth of the largest force
  auto const record = record_of(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(contains(texts(record.warnings), "the force has 2 single-sample spikes at 2.3 s (sample 231) and 4.3 s"))
      << texts(record.warnings);
  EXPECT_TRUE(contains(texts(record.warnings), "here block 1;"));
  EXPECT_EQ(properties.find(1, 3), nullptr);
  EXPECT_TRUE(properties.refusal.empty());
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 3);

  ReadOptions repair;
  repair.corrections.repair_spikes = true;
  std::string text = "time [s],disp [mm],force [kN]\n";
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i)
    text += std::to_string(motion.time_s[i]) + "," + std::to_string(motion.disp_mm[i]) + "," +
            std::to_string(motion.force_kN[i]) + "\n";
  auto const repaired = cyclic_properties(read_record_text(text, "test.csv", repair));
  ASSERT_NE(repaired.find(1, 3), nullptr);
  EXPECT_NEAR(repaired.find(1, 3)->K_eff_kN_per_mm, K, 1e-3 * K);
}

TEST(Blocks, AClippedSmallStageIsFoundAndTakesNoOther) {
  auto motion = stages({5.0, 100.0});
  for (std::size_t i = 0; i < 600; ++i) motion.disp_mm[i] = std::min(motion.disp_mm[i], 4.6);
  auto const record = record_of(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(contains(texts(record.warnings), "the displacement is clipped at 4.6 mm")) << texts(record.warnings);
  EXPECT_TRUE(contains(texts(record.warnings), "No cycle of block 1 counts."));
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 2);
}

TEST(Blocks, ADropoutTakesItsBlock) {
  auto motion = stages({5.0, 50.0, 100.0});
  auto const sound = cyclic_properties(record_of(motion));
  for (std::size_t i = 440; i < 460; ++i) motion.force_kN[i] = 0.0;
  auto const record = record_of(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_FALSE(properties.is_false);
  ASSERT_EQ(properties.blocks.size(), 3u);
  EXPECT_TRUE(properties.blocks[0].counted().empty());
  EXPECT_EQ(properties.blocks[0].fault, "the force is interrupted");
  for (int const block : {2, 3}) {
    ASSERT_NE(properties.find(block, 3), nullptr);
    EXPECT_EQ(properties.find(block, 3)->K_eff_kN_per_mm, sound.find(block, 3)->K_eff_kN_per_mm);
  }
  EXPECT_TRUE(contains(texts(record.warnings), "the force drops out")) << texts(record.warnings);
}

TEST(Blocks, ALoopThatGivesEnergyBackTakesItsBlock) {
  auto motion = stages({50.0, 100.0});
  for (std::size_t i = 0; i < 600; ++i)
    motion.force_kN[i] = 0.5 * motion.disp_mm[i] - 5.0 * std::cos(pi * motion.time_s[i]);
  auto const properties = cyclic_properties(motion.view());
  EXPECT_FALSE(properties.is_false);
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 2);
  ASSERT_EQ(properties.faulty.size(), 1u);
  EXPECT_EQ(properties.faulty[0].kind, FindingKind::cycle_gives_energy);
}

TEST(Blocks, AFailureIsNamedAndADeadCycleIsNeverReported) {
  for (double const slope : {0.0005, -0.0005}) {
    auto motion = stages({5.0, 10.0, 20.0, 40.0});
    auto const sound = cyclic_properties(motion.view());
    for (std::size_t i = 2060; i < motion.force_kN.size(); ++i) {  // before the positive peak of the second cycle
      double const left = std::exp(-0.05 * static_cast<double>(i - 2060));
      motion.force_kN[i] = left * motion.force_kN[i] + slope * motion.disp_mm[i];
    }
    auto const record = record_of(motion);
    auto const properties = cyclic_properties(record);
    EXPECT_TRUE(contains(texts(record.warnings), "the force is suddenly lost: cycle 2 of block 4 has"))
        << texts(record.warnings);
    EXPECT_TRUE(properties.refusal.empty()) << texts(properties.refusal);
    for (int block = 1; block <= 3; ++block) {
      ASSERT_NE(properties.find(block, 3), nullptr) << block;
      EXPECT_EQ(properties.find(block, 3)->K_eff_kN_per_mm, sound.find(block, 3)->K_eff_kN_per_mm);
    }
    EXPECT_NE(properties.find(4, 1), nullptr);
    EXPECT_EQ(properties.find(4, 2), nullptr);
    EXPECT_EQ(properties.find(4, 3), nullptr);
    ASSERT_TRUE(properties.reported);
    EXPECT_EQ(properties.reported->block, 3);
  }
}

TEST(Blocks, HeatingAndScraggingAreNoFailure) {
  auto motion = Motion().sine(100.0, 0.5, 30).end().loop();
  for (std::size_t i = 0; i < motion.force_kN.size(); ++i)
    motion.force_kN[i] *= 0.5 + 0.35 * std::exp(-0.003 * static_cast<double>(i)) + 0.3 * std::exp(-0.02 * static_cast<double>(i));
  EXPECT_FALSE(cyclic_properties(motion.view()).failure);
  auto damaged = Motion().sine(100.0, 0.5, 4).end().loop();
  for (std::size_t i = 600; i < damaged.force_kN.size(); ++i) damaged.force_kN[i] *= 0.6;
  auto const properties = cyclic_properties(damaged.view());
  ASSERT_TRUE(properties.failure);
  EXPECT_EQ(properties.failure->number("cycle"), 4.0);
  EXPECT_NEAR(properties.failure->number("percent"), 60.0, 0.5);
  EXPECT_EQ(properties.counted().size(), 4u);
}

TEST(Blocks, NoQuotientByNearlyNothing) {
  Motion motion = Motion().sine(50.0, 1.0, 5).end();
  for (double const t : motion.time_s) motion.force_kN.push_back(100.0 * std::cos(2.0 * pi * t));
  auto const properties = motion.properties();
  ASSERT_FALSE(properties.blocks.empty());
  EXPECT_TRUE(stability(properties.blocks[0], &Cycle::K_eff_kN_per_mm).ratio_to_third.empty());
}

}  // namespace
}  // namespace isolaw::data::testing
