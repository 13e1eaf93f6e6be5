// Tests the error budget of a record, the list of its measurement errors and their effects. Each warning and note must
// appear, with its numbers, if the record has the error, and must not appear otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/data/properties/error_budget.hpp"
#include "isolaw/data/properties/skew.hpp"
#include "motions.hpp"
#include "signals.hpp"

namespace isolaw::data::testing {
namespace {

Effect const* find(Budget const& budget, std::string_view effect) {
  auto const found = std::ranges::find(budget.effects, effect, &Effect::effect);
  return found == budget.effects.end() ? nullptr : &*found;
}

Budget budget_of(Motion const& motion, int smooth = 1) {
  return error_budget(motion.view(), motion.properties(), smooth);
}

Motion plain() {
  return Motion().sine(208.0, 0.5, 5).end().loop();
}

// Returns cycles of 208 mm whose force is late by `late_s`, computed at fine steps and then sampled every 0.01 s.
Motion skewed(double late_s, double K = 0.5, double Q = 30.0, double alpha = 0.08, double friction_kN = 0.0) {
  Motion fine;
  fine.dt_s = 0.0005;
  fine.sine(208.0, 0.5, 5.5).loop(K, Q, alpha);
  for (std::size_t i = 1; i < fine.disp_mm.size(); ++i)
    fine.force_kN[i] += std::copysign(friction_kN, fine.disp_mm[i] - fine.disp_mm[i - 1]);
  auto const shift = std::lround(late_s / fine.dt_s);
  Motion coarse;
  for (long i = 0; i <= 20000; i += 20) {
    coarse.add(fine.disp_mm[static_cast<std::size_t>(i)]);
    coarse.force_kN.push_back(fine.force_kN[static_cast<std::size_t>(std::max(0L, i - shift))]);
  }
  return coarse;
}

TEST(ErrorBudget, ACleanRecordHasNotesAndNoWarnings) {
  auto const budget = budget_of(plain());
  EXPECT_EQ(budget.warnings, std::vector<Finding>{});
  EXPECT_TRUE(
      says(budget.notes, "200.0 samples per cycle: energy comes out 0.016 % too small, and a peak up to 0.012 %"));
  EXPECT_TRUE(says(budget.notes, "each tonne that moves"));
  EXPECT_TRUE(says(budget.notes, "the largest speed"));
  for (auto const& effect : budget.effects) EXPECT_FALSE(effect.exceeds) << effect.effect;
}

// The force is zero in two samples at one peak of cycle 3, which halves the stiffness of that cycle. A warning must
// name the cycle.
TEST(ErrorBudget, ACycleUnlikeItsNeighboursIsNamed) {
  auto motion = Motion().sine(100.0, 0.5, 5).end().loop();
  EXPECT_FALSE(says(budget_of(motion).warnings, "beside it"));
  motion.force_kN[450] = motion.force_kN[451] = 0.0;  // peak of cycle 3, at 200 samples a cycle
  auto const budget = budget_of(motion);
  EXPECT_TRUE(says(budget.warnings, "the peak of cycle 3 of block 1 has "));
}

TEST(ErrorBudget, FewSamples) {
  Motion motion;
  motion.dt_s = 0.04;
  auto const budget = budget_of(motion.sine(208.0, 0.5, 5).end().loop());
  EXPECT_TRUE(
      says(budget.warnings, "50.0 samples per cycle: energy comes out 0.26 % too small, and a peak up to 0.2 %"));
  EXPECT_TRUE(find(budget, "samples per cycle")->exceeds);
}

// In a triangular motion with 80 samples a cycle, the corner may lie 2.5 % of the amplitude beyond the largest sample.
TEST(ErrorBudget, FewSamplesOfATriangle) {
  Motion motion;
  motion.dt_s = 0.025;
  for (int k = 0; k < 4; ++k) motion.ramp(0.0, 100.0, 0.5).ramp(100.0, -100.0, 1.0).ramp(-100.0, 0.0, 0.5);
  auto const budget = budget_of(motion.end().loop());
  EXPECT_TRUE(
      says(budget.warnings, "80.0 samples per cycle: energy comes out up to 2.5 % too small, and a peak up to 2.5 %"));
  EXPECT_DOUBLE_EQ(find(budget, "peak missed between samples")->value, corner_loss_percent(80.0));
}

TEST(ErrorBudget, ALateForceIsWarnedOfInMilliseconds) {
  for (double const late : {0.010, 0.015, 0.020}) {
    auto const budget = budget_of(skewed(late));
    auto const* effect = find(budget, "skew");
    ASSERT_NE(effect, nullptr);
    EXPECT_NEAR(effect->value, 1000.0 * late, 2.0);  // 2 ms are 0.2 of a sampling interval
    EXPECT_TRUE(effect->exceeds);
    EXPECT_NEAR(find(budget, "damping by skew")->value, -100.0 * pi * 0.5 * late, 0.35);
    EXPECT_TRUE(says(budget.warnings, "--skew-ms")) << late;
  }
}

TEST(ErrorBudget, AnEarlyForceIsNotedOnly) {
  auto const budget = budget_of(skewed(-0.020));
  EXPECT_FALSE(find(budget, "skew")->exceeds);
  EXPECT_TRUE(says(budget.notes, "viscosity of the device, or an early channel"));
  EXPECT_FALSE(says(budget.warnings, "displacement. No device"));
  EXPECT_NEAR(find(budget, "damping by skew")->value, 100.0 * pi * 0.5 * 0.020, 0.5);
}

TEST(ErrorBudget, NoSkewIsSeenInLoopsThatHaveNone) {
  for (double const alpha : {0.03, 0.08, 0.15, 0.3, 1.0, 5.0}) {
    auto const motion = skewed(0.0, 0.5, 30.0, alpha);
    auto const found = estimate_skew(motion.view(), motion.properties());
    EXPECT_FALSE(found && found->significant()) << alpha << ": " << (found ? found->phase : 0.0);
  }
}

TEST(ErrorBudget, SkewWithoutTimeIsInSamples) {
  auto motion = skewed(0.020);
  motion.time_s.clear();
  auto const budget = budget_of(motion);
  ASSERT_NE(find(budget, "skew"), nullptr);
  EXPECT_EQ(find(budget, "skew")->unit, "samples");
  EXPECT_NEAR(find(budget, "skew")->value, 2.0, 0.2);
  EXPECT_FALSE(says(budget.warnings, "--skew-ms"));
}

TEST(ErrorBudget, FrictionOfTheRig) {
  auto motion = plain();
  std::vector<double> const load(motion.disp_mm.size(), 3000.0);
  CycleView const view{motion.disp_mm, motion.force_kN, motion.time_s, load};
  auto const properties = cyclic_properties(view);
  auto const quiet = error_budget(view, properties);
  double const points = friction_damping_points(15.0, properties.reported->K_eff_kN_per_mm, 208.0);
  EXPECT_NEAR(find(quiet, "damping by rig friction of 0.5 % of the vertical load")->value, points, 1e-9);
  EXPECT_EQ(find(quiet, "damping by the jump"), nullptr);
  // Add 8 kN of the rig's friction to the force.
  for (std::size_t i = 1; i + 1 < motion.disp_mm.size(); ++i)
    motion.force_kN[i] += std::copysign(8.0, motion.disp_mm[i + 1] - motion.disp_mm[i - 1]);
  auto const budget = budget_of(motion);
  ASSERT_NE(find(budget, "damping by the jump"), nullptr);
  EXPECT_NEAR(find(budget, "jump of force at reversals")->value, 16.0, 2.0);
  EXPECT_TRUE(says(budget.warnings, "--rig-friction "));
}

TEST(ErrorBudget, FrictionIsNotNamedAgainAsSkew) {
  auto motion = Motion().sine(150.0, 0.5, 5).end().loop(0.6, 25.0);
  for (std::size_t i = 1; i + 1 < motion.disp_mm.size(); ++i) {
    double const way = motion.disp_mm[i + 1] - motion.disp_mm[i - 1];
    if (std::abs(way) > 1e-6) motion.force_kN[i] += std::copysign(3.0, way);
  }
  auto const budget = budget_of(motion);
  EXPECT_TRUE(says(budget.warnings, "as friction of 2.9"));
  EXPECT_FALSE(says(budget.notes, "force reverses"));
  EXPECT_FALSE(says(budget.warnings, "force reverses"));
}

TEST(ErrorBudget, ASkewBesideFrictionIsWhatIsLeftOfIt) {
  auto const budget = budget_of(skewed(-0.015, 0.5, 30.0, 0.08, 4.0));
  ASSERT_NE(find(budget, "damping by the jump"), nullptr);
  EXPECT_NEAR(find(budget, "skew")->value, -15.0, 5.0);  // 5 ms are half a sampling interval
  EXPECT_TRUE(says(budget.notes, "before displacement, after its jump is subtracted: viscosity"));
}

TEST(ErrorBudget, NoiseIsNoSkew) {
  // On the steep branch after a reversal, noise of displacement looks like a force that is early.
  for (double const noise : {0.5, 0.75, 1.5})
    for (unsigned seed = 1; seed <= 40; ++seed) {
      auto motion = Motion().sine(150.0, 0.5, 5).end().loop(0.6, 25.0).noise(noise, seed);
      std::mt19937 generator(1000 + seed);
      std::normal_distribution<double> normal(0.0, 0.7);
      for (double& F : motion.force_kN) F += normal(generator);
      auto const budget = budget_of(motion);
      EXPECT_FALSE(says(budget.notes, "force reverses")) << noise << ", seed " << seed;
      EXPECT_FALSE(says(budget.warnings, "force reverses")) << noise << ", seed " << seed;
    }
}

TEST(ErrorBudget, SkewIsFoundInNoise) {
  int found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto const budget = budget_of(skewed(0.020).noise(0.5, seed));
    auto const* effect = find(budget, "skew");
    ASSERT_NE(effect, nullptr);
    EXPECT_NEAR(effect->value, 20.0, 6.0) << seed;
    found += effect->exceeds ? 1 : 0;
  }
  EXPECT_GE(found, 18);
}

TEST(ErrorBudget, NoiseMovesTheExtremes) {
  auto const quiet = budget_of(plain());
  EXPECT_FALSE(says(quiet.warnings, "noise"));
  double beyond = 0.0, softer = 0.0;
  constexpr int draws = 200;
  for (unsigned seed = 1; seed <= draws; ++seed) {
    auto motion = Motion().sine(150.0, 0.5, 5).end().loop(0.6, 25.0).noise(3.0, seed);
    auto const cycle = *motion.properties().reported;
    beyond += (cycle.amplitude_mm - 150.0) / draws;
    softer += (1.0 - cycle.K_eff_kN_per_mm / 0.766667) / draws;
    if (seed > 1) continue;
    auto const budget = budget_of(motion);
    EXPECT_TRUE(says(budget.warnings, "The extremes of a cycle lie about "));
    EXPECT_NEAR(find(budget, "noise of displacement")->value, 2.0, 0.2);
    EXPECT_NEAR(find(budget, "extremes moved by noise")->value, 2.82, 0.4);
    EXPECT_TRUE(find(budget, "extremes moved by noise")->exceeds);
  }
  // Each extreme has a standard deviation of 0.6 times the 3 mm of the noise. The mean amplitude of 200 cycles, with
  // two extremes each, then has a standard deviation of 0.09 mm. The tolerance is about three times this.
  EXPECT_NEAR(beyond, peak_gain_mm(3.0, 150.0, 200.0), 0.3);
  // Noise moves the extreme of displacement away from the peak of the force. The stiffness therefore falls by a larger
  // share than that by which the amplitude rises.
  EXPECT_GT(softer, peak_gain_mm(3.0, 150.0, 200.0) / 150.0);
  EXPECT_LT(softer, 2.0 * peak_gain_mm(3.0, 150.0, 200.0) / 150.0);
  EXPECT_DOUBLE_EQ(peak_gain_mm(0.0, 150.0, 200.0), 0.0);
  // With 20 samples a cycle only one sample lies near the peak. Its mean error is the mean of the noise, which is zero.
  EXPECT_NEAR(peak_gain_mm(0.01, 150.0, 20.0), 0.0, 1e-5);
}

TEST(ErrorBudget, ALongRestIsNoted) {
  auto const rested =
      Motion().sine(150.0, 0.5, 1).hold(0.0, 3.0).sine(150.0, 0.5, 1).hold(0.0, 4.0).sine(150.0, 0.5, 1);
  auto const budget = budget_of(Motion(rested).end().loop());
  EXPECT_TRUE(
      says(budget.notes,
           "the device is at rest for 4 s in cycle 3 of block 1, longer than its period, and so in 1 more cycle"));
  EXPECT_NEAR(find(budget, "longest rest or hold")->value, 4.0, 0.03);
  EXPECT_FALSE(says(budget_of(plain()).notes, "is at rest"));
}

TEST(ErrorBudget, OffsetsDriftAndClosure) {
  auto moved = plain();
  moved.offset(20.0);
  for (double& F : moved.force_kN) F += 40.0;
  auto const off = budget_of(moved);
  EXPECT_TRUE(says(off.warnings, "displacement is off centre by 20 mm"));
  EXPECT_TRUE(says(off.warnings, "force is off centre by 40"));
  EXPECT_TRUE(says(off.notes, "cycles are cut where displacement passes 20 mm"));

  auto drifting = plain();
  for (std::size_t i = 0; i < drifting.disp_mm.size(); ++i) drifting.force_kN[i] += 1.5 * drifting.time_s[i];
  EXPECT_TRUE(says(budget_of(drifting).warnings, "force drifts"));
  EXPECT_FALSE(says(budget_of(plain()).warnings, "drifts"));

  auto open = Motion().sine(100.0, 0.5, 0.99);  // stops at -6.3 mm, near enough to zero for a full cycle
  open.end(-4.0).loop();
  EXPECT_TRUE(says(budget_of(open).warnings, "ends -4 mm from where it starts, 2 % of the whole travel"));
}

TEST(ErrorBudget, UnevenTime) {
  auto motion = plain();
  EXPECT_FALSE(says(budget_of(motion).warnings, "not uniform"));
  for (std::size_t i = 500; i < motion.time_s.size(); ++i) motion.time_s[i] += 0.05;
  EXPECT_TRUE(says(budget_of(motion).warnings, "sampling is not uniform: intervals from 0.01 to 0.06 s"));
}

TEST(ErrorBudget, VelocityTellsAWrongClock) {
  auto motion = plain();
  auto const honest = budget_of(motion);
  EXPECT_LT(std::abs(find(honest, "v_max beside its closed form")->value), 0.5);
  // This motion is faster in the middle than a sine or a triangle.
  for (double& x : motion.disp_mm) x = 208.0 * std::tanh(3.0 * x / 208.0) / std::tanh(3.0);
  auto const rushed = budget_of(motion);
  EXPECT_GT(find(rushed, "v_max beside its closed form")->value, 50.0);
  EXPECT_TRUE(says(rushed.notes, "neither a sine nor a triangle"));
}

TEST(ErrorBudget, TheMovingAverage) {
  auto const eleven = budget_of(plain(), 11);
  EXPECT_NEAR(find(eleven, "taken by the moving average")->value, 0.5, 0.02);
  EXPECT_NEAR(find(eleven, "taken by the moving average from the third harmonic")->value, 4.4, 0.05);
  EXPECT_TRUE(says(eleven.notes, "the moving average over 11 samples, of 200 in a cycle, removes 0.49 %"));
  EXPECT_TRUE(says(budget_of(plain(), 21).warnings, "the moving average over 21"));
  EXPECT_EQ(find(budget_of(plain()), "taken by the moving average"), nullptr);
}

TEST(ErrorBudget, ARecordWithoutCyclesHasItsTimeAssessedOnly) {
  auto const budget = budget_of(Motion().ramp(0.0, 100.0, 3.0).loop());
  ASSERT_EQ(budget.effects.size(), 1u);
  EXPECT_EQ(budget.effects[0].effect, "uneven time");
}

// --- how often the force is called late ---

// called_late() makes noisy records of 2 to 20 cycles of devices without rate dependence. It counts the records for
// which isolaw estimates a delay of the force, and among them those whose force isolaw calls late. `late_rad` is the
// true delay as a phase.
struct SkewCount {
  int estimated = 0, late = 0;
};
void rubber_or_lead(Plan& plan, Drawn& random) {
  plan.device = random.chance(0.5) ? Device::rubber : Device::lead;
}
// Chooses a Bouc-Wen device, whose loops turn sharply. isolaw estimates the delay by a cubic through the force after
// each reversal, and no cubic fits these loops well.
void sharp(Plan& plan, Drawn& random) {
  plan.device = Device::bouc_wen;
  plan.exponent = random.whole(1, 2);
  plan.yields_at = random.on_logs(0.01, 0.2);
  plan.stiffness_ratio = random.between(10.0, 30.0);
}
SkewCount called_late(unsigned first_seed, int count, double late_rad, Bounds const& bounds, bool holds = false,
                      std::function<void(Plan&, Drawn&)> const& choose_device = rubber_or_lead) {
  SkewCount found;
  for (int k = 0; k < count; ++k) {
    Drawn random(first_seed + static_cast<unsigned>(k));
    auto plan = draw(random, bounds, holds);
    choose_device(plan, random);
    plan.cycles = random.chance(0.5) ? 3 : random.whole(2, 20);
    if (plan.cycles > 5) plan.samples = std::min(plan.samples, 200);
    auto motion = true_motion(plan);
    auto const sharp = motion.force_kN;
    double const samples = late_rad / (2.0 * pi) * plan.samples;
    for (std::size_t i = 0; i < sharp.size(); ++i)
      motion.force_kN[i] = value_at(sharp, std::max(0.0, static_cast<double>(i) - samples));
    auto const record = finish(random, plan, motion);
    auto const properties = cyclic_properties(record.view());
    if (!properties.reported) continue;
    auto const skew = estimate_skew(record.view(), properties);
    if (!skew) continue;
    ++found.estimated;
    if (skew->significant() && skew->force_late > 0.0) ++found.late;
  }
  return found;
}

TEST(ErrorBudget, SynchronousChannelsAreCalledLateLessThanOnceInFiveHundred) {
  auto const found =
      called_late(80000, 3000, 0.0, {.most_disp_noise = 0.008, .most_force_noise = 0.03, .most_samples = 400});
  EXPECT_GT(found.estimated, 800);
  EXPECT_LE(500 * found.late, found.estimated);
}

TEST(ErrorBudget, SharpLoopsAreNotCalledLateForTheirShape) {
  for (double const most_noise : {1.1e-5, 0.005}) {
    auto const found = called_late(
        110000, 2000, 0.0, {.most_disp_noise = most_noise / 5.0, .most_force_noise = most_noise, .most_samples = 1000},
        false, sharp);
    EXPECT_GT(found.estimated, 1000);
    EXPECT_LE(500 * found.late, found.estimated) << found.late << " of " << found.estimated;
  }
}

TEST(ErrorBudget, ALateChannelOfASharpLoopIsFoundWhereSamplesTellIt) {
  auto const found = called_late(
      120000, 600, 0.05, {.most_disp_noise = 2e-4, .most_force_noise = 0.002, .fewest_samples = 200}, false, sharp);
  EXPECT_GT(found.estimated, 300);
  EXPECT_GE(10 * found.late, 9 * found.estimated) << found.late << " of " << found.estimated;
}

TEST(ErrorBudget, HoldsAreNoLateChannel) {
  auto const found =
      called_late(100000, 3000, 0.0, {.most_disp_noise = 0.008, .most_force_noise = 0.03, .most_samples = 400}, true);
  EXPECT_GT(found.estimated, 500);
  EXPECT_LE(500 * found.late, found.estimated);
}

// A device that creeps during a hold loses force. This loss must not count as friction of the rig.
TEST(ErrorBudget, CreepInHoldsIsNoFriction) {
  int assessed = 0;
  for (auto const waveform : {Waveform::trapezoid, Waveform::dwell})
    for (unsigned seed = 0; seed < 50; ++seed) {
      Drawn random(seed);
      auto plan = draw(random, {.most_disp_noise = 0.001, .most_force_noise = 0.003, .most_samples = 400}, true);
      plan.device = Device::relaxing;
      plan.waveform = waveform;
      auto const record = finish(random, plan, true_motion(plan));
      auto const properties = cyclic_properties(record.view());
      if (!properties.reported) continue;
      ++assessed;
      EXPECT_EQ(find(error_budget(record.view(), properties), "damping by the jump"), nullptr) << record.text;
    }
  EXPECT_GT(assessed, 80);
}

// Holds of any length in a clean record must not make a channel count as late.
TEST(ErrorBudget, NoHoldAtTheExtremesIsALateChannel) {
  for (double hold = 0.02; hold < 0.45; hold += 0.02) {
    Motion motion;
    motion.dt_s = 0.02;
    double const slope = 1.0 / (1.0 - 2.0 * hold);  // slope of the triangle before the holds cut it off
    for (int i = 0; i <= 300; ++i) {
      double const part = std::fmod(i / 100.0, 1.0);
      double const triangle = part < 0.25 ? 4.0 * part : part < 0.75 ? 2.0 - 4.0 * part : 4.0 * part - 4.0;
      motion.add(100.0 * std::clamp(slope * triangle, -1.0, 1.0));
    }
    auto const budget = budget_of(motion.loop());
    EXPECT_FALSE(says(budget.warnings, "a channel is late")) << hold;
    bool const clearly = hold > 0.1;  // with shorter holds the motion is nearly a triangle
    EXPECT_FALSE(clearly && says(budget.warnings, "the largest speed")) << hold;
  }
}

TEST(ErrorBudget, ALateChannelIsFoundInNineRecordsOfTen) {
  auto const found = called_late(90000, 600, 0.08, {.most_disp_noise = 0.001, .most_force_noise = 0.005});
  EXPECT_GT(found.estimated, 200);
  EXPECT_GE(10 * found.late, 9 * found.estimated) << found.late << " of " << found.estimated;
}

// A delay estimated from few reversals may be chance. With four reversals, an estimate of six standard errors is not
// significant.
TEST(ErrorBudget, FewReversalsMustAgreeBetter) {
  Skew skew{.force_late = 0.01, .uncertainty = 2.0 * 0.01 / 6.0, .phase = 0.05, .agreement = 1.0, .reversals = 4};
  EXPECT_FALSE(skew.significant());  // for 3 degrees of freedom, Student's t asks for 10.2 standard errors
  skew.uncertainty = 2.0 * 0.01 / 11.0;
  EXPECT_TRUE(skew.significant());
  skew.reversals = 24;
  skew.uncertainty = 2.0 * 0.01 / 4.5;
  EXPECT_TRUE(skew.significant());
}

}  // namespace
}  // namespace isolaw::data::testing
