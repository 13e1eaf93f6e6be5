// history-integral is compared with the closed form of its memory terms q. Along a straight path of length L a term
// changes from q0 to d + (q0 - d) exp(-L/D), where d is the direction, +1 or -1, and D the length of the memory.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "laws/candidates.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

using laws::HistoryIntegral;

// Returns a law with two terms of strength S and length D, (S, D) = (0.1 kN, 20 mm) and (0.05 kN, 80 mm), and an
// elastic force of 0.4 kN at 100 mm.
Values<HistoryIntegral> two_terms(double g) {
  return named<HistoryIntegral>({{"K", 0.4}, {"g", g}, {"S", 0.15}, {"D", 80.0}, {"s", 2.0 / 3.0}, {"u", 0.25}});
}

// For either exponent g, the first expected force was published as that of the first, straight leg of a path in two
// directions. A script that evaluates the terms from corner to corner gave the other four forces. All have nine
// decimals. A leg that is cut into a thousand steps must give the same force as a single step.
TEST(HistoryIntegral, TwoTerms) {
  struct Case {
    double g;
    std::array<double, 5> force;
  };
  for (auto const& [g, force] : {Case{1.0, {0.535000965, -0.542958338, 0.335632378, -0.087697165, 0.741601175}},
                                 Case{0.6, {0.535000965, -0.542958338, 0.335632378, -0.087697165, 0.651770975}}})
    for (int const steps : {1, 7, 1000}) {
      auto const found =
          forces<HistoryIntegral>(two_terms(g), laws::make_path(through({0, 100, -100, 50, 0, 150}, steps), {}));
      for (std::size_t i = 0; i < force.size(); ++i)
        EXPECT_NEAR(found[(i + 1) * static_cast<std::size_t>(steps)], force[i], 6e-10) << steps << " steps a leg";
    }
}

// In a stationary cycle of amplitude A, a term (S, D) has q = tanh(A/D) at the peak and dissipates 4 S (A - D
// tanh(A/D)).
TEST(HistoryIntegral, StationaryCycle) {
  constexpr int steps = 20000;
  auto const x = through({0, 100, -100, 100, -100, 100, -100, 100, -100, 100, -100, 100}, steps);
  auto const force = forces<HistoryIntegral>(two_terms(1.0), laws::make_path(x, {}));
  double energy = 0.0;
  for (std::size_t i = 9 * steps; i + 1 < x.size(); ++i) energy += 0.5 * (force[i] + force[i + 1]) * (x[i + 1] - x[i]);
  auto const of_term = [](double S, double D) { return 4.0 * S * (100.0 - D * std::tanh(100.0 / D)); };
  // The tolerance covers the rest of the start-up, which has decayed over nine half cycles, and the error of the
  // trapezoidal rule with 20,000 steps per leg.
  EXPECT_NEAR(energy, of_term(0.1, 20.0) + of_term(0.05, 80.0), 1e-5);
  EXPECT_NEAR(force.back(), 0.4 + 0.1 * std::tanh(5.0) + 0.05 * std::tanh(1.25), 1e-7);
}

// The force must be continuous: as the last step is halved, the change of the force over it tends to 0. On the first
// motion away from 0 this change falls as d^g, where d is the length of the step and g the exponent of the elastic
// force.
TEST(HistoryIntegral, IsContinuous) {
  std::vector<std::vector<double>> const histories{{0}, {0, 50}, {0, 50, 10}, {0, 50, -50, 0}, {0, 50, -30, 50}};
  for (auto const& history : histories)
    for (double const sign : {1.0, -1.0})
      for (double d = 1.0; d > 1e-12; d *= 0.5) {
        auto x = history;
        x.push_back(x.back() + sign * d);
        auto const force = forces<HistoryIntegral>(two_terms(0.6), laws::make_path(x, {}));
        double const bound = 0.4 * std::pow(d / 100.0, 0.6) + 2.0 * (0.1 / 20.0 + 0.05 / 80.0) * d;
        EXPECT_LE(std::abs(force.back() - force[force.size() - 2]), bound) << d << " from " << history.back();
      }
}

// A cycle that starts and ends at x = 0 dissipates for all parameters in the box. The elastic force returns less energy
// than it took, because its secant stiffness falls as the peak grows (g is at most 1). The memory terms never return
// more than they took.
TEST(HistoryIntegral, CyclesDissipate) {
  for (double const amplitude : {2.0, 50.0, 208.0, 1000.0})
    for (std::uint32_t i = 0; i < 200; ++i) {
      auto const x = through({0.0, amplitude, 0.0, -amplitude, 0.0, amplitude, 0.0, -amplitude, 0.0}, 100);
      auto const force = forces<HistoryIntegral>(scaled_candidate<HistoryIntegral>(i), laws::make_path(x, {}));
      for (std::size_t const from : {std::size_t{0}, std::size_t{400}}) {
        double energy = 0.0;
        for (std::size_t k = from; k < from + 400; ++k) energy += 0.5 * (force[k] + force[k + 1]) * (x[k + 1] - x[k]);
        EXPECT_GT(energy, 0.0) << amplitude << " mm, " << i;
      }
    }
}

// With one term and no softening the law equals vaiana with straight limit curves. vaiana's parameters are in N and m.
TEST(HistoryIntegral, OneMemoryIsVaiana) {
  auto const here = named<HistoryIntegral>({{"K", 40.0}, {"g", 1.0}, {"S", 30.0}, {"D", 25.0}, {"s", 0.0}, {"u", 0.1}});
  auto const there =
      named<laws::Vaiana>({{"Kb+", 4e5}, {"Kb-", 4e5}, {"f0+", 3e4}, {"f0-", 3e4}, {"alpha+", 40.0}, {"alpha-", 40.0}});
  auto const motion = irregular(3, 150.0, 4, 60, 0.01);
  std::vector<double> from_rest{0.0}, velocity(motion.size() + 1, 0.0);
  from_rest.insert(from_rest.end(), motion.disp_mm.begin(), motion.disp_mm.end());
  auto expected = forces<laws::Vaiana>(there, Motion{from_rest, velocity});
  for (double& f : expected) f *= 1e-3;
  auto const found = forces<HistoryIntegral>(here, Motion{from_rest, velocity});
  EXPECT_LT(largest_difference(found, expected), 1e-12 * largest_magnitude(expected));
}

}  // namespace
}  // namespace isolaw::law_tests
