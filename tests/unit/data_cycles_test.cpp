// Tests how records are cut into cycles, which are grouped into blocks of about one amplitude and frequency: where
// cycles begin, how they are numbered, which cycles are left out of the count, and which records are not cyclic.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "finding_text.hpp"
#include "motions.hpp"

namespace isolaw::data::testing {
namespace {

using Counts = std::vector<int>;
using Values = std::vector<double>;

TEST(Segment, StagesFromFiveToTwoHundredPercent) {
  Motion motion;
  for (double const amplitude : {10.0, 20.0, 40.0, 100.0, 200.0, 300.0, 400.0}) motion.sine(amplitude, 0.5, 3);
  motion.end();
  for (double const noise : {0.0, 0.4}) {
    auto const cut = motion.noise(noise).cut();
    EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
    EXPECT_EQ(counted_per_block(cut), Counts(7, 3)) << noise;
    EXPECT_EQ(cut.cycles.size(), 21u);
  }
}

TEST(Segment, ASmallStageBetweenLargeOnes) {
  Motion motion;
  motion.sine(200.0, 0.5, 3).sine(5.0, 0.5, 3).sine(200.0, 0.5, 2).end();
  EXPECT_EQ(counted_per_block(motion.cut()), (Counts{3, 3, 2}));
}

TEST(Segment, OneCyclePerStageIsCyclic) {
  for (double const sign : {1.0, -1.0}) {
    Motion motion;
    for (double const amplitude : {20.0, 50.0, 100.0, 150.0, 200.0}) motion.sine(sign * amplitude, 0.5, 1);
    auto const cut = motion.end().cut();
    EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
    EXPECT_EQ(counted_per_block(cut), Counts(5, 1));
  }
}

TEST(Segment, OneCycleIsCyclic) {
  auto const cut = Motion().sine(100.0, 0.5, 1).end().cut();
  EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
  EXPECT_EQ(counted_per_block(cut), Counts{1});
}

TEST(Segment, AChangeOfFrequencyAtOneAmplitudeIsABlock) {
  auto const cut = Motion().sine(100.0, 0.1, 3).sine(100.0, 0.5, 5).end().cut();
  EXPECT_EQ(counted_per_block(cut), (Counts{3, 5}));
  // Without time, isolaw can see a change of frequency only in the number of samples per cycle.
  Motion const motion = Motion().sine(100.0, 0.1, 3).sine(100.0, 0.5, 5).end();
  EXPECT_EQ(counted_per_block(segment(motion.disp_mm)), (Counts{3, 5}));
}

TEST(Segment, AChangeOfAmplitudeAtOneFrequencyIsABlock) {
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 4).sine(112.0, 0.5, 4).end().cut()), (Counts{4, 4}));
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 4).sine(103.0, 0.5, 4).end().cut()), Counts{8});
}

TEST(Segment, HoldsAndSlowStartsAreNoChangeOfFrequency) {
  auto const held = Motion().hold(0.0, 30.0).sine(100.0, 0.5, 2).hold(0.0, 20.0).sine(100.0, 0.5, 3).hold(0.0, 9.0);
  EXPECT_EQ(counted_per_block(held.cut()), Counts{5});
  auto const at_peak = Motion().sine(100.0, 0.5, 2.25).hold(100.0, 5.0).end(100.0);
  EXPECT_EQ(counted_per_block(at_peak.cut()), Counts{2});
  Motion slow;
  slow.ramp(0.0, 100.0, 6.0);  // a slow start; the fast cycles begin at the peak
  for (int i = 0; i <= 750; ++i) slow.add(100.0 * std::cos(pi * 0.01 * i));
  auto const cut = slow.cut();
  EXPECT_EQ(counted_per_block(cut), Counts{3});
  EXPECT_EQ(cut.cycles[0].not_counted, "its period of 7.5 s is 3.75 times as long as the block's 2 s, more than 1.4");
}

TEST(Segment, HoldsBetweenBlocksOfDifferentAmplitude) {
  auto const cut = Motion().sine(50.0, 0.5, 3).hold(0.0, 15.0).sine(100.0, 0.5, 3).end().noise(0.2).cut();
  EXPECT_EQ(counted_per_block(cut), (Counts{3, 3}));
}

TEST(Segment, PlateausAtThePeaksCutNothing) {
  Motion motion;  // trapezoids, whose plateaus are noisy
  for (int cycle = 0; cycle < 4; ++cycle)
    motion.ramp(0, 80, 1.0).hold(80, 2.0).ramp(80, -80, 2.0).hold(-80, 2.0).ramp(-80, 0, 1.0);
  EXPECT_EQ(counted_per_block(motion.end().noise(0.5).cut()), Counts{4});
}

TEST(Segment, NoiseAndTremorCutNothing) {
  for (double const noise : {0.1, 0.5, 1.0, 2.0}) {
    Motion motion = Motion().sine(-100.0, 0.5, 5).hold(0.0, 10.0).noise(noise);
    auto const cut = motion.cut();
    EXPECT_EQ(counted_per_block(cut), Counts{5}) << noise;
  }
  Motion tremor = Motion().sine(100.0, 0.5, 5).end();
  for (std::size_t i = 0; i < tremor.disp_mm.size(); ++i)
    tremor.disp_mm[i] += 0.5 * std::sin(2.0 * pi * 7.3 * tremor.time_s[i]);
  EXPECT_EQ(counted_per_block(tremor.cut()), Counts{5});
}

TEST(Segment, AStumbleOnTheWayIsNoReversal) {
  Motion motion;  // with backlash: about zero the motion falls back by 4 mm before it goes on
  motion.ramp(0, 100, 0.5);
  for (int cycle = 0; cycle < 4; ++cycle) {
    motion.ramp(100, -2, 0.5).ramp(-2, 2, 0.1).ramp(2, -100, 0.5);
    if (cycle < 3) motion.ramp(-100, 2, 0.5).ramp(2, -2, 0.1).ramp(-2, 100, 0.5);
  }
  auto const cut = motion.ramp(-100, 0, 0.5).end().cut();
  EXPECT_EQ(counted_per_block(cut), Counts{4});
  EXPECT_EQ(cut.cycles.size(), 4u);
}

TEST(Segment, APreLoadRampIsNoFirstMotion) {
  // A small displacement upwards comes before the test itself, which starts downwards.
  Motion motion;
  motion.ramp(0.0, 4.0, 3.0).ramp(4.0, 0.0, 3.0).sine(-100.0, 0.5, 3).end();
  auto const cut = motion.cut();
  EXPECT_EQ(counted_per_block(cut), Counts{3});
  // A cycle of this test starts where the displacement falls through zero, so its second half is positive.
  auto const& last = cut.cycles.back();
  EXPECT_EQ(last.number, 3);
  EXPECT_GT(value_at(motion.disp_mm, last.first + 0.75 * (last.last - last.first)), 50.0);
}

TEST(Segment, APreLoadEitherWayCostsNoCycle) {
  struct Case {
    double to_mm, seconds;
    int cycles;
  };
  for (auto const& [to, seconds, cycles] : std::vector<Case>{{-40.0, 4.0, 3},
                                                             {-60.0, 4.0, 3},
                                                             {-100.0, 4.0, 3},
                                                             {-148.0, 8.0, 3},
                                                             {-60.0, 4.0, 10},
                                                             {-148.0, 8.0, 1},
                                                             {148.0, 8.0, 3},
                                                             {40.0, 4.0, 3},
                                                             {40.0, 1.0, 2}})
    for (double const sign : {1.0, -1.0})
      for (double const noise : {0.0, 0.2}) {
        SCOPED_TRACE(fmt::format("{} mm, {} cycles, noise {}", sign * to, cycles, noise));
        Motion motion;
        motion.ramp(0.0, sign * to, seconds).ramp(sign * to, 0.0, seconds).sine(sign * 150.0, 0.5, cycles).end();
        auto const properties = motion.noise(noise).loop(0.6, 25.0).properties();
        auto const cut = motion.cut();
        ASSERT_TRUE(cut.cyclic) << text_of(cut.refusal);
        EXPECT_EQ(counted_per_block(cut), Counts{cycles});
        EXPECT_TRUE(cut.cycles[0].partial);
        EXPECT_TRUE(cut.cycles[0].not_counted.starts_with("pre-load: to ")) << cut.cycles[0].not_counted;
        EXPECT_NEAR(cut.cycles[1].first, 200.0 * seconds, 2.0);
        // Cycles start in the direction in which the test starts after its pre-load.
        EXPECT_GT(sign * value_at(motion.disp_mm, cut.cycles[1].first + 50.0), 140.0);
        EXPECT_EQ(properties.reported->number, std::min(3, cycles));
        if (noise > 0.0) continue;
        for (auto const* cycle : properties.counted()) {
          EXPECT_NEAR(*cycle->period_s, 2.0, 0.01);
          EXPECT_NEAR(cycle->amplitude_mm, 150.0, 0.1);
        }
        if (cycles >= 2) {
          // The energy is 4 Q (D - tanh(alpha D) / alpha) with D = 150 mm, Q = 25 kN and the alpha of Motion::loop().
          EXPECT_NEAR(properties.find(1, 2)->energy_kN_mm, 13750.0, 10.0);
        }
      }
}

TEST(Segment, ABlockMayStartTheOtherWay) {
  for (double const pause : {0.0, 3.0})
    for (double const noise : {0.0, 0.2}) {
      auto motion = Motion().sine(100.0, 0.5, 3).hold(0.0, pause).sine(-150.0, 0.5, 3).end().noise(noise);
      auto const cut = motion.cut();
      EXPECT_EQ(counted_per_block(cut), (Counts{3, 3})) << pause << " s, noise " << noise;
      EXPECT_EQ(cut.cycles.size(), 6u);
    }
  // After two and a half cycles the test starts anew in the other direction. The half cycle must be listed with the
  // first block, but not be counted among the cycles of this block.
  auto const cut = Motion().sine(100.0, 0.5, 2.5).sine(-150.0, 0.5, 3).end().cut();
  EXPECT_EQ(counted_per_block(cut), (Counts{2, 3}));
  ASSERT_EQ(cut.cycles.size(), 6u);
  EXPECT_EQ(cut.cycles[2].not_counted, "half a cycle: to 100 mm and back, then the motion starts anew");
  EXPECT_EQ(cut.cycles[2].block, 1);
}

TEST(Segment, TheStrengthOfABlockThatStartsTheOtherWay) {
  // The second block starts in the opposite direction. When its displacement first crosses zero, the force still
  // belongs to the first block's loop, so this crossing must not count in the strength of the second block.
  auto const properties = Motion().sine(100.0, 0.5, 3).sine(-150.0, 0.5, 3).end().loop(0.6, 25.0).properties();
  for (int const number : {1, 2, 3}) EXPECT_NEAR(properties.find(2, number)->Q_d_kN, 25.0, 0.1) << number;
}

TEST(Segment, ASlowStartDoesNotCount) {
  Motion motion;
  motion.ramp(0.0, 150.0, 2.0);
  for (int i = 0; i <= 800; ++i) motion.add(150.0 * std::cos(pi * 0.01 * i));
  auto const cut = motion.ramp(150.0, 0.0, 2.0).end().cut();
  EXPECT_EQ(counted_per_block(cut), Counts{3});
  EXPECT_EQ(cut.cycles[0].not_counted, "its period of 3.5 s is 1.75 times as long as the block's 2 s, more than 1.4");
  EXPECT_TRUE(cut.cycles.back().partial);
  // Rigs start gently, so a first cycle that is only a little slower than the others must be counted.
  Motion gentle;
  gentle.ramp(0.0, 150.0, 0.9);
  for (int i = 0; i <= 750; ++i) gentle.add(150.0 * std::cos(pi * 0.01 * i));
  EXPECT_EQ(counted_per_block(gentle.cut()), Counts{4});
}

TEST(Segment, ASmallLastingChangeOfFrequencyIsABlock) {
  for (double const frequency : {0.45, 0.47, 0.55})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      auto motion = Motion().sine(150.0, 0.5, 3).sine(150.0, frequency, 3).end().noise(seed == 1 ? 0.0 : 1.0, seed);
      auto const properties = motion.loop().properties();
      ASSERT_EQ(counted_per_block(motion.cut()), (Counts{3, 3})) << frequency << ", seed " << seed;
      EXPECT_NEAR(*properties.blocks[0].frequency_Hz, 0.5, 0.005);
      EXPECT_NEAR(*properties.blocks[1].frequency_Hz, frequency, 0.005);
    }
  // A single cycle of another frequency, periods that scatter over about 10 %, and noise must not start a new block.
  auto const odd = Motion().sine(150.0, 0.5, 3).sine(150.0, 0.45, 1).sine(150.0, 0.5, 3).end();
  EXPECT_EQ(counted_per_block(odd.cut()), Counts{7});
  Motion uneven;
  for (double const frequency : {0.5, 0.46, 0.51, 0.47, 0.49, 0.46, 0.5, 0.47}) uneven.sine(150.0, frequency, 1);
  EXPECT_EQ(counted_per_block(uneven.end().cut()), Counts{8});
  for (unsigned seed = 1; seed <= 20; ++seed)
    EXPECT_EQ(counted_per_block(Motion().sine(150.0, 0.5, 12).end().noise(3.0, seed).cut()), Counts{12}) << seed;
}

TEST(Segment, RestsAndHoldsAreNoPartOfPeriods) {
  Motion whole = Motion().sine(150.0, 0.5, 4);
  auto const held = [&](std::size_t at) {  // puts a hold of 3 s into the second cycle
    Motion motion;
    for (std::size_t i = 0; i < at; ++i) motion.add(whole.disp_mm[i]);
    motion.hold(whole.disp_mm[at], 3.0);
    for (auto i = at; i < whole.disp_mm.size(); ++i) motion.add(whole.disp_mm[i]);
    return motion.end();
  };
  auto const rested =
      Motion().sine(150.0, 0.5, 1).hold(0.0, 3.0).sine(150.0, 0.5, 1).hold(0.0, 3.0).sine(150.0, 0.5, 1).end();
  for (auto const& motion : {held(250), held(225), held(300), held(275), rested})
    for (double const noise : {0.0, 0.02, 0.3}) {
      auto noisy = motion;
      auto const properties = noisy.noise(noise).loop().properties();
      ASSERT_EQ(properties.blocks.size(), 1u);
      EXPECT_EQ(properties.counted().size(), properties.complete().size());
      // At rest, noise crosses the centre a few samples after the motion has ended, so the cut and the frequency are
      // less exact.
      EXPECT_NEAR(*properties.blocks[0].frequency_Hz, 0.5, 0.0125) << noise;
      EXPECT_NEAR(*properties.samples_per_cycle, 200.0, 5.0) << noise;
      EXPECT_EQ(properties.blocks[0].waveform, "sine");
      double still = 0.0;
      for (auto const* cycle : properties.counted()) {
        EXPECT_NEAR(*cycle->period_s, 2.0, 0.08) << noise;
        still += *cycle->still_s;
      }
      EXPECT_NEAR(still, properties.counted().size() == 3 ? 6.0 : 3.0, 0.12);
    }
}

TEST(Segment, MotionWithoutHoldsHasNone) {
  for (auto const& motion :
       {Motion().sine(150.0, 0.5, 4).end(), Motion().sine(150.0, 0.02, 2).end(),
        Motion().ramp(0, 80, 1).ramp(80, -80, 2).ramp(-80, 80, 2).ramp(80, -80, 2).ramp(-80, 0, 1).end()})
    for (double const noise : {0.0, 0.3, 1.5}) {
      auto noisy = motion;
      for (auto const& cycle : noisy.noise(noise).cut().cycles) EXPECT_EQ(cycle.still_samples, 0.0) << noise;
    }
}

TEST(Segment, ABuildUpCycleDoesNotCount) {
  for (double const first : {138.0, 130.0, 160.0}) {
    auto const cut = Motion().sine(first, 0.5, 1).sine(150.0, 0.5, 4).end().cut();
    EXPECT_EQ(counted_per_block(cut), Counts{4}) << first;
    EXPECT_EQ(cut.cycles[0].number, 0);
    EXPECT_EQ(cut.cycles[3].number, 3);
  }
  EXPECT_EQ(Motion().sine(138.0, 0.5, 1).sine(150.0, 0.5, 4).end().cut().cycles[0].not_counted,
            "build-up: its amplitude of 138 mm is 8.0 % below the block's 150 mm, more than 5 %");
  // Cycles of 100 mm and 150 mm differ too much to be one block, even if there is only one cycle of 100 mm.
  EXPECT_EQ(counted_per_block(Motion().sine(100.0, 0.5, 1).sine(150.0, 0.5, 3).end().cut()), (Counts{1, 3}));
}

TEST(Segment, PartialEndsAreShownWithTheirReason) {
  Motion motion;
  motion.ramp(40.0, 0.0, 0.5).sine(-100.0, 0.5, 3.3).end(-100.0 * std::sin(2.0 * pi * 0.3));
  auto const cut = motion.cut();
  ASSERT_EQ(cut.cycles.size(), 5u);
  EXPECT_TRUE(cut.cycles.front().partial);
  EXPECT_EQ(cut.cycles.front().number, 0);
  EXPECT_NE(cut.cycles.front().not_counted.find("the record starts at 40 mm"), std::string::npos);
  EXPECT_TRUE(cut.cycles.back().partial);
  EXPECT_NE(cut.cycles.back().not_counted.find("before the cycle is closed"), std::string::npos);
  EXPECT_EQ(counted_per_block(cut), Counts{3});
  for (std::size_t k = 1; k < cut.cycles.size(); ++k) EXPECT_EQ(cut.cycles[k].first, cut.cycles[k - 1].last);
}

TEST(Segment, ARecordThatStartsAndEndsAnywhereInItsCyclesIsCyclic) {
  Motion whole;
  whole.sine(100.0, 0.5, 12.0);  // the sine has 200 samples per cycle
  for (int const start : {0, 1, 3, 10, 40, 49, 51, 90, 100, 110, 149, 150, 151, 190, 199})
    for (int const samples : {450, 520, 600, 650, 700, 730, 799, 801, 900, 1101}) {
      auto const from = whole.disp_mm.begin() + start;
      auto const cut = segment(std::vector<double>(from, from + samples));
      EXPECT_TRUE(cut.cyclic) << "from sample " << start << ", " << samples << ": " << text_of(cut.refusal);
      auto const counted = std::ranges::count_if(cut.cycles, [](CycleCut const& c) { return c.number > 0; });
      EXPECT_GE(counted, (samples - 1) / 200 - 1) << "from sample " << start << ", " << samples;
      EXPECT_EQ(counted, std::ranges::count(cut.cycles, false, &CycleCut::partial));
    }
}

TEST(Segment, AnOddCycleWithinABlockDoesNotCount) {
  auto const cut = Motion().sine(100.0, 0.5, 3).sine(80.0, 0.5, 1).sine(100.0, 0.5, 3).end().cut();
  ASSERT_EQ(counted_per_block(cut), Counts{6});
  EXPECT_EQ(cut.cycles[3].number, 0);
  EXPECT_EQ(cut.cycles[3].not_counted, "its amplitude of 80 mm is 20.0 % below the block's 100 mm, more than 5 %");
  EXPECT_EQ(cut.cycles[4].number, 4);
}

TEST(Segment, RampedEndsBelongToTheirBlock) {
  Motion motion;  // the amplitude grows over two cycles and fades over two
  for (int i = 0; i <= 1400; ++i) {
    double const t = 0.01 * i;
    motion.add(25.0 * std::min({1.0, t / 4.0, (14.0 - t) / 4.0}) * std::sin(pi * t));
  }
  auto const cut = motion.cut();
  EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
  EXPECT_EQ(std::ranges::count(cut.cycles, false, &CycleCut::partial), 7);
  EXPECT_EQ(counted_per_block(cut), Counts{3});
}

TEST(Segment, AnOffsetIsCutAtTheCentre) {
  for (double const by : {0.0, 3.0, 15.0, 60.0, 250.0, -1000.0}) {
    auto const cut = Motion().sine(100.0, 0.5, 4).sine(20.0, 0.5, 3).end().offset(by).cut();
    EXPECT_EQ(counted_per_block(cut), (Counts{4, 3})) << by;
    EXPECT_NEAR(cut.centre_mm, std::abs(by) <= 5.0 ? 0.0 : by, 0.6) << by;
  }
  // The offset of 3 mm is larger than the second amplitude of 2.5 mm, so these cycles never cross zero. They are cut at
  // the centre of the record instead.
  auto const cut = Motion().sine(100.0, 0.5, 4).sine(2.5, 0.5, 3).end().offset(3.0).cut();
  EXPECT_EQ(counted_per_block(cut), (Counts{4, 3}));
}

TEST(Segment, ADriftingMiddleStaysCyclic) {
  Motion motion = Motion().sine(100.0, 0.5, 10).end();
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i) motion.disp_mm[i] += 3.0 * motion.time_s[i] - 30.0;
  auto const cut = motion.cut();
  EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
  EXPECT_GE(counted_per_block(cut).at(0), 8);
}

// The records are responses of oscillators, with periods of 0.5 to 3 s, to noise that swells and fades. Such responses
// are as irregular as those to earthquakes.
TEST(Segment, ResponsesToIrregularMotionAreNotCyclic) {
  int cyclic = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    double const period = 0.5 + 2.5 * (seed % 10) / 9.0;
    double const damping = seed % 2 == 0 ? 0.05 : 0.15;
    double const omega = 2.0 * pi / period;
    double x = 0.0, v = 0.0;
    Motion motion;
    for (int i = 0; i < 4000; ++i) {
      double const t = 0.01 * i;
      v += 0.01 *
           (3000.0 * t * std::exp(-t / 8.0) * normal(generator) / 10.0 - 2.0 * damping * omega * v - omega * omega * x);
      x += 0.01 * v;
      motion.add(x);
    }
    auto const cut = motion.cut();
    cyclic += cut.cyclic ? 1 : 0;
    if (cut.cyclic) continue;
    EXPECT_TRUE(text_of(cut.refusal).starts_with("the motion is not cyclic: ")) << text_of(cut.refusal);
    EXPECT_NE(text_of(cut.refusal).find("80 % or more"), std::string::npos) << text_of(cut.refusal);
    for (auto const& cycle : cut.cycles) {
      EXPECT_EQ(cycle.number, 0);
      EXPECT_FALSE(cycle.not_counted.starts_with("pre-load")) << "of nothing";
    }
  }
  EXPECT_EQ(cyclic, 0);
}

TEST(Segment, HistoriesThatDoNotMoveAreRefused) {
  EXPECT_EQ(text_of(segment({}).refusal), "there are no samples.");
  for (auto const& x : {Values{1.0}, Values{1.0, 2.0}, Values(100, 7.0)}) {
    auto const cut = segment(x);
    EXPECT_FALSE(cut.cyclic);
    EXPECT_TRUE(text_of(cut.refusal).starts_with("less than one complete cycle")) << text_of(cut.refusal);
  }
  auto const monotone = Motion().ramp(0.0, 100.0, 10.0).cut();
  EXPECT_TRUE(
      text_of(monotone.refusal).starts_with("less than one complete cycle: displacement goes from 0 to 99.9 mm"));
}

// --- changes of a record that must not change its cycles ---

class Draw : public ::testing::TestWithParam<unsigned> {
 protected:
  // Returns a cyclic test with stages of growing amplitude. The sampling interval, the direction, the stages, the rests
  // between them and the noise are random.
  Motion random() {
    std::mt19937 generator(GetParam());
    auto const uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(generator); };
    Motion motion;
    motion.dt_s = uniform(0.004, 0.015);
    double const sign = uniform(0.0, 1.0) < 0.5 ? 1.0 : -1.0;
    if (uniform(0.0, 1.0) < 0.3) motion.hold(0.0, uniform(1.0, 10.0));
    double amplitude = uniform(20.0, 40.0);
    int const stages = std::uniform_int_distribution(1, 4)(generator);
    for (int stage = 0; stage < stages; ++stage) {
      int const cycles = std::uniform_int_distribution(2, 6)(generator);
      motion.sine(sign * amplitude, uniform(0.2, 1.0), cycles);
      expected_.push_back(cycles);
      amplitude *= uniform(1.3, 2.0);
      if (uniform(0.0, 1.0) < 0.3) motion.hold(0.0, uniform(1.0, 10.0));
    }
    motion.end();
    motion.noise(uniform(0.0, 0.05), GetParam());
    return motion;
  }
  Counts expected_;
};

TEST_P(Draw, IsCutIntoItsStages) {
  auto const motion = random();
  auto const cut = motion.cut();
  EXPECT_TRUE(cut.cyclic) << text_of(cut.refusal);
  EXPECT_EQ(counted_per_block(cut), expected_);
}

void expect_same(Segmentation const& a, Segmentation const& b, double scale = 1.0) {
  ASSERT_EQ(a.cycles.size(), b.cycles.size());
  EXPECT_EQ(a.cyclic, b.cyclic);
  for (std::size_t k = 0; k < a.cycles.size(); ++k) {
    EXPECT_EQ(a.cycles[k].block, b.cycles[k].block);
    EXPECT_EQ(a.cycles[k].number, b.cycles[k].number);
    EXPECT_NEAR(scale * a.cycles[k].first, b.cycles[k].first, 1e-6 + (scale == 1.0 ? 0.0 : 8.0 * scale));
    EXPECT_NEAR(scale * a.cycles[k].last, b.cycles[k].last, 1e-6 + (scale == 1.0 ? 0.0 : 8.0 * scale));
  }
}

TEST_P(Draw, UnitsSignAndTimeOriginDoNotMatter) {
  auto const motion = random();
  auto const cut = motion.cut();
  for (double const factor : {0.001, 0.0393701, 10.0, -1.0}) {
    auto scaled = motion;
    for (double& x : scaled.disp_mm) x *= factor;
    expect_same(cut, scaled.cut());
  }
  auto later = motion;
  for (double& t : later.time_s) t = 60.0 * t + 12345.0;
  expect_same(cut, later.cut());
}

TEST_P(Draw, ThePhysicsSurviveRescalingShiftResamplingAndReversal) {
  auto motion = random();
  // Make the number of samples odd. The last sample then stays when every second one is dropped.
  if (motion.disp_mm.size() % 2 == 0) motion.end();
  motion.loop();
  auto const reference = motion.properties();
  ASSERT_TRUE(reference.reported) << text_of(reference.refusal);
  auto const& cycle = *reference.reported;
  auto reversed = motion;
  for (double& x : reversed.disp_mm) x = -x;
  for (double& F : reversed.force_kN) F = -F;
  auto const other = *reversed.properties().reported;
  EXPECT_NEAR(other.K_eff_kN_per_mm, cycle.K_eff_kN_per_mm, 1e-9);
  EXPECT_NEAR(other.energy_kN_mm, cycle.energy_kN_mm, 1e-6);
  EXPECT_NEAR(other.Q_d_kN, cycle.Q_d_kN, 1e-6);
  EXPECT_NEAR(other.d_plus_mm, -cycle.d_minus_mm, 1e-9);
  EXPECT_NEAR(other.K_plus_kN_per_mm, cycle.K_minus_kN_per_mm, 1e-9);

  auto scaled = motion;  // the same record in cm, tonf and ms, and recorded an hour later
  for (double& x : scaled.disp_mm) x *= 0.1;
  for (double& F : scaled.force_kN) F /= 9.80665;
  for (double& t : scaled.time_s) t = 1000.0 * t + 3.6e6;
  auto const in_cm = *scaled.properties().reported;
  EXPECT_NEAR(in_cm.K_eff_kN_per_mm, cycle.K_eff_kN_per_mm * 10.0 / 9.80665, 1e-9);
  EXPECT_NEAR(in_cm.energy_kN_mm, cycle.energy_kN_mm * 0.1 / 9.80665, 1e-7);
  EXPECT_NEAR(in_cm.damping_percent, cycle.damping_percent, 1e-9);
  EXPECT_NEAR(in_cm.v_max_mm_s.value(), cycle.v_max_mm_s.value() * 1e-4, 1e-9);

  Motion half;
  for (std::size_t i = 0; i < motion.disp_mm.size(); i += 2) {
    half.time_s.push_back(motion.time_s[i]);
    half.disp_mm.push_back(motion.disp_mm[i]);
    half.force_kN.push_back(motion.force_kN[i]);
  }
  auto const thinned = half.properties();
  ASSERT_TRUE(thinned.reported) << text_of(thinned.refusal);
  ASSERT_EQ(thinned.counted().size(), reference.counted().size());
  EXPECT_NEAR(thinned.reported->K_eff_kN_per_mm, cycle.K_eff_kN_per_mm, 0.02 * cycle.K_eff_kN_per_mm);
  EXPECT_NEAR(thinned.reported->energy_kN_mm, cycle.energy_kN_mm, 0.02 * cycle.energy_kN_mm);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Draw, ::testing::Range(1u, 61u));

// --- meaningless displacements ---

TEST(Segment, GarbageOfAnyShapeIsCutWithinTheRecord) {
  std::mt19937_64 generator(5);
  auto const check = [](Values const& x) {
    auto const properties = cyclic_properties(x, x);
    double before = 0.0;
    for (auto const& block : properties.blocks)
      for (auto const& cycle : block.cycles) {
        ASSERT_GE(cycle.first, before);
        ASSERT_LE(cycle.first, cycle.last);
        ASSERT_LE(cycle.last, static_cast<double>(x.size() - 1));
        before = cycle.last;
      }
  };
  for (int draw = 0; draw < 3000; ++draw) {
    auto const kind = draw % 6;
    Values x(1 + generator() % 60);
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const bits = generator();
      double const unit = static_cast<double>(bits >> 11) / 9007199254740992.0;
      if (kind == 0) x[i] = unit - 0.5;
      if (kind == 1) x[i] = static_cast<double>(bits % 3) - 1.0;
      if (kind == 2) x[i] = std::ldexp(unit - 0.5, static_cast<int>(bits % 2000) - 1000);
      if (kind == 3) x[i] = (i % 2 == 0 ? 1.0 : -1.0) * std::numeric_limits<double>::max() * unit;
      if (kind == 4) x[i] = i == 0 ? 0.0 : x[i - 1] + unit - 0.5;
      if (kind == 5) x[i] = std::numeric_limits<double>::denorm_min() * static_cast<double>(bits % 5);
    }
    check(x);
  }
}

TEST(Segment, AMillionSamplesOfAnyShape) {
  std::size_t const size = 1'000'000;
  std::mt19937 generator(9);
  std::normal_distribution<double> normal;
  Values white(size), walk(size), alternating(size), spike(size, 0.0), growing(size), stairs(size);
  for (std::size_t i = 0; i < size; ++i) {
    white[i] = normal(generator);
    walk[i] = i == 0 ? 0.0 : walk[i - 1] + normal(generator);
    alternating[i] = i % 2 == 0 ? 1.0 : -1.0;
    growing[i] = (i % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(i);
    stairs[i] = static_cast<double>((i / 1000) % 2) * static_cast<double>(i);
  }
  spike[size / 2] = 1.0;
  for (auto const* x : {&white, &walk, &alternating, &spike, &growing, &stairs}) {
    auto const properties = cyclic_properties(*x, *x);
    for (auto const* cycle : properties.complete()) ASSERT_LT(cycle->first, cycle->last);
  }
}

Segmentation cut_with_halves(Motion const& motion) {
  return segment(motion.disp_mm, motion.time_s, {}, {.half_cycles = true});
}

Properties properties_with_halves(Motion const& motion) {
  auto view = motion.view();
  view.half_cycles = true;
  return cyclic_properties(view);
}

// In steady cycles each half of the loop is the other half turned by 180 degrees. The properties of half cycles must
// therefore equal those of full cycles.
TEST(HalfCycles, OfASteadyLoopHaveTheValuesOfItsFullCycles) {
  auto const motion = Motion().sine(100.0, 0.5, 3.5).end().loop();
  EXPECT_EQ(counted_per_block(motion.cut()), Counts{3});
  auto const properties = properties_with_halves(motion);
  ASSERT_EQ(properties.blocks.size(), 3u);
  EXPECT_EQ(properties.blocks[0].counted().size(), 3u);
  auto const& full = *properties.find(1, 3);
  auto const& half = *properties.find(2, 1);
  EXPECT_FALSE(full.half);
  EXPECT_TRUE(half.half);
  EXPECT_NEAR(half.K_eff_kN_per_mm, full.K_eff_kN_per_mm, 1e-3 * full.K_eff_kN_per_mm);
  EXPECT_NEAR(half.energy_kN_mm, full.energy_kN_mm, 2e-3 * full.energy_kN_mm);
  EXPECT_NEAR(half.damping_percent, full.damping_percent, 2e-3 * full.damping_percent);
  EXPECT_NEAR(half.Q_d_kN, full.Q_d_kN, 1e-2 * full.Q_d_kN);
  EXPECT_NEAR(*half.period_s, 2.0, 0.03);
  EXPECT_EQ(properties.blocks[1].waveform, "sine");
  EXPECT_NEAR(properties.find(3, 1)->amplitude_mm, 50.0, 0.1);  // the way from the last peak to zero
  EXPECT_TRUE(properties.reported && !properties.reported->half);
  // Two tests of one device with the same signal: the numbers of blocks go on from the first test to the second.
  auto twice = motion.disp_mm;
  twice.insert(twice.end(), motion.disp_mm.begin(), motion.disp_mm.end());
  std::vector<std::size_t> const starts{0, motion.disp_mm.size()};
  EXPECT_EQ(counted_per_block(segment(twice, {}, starts, {.half_cycles = true})), (Counts{3, 1, 1, 3, 1, 1}));
}

TEST(HalfCycles, OfASinglePushAreTwo) {
  auto const motion = Motion().ramp(0.0, 50.0, 5.0).ramp(50.0, 0.0, 5.0).end().loop();
  EXPECT_FALSE(motion.properties().reported);
  auto const properties = properties_with_halves(motion);
  ASSERT_TRUE(properties.reported);
  auto const counted = properties.counted();
  ASSERT_EQ(counted.size(), 2u);
  for (auto const* cycle : counted) {
    EXPECT_TRUE(cycle->half);
    EXPECT_NEAR(cycle->amplitude_mm, 25.0, 1e-9);
    EXPECT_NEAR(*cycle->period_s, 10.0, 1e-9);
  }
  EXPECT_NEAR(counted[0]->K_eff_kN_per_mm, motion.force_kN[500] / 50.0, 1e-9);
  // The way back counts as a half cycle only if it reaches the start. If the record ends earlier, its end does not
  // count as a turning point.
  EXPECT_EQ(counted_per_block(cut_with_halves(Motion().ramp(0.0, 50.0, 5.0).ramp(50.0, 20.0, 3.0).end(20.0))),
            Counts{1});
}

TEST(HalfCycles, ChangeNothingWhereEverySwingBelongsToAFullCycle) {
  for (auto const& motion :
       {Motion().sine(50.0, 0.5, 3).sine(100.0, 0.5, 3).end(), Motion().sine(100.0, 0.5, 4, 30.0).end(30.0)}) {
    auto const without = motion.cut(), with = cut_with_halves(motion);
    EXPECT_EQ(counted_per_block(with), counted_per_block(without));
    EXPECT_TRUE(std::ranges::none_of(with.cycles, &CycleCut::half));
  }
}

// Each swing of an irregular motion is a half cycle.
TEST(HalfCycles, OfARecordWithoutCyclesAreAllItsSwings) {
  Motion motion;
  double from = 0.0;
  for (double const to : {20.0, -45.0, 70.0, -15.0, 30.0, -80.0, 50.0, 0.0}) {
    motion.ramp(from, to, std::abs(to - from) / 100.0);
    from = to;
  }
  motion.end().loop();
  auto const cut = cut_with_halves(motion);
  EXPECT_FALSE(motion.cut().cyclic);
  EXPECT_TRUE(cut.cyclic);
  EXPECT_EQ(cut.cycles.size(), 8u);
  EXPECT_TRUE(std::ranges::all_of(cut.cycles, &CycleCut::half));
  auto const properties = properties_with_halves(motion);
  EXPECT_NEAR(properties.reported->amplitude_mm, 65.0, 1e-9);
}

}  // namespace
}  // namespace isolaw::data::testing
