// Tests where blocks of cycles end. A fault of a signal or a failure of the device must affect only the block in which
// it lies.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "motions.hpp"

namespace isolaw::data::testing {
namespace {

Motion in_stages(std::vector<double> const& amplitudes) {
  Motion motion;
  for (double const amplitude : amplitudes) motion.sine(amplitude, 0.5, 3);
  return motion.end().loop();
}

TestRecord record_of_motion(Motion const& motion, std::vector<double> load_kN = {}) {
  return record_of_values("test", {motion.disp_mm, motion.force_kN, motion.time_s, std::move(load_kN)});
}

std::string said_in(std::vector<Finding> const& findings) {
  std::string all;
  for (auto const& finding : findings) all += text_of(finding) + "\n";
  return all;
}

TEST(Blocks, EndWhereTheVerticalLoadChanges) {
  for (double const rest_s : {0.0, 60.0}) {
    Motion motion;
    std::vector<double> load;
    for (double const kN : {1000.0, 3000.0, 2000.0}) {
      motion.sine(150.0, 0.5, 4).hold(0.0, rest_s);
      while (load.size() < motion.disp_mm.size()) load.push_back(kN + 20.0 * std::sin(pi * motion.time_s[load.size()]));
    }
    motion.end().loop();
    load.push_back(2000.0);
    auto const properties = cyclic_properties(record_of_motion(motion, load));
    ASSERT_EQ(properties.blocks.size(), 3u) << rest_s;
    for (auto const& block : properties.blocks) {
      ASSERT_EQ(block.counted().size(), 4u);
      double const expected = block.number == 1 ? 1000.0 : block.number == 2 ? 3000.0 : 2000.0;
      // The mean load of the first cycle after a rest is taken over its motion, without the rest before it.
      for (auto const* cycle : block.counted()) EXPECT_NEAR(*cycle->N_mean_kN, expected, 0.01 * expected);
    }
  }
}

TEST(Blocks, DoNotEndWhereOneCycleHasAnotherLoadOrNone) {
  auto const motion = Motion().sine(150.0, 0.5, 6).end().loop();
  std::vector<double> once(motion.disp_mm.size(), 1000.0), none(motion.disp_mm.size());
  for (std::size_t i = 400; i < 600; ++i) once[i] = 1300.0;
  for (std::size_t i = 0; i < none.size(); ++i) none[i] = 0.3 * std::sin(0.01 * static_cast<double>(i * i));
  EXPECT_EQ(counted_per_block(segment(motion.disp_mm, motion.time_s, {}, {.load_kN = once})), std::vector<int>{6});
  EXPECT_EQ(counted_per_block(segment(motion.disp_mm, motion.time_s, {}, {.load_kN = none})), std::vector<int>{6});
}

TEST(Blocks, EndAtARestBetweenSetsOfCycles) {
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 3).hold(0.0, 30.0).sine(100.0, 0.5, 4).end().cut()),
            (std::vector<int>{3, 4}));
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 3).hold(0.0, 1.5).sine(100.0, 0.5, 4).end().cut()),
            std::vector<int>{7});
  Motion each;  // with a rest after every cycle; such rests end no block
  for (int k = 0; k < 8; ++k) each.sine(100.0, 0.5, 1).hold(0.0, 10.0);
  EXPECT_EQ(counted_per_block(each.end().cut()), std::vector<int>{8});
}

TEST(Blocks, SpikesAreFoundInASmallStageBeforeALargeOne) {
  auto motion = in_stages({5.0, 50.0, 100.0});
  double const K = cyclic_properties(record_of_motion(motion)).find(1, 3)->K_eff_kN_per_mm;
  for (std::size_t const at : {230u, 430u}) motion.force_kN[at] += 1.6;  // less than a twentieth of the largest force
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(
      contains(said_in(record.warnings), "the force has 2 single-sample spikes at 2.3 s (sample 231) and 4.3 s"))
      << said_in(record.warnings);
  EXPECT_TRUE(contains(said_in(record.warnings), "here block 1;"));
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
  auto motion = in_stages({5.0, 100.0});
  for (std::size_t i = 0; i < 600; ++i) motion.disp_mm[i] = std::min(motion.disp_mm[i], 4.6);
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(contains(said_in(record.warnings), "the displacement is clipped at 4.6 mm")) << said_in(record.warnings);
  EXPECT_TRUE(contains(said_in(record.warnings), "No cycle of block 1 counts."));
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 2);
}

TEST(Blocks, ADropoutTakesItsBlock) {
  auto motion = in_stages({5.0, 50.0, 100.0});
  auto const sound = cyclic_properties(record_of_motion(motion));
  for (std::size_t i = 440; i < 460; ++i) motion.force_kN[i] = 0.0;
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_FALSE(properties.refusal_is_of_fault);
  ASSERT_EQ(properties.blocks.size(), 3u);
  EXPECT_TRUE(properties.blocks[0].counted().empty());
  EXPECT_EQ(properties.blocks[0].fault, "the force is interrupted");
  for (int const block : {2, 3}) {
    ASSERT_NE(properties.find(block, 3), nullptr);
    EXPECT_EQ(properties.find(block, 3)->K_eff_kN_per_mm, sound.find(block, 3)->K_eff_kN_per_mm);
  }
  EXPECT_TRUE(contains(said_in(record.warnings), "the force drops out")) << said_in(record.warnings);
}

TEST(Blocks, ALoopThatGivesEnergyBackTakesItsBlock) {
  auto motion = in_stages({50.0, 100.0});
  for (std::size_t i = 0; i < 600; ++i)
    motion.force_kN[i] = 0.5 * motion.disp_mm[i] - 5.0 * std::cos(pi * motion.time_s[i]);
  auto const properties = cyclic_properties(motion.view());
  EXPECT_FALSE(properties.refusal_is_of_fault);
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 2);
  ASSERT_EQ(properties.block_faults.size(), 1u);
  EXPECT_EQ(properties.block_faults[0].kind, FindingKind::cycle_gives_energy);
}

// The device fails in the third cycle. This cycle keeps one of its peaks and most of its energy, so only the next
// cycle, which has almost no force, shows the failure.
TEST(Blocks, TheCycleInWhichTheForceGoesAfterAPeakDoesNotCount) {
  auto motion = Motion().sine(100.0, 0.5, 5).end().loop();
  auto const sound = motion.properties();
  for (std::size_t i = 520; i < motion.force_kN.size(); ++i)
    motion.force_kN[i] = 0.01 * std::sin(0.7 * static_cast<double>(i));
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(contains(said_in(record.warnings), "the force is suddenly lost: cycle 3 of block 1 has"))
      << said_in(record.warnings);
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.counted().size(), 2u);
  EXPECT_EQ(properties.reported->K_eff_kN_per_mm, sound.find(1, 2)->K_eff_kN_per_mm);
}

// A logger writes 0 where it has no value. The zeros must be reported as spikes, and no energy must be reported: with
// the zeros it would be too small.
TEST(Blocks, OneValueInPlaceOfMissingOnesIsNoRoughSignal) {
  auto motion = Motion().sine(100.0, 0.5, 4).end().loop();
  for (std::size_t i = 30; i < motion.force_kN.size(); i += 40) motion.force_kN[i] = 0.0;
  auto const record = record_of_motion(motion);
  EXPECT_TRUE(contains(said_in(record.warnings), "single-sample spikes")) << said_in(record.warnings);
  EXPECT_FALSE(cyclic_properties(record).reported);
}

TEST(Blocks, AFailureIsNamedAndADeadCycleIsNeverReported) {
  for (double const slope : {0.0005, -0.0005}) {
    auto motion = in_stages({5.0, 10.0, 20.0, 40.0});
    auto const sound = cyclic_properties(motion.view());
    for (std::size_t i = 2060; i < motion.force_kN.size(); ++i) {  // before the positive peak of the second cycle
      double const left = std::exp(-0.05 * static_cast<double>(i - 2060));
      motion.force_kN[i] = left * motion.force_kN[i] + slope * motion.disp_mm[i];
    }
    auto const record = record_of_motion(motion);
    auto const properties = cyclic_properties(record);
    EXPECT_TRUE(contains(said_in(record.warnings), "the force is suddenly lost: cycle 2 of block 4 has"))
        << said_in(record.warnings);
    EXPECT_TRUE(properties.refusal.empty()) << said_in(properties.refusal);
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

// The force is lost in the second stage and back in the third. Only the cycles without force are left out of properties
// and fit.
TEST(Blocks, AForceThatComesBackIsLostForItsDeadCyclesOnly) {
  auto motion = in_stages({40.0, 40.5, 60.0});
  for (std::size_t i = 600; i < 1200; ++i) motion.force_kN[i] *= 0.02;
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  ASSERT_TRUE(properties.failure);
  EXPECT_EQ(properties.reported->amplitude_mm, 60.0);
  EXPECT_NEAR(properties.failure->number("percent"), 2.0, 1.5) << "as measured";
  auto const fitted = clean(record, {.samples_per_cycle = std::nullopt});
  EXPECT_TRUE(fitted.is_scored(500));
  EXPECT_FALSE(fitted.is_scored(900));
  EXPECT_TRUE(fitted.is_scored(1500));
  EXPECT_TRUE(contains(said_in(fitted.cleaning), "lost its force for a time")) << said_in(fitted.cleaning);
}

// The block in which the device fails also has a fault of the signal. The failure must still be reported, because the
// force is missing in the stages after this block too.
TEST(Blocks, AFailureStaysBesideASignalFault) {
  auto motion = in_stages({20.0, 40.0, 60.0});
  for (std::size_t i = 1000; i < motion.force_kN.size(); ++i) motion.force_kN[i] *= 0.02;
  auto record = record_of_motion(motion);
  auto const failed = cyclic_properties(record);
  ASSERT_TRUE(failed.failure);
  EXPECT_EQ(failed.failure->blocks.front(), 2);
  record.faults = {{.kind = FaultKind::spike, .channel = "force", .samples = {700}}};
  auto const properties = cyclic_properties(record);
  EXPECT_FALSE(properties.blocks[1].fault.empty());
  EXPECT_TRUE(properties.failure);
  EXPECT_FALSE(clean(record, {.samples_per_cycle = std::nullopt}).is_scored(1500));
}

// A cycle that does not count has no number, so its failure is named by its time.
TEST(Blocks, AFailureInAnUncountedCycleIsNamedByItsTime) {
  auto motion = Motion().sine(100.0, 0.5, 4).sine(110.0, 0.5, 1).end().loop();
  for (std::size_t i = 800; i < motion.force_kN.size(); ++i) motion.force_kN[i] *= 0.02;
  auto const said = said_in(record_of_motion(motion).warnings);
  EXPECT_TRUE(contains(said, "the uncounted cycle from 8 s on in block 1 has")) << said;
  EXPECT_TRUE(contains(said, "% of the force in cycle 2 of block 1")) << said;
}

// The force of a slider is proportional to the load. At a tenth of the load its force is small but not lost.
TEST(Blocks, AForceThatFollowsTheLoadIsNotLost) {
  auto motion = Motion().sine(100.0, 0.5, 3).sine(100.0, 0.5, 3).end().loop();
  std::vector<double> load(motion.disp_mm.size(), 2000.0);
  for (std::size_t i = 600; i < load.size(); ++i) load[i] = 150.0, motion.force_kN[i] *= 0.075;
  EXPECT_FALSE(cyclic_properties(record_of_motion(motion, load)).failure);
  for (std::size_t i = 0; i < load.size(); ++i) load[i] = 0.3 * std::sin(0.01 * static_cast<double>(i * i));
  EXPECT_TRUE(cyclic_properties(record_of_motion(motion, load)).failure) << "of a load channel that is noise";
}

// The first stage has so few samples per cycle that the whole record is refused. If this stage also has a fault, it is
// left out, and the record must then be accepted.
TEST(Blocks, ARefusalDoesNotOutliveTheFaultyBlockFromWhichItCame) {
  auto const motion = Motion().sine(50.0, 10.0, 30).sine(100.0, 0.5, 3).end().loop();
  auto record = record_of_motion(motion);
  EXPECT_FALSE(cyclic_properties(record).reported);
  record.faults = {{.kind = FaultKind::spike, .channel = "force", .samples = {150}}};
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(properties.refusal.empty()) << said_in(properties.refusal);
  ASSERT_TRUE(properties.reported);
  EXPECT_EQ(properties.reported->block, 2);
}

// The stage of largest amplitude has a fault and looks like a viscous damper. The sound stage shows that the device has
// stiffness.
TEST(Blocks, TheKindOfDeviceIsThatOfTheSoundBlocks) {
  auto motion = Motion().sine(50.0, 0.5, 3).sine(100.0, 0.5, 3).end().loop();
  for (std::size_t i = 600; i < motion.force_kN.size(); ++i) {
    double const v = 100.0 * pi * std::cos(pi * motion.time_s[i]);
    motion.force_kN[i] = std::copysign(17.81 * std::pow(std::abs(v), 0.3), v);
  }
  auto record = record_of_motion(motion);
  record.faults.clear();
  EXPECT_TRUE(cyclic_properties(record).viscous);
  record.faults = {{.kind = FaultKind::spike, .channel = "force", .samples = {900}}};
  EXPECT_FALSE(cyclic_properties(record).viscous);
}

// A spike after the end of the motion makes no block faulty, and laws are not fitted to it.
TEST(Blocks, AFaultOutsideTheBlocksTakesNoneAndIsNotFitted) {
  auto motion = Motion().sine(100.0, 0.5, 3).hold(0.0, 4.0).end().loop();
  motion.force_kN[800] += 60.0;
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  EXPECT_TRUE(properties.block_faults.empty());
  EXPECT_EQ(properties.counted().size(), 3u);
  auto const said = said_in(record.warnings);
  EXPECT_TRUE(contains(said, "outside the blocks")) << said;
  EXPECT_FALSE(contains(said, "No properties")) << said;
  auto const fitted = clean(record, {.samples_per_cycle = std::nullopt});
  EXPECT_FALSE(fitted.is_scored(800));
  EXPECT_TRUE(fitted.is_scored(790) && fitted.is_scored(500));
  EXPECT_TRUE(contains(said_in(fitted.cleaning), "the samples outside the blocks")) << said_in(fitted.cleaning);
}

TEST(Blocks, HeatingAndScraggingAreNoFailure) {
  auto motion = Motion().sine(100.0, 0.5, 30).end().loop();
  for (std::size_t i = 0; i < motion.force_kN.size(); ++i)
    motion.force_kN[i] *=
        0.5 + 0.35 * std::exp(-0.003 * static_cast<double>(i)) + 0.3 * std::exp(-0.02 * static_cast<double>(i));
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

// --- cuts that are not at the centre of the motion ---

TEST(Cuts, AOneSidedTestInStagesIsCutWhereItComesBack) {
  for (double const side : {1.0, -1.0}) {
    Motion motion;
    for (double const peak : {5.0, 10.0, 20.0, 40.0})
      for (int k = 0; k < (peak == 40.0 ? 5 : 3); ++k) motion.ramp(0.0, side * peak, 4.0).ramp(side * peak, 0.0, 4.0);
    auto const properties = motion.end().loop().properties();
    EXPECT_TRUE(properties.refusal.empty()) << said_in(properties.refusal);
    EXPECT_EQ(counted_per_block(motion.cut()), (std::vector<int>{3, 3, 3, 5}));
    ASSERT_TRUE(properties.reported);
    EXPECT_EQ(properties.reported->block, 4);
    // The reported cycle goes from one reversal to the other, 40 mm away, and back. In steady motion the exponential loop
    // of Motion::loop() then has the area 2 Q (40 - tanh(40 alpha / 2) / (alpha / 2)).
    double const K = 0.5, Q = 30.0, alpha = 0.08;
    double const area = 2.0 * Q * (40.0 - std::tanh(20.0 * alpha) * 2.0 / alpha);
    EXPECT_NEAR(properties.reported->energy_kN_mm, area, 0.005 * area);
    EXPECT_NEAR(properties.reported->K_eff_kN_per_mm, K + 2.0 * Q * std::tanh(20.0 * alpha) / 40.0, 0.01);
    EXPECT_GT(properties.reported->Q_d_kN, 0.5 * Q);
  }
}

TEST(Cuts, HalfCyclesThatGrowFromEachToTheNextAreLoops) {
  Motion motion;
  double peak = 5.0, at = 0.0;
  for (int k = 0; k < 16; ++k, peak *= -1.15) {
    motion.ramp(at, peak, 5.0);
    at = peak;
  }
  auto const cut = motion.ramp(at, 0.0, 5.0).end().cut();
  EXPECT_TRUE(cut.cyclic);
  EXPECT_EQ(counted_per_block(cut), std::vector<int>(8, 1));
}

TEST(Cuts, NoLoopIsClosedAcrossAJumpOfTimeAndTheLoggersNumbersCount) {
  std::string text = "time [s],cycle,disp [mm],force [kN]\n";
  auto const motion = Motion().sine(30.0, 1.0, 6).loop();
  int const logged[] = {1, 2, 3, 100, 200, 300};
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i) {
    int const cycle = logged[i / 100];
    text += std::to_string(cycle - 1 + 0.01 * static_cast<double>(i % 100)) + "," + std::to_string(cycle) + "," +
            std::to_string(motion.disp_mm[i]) + "," + std::to_string(motion.force_kN[i]) + "\n";
  }
  auto const properties = cyclic_properties(read_record_text(text, "bursts.csv"));
  ASSERT_EQ(properties.counted().size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(properties.counted()[k]->number, logged[k]);
  EXPECT_NEAR(properties.counted()[2]->last, 299.0, 1e-9);  // the last sample before the logged number jumps to 100
  EXPECT_NEAR(properties.counted()[3]->first, 300.0, 1e-9);
  auto const found = stability(properties.blocks[0], &Cycle::energy_kN_mm);
  EXPECT_EQ(found.ratio_to_third.size(), 6u);
  EXPECT_EQ(*found.min_2_10, std::min(found.ratio_to_third[1], found.ratio_to_third[2]));
}

TEST(Cuts, ACounterThatGoesOnFromBlockToBlockStartsAnewInEach) {
  auto const motion = Motion().sine(50.0, 1.0, 3).sine(100.0, 1.0, 3).end();
  std::vector<double> counter;
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i)
    counter.push_back(1.0 + std::floor(static_cast<double>(i) / 100.0));
  EXPECT_EQ(counted_per_block(segment(motion.disp_mm, motion.time_s, {}, {.logged_cycle = counter})),
            (std::vector<int>{3, 3}));
}

// The logger numbers all cycles. The last cycle of the first block and the first one of the second do not count, but
// have numbers of the logger too.
TEST(Cuts, ACounterThatGoesOnStartsWithTheFirstCycleOfTheBlock) {
  auto const motion = Motion().sine(50.0, 1.0, 3).sine(46.0, 1.0, 1).sine(100.0, 1.0, 3).end();
  std::vector<double> counter;
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i)
    counter.push_back(1.0 + std::floor(static_cast<double>(i) / 100.0));
  auto const cut = segment(motion.disp_mm, motion.time_s, {}, {.logged_cycle = counter});
  EXPECT_EQ(counted_per_block(cut), (std::vector<int>{3, 3}));
}

// The record has only the cycles 1, 2, 100 and 200. There is no cycle 3 with which the others could be compared.
TEST(Cuts, NoCycleStandsForCycleThree) {
  Block block;
  for (int const number : {1, 2, 100, 200}) {
    auto& cycle = block.cycles.emplace_back();
    cycle.number = number;
    cycle.energy_kN_mm = 100.0 + number;
  }
  auto found = stability(block, &Cycle::energy_kN_mm);
  EXPECT_EQ(found.cycles, 4);
  EXPECT_TRUE(found.ratio_to_third.empty());
  block.cycles[2].number = 3;
  EXPECT_EQ(stability(block, &Cycle::energy_kN_mm).first_to_third, 101.0 / 200.0);
  block.cycles.erase(block.cycles.begin());
  found = stability(block, &Cycle::energy_kN_mm);
  EXPECT_EQ(found.ratio_to_third.size(), 3u);
  EXPECT_FALSE(found.first_to_third || found.min_1_10);
  EXPECT_EQ(found.min_2_10, 102.0 / 200.0);
}

// --- devices without stiffness ---

TEST(DeviceKind, AViscousDamperIsRecognisedAndItsStiffnessJudgesNothing) {
  Motion motion;
  motion.dt_s = 0.005;
  motion.sine(50.0, 1.0, 4).end();
  for (double const t : motion.time_s) {
    double const v = 100.0 * pi * std::cos(2.0 * pi * t);
    motion.force_kN.push_back(std::copysign(17.81 * std::pow(std::abs(v), 0.3), v));
  }
  auto const record = record_of_motion(motion);
  auto const properties = cyclic_properties(record);
  ASSERT_TRUE(properties.viscous);
  for (auto const& side : {properties.viscous->rising, properties.viscous->falling}) {
    EXPECT_NEAR(side.alpha, 0.3, 0.003);
    EXPECT_NEAR(side.C * std::pow(100.0 * pi, side.alpha), 100.0, 0.2);
  }
  for (auto const& warning : record.warnings) {
    EXPECT_NE(warning.kind, FindingKind::cycle_unlike_neighbours);
    EXPECT_NE(warning.kind, FindingKind::friction_in_force);
    EXPECT_NE(warning.kind, FindingKind::noise);
  }
}

TEST(DeviceKind, AShockAbsorberOffZeroWithoutAnyStiffnessHasProperties) {
  auto motion = Motion().sine(25.0, 1.0, 4, 40.0).end(40.0);
  for (double const t : motion.time_s) {
    double const v = 50.0 * pi * std::cos(2.0 * pi * t);
    motion.force_kN.push_back(-0.15 + (v > 0.0 ? 0.0036 * v : 0.0024 * v));  // a gas spring adds -0.15 kN
  }
  auto const properties = cyclic_properties(record_of_motion(motion));
  EXPECT_TRUE(properties.refusal.empty()) << said_in(properties.refusal);
  ASSERT_TRUE(properties.viscous);
  EXPECT_NEAR(properties.viscous->F_0_kN, -0.15, 0.003);
  EXPECT_NEAR(properties.viscous->rising.C, 0.0036, 4e-5);
  EXPECT_NEAR(properties.viscous->falling.C, 0.0024, 3e-5);
}

TEST(DeviceKind, ASliderHasFrictionAndARadius) {
  auto motion = Motion().sine(200.0, 0.5, 4).end();
  double const N = 2000.0, mu = 0.06, R = 2500.0;
  double z = 0.0, before = 0.0;
  for (double const x : motion.disp_mm) {
    z = std::clamp(z + (x - before) / 0.5, -1.0, 1.0);
    before = x;
    motion.force_kN.push_back(N / R * x + mu * N * z);
  }
  auto const properties = cyclic_properties(record_of_motion(motion, std::vector<double>(motion.disp_mm.size(), N)));
  ASSERT_TRUE(properties.slider);
  EXPECT_NEAR(properties.slider->mu, mu, 0.0005);
  EXPECT_NEAR(*properties.slider->R_mm, R, 25.0);
  EXPECT_FALSE(properties.viscous);
  EXPECT_FALSE(cyclic_properties(record_of_motion(Motion().sine(150.0, 0.5, 4).end().loop())).viscous);
}

}  // namespace
}  // namespace isolaw::data::testing
