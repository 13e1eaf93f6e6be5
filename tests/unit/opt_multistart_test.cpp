// Tests descents from many starts on sums of absolute residuals whose minimum is known. Some minima lie at an edge of
// the box or beyond misleading valleys. Further tests cover counts of evaluations, repetition, failure and
// interruption.
#include "isolaw/opt/multistart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "not_finite.hpp"

namespace isolaw::opt {
namespace {

using Point = std::span<double const>;

// A problem with `count` residuals r(x, j), which are equally weighted unless weights are given.
class Residuals : public DeviationProblem {
 public:
  Residuals(std::size_t dimension, std::size_t count, std::function<double(Point, std::size_t)> residual)
      : dimension_(dimension), weights_(count, 1.0 / static_cast<double>(count)), residual_(std::move(residual)) {}
  std::size_t dimension() const override { return dimension_; }
  std::span<double const> weights() const override { return weights_; }
  void evaluate(Points const& points, std::span<double> values) const override {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = value(points[i]);
  }
  void residuals(Points const& points, std::span<double> values) const override {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < weights_.size(); ++j) values[i * weights_.size() + j] = residual_(points[i], j);
    seen += points.size();
  }
  double value(Point x) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < weights_.size(); ++j) sum += weights_[j] * std::abs(residual_(x, j));
    return sum;
  }

  mutable std::size_t seen = 0;

 private:
  std::size_t dimension_;
  std::vector<double> weights_;
  std::function<double(Point, std::size_t)> residual_;
};

num::Stream const stream(17);

// The sum of distances to these numbers is least at their median, 0.3. At their mean, 0.5, the sum of squares would be
// least.
TEST(Multistart, FindsTheMedianNotTheMean) {
  std::vector<double> const numbers{0.1, 0.2, 0.3, 0.9, 1.0};
  Residuals const problem(1, 5, [&](Point x, std::size_t j) { return x[0] - numbers[j]; });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_EQ(found.outcome, Outcome::confirmed);
  EXPECT_NEAR(found.best.at(0), 0.3, 1e-3);
  EXPECT_NEAR(found.best_value, (0.2 + 0.1 + 0.0 + 0.6 + 0.7) / 5.0, 1e-4);
}

// A third of the points lies far off a line. The other points must determine the line.
TEST(Multistart, IsNotDrawnByOutliers) {
  Residuals const problem(2, 30, [](Point x, std::size_t j) {
    double const t = static_cast<double>(j) / 29.0, y = 0.2 + 0.5 * t + (j % 3 == 1 ? 4.0 : 0.0);
    return x[0] + x[1] * t - y;
  });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_NEAR(found.best.at(0), 0.2, 1e-2);
  EXPECT_NEAR(found.best.at(1), 0.5, 1e-2);
}

TEST(Multistart, StaysInTheBoxAndFindsTheBestOfAnEdge) {
  // Without the box the minimum is at (1.4, 0.75). The box limits x0 to 1, and the second residual couples x1 to x0, so
  // the minimum is at (1, 0.55).
  Residuals const problem(
      2, 2, [](Point x, std::size_t j) { return j == 0 ? x[0] - 1.4 : 4.0 * (x[1] - 0.05 - 0.5 * x[0]); });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_EQ(found.best.at(0), 1.0);
  EXPECT_NEAR(found.best.at(1), 0.55, 1e-3);
  EXPECT_NEAR(found.best_value, 0.2, 1e-3);
}

// Rosenbrock's curved valley as two residuals.
TEST(Multistart, FollowsACurvedValley) {
  Residuals const problem(2, 2, [](Point x, std::size_t j) {
    double const u = 4.0 * x[0] - 2.0, v = 4.0 * x[1] - 1.0;
    return j == 0 ? 1.0 - u : 10.0 * (v - u * u);
  });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_LT(found.best_value, 1e-4);
  EXPECT_NEAR(found.best.at(0), 0.75, 1e-3);
}

// Most starts fall into a broad valley, but the least value is in a narrow one. The search must end in the narrow one
// with each of 20 seeds.
TEST(Multistart, LeavesABroadValleyForADeeperNarrowOne) {
  Residuals const problem(1, 1, [](Point x, std::size_t) {
    return 1.0 + 2.0 * std::abs(x[0] - 0.3) - 1.3 * std::exp(-std::pow((x[0] - 0.85) / 0.05, 2));
  });
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto const found = minimise_multistart(problem, num::Stream(seed));
    EXPECT_NEAR(found.best.at(0), 0.85, 0.02) << "seed " << seed;
  }
}

TEST(Multistart, RepeatsItselfAndCountsWhatItDoes) {
  auto const residual = [](Point x, std::size_t j) {
    return std::sin(7.0 * x[0] + static_cast<double>(j)) + x[1] * std::cos(static_cast<double>(j)) - 0.3;
  };
  Residuals const problem(2, 25, residual);
  auto const first = minimise_multistart(problem, stream);
  EXPECT_EQ(problem.seen, static_cast<std::size_t>(first.evaluations));
  auto const again = minimise_multistart(Residuals(2, 25, residual), stream);
  EXPECT_EQ(first.best, again.best);
  EXPECT_EQ(first.history, again.history);
  EXPECT_EQ(first.evaluations, again.evaluations);
  EXPECT_NE(minimise_multistart(problem, num::Stream(18)).history, first.history);

  EXPECT_TRUE(std::ranges::is_sorted(first.history, std::greater{}));
  EXPECT_EQ(first.history.back(), first.best_value);
  EXPECT_NEAR(first.best_value, problem.value(first.best), 1e-14);
  EXPECT_EQ(first.history.size(), static_cast<std::size_t>(first.starts) + 1);
  EXPECT_GE(first.starts, 16);
  EXPECT_GE(first.hits, 3);
  EXPECT_EQ(first.failed_evaluations, 0);
}

// A problem with an outline: a coarser problem for the first steps, with a quarter of the residuals.
class Outlined final : public Residuals {
 public:
  Outlined(std::function<double(Point, std::size_t)> const& residual,
           std::function<double(Point, std::size_t)> const& fewer)
      : Residuals(2, 40, residual), fewer_(2, 10, fewer) {}
  DeviationProblem const* outline() const override { return &fewer_; }
  Residuals const& fewer() const { return fewer_; }

 private:
  Residuals fewer_;
};

double line(Point x, double t) {
  return x[0] + x[1] * t - (0.2 + 0.5 * t) + (t < 0.1 ? 0.3 : 0.0);
}

TEST(Multistart, ApproachesByTheOutlineAndCountsItsShare) {
  Outlined const problem([](Point x, std::size_t j) { return line(x, static_cast<double>(j) / 39.0); },
                         [](Point x, std::size_t j) { return line(x, static_cast<double>(j) / 9.0); });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_EQ(found.outcome, Outcome::confirmed);
  EXPECT_NEAR(found.best.at(0), 0.2, 1e-2);
  EXPECT_NEAR(found.best.at(1), 0.5, 1e-2);
  EXPECT_NEAR(found.best_value, problem.value(found.best), 1e-14);
  EXPECT_GT(problem.fewer().seen, problem.seen / 4);
  EXPECT_EQ(found.evaluations, static_cast<int>((4 * problem.seen + problem.fewer().seen + 3) / 4));
}

// The result must not depend on the outline. One outline has its minimum elsewhere; the other is never finite.
TEST(Multistart, IsNotMisledByABadOutline) {
  auto const whole = [](Point x, std::size_t j) { return line(x, static_cast<double>(j) / 39.0); };
  Outlined const elsewhere(whole, [](Point x, std::size_t) { return x[0] - x[1] + 0.9; });
  Outlined const nowhere(whole, [](Point, std::size_t) { return nan; });
  for (auto const* problem : {&elsewhere, &nowhere}) {
    auto const found = minimise_multistart(*problem, stream);
    EXPECT_EQ(found.outcome, Outcome::confirmed);
    EXPECT_NEAR(found.best.at(0), 0.2, 1e-2);
    EXPECT_NEAR(found.best.at(1), 0.5, 1e-2);
    EXPECT_NEAR(found.best_value, problem->value(found.best), 1e-14);
    EXPECT_LE(found.failed_evaluations, found.evaluations);
  }
}

// Half of the box has no finite value. The search must stay in the other half and count the points without a value.
TEST(Multistart, PassesOverPointsWithoutAValue) {
  Residuals const problem(2, 4, [](Point x, std::size_t j) {
    return x[0] < 0.5 ? nan : x[0] - 0.5 + std::abs(x[1] - 0.25 * static_cast<double>(j));
  });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_EQ(found.outcome, Outcome::confirmed);
  EXPECT_NEAR(found.best.at(0), 0.5, 2e-3);
  EXPECT_GT(found.failed_evaluations, 0);
  EXPECT_LT(found.failed_evaluations, found.evaluations);
}

TEST(Multistart, WithoutAnyValueSaysSo) {
  Residuals const problem(3, 4, [](Point, std::size_t) { return nan; });
  auto const found = minimise_multistart(problem, stream);
  EXPECT_EQ(found.outcome, Outcome::no_finite_value);
  EXPECT_FALSE(found.usable());
  EXPECT_EQ(found.failed_evaluations, found.evaluations);
}

// On a flat problem and at an exact fit there is no scale for a relative tolerance, but the search must end.
TEST(Multistart, EndsOnAFlatProblemAndOnAnExactFit) {
  auto const flat = minimise_multistart(Residuals(3, 2, [](Point, std::size_t) { return 1.0; }), stream);
  EXPECT_EQ(flat.outcome, Outcome::confirmed);
  EXPECT_EQ(flat.best_value, 1.0);
  auto const exact = minimise_multistart(
      Residuals(2, 9, [](Point x, std::size_t j) { return (x[0] - 0.4) + static_cast<double>(j) * (x[1] - 0.6); }),
      stream);
  EXPECT_EQ(exact.outcome, Outcome::confirmed);
  EXPECT_LT(exact.best_value, 1e-6);
}

TEST(Multistart, StopsWhenItIsAsked) {
  Residuals const problem(2, 3, [](Point x, std::size_t j) { return x[j % 2] - 0.2 * static_cast<double>(j); });
  int asked = 0;
  auto const found = minimise_multistart(problem, stream, {}, [&] { return ++asked > 4; });
  EXPECT_EQ(found.outcome, Outcome::interrupted);
  EXPECT_EQ(found.starts, 4);
  EXPECT_TRUE(found.usable());
}

TEST(Multistart, SpendsItsBudgetWhereTheBestIsNotConfirmed) {
  // The box holds as many valleys as starts, all of different depth.
  Residuals const problem(1, 1, [](Point x, std::size_t) { return 2.0 + std::sin(900.0 * x[0]) + x[0]; });
  auto const found = minimise_multistart(problem, stream, {.hits = 16, .most_evaluations = 3000});
  EXPECT_EQ(found.outcome, Outcome::budget_spent);
  EXPECT_GE(found.evaluations, 3000);
  EXPECT_LT(found.evaluations, 20'000);
}

TEST(Multistart, AProblemWithoutDimensionsIsRefused) {
  EXPECT_THROW(minimise_multistart(Residuals(0, 1, [](Point, std::size_t) { return 1.0; }), stream), Error);
}

// descend() makes a single descent, for example from a former optimum after the problem has changed a little.
TEST(Descend, GoesToTheNearMinimumAndNeverAboveItsStart) {
  std::vector<double> const numbers{0.1, 0.2, 0.3, 0.9, 1.0};
  Residuals const problem(1, 5, [&](Point x, std::size_t j) { return x[0] - numbers[j]; });
  for (double const from : {0.0, 0.25, 0.3, 0.35, 1.0}) {
    std::vector<double> const start{from};
    auto const found = descend(problem, start, 0.1);
    EXPECT_NEAR(found.best.at(0), 0.3, 2e-3) << from;
    EXPECT_LE(found.best_value, problem.value(start) + 1e-14) << from;
    EXPECT_NEAR(found.best_value, problem.value(found.best), 1e-14) << from;
  }
}

TEST(Descend, SaysThatItsStartHasNoValue) {
  Residuals const problem(1, 2, [](Point, std::size_t) { return nan; });
  auto const found = descend(problem, std::vector<double>{0.5});
  EXPECT_FALSE(found.usable());
  EXPECT_EQ(found.evaluations, 1);
  EXPECT_EQ(found.failed_evaluations, 1);
  EXPECT_THROW(descend(Residuals(0, 1, [](Point, std::size_t) { return 0.0; }), std::vector<double>{}), Error);
}

}  // namespace
}  // namespace isolaw::opt
