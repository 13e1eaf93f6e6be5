// kikuchi-aiken is compared with the published functions of a rubber compound and with independent scripts. Further
// tests check properties that its definition implies for any path.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "laws/candidates.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

using laws::KikuchiAiken;
using AtPeak = laws::kikuchi_aiken::AtPeak<double>;
using CompoundLoops = laws::kikuchi_aiken::Loops<double>;

// Returns the published functions of rubber compound X0.6 at the strain g and its standard pressure, with stress in
// MPa.
AtPeak compound(double g) {
  double const G =
      g < 1.15 ? 0.68358 * std::pow(g, -0.39964) : 1.10103 - 0.61946 * g + 0.22047 * g * g - 0.022191 * g * g * g;
  return {.force = G * g,
          .damping = 0.23834 - 0.028108 * g + 0.000087664 * g * g,
          .share = 0.44236 - 0.062943 * g - 0.0037571 * g * g,
          .exponent = g < 1.5 ? 1.0 : 0.91173 - 0.59184 * g + 0.43379 * g * g};
}

struct CompoundResponse {
  std::vector<double> stress;
  double a, b;
};
CompoundResponse of_compound(std::vector<double> const& strain) {
  auto const path = laws::make_path(strain, {});
  auto const constants = laws::kikuchi_aiken::constants(10.19171, 5.0);
  CompoundLoops loops;
  loops.make_room(laws::Depth{path.deepest});
  CompoundResponse response;
  for (std::size_t i = 0; i < path.steps.size(); ++i) {
    auto const& step = path.steps[i];
    bool const moved = path.memory[i].peak > 0.0;
    response.stress.push_back(moved ? loops.force(constants, step.x0, step.x1, path.memory[i], compound) : 0.0);
  }
  response.a = loops.a / num::log2_e, response.b = loops.b;
  return response;
}

double work_along(std::vector<double> const& x, std::vector<double> const& force, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) sum += 0.5 * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
  return sum;
}

// For a cycle of strain amplitude A the published functions give the stress at the peak, the stress at zero strain on
// unloading, the energy 2 pi h G A^2 with damping ratio h and shear modulus G, and the constants a and b of the
// branches. A branch contains the terms exp(-a s) and b s exp(-c s), where s is the travel since its turn divided by
// the peak. Another implementation computed the expected values to six digits.
TEST(KikuchiAiken, Compound) {
  struct Case {
    double A, peak, zero, energy, a, b, energy_tolerance;
  };
  // Only at strain 2 is b above 0. The formula for b neglects exp(-2c), and isolaw's branch, unlike the published one,
  // ends exactly at the peak. Together this lowers the energy by 5e-5 of its value.
  for (auto const& k : {Case{0.5, 0.450882, -0.184539, 0.317729, 7.116283, 0.0, 1e-6},
                        Case{1.0, 0.683580, -0.256665, 0.903336, 8.294444, 0.0, 1e-6},
                        Case{2.0, 1.132924, -0.347124, 2.597845, 10.19171, 2.448609, 1.5e-4}}) {
    constexpr int steps = 20000;
    auto const x = through({0, k.A, 0, -k.A, 0, k.A}, steps);
    auto const found = of_compound(x);
    EXPECT_NEAR(found.stress[steps], k.peak, 6e-7);
    EXPECT_NEAR(found.stress[2 * steps], k.zero, 6e-7);
    EXPECT_NEAR(found.stress.back(), k.peak, 6e-7);
    EXPECT_NEAR(found.a, k.a, 6e-7);
    EXPECT_NEAR(found.b, k.b, 6e-7);
    EXPECT_NEAR(work_along(x, found.stress, steps, x.size() - 1), k.energy, k.energy_tolerance);
  }
}

TEST(KikuchiAiken, InnerBranchesOfTheCompound) {
  std::array const stress{0.0, 0.683580, -0.683580, 0.470185, -0.340607, 0.470185, 0.683580};
  for (int const steps : {1, 7, 1000}) {
    auto const found = of_compound(through({0, 1, -1, 0.5, -0.2, 0.5, 1}, steps));
    for (std::size_t i = 0; i < stress.size(); ++i)
      EXPECT_NEAR(found.stress[i * static_cast<std::size_t>(steps)], stress[i], 6e-7) << steps << " steps a leg";
  }
}

// Tests inner branches with the term b s exp(-c s), by which a branch overshoots. The term acts if the last two turns
// were on opposite sides of x = 0, not if they were on the same side.
TEST(KikuchiAiken, InnerBranchesWithOvershoot) {
  std::array const stress{1.132924000, -1.132924000, 0.683569418, -0.474653553,
                          0.575618164, -0.284334261, 0.683569418, 1.132924000};
  auto const found = of_compound({0, 2, -2, 1, -0.4, 0.7, 0.2, 1, 2});
  // The turn at -0.4 follows a turn at 1, so the term acts; the turn at 0.2 follows one at 0.7, so it does not. An
  // independent script gave the values to 1e-9.
  for (std::size_t i = 0; i < stress.size(); ++i) EXPECT_NEAR(found.stress[i + 1], stress[i], 6e-10) << i;
}

// The expected values come from a script with its own code, which finds the rate a of the branches' exponential by
// bisection and keeps its own stack of turning points. With the second set of parameters the branches overshoot and the
// stiffness hardens.
TEST(KikuchiAiken, ItsOwnFunctions) {
  struct Case {
    Values<KikuchiAiken> values;
    std::array<double, 5> force;
  };
  constexpr std::array<std::size_t, 5> asked{2, 4, 5, 8, 9};
  for (auto const& [values, force] : {Case{{60, 0.4, 0.22, -2e-4, 0.42, -4e-4, 0.0, 30, 0, 10.19171, 5},
                                           {39.585237, -34.834059, -44.161315, 37.491505, 52.481380}},
                                      Case{{60, 0.4, 0.22, 0, 0.38, -1e-3, 0.02, 30, 0, 10.19171, 5},
                                           {39.585237, -33.392301, -44.161315, 34.899583, 52.481380}}})
    for (int const steps : {1, 7, 1000}) {
      auto const found = forces<KikuchiAiken>(values, laws::make_path(through(corners, steps), {}));
      for (std::size_t i = 0; i < asked.size(); ++i)
        EXPECT_NEAR(found[asked[i] * static_cast<std::size_t>(steps)], force[i], 6e-7) << steps << " steps a leg";
    }
}

// If the peak m exceeds the displacement xn, the peak force is (1 + s1 (m - xn)) times the force without this factor. A
// closed loop must have the damping ratio h, computed with that larger peak force.
TEST(KikuchiAiken, SecondBranchOfTheStiffness) {
  Values<KikuchiAiken> const stiffening{60, 0.4, 0.22, -2e-4, 0.42, -4e-4, 0.0, 30, 0.004, 10.19171, 5};
  constexpr int steps = 4000;
  for (double const A : {20.0, 30.0, 80.0, 200.0}) {
    auto const x = through({0, A, -A, A}, steps);
    auto const force = forces<KikuchiAiken>(stiffening, laws::make_path(x, {}));
    double const Fm = 60.0 * std::pow(A / 100.0, 0.6) * (1.0 + 0.004 * std::max(A - 30.0, 0.0));
    EXPECT_NEAR(force[steps], Fm, 1e-12 * Fm) << A;
    EXPECT_NEAR(force[2 * steps], -Fm, 1e-12 * Fm) << A;
    EXPECT_NEAR(work_along(x, force, steps, x.size() - 1), 2.0 * std::numbers::pi * (0.22 - 2e-4 * A) * Fm * A,
                1e-4 * Fm * A)
        << A;
  }
}

Values<KikuchiAiken> const rubber{60, 0.4, 0.22, -2e-4, 0.42, -4e-4, 0.02, 30, 0, 10.19171, 5};
Values<KikuchiAiken> const overshooting{60, 0.4, 0.22, 0, 0.38, -1e-3, 0.02, 30, 0, 10.19171, 5};
// With these values the rate a of the branches' exponential is only 1.36. The published branch would miss the peak that
// it leads to by 13 % of the hysteretic force; isolaw adds a term that makes it end at the peak.
Values<KikuchiAiken> const far_off{60, 0.4, 0.1, 0, 0.5, 0, 0, 30, 0, 10.19171, 5};

// A small loop of unloading and reloading that closes must not change later forces, except by rounding.
TEST(KikuchiAiken, LoopsClose) {
  for (auto const& values : {rubber, overshooting, far_off}) {
    auto const plain = forces<KikuchiAiken>(values, laws::make_path(std::vector<double>{0, 50, -60, 40, 80}, {}));
    auto const looped =
        forces<KikuchiAiken>(values, laws::make_path(std::vector<double>{0,   30,  10,  25, 12,  30, 50, 20, 35, 21, 50,
                                                                         -60, -30, -60, 20, -10, 15, -9, 20, 40, 80},
                                                     {}));
    EXPECT_NEAR(looped[10], plain[1], 1e-12);
    EXPECT_NEAR(looped[13], plain[2], 1e-12);
    EXPECT_NEAR(looped[14], looped[18], 1e-12);
    EXPECT_NEAR(looped[19], plain[3], 1e-12);
    EXPECT_NEAR(looped[20], plain[4], 1e-12);
  }
}

// The force must be continuous: as the last step d is halved, the change of the force over it tends to 0. From rest
// this change falls as d^(1-p) with the law's parameter p, elsewhere as d. Some steps end on a peak or on a turning
// point, others go past it.
TEST(KikuchiAiken, IsContinuous) {
  std::vector<std::vector<double>> const histories{{0},
                                                   {0, 50},
                                                   {0, 50, 10},
                                                   {0, 50, -50, 0},
                                                   {0, 50, -30, 50},
                                                   {0, 20, 5, 20},
                                                   {0, 50, -50},
                                                   {0, 50, -50, 30, -20, 30},
                                                   {0, 50, -50, 30, 20, 30, -50},
                                                   {0, 50, -50, 30, 20, 50}};
  for (auto const& values : {rubber, overshooting, far_off})
    for (auto const& history : histories)
      for (double const sign : {1.0, -1.0})
        for (double d = 1.0; d > 1e-12; d *= 0.5) {
          auto on = history, onto = history;
          on.push_back(on.back() + sign * d);
          // The path `onto` ends at the last point of the history with a step of length d, from the side from which the
          // history comes.
          double const from = onto.size() < 2 ? 0.0 : onto[onto.size() - 2] < onto.back() ? -1.0 : 1.0;
          if (from != 0.0) onto.insert(onto.end() - 1, onto.back() + from * std::min(d, 0.5));
          double const bound = 60.0 * std::pow(d / 100.0, 0.6) + 25.0 * d + 1e-12;
          for (auto const& x : {on, onto}) {
            auto const force = forces<KikuchiAiken>(values, laws::make_path(x, {}));
            if (force.size() < 2) continue;
            EXPECT_LE(std::abs(force.back() - force[force.size() - 2]), bound) << d << " from " << history.back();
          }
        }
}

// A closed loop between the peaks -m and m must dissipate 2 pi h Fm m, with damping ratio h and peak force Fm. The
// tolerance allows for the term that closes the branches, which is of the order of exp(-2a) here.
TEST(KikuchiAiken, DampingIsThatOfTheLoop) {
  constexpr int steps = 4000;
  for (double const A : {20.0, 100.0, 200.0}) {
    auto const x = through({0, A, -A, A}, steps);
    auto const force = forces<KikuchiAiken>(rubber, laws::make_path(x, {}));
    double const h = 0.22 - 2e-4 * A, Fm = 60.0 * std::pow(A / 100.0, 0.6);
    EXPECT_NEAR(force[steps], Fm, 1e-12 * Fm);
    EXPECT_NEAR(work_along(x, force, steps, x.size() - 1), 2.0 * std::numbers::pi * h * Fm * A, 1e-4 * Fm * A) << A;
  }
}

// Up to 416 mm, twice the amplitude for which the search box is made, the first two cycles from x = 0 dissipate. At
// 1040 mm the damping ratio h may have fallen to 0, and on the first loading the force grows faster than the
// displacement, so less energy goes in than comes back. There only the second cycle must dissipate, through the terms
// that close the branches.
TEST(KikuchiAiken, CyclesDissipate) {
  for (double const amplitude : {2.0, 50.0, 208.0, 416.0, 1040.0})
    for (std::uint32_t i = 0; i < 500; ++i) {
      auto const values = scaled_candidate<KikuchiAiken>(i);
      auto const x = through({0.0, amplitude, 0.0, -amplitude, 0.0, amplitude, 0.0, -amplitude, 0.0}, 200);
      auto const force = forces<KikuchiAiken>(values, laws::make_path(x, {}));
      if (amplitude < 1000.0) {
        EXPECT_GT(work_along(x, force, 0, 800), 0.0) << amplitude << " mm, " << i;
      }
      EXPECT_GT(work_along(x, force, 800, 1600), 0.0) << amplitude << " mm, " << i << describe<KikuchiAiken>(values);
    }
}

// Full cycles at 10 to 100 % of the tested amplitude must not exceed the force Fm at their peaks. Parameters are drawn
// anywhere in the search box and, in every other draw, in its corners. Let U be the hysteretic share of Fm. Since b is
// at most e (1/U - 1) min(c, 5), the term with b adds at most (1 - U) Fm. While the elastic force is below zero, the
// whole force is therefore at most Fm. Where it is above zero, the term that closes the branches makes up for the rest
// of the term with b if c is at least 2.
TEST(KikuchiAiken, CyclesDoNotExceedTheForceAtTheirPeaks) {
  constexpr int per_cycle = 400;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    num::Draws draws(num::Stream(4), 0, i);
    auto const intervals = box<KikuchiAiken>();
    Values<KikuchiAiken> values{};
    for (std::size_t k = 0; k < values.size(); ++k) {
      double const share = draws.uniform();
      values[k] =
          intervals[k].lower + (i % 2 == 0 ? share : std::round(share)) * (intervals[k].upper - intervals[k].lower);
    }
    for (double const tested : {0.10, 0.25, 0.50, 0.75, 1.0}) {
      double const amplitude = tested * 208.0;
      auto const x = sine(amplitude, 0.5, 2, per_cycle).disp_mm;
      auto const force = forces<KikuchiAiken>(values, laws::make_path(x, {}));
      double const peak = force[5 * per_cycle / 4];
      double largest = 0.0, jump = 0.0;
      for (std::size_t k = per_cycle; k < x.size(); ++k) {
        largest = std::max(largest, std::abs(force[k]));
        if (std::abs(x[k]) < 0.8 * amplitude) jump = std::max(jump, std::abs(force[k] - force[k - 1]));
      }
      ASSERT_LE(largest, 1.01 * peak) << amplitude << " mm: " << describe<KikuchiAiken>(values);
      ASSERT_LE(jump, 0.1 * peak) << amplitude << " mm: " << describe<KikuchiAiken>(values);
      ASSERT_GE(work_along(x, force, per_cycle, 2 * per_cycle), 0.0) << describe<KikuchiAiken>(values);
    }
  }
}

// A closed loop between two inner turning points dissipates, wherever it starts.
TEST(KikuchiAiken, InnerLoopsDissipate) {
  for (double const length : {1.0, 20.0, 100.0, 300.0})
    for (double const at : {-150.0, -20.0, 100.0, 200.0})
      for (std::uint32_t i = 0; i < 200; ++i) {
        double const to = std::max(at - length, -207.0);
        auto const x = through({-208.0, 208.0, -208.0, at, to, at, to, at}, 200);
        auto const force = forces<KikuchiAiken>(scaled_candidate<KikuchiAiken>(i), laws::make_path(x, {}));
        EXPECT_GT(work_along(x, force, 600, 1000), 0.0) << length << " mm at " << at << ", " << i;
        EXPECT_NEAR(work_along(x, force, 600, 1000), work_along(x, force, 1000, 1400), 1e-9)
            << length << " mm at " << at;
      }
}

}  // namespace
}  // namespace isolaw::law_tests
