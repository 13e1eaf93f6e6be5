// Tests cycles and their properties against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {
namespace {

using std::numbers::pi;
using Values = std::vector<double>;

struct History {
  Values x;
  Values F;
  void add(double disp_mm, double force_kN) {
    x.push_back(disp_mm);
    F.push_back(force_kN);
  }
  Properties properties() const { return cyclic_properties(x, F); }
};

Cycle const& nth(Properties const& properties, std::size_t index) {
  return *properties.counted().at(index);
}

// Returns cycles with the displacement Xa sin(a) and the force Fa sin(a + phi). `sign` is the direction of the first
// motion.
History ellipse(int samples_per_cycle, int cycles, double Xa, double Fa, double phi, double sign = 1.0) {
  History history;
  for (int i = 0; i <= samples_per_cycle * cycles; ++i) {
    double const angle = 2.0 * pi * i / samples_per_cycle;
    history.add(sign * Xa * std::sin(angle), sign * Fa * std::sin(angle + phi));
  }
  return history;
}

// The trapezoidal rule gives the area of a polygon inscribed in the ellipse. This factor is the polygon's area over the
// ellipse's.
double trapezoid_factor(double samples) {
  return samples / (2.0 * pi) * std::sin(2.0 * pi / samples);
}

class Ellipses : public ::testing::TestWithParam<int> {};

TEST_P(Ellipses, HaveTheirClosedForm) {
  int const samples = GetParam();  // a multiple of 4, so the extremes are sampled
  double const Xa = 208.0, Fa = 250.0, phi = 0.3;
  for (double const sign : {1.0, -1.0}) {
    auto const properties = ellipse(samples, 3, Xa, Fa, phi, sign).properties();
    ASSERT_EQ(properties.counted().size(), 3u);
    ASSERT_TRUE(properties.reported);
    EXPECT_EQ(text_of(properties.refusal), "");
    EXPECT_NEAR(*properties.samples_per_cycle, samples, 1e-9);
    for (int k = 0; k < 3; ++k) {
      auto const& cycle = nth(properties, static_cast<std::size_t>(k));
      EXPECT_EQ(cycle.number, k + 1);
      EXPECT_NEAR(cycle.first, k * samples, 1e-9);
      EXPECT_NEAR(cycle.last, (k + 1) * samples, 1e-9);
      EXPECT_NEAR(cycle.amplitude_mm, Xa, 1e-9);
      EXPECT_NEAR(cycle.K_eff_kN_per_mm, Fa * std::cos(phi) / Xa, 1e-12);
      double const energy = pi * Fa * Xa * std::sin(phi) * trapezoid_factor(samples);
      EXPECT_NEAR(cycle.energy_kN_mm, energy, 1e-9 * energy);
      EXPECT_NEAR(cycle.damping_percent, 50.0 * std::tan(phi) * trapezoid_factor(samples), 1e-9);
    }
    EXPECT_EQ(properties.reported->number, 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Ellipses, ::testing::Values(20, 100, 200, 1000));

TEST(Cycles, CutBetweenSamplesAreInterpolated) {
  // A triangular motion of ±2.5 mm with a period of 10 samples, shifted by half a sample. It crosses zero at samples
  // 0.5, 10.5 and 20.5, where the force is -1 kN.
  History history;
  for (int i = 0; i <= 21; ++i) {
    double const t = i - 0.5;
    double const in_period = t - 10.0 * std::floor(t / 10.0);
    double const x = in_period < 2.5 ? in_period : in_period < 7.5 ? 5.0 - in_period : in_period - 10.0;
    history.add(x, 3.0 * x - 1.0);
  }
  auto const properties = history.properties();
  ASSERT_EQ(properties.counted().size(), 2u);  // no cycle starts at the first sample: -0.5 mm is too far from zero
  EXPECT_NEAR(nth(properties, 0).first, 0.5, 1e-12);
  EXPECT_NEAR(nth(properties, 0).last, 10.5, 1e-12);
  EXPECT_NEAR(nth(properties, 1).last, 20.5, 1e-12);
  EXPECT_NEAR(nth(properties, 0).energy_kN_mm, 0.0, 1e-12);  // the spring is elastic
  EXPECT_NEAR(nth(properties, 0).K_eff_kN_per_mm, 3.0, 1e-12);
}

// A bilinear loop with first stiffness K1, second stiffness K2 and strength Qd yields at D_y = Qd / (K1 - K2).
TEST(Cycles, BilinearLoopHasTheArea4QdDMinusDy) {
  double const K1 = 10.0, K2 = 1.0, Qd = 45.0, D = 100.0;
  double const Dy = Qd / (K1 - K2);
  History history;
  double elastic = 0.0;  // force of the part that is elastic and perfectly plastic, limited to ±Qd
  double x = 0.0;
  history.add(0.0, 0.0);
  auto const go = [&](double to) {
    double const step = to > x ? 0.5 : -0.5;  // Dy = 5 is a multiple of the step of 0.5, so corners fall on samples
    while (x != to) {
      x += step;
      elastic = std::clamp(elastic + (K1 - K2) * step, -Qd, Qd);
      history.add(x, K2 * x + elastic);
    }
  };
  go(D), go(-D), go(D), go(-D), go(0.0);
  auto const properties = history.properties();
  ASSERT_EQ(properties.counted().size(), 2u);
  auto const& steady = nth(properties, 1);
  double const energy = 4.0 * Qd * (D - Dy);
  EXPECT_NEAR(steady.energy_kN_mm, energy, 1e-9 * energy);
  EXPECT_NEAR(steady.K_eff_kN_per_mm, K2 + Qd / D, 1e-12);
  EXPECT_NEAR(steady.damping_percent, 100.0 * energy / (2.0 * pi * (K2 + Qd / D) * D * D), 1e-9);
}

TEST(Cycles, ConstantOffsetsChangeNeitherStiffnessNorEnergy) {
  auto const plain = ellipse(400, 3, 100.0, 80.0, 0.3);
  auto moved = plain;
  for (double& x : moved.x) x += 20.0;
  for (double& F : moved.F) F -= 30.0;
  auto const a = plain.properties();
  auto const b = moved.properties();
  ASSERT_EQ(b.counted().size(), 3u);
  EXPECT_NEAR(b.centre_mm, 20.0, 1e-9);
  EXPECT_NEAR(nth(b, 1).K_eff_kN_per_mm, nth(a, 1).K_eff_kN_per_mm, 1e-12);
  EXPECT_NEAR(nth(b, 1).energy_kN_mm, nth(a, 1).energy_kN_mm, 1e-12 * nth(a, 1).energy_kN_mm);
}

TEST(Cycles, TheLoopIsClosedByAStraightLine) {
  // The record starts at 1 mm and 2 kN, near enough to zero for a cycle to start, and ends at 0 mm and 0 kN. The line
  // that closes the loop adds its mean force of 1 kN times 1 mm.
  History history;
  history.add(1.0, 2.0);
  for (int i = 1; i <= 100; ++i) history.add(100.0 * std::sin(2.0 * pi * i / 100), 0.0);
  auto const properties = history.properties();
  ASSERT_EQ(properties.counted().size(), 1u);
  double const first_step = 0.5 * 2.0 * (history.x[1] - 1.0);
  EXPECT_NEAR(nth(properties, 0).energy_kN_mm, first_step + 1.0, 1e-9);
}

TEST(Cycles, NoiseAndHoldsAboutZeroCutNothing) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> tremor(-1.0, 1.0);
  History history;
  auto const hold = [&](int samples) {
    for (int i = 0; i < samples; ++i) history.add(tremor(generator), tremor(generator));
  };
  hold(300);
  for (int cycle = 0; cycle < 3; ++cycle) {
    for (int i = 0; i < 200; ++i)
      history.add(-100.0 * std::sin(2.0 * pi * i / 200) + tremor(generator),
                  -90.0 * std::sin(2.0 * pi * i / 200 + 0.3));
    if (cycle < 2) hold(50);  // a hold between cycles
  }
  hold(100);
  auto const properties = history.properties();
  ASSERT_EQ(properties.counted().size(), 3u);
  EXPECT_EQ(nth(properties, 0).first, 0.0);
  EXPECT_NEAR(nth(properties, 0).last, 500.0, 50.0);
  // Each cycle has 200 samples of motion. Samples of the noisy holds before and after it may be added to them.
  EXPECT_NEAR(*properties.samples_per_cycle, 250.0, 60.0);
}

TEST(Cycles, StagesFromFiveToTwoHundredPercentAreAllFound) {
  History history;
  for (double const amplitude : {5.0, 50.0, 200.0})
    for (int i = 0; i < 600; ++i)
      history.add(amplitude * std::sin(2.0 * pi * i / 200), amplitude * std::sin(2.0 * pi * i / 200 + 0.3));
  history.add(0.0, 0.0);
  auto const properties = history.properties();
  EXPECT_EQ(properties.counted().size(), 9u);
  ASSERT_EQ(properties.blocks.size(), 3u);
  EXPECT_NEAR(properties.blocks[0].amplitude_mm, 5.0, 1e-9);
  EXPECT_EQ(properties.reported->block, 3);
}

TEST(Cycles, TheLastOfFewerThanThreeIsReported) {
  EXPECT_EQ(ellipse(100, 1, 1.0, 1.0, 0.3).properties().reported->number, 1);
  EXPECT_EQ(ellipse(100, 2, 1.0, 1.0, 0.3).properties().reported->number, 2);
  EXPECT_EQ(ellipse(100, 7, 1.0, 1.0, 0.3).properties().reported->number, 3);
}

TEST(Cycles, AreRefusedWithNumbers) {
  History half;
  for (int i = 0; i <= 100; ++i) half.add(100.0 * std::sin(pi * i / 100.0), 0.5 * i);
  auto const none = half.properties();
  EXPECT_FALSE(none.reported);
  EXPECT_FALSE(none.samples_per_cycle);
  EXPECT_TRUE(none.complete().empty());
  EXPECT_TRUE(text_of(none.refusal)
                  .starts_with("less than one complete cycle: displacement goes from 0 to 100 mm. A cycle needs 2"))
      << text_of(none.refusal);
  auto const few = ellipse(16, 3, 100.0, 80.0, 0.3).properties();
  EXPECT_FALSE(few.reported);
  EXPECT_EQ(few.counted().size(), 3u);
  EXPECT_EQ(text_of(few.refusal), "16.0 samples per cycle, fewer than the 20 that stiffness and energy need.");
}

TEST(Cycles, HistoriesThatAreNoTestsDoNotCrash) {
  EXPECT_FALSE(cyclic_properties(Values{}, Values{}).reported);
  EXPECT_FALSE(cyclic_properties(Values{1.0}, Values{1.0}).reported);
  EXPECT_FALSE(cyclic_properties(Values(100, 0.0), Values(100, 1.0)).reported);
  EXPECT_FALSE(cyclic_properties(Values(100, 7.0), Values(100, 1.0)).reported);
  std::mt19937 generator(11);
  std::normal_distribution<double> step(0.0, 1.0);
  History quake;
  double x = 0.0, v = 0.0;
  for (int i = 0; i < 4000; ++i) {
    v = 0.98 * v - 0.01 * x + step(generator);
    x += 0.1 * v;
    quake.add(x, x + v);
  }
  auto const properties = quake.properties();
  EXPECT_TRUE(text_of(properties.refusal).starts_with("the motion is not cyclic")) << text_of(properties.refusal);
  EXPECT_TRUE(properties.counted().empty());
  for (auto const* cycle : properties.complete()) EXPECT_LT(cycle->first, cycle->last);
}

// This record has two faults: its loops give energy back, and it has few samples. The message must name the energy.
TEST(Properties, EnergyGivenBackIsSaidBeforeFewSamples) {
  auto const properties = ellipse(12, 3, 100.0, 70.0, -0.3).properties();
  EXPECT_TRUE(properties.refusal_is_of_fault);
  EXPECT_NE(text_of(properties.refusal).find("gives back"), std::string::npos) << text_of(properties.refusal);
  auto const few = ellipse(12, 3, 100.0, 70.0, 0.3).properties();
  EXPECT_FALSE(few.refusal_is_of_fault);
  EXPECT_NE(text_of(few.refusal).find("samples per cycle"), std::string::npos) << text_of(few.refusal);
}

// An elastic spring dissipates nothing. The small energy that noise produces must not be reported as energy given back.
TEST(Properties, NoiseOfAnElasticSpringGivesNothingBack) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    auto history = ellipse(100, 3, 100.0, 70.0, 0.0);
    for (double& F : history.F) F += 0.003 * 70.0 * normal(generator);
    for (double& x : history.x) x += 0.001 * 100.0 * normal(generator);
    auto const properties = history.properties();
    EXPECT_EQ(text_of(properties.refusal), "") << seed;
  }
  EXPECT_TRUE(ellipse(100, 3, 100.0, 70.0, -0.02).properties().refusal_is_of_fault) << "more than noise";
}

// A bilinear loop of K2 = 1, Qd = 45 and D_y = 5. The equivalent bilinear loop must return these values.
TEST(Properties, TheIdealisationOfABilinearLoopIsTheLoop) {
  double const K1 = 10.0, K2 = 1.0, Qd = 45.0, D = 100.0;
  History history;
  double elastic = 0.0;
  double x = 0.0;
  history.add(0.0, 0.0);
  for (double const to : {D, -D, D, -D, D, -D, 0.0})
    while (x != to) {
      double const step = to > x ? 0.5 : -0.5;
      x += step;
      elastic = std::clamp(elastic + (K1 - K2) * step, -Qd, Qd);
      history.add(x, K2 * x + elastic);
    }
  auto const properties = history.properties();
  ASSERT_EQ(properties.counted().size(), 3u);
  for (std::size_t k : {1u, 2u}) {
    auto const& cycle = nth(properties, k);
    EXPECT_NEAR(cycle.Q_d_kN, Qd, 1e-9);
    EXPECT_NEAR(cycle.K_d_kN_per_mm, K2, 1e-12);
    EXPECT_NEAR(cycle.D_y_mm.value(), 5.0, 1e-9);
    EXPECT_NEAR(cycle.K_1_kN_per_mm.value(), K1, 1e-9);
    EXPECT_NEAR(cycle.F_y_kN().value(), 50.0, 1e-8);
    // From its peak of 145 kN the loop unloads with K1 to 45 kN at 90 mm. Its branch down crosses zero at Qd / K2.
    EXPECT_NEAR(cycle.residual_plus_mm.value(), Qd / K2, 1e-9);
    EXPECT_NEAR(cycle.residual_minus_mm.value(), -Qd / K2, 1e-9);
    EXPECT_NEAR(cycle.work_kN_mm - nth(properties, k - 1).work_kN_mm, cycle.energy_kN_mm, 1e-6);
    EXPECT_NEAR(cycle.K_plus_kN_per_mm, K2 + Qd / D, 1e-12);
    EXPECT_NEAR(cycle.K_minus_kN_per_mm, K2 + Qd / D, 1e-12);
    EXPECT_NEAR(cycle.closure_mm, 0.0, 1e-9);
  }
  // The first cycle starts from rest at zero force. This point is not on the loop and must not lower Q_d.
  EXPECT_NEAR(nth(properties, 0).Q_d_kN, Qd, 1e-9);
}

// The work must be the sum over both tests. The jump from the end of the first to the start of the second must add
// none.
TEST(Properties, WorkGoesOnOverSeveralTests) {
  auto const one = ellipse(200, 3, 100.0, 80.0, 0.3);
  auto two = one;
  for (std::size_t i = 0; i < one.x.size(); ++i) two.add(one.x[i] + 20.0, one.F[i]);
  std::vector<std::size_t> const starts{0, one.x.size()};
  auto const properties = cyclic_properties(CycleView{two.x, two.F, {}, {}, starts});
  double const energy = trapezoid_factor(200.0) * pi * 100.0 * 80.0 * std::sin(0.3);
  EXPECT_NEAR(nth(properties, 2).work_kN_mm, 3.0 * energy, 1e-6);
  EXPECT_NEAR(properties.blocks.back().cycles.back().work_kN_mm, 6.0 * energy, 1e-6);
}

TEST(Properties, AnElasticSpringHasNoIdealisation) {
  auto const cycle = *ellipse(200, 3, 100.0, 80.0, 0.0).properties().reported;
  EXPECT_NEAR(cycle.Q_d_kN, 0.0, 1e-9);
  EXPECT_FALSE(cycle.D_y_mm && cycle.K_1_kN_per_mm && *cycle.D_y_mm < 99.0);
  EXPECT_FALSE(cycle.period_s || cycle.v_max_mm_s || cycle.N_mean_kN);
}

// Returns a record of cycles at 0.5 Hz, with a time column and with a vertical load of 1000 kN that swings by 30 kN
// twice a cycle.
TestRecord timed(double (*wave)(double), int samples_per_cycle = 200, double frequency = 0.5) {
  TestRecord record;
  for (int i = 0; i <= 4 * samples_per_cycle; ++i) {
    double const cycles = static_cast<double>(i) / samples_per_cycle;
    record.time_s.push_back(3.0 + cycles / frequency);
    record.disp_mm.push_back(100.0 * wave(cycles));
    record.force_kN.push_back(70.0 * wave(cycles) + 10.0 * wave(cycles + 0.25));
    record.load_kN.push_back(1000.0 + 30.0 * std::cos(4.0 * pi * cycles));
  }
  return record;
}
double sine(double cycles) {
  return std::sin(2.0 * pi * cycles);
}
double triangle(double cycles) {
  double const part = cycles + 0.25 - std::floor(cycles + 0.25);
  return part < 0.5 ? 4.0 * part - 1.0 : 3.0 - 4.0 * part;
}
double square_root(double cycles) {
  return std::copysign(std::sqrt(std::abs(sine(cycles))), sine(cycles));
}

TEST(Properties, TimeGivesFrequencyVelocityAndWaveform) {
  auto const of_sine = cyclic_properties(timed(sine));
  auto const of_triangle = cyclic_properties(timed(triangle));
  auto const other = cyclic_properties(timed(square_root));
  ASSERT_EQ(of_sine.blocks.size(), 1u);
  EXPECT_EQ(of_sine.blocks[0].waveform, "sine");
  EXPECT_EQ(of_triangle.blocks[0].waveform, "triangle");
  EXPECT_EQ(other.blocks[0].waveform, "other");
  EXPECT_NEAR(of_sine.blocks[0].frequency_Hz.value(), 0.5, 1e-4);
  EXPECT_NEAR(of_triangle.blocks[0].frequency_Hz.value(), 0.5, 1e-4);
  // isolaw takes the velocity over a 25th of a cycle. For a sine, 1 - sinc(pi / 25) = 0.3 % of the peak is lost.
  EXPECT_NEAR(of_sine.blocks[0].v_max_mm_s.value(), 2.0 * pi * 0.5 * 100.0, 0.004 * 314.0);
  EXPECT_NEAR(of_triangle.blocks[0].v_max_mm_s.value(), 4.0 * 0.5 * 100.0, 1e-6);
  EXPECT_NEAR(of_sine.reported->period_s.value(), 2.0, 1e-9);
}

TEST(Properties, VerticalLoadThroughTheCycle) {
  auto const cycle = *cyclic_properties(timed(sine)).reported;
  EXPECT_NEAR(cycle.N_mean_kN.value(), 1000.0, 0.2);
  EXPECT_NEAR(cycle.N_max_kN.value(), 1030.0, 1e-9);
  EXPECT_NEAR(cycle.N_min_kN.value(), 970.0, 1e-9);
}

TEST(Properties, StabilityComparesWithTheThirdCycle) {
  Block block;
  for (double const K : {1.5, 1.1, 1.0, 0.9, 0.8, 0.95, 0.9, 0.9, 0.9, 0.85, 0.5}) {
    Cycle cycle;
    cycle.number = static_cast<int>(block.cycles.size()) + 1;
    cycle.K_eff_kN_per_mm = 2.0 * K;
    block.cycles.push_back(cycle);
  }
  block.cycles.emplace_back().not_counted = "partial";  // a partial cycle after the eleven others, which must not count
  auto const found = stability(block, &Cycle::K_eff_kN_per_mm);
  EXPECT_EQ(found.cycles, 11);
  ASSERT_EQ(found.ratio_to_third.size(), 11u);
  EXPECT_NEAR(found.ratio_to_third[0], 1.5, 1e-12);
  EXPECT_NEAR(found.first_to_third.value(), 1.5, 1e-12);
  EXPECT_NEAR(found.first_to_mean_1_3.value(), 1.5 / 1.2, 1e-12);
  EXPECT_NEAR(found.last_to_mean_1_3.value(), 0.5 / 1.2, 1e-12);
  EXPECT_NEAR(found.min_2_10.value(), 0.8, 1e-12);  // extremes leave out cycle 11
  EXPECT_NEAR(found.max_2_10.value(), 1.1, 1e-12);
  EXPECT_NEAR(found.max_1_10.value(), 1.5, 1e-12);
  EXPECT_NEAR(found.least_to_largest_2_10.value(), 0.8 / 1.1, 1e-12);
  EXPECT_NEAR(found.least_to_largest_1_10.value(), 0.8 / 1.5, 1e-12);
  block.cycles.resize(2);
  EXPECT_TRUE(stability(block, &Cycle::K_eff_kN_per_mm).ratio_to_third.empty());
}

TEST(Properties, StrainsOfAGeometry) {
  Cycle cycle;
  cycle.amplitude_mm = 208.0;
  cycle.K_eff_kN_per_mm = 0.6;
  auto const found = strains(cycle, 208.0, 282743.0);
  EXPECT_NEAR(found.shear_strain_percent, 100.0, 1e-12);
  EXPECT_NEAR(found.G_MPa, 0.6e3 * 208.0 / 282743.0, 1e-12);
}

TEST(Cycles, AnotherForceOnTheSameCut) {
  auto const history = ellipse(200, 3, 100.0, 80.0, 0.3);
  auto const measured = *history.properties().reported;
  auto const same = properties_on(measured, history.x, history.F);
  EXPECT_EQ(same.energy_kN_mm, measured.energy_kN_mm);
  EXPECT_EQ(same.K_eff_kN_per_mm, measured.K_eff_kN_per_mm);
  auto doubled = history.F;
  for (double& F : doubled) F *= 2.0;
  auto const twice = properties_on(measured, history.x, doubled);
  EXPECT_EQ(twice.number, 3);
  EXPECT_NEAR(twice.energy_kN_mm, 2.0 * measured.energy_kN_mm, 1e-9);
  EXPECT_NEAR(twice.damping_percent, measured.damping_percent, 1e-9);
}

}  // namespace
}  // namespace isolaw::data
