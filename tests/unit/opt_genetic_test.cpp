// Tests the whole genetic algorithm: how many points it evaluates, that it repeats itself, what it does where values
// are not finite, when it stops, and how close it comes to known optima.
#include "isolaw/opt/genetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "not_finite.hpp"
#include "refusal.hpp"

namespace isolaw::opt {
namespace {

using Point = std::span<double const>;

// A search problem made from a function of one point. It keeps all batches of points that were evaluated.
class FunctionProblem : public Problem {
 public:
  FunctionProblem(std::size_t dimension, std::function<double(Point)> function)
      : dimension_(dimension), function_(std::move(function)) {}
  std::size_t dimension() const override { return dimension_; }
  void evaluate(Points const& points, std::span<double> values) const override {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = function_(points[i]);
    batches.push_back(points);
  }

  mutable std::vector<Points> batches;

 private:
  std::size_t dimension_;
  std::function<double(Point)> function_;
};

double sphere(Point x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const d = x[i] - (0.3 + 0.07 * static_cast<double>(i));
    sum += d * d;
  }
  return sum;
}

// Rosenbrock's function on [-2, 2] x [-1, 3]; the minimum is 0 at (1, 1).
double rosenbrock(Point x) {
  double const u = 4.0 * x[0] - 2.0, v = 4.0 * x[1] - 1.0;
  return 100.0 * (v - u * u) * (v - u * u) + (1.0 - u) * (1.0 - u);
}

// Rastrigin's function on [-5.12, 5.12] per gene, shifted by 1. Neighbouring local minima differ by about 1 in value.
double rastrigin(Point x) {
  double sum = 0.0;
  for (double const gene : x) {
    double const u = 10.24 * gene - 6.12;
    sum += 10.0 + u * u - 10.0 * std::cos(2.0 * std::numbers::pi * u);
  }
  return sum;
}

// Returns the objective of a small identification problem: the mean absolute deviation between two curves, each the sum
// of a line and a decay.
double curve_fit(Point x) {
  constexpr int samples = 100;
  double sum = 0.0;
  for (int k = 0; k < samples; ++k) {
    double const t = k / (samples - 1.0);
    double const measured = 0.3 + 0.4 * t + 0.35 * std::exp(-2.0 * t);
    sum += std::abs(x[0] + 0.8 * x[1] * t + x[2] * std::exp(-5.0 * x[3] * t) - measured);
  }
  return sum / samples;
}

FunctionProblem flat(double value, std::size_t dimension = 2) {
  return {dimension, [value](Point) { return value; }};
}

// --- options of the algorithm ---

TEST(GeneticOptions, DefaultsAreThePapers) {
  GeneticOptions const options;
  EXPECT_EQ(options.population * options.generations, 5000);
}

TEST(GeneticOptions, TheSmallestAllowedRun) {
  GeneticOptions const options{.population = 4, .generations = 1};
  auto const result = minimise_genetic(FunctionProblem(3, sphere), num::Stream(1), options);
  EXPECT_EQ(result.outcome, Outcome::all_generations);
  EXPECT_EQ(result.evaluations, 4);
}

TEST(Genetic, RefusesAProblemWithoutParameters) {
  EXPECT_NE(refusal_of([] { minimise_genetic(flat(1.0, 0), num::Stream(1)); }).find("no free parameter"),
            std::string::npos);
}

// --- which points are evaluated ---

TEST(Genetic, EvaluatesOnePopulationPerGenerationInsideTheBox) {
  FunctionProblem const problem(4, sphere);
  GeneticOptions const options{.population = 40, .generations = 30, .mutation_rate = 0.2, .stagnation = 30};
  auto const result = minimise_genetic(problem, num::Stream(1), options);
  EXPECT_EQ(result.outcome, Outcome::all_generations);
  EXPECT_EQ(result.evaluations, 40 * 30);
  EXPECT_EQ(result.history.size(), 30u);
  ASSERT_EQ(problem.batches.size(), 30u);
  for (auto const& batch : problem.batches) {
    EXPECT_EQ(batch.size(), 40u);
    EXPECT_TRUE(std::ranges::all_of(batch.values, [](double gene) { return gene >= 0.0 && gene < 1.0; }));
  }
}

TEST(Genetic, ReportsTheBestPointEverEvaluatedAndTheBestOfEachGeneration) {
  FunctionProblem const problem(3, rastrigin);
  auto const result = minimise_genetic(problem, num::Stream(2));
  double best = infinity;
  for (std::size_t g = 0; g < problem.batches.size(); ++g) {
    for (std::size_t i = 0; i < problem.batches[g].size(); ++i) best = std::min(best, rastrigin(problem.batches[g][i]));
    EXPECT_EQ(result.history[g], best);
  }
  ASSERT_TRUE(result.usable());
  EXPECT_EQ(result.best_value, best);
  EXPECT_EQ(rastrigin(result.best), best);
}

// Without mutation, every gene of a child must occur in the initial population at the same position.
TEST(Genetic, ChildrenAreMadeOfTheirParentsGenes) {
  FunctionProblem const problem(3, sphere);
  minimise_genetic(problem, num::Stream(3), {.population = 10, .generations = 8, .mutation_rate = 0.0});
  auto const& initial = problem.batches.front();
  for (auto const& batch : problem.batches)
    for (std::size_t i = 0; i < batch.size(); ++i)
      for (std::size_t gene = 0; gene < 3; ++gene) {
        bool found = false;
        for (std::size_t k = 0; k < initial.size(); ++k) found |= initial[k][gene] == batch[i][gene];
        EXPECT_TRUE(found);
      }
}

TEST(Genetic, OneParameterIsSearchedByMutation) {
  auto const result = minimise_genetic(FunctionProblem(1, sphere), num::Stream(1), {.mutation_rate = 0.2});
  EXPECT_LT(result.best_value, 1e-5);  // one gene in five mutates, so 5,000 evaluations are about 1,000 uniform samples
}

// --- repeated searches ---

TEST(Genetic, TheSameStreamGivesTheSameResultAndAnotherAnother) {
  FunctionProblem const problem(4, curve_fit);
  auto const first = minimise_genetic(problem, num::Stream(1)), again = minimise_genetic(problem, num::Stream(1)),
             other = minimise_genetic(problem, num::Stream(2));
  EXPECT_EQ(first.best, again.best);
  EXPECT_EQ(first.history, again.history);
  EXPECT_NE(first.best, other.best);
  EXPECT_NE(first.history, other.history);
}

// --- problems without a finite value ---

TEST(Genetic, FailedRegionsAreAvoidedUpToTheirEdge) {
  for (double const failure : {nan, infinity, -infinity}) {
    // The least value is at x0 = 0.5, the edge of the region where the function fails.
    FunctionProblem const problem(2, [failure](Point x) { return x[0] < 0.5 ? failure : x[0] + sphere(x); });
    auto const result = minimise_genetic(problem, num::Stream(1), {.mutation_rate = 0.05});
    ASSERT_TRUE(result.usable());
    EXPECT_GE(result.best[0], 0.5);
    EXPECT_NEAR(result.best[0], 0.5, 0.02);
    EXPECT_TRUE(std::ranges::all_of(result.history, [](double value) { return std::isfinite(value); }));
  }
}

TEST(Genetic, OneFiniteValueInTheInitialPopulationIsEnough) {
  int calls = 0;
  FunctionProblem const problem(2, [&calls](Point x) { return calls++ == 17 ? 1.0 : (calls > 100 ? sphere(x) : nan); });
  auto const result = minimise_genetic(problem, num::Stream(1), {.mutation_rate = 0.1});
  EXPECT_TRUE(result.usable());
  EXPECT_EQ(result.history.front(), 1.0);
  EXPECT_LT(result.best_value, 1.0);
}

TEST(Genetic, NothingFiniteIsAnOutcomeOfItsOwn) {
  for (double const failure : {nan, infinity, -infinity}) {
    auto const result = minimise_genetic(flat(failure), num::Stream(1));
    EXPECT_EQ(result.outcome, Outcome::no_finite_value);
    EXPECT_FALSE(result.usable());
    EXPECT_EQ(result.best_value, infinity);  // a failed search must not return a number that looks like a perfect fit
    EXPECT_EQ(result.evaluations, 100);
  }
}

// --- when a search stops ---

TEST(Genetic, AFlatProblemStopsAfterTheFirstGenerationAndTheStagnation) {
  for (double const value : {0.0, 1.0, -1.0}) {
    auto const result = minimise_genetic(flat(value), num::Stream(1));
    EXPECT_EQ(result.outcome, Outcome::stagnated);
    EXPECT_EQ(result.history, std::vector<double>(21, value));
    EXPECT_EQ(result.evaluations, 2100);
  }
}

TEST(Genetic, StagnationInTheLastGenerationIsNoEarlyStop) {
  EXPECT_EQ(minimise_genetic(flat(1.0), num::Stream(1), {.generations = 21}).outcome, Outcome::all_generations);
  EXPECT_EQ(minimise_genetic(flat(1.0), num::Stream(1), {.generations = 22}).outcome, Outcome::stagnated);
}

// Returns an objective that falls by 1 % of its first value in each generation, whatever the points are.
FunctionProblem steadily_falling(int& calls) {
  return {2, [&calls](Point) { return 1.0 - 0.01 * (calls++ / 10); }};
}

TEST(Genetic, AnImprovementBelowTheToleranceIsNoneUntilItHasAddedUp) {
  GeneticOptions options{.population = 10, .generations = 40, .stagnation = 3};
  auto const generations = [&options](double tolerance) {
    int calls = 0;
    options.stagnation_tolerance = tolerance;
    return minimise_genetic(steadily_falling(calls), num::Stream(1), options).history.size();
  };
  EXPECT_EQ(generations(0.0), 40u);
  EXPECT_EQ(generations(0.025), 40u);  // a fall of 1 % a generation exceeds 2.5 % within three generations
  EXPECT_EQ(generations(0.035), 4u);   // three generations do not reach 3.5 %
}

TEST(Genetic, AnInterruptionKeepsWhatWasFound) {
  FunctionProblem const problem(4, sphere);
  auto const whole = minimise_genetic(problem, num::Stream(1));
  int asked = 0;
  auto const part = minimise_genetic(problem, num::Stream(1), {}, [&] { return ++asked > 7; });
  EXPECT_EQ(part.outcome, Outcome::interrupted);
  EXPECT_EQ(asked, 8);
  EXPECT_EQ(part.evaluations, 700);
  EXPECT_EQ(part.history, std::vector<double>(whole.history.begin(), whole.history.begin() + 7));
  EXPECT_EQ(sphere(part.best), part.best_value);
  EXPECT_EQ(part.best_value, part.history.back());
}

TEST(Genetic, AnInterruptionBeforeTheFirstGenerationFindsNothing) {
  auto const result = minimise_genetic(FunctionProblem(4, sphere), num::Stream(1), {}, [] { return true; });
  EXPECT_EQ(result.outcome, Outcome::interrupted);
  EXPECT_FALSE(result.usable());
  EXPECT_EQ(result.evaluations, 0);
}

// --- problems with known optima ---

// For each tolerance, searches were made with 60 random streams, and nine of ten ended within a certain excess over the
// minimum. The tolerance is two to three times this excess. At the paper's mutation rate of 1 % a search hardly ever
// finds a better value of a gene than the best of its 100 initial values, so sphere() in six dimensions ends near 1e-3.
// Curved valleys and functions with many local minima need the wide search.
struct KnownOptimum {
  char const* name;
  std::size_t dimension;
  double (*function)(Point);
  // The wide search mutates 10 % of the genes and evaluates at most 20,000 points; the paper's search mutates 1 % and
  // evaluates at most 5,000.
  bool wide;
  double tolerance;  // allowed excess over the minimum, which is 0
};

void PrintTo(KnownOptimum const& problem, std::ostream* out) {
  *out << problem.name;
}

class KnownOptima : public testing::TestWithParam<KnownOptimum> {};

GeneticOptions options_for(KnownOptimum const& problem) {
  if (!problem.wide) return {};
  return {.population = 200, .generations = 100, .mutation_rate = 0.1, .stagnation = 100};
}

TEST_P(KnownOptima, AreReachedForAtLeast18Of20Streams) {
  auto const& known = GetParam();
  FunctionProblem const problem(known.dimension, known.function);
  int reached = 0;
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    auto const result = minimise_genetic(problem, num::Stream(seed), options_for(known));
    EXPECT_TRUE(std::ranges::is_sorted(result.history, std::greater{}));
    EXPECT_LE(result.evaluations, known.wide ? 20'000 : 5'000);
    values.push_back(result.best_value);
    reached += result.best_value <= known.tolerance;
  }
  EXPECT_GE(reached, 18) << testing::PrintToString(values);
}

INSTANTIATE_TEST_SUITE_P(Genetic, KnownOptima,
                         testing::Values(KnownOptimum{"sphere_2", 2, sphere, false, 1e-3},
                                         KnownOptimum{"sphere_4", 4, sphere, false, 3e-3},
                                         KnownOptimum{"sphere_6", 6, sphere, false, 5e-3},
                                         KnownOptimum{"curve", 4, curve_fit, false, 0.02},
                                         KnownOptimum{"sphere_6_wide", 6, sphere, true, 2e-5},
                                         KnownOptimum{"curve_wide", 4, curve_fit, true, 0.008},
                                         KnownOptimum{"rosenbrock_wide", 2, rosenbrock, true, 0.1},
                                         KnownOptimum{"rastrigin_2_wide", 2, rastrigin, true, 0.03},
                                         KnownOptimum{"rastrigin_4_wide", 4, rastrigin, true, 0.1}),
                         [](auto const& instance) { return std::string(instance.param.name); });

// A search that selects and recombines must beat equally many uniform samples in six dimensions. In two dimensions it
// does not: 5,000 uniform samples of the Rosenbrock function come nearer to the minimum than the paper's settings do.
TEST(Genetic, BeatsUniformSamplingInSixDimensions) {
  constexpr std::size_t dimension = 6;
  for (auto const function : {sphere, rastrigin}) {
    int better = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      auto const result = minimise_genetic(FunctionProblem(dimension, function), num::Stream(seed));
      num::Draws draws(num::Stream(seed).split(1), 0, 0);
      double sampled = infinity;
      std::vector<double> point(dimension);
      for (int i = 0; i < result.evaluations; ++i) {
        for (double& gene : point) gene = draws.uniform();
        sampled = std::min(sampled, function(point));
      }
      better += result.best_value < sampled;
    }
    EXPECT_GE(better, 18);
  }
}

// outcome_of() must find the outcome from the history alone. With one generation less or more, the history meets no
// stopping rule and counts as interrupted.
TEST(Outcome, FollowsFromTheHistory) {
  for (int const stagnation : {1, 3, 20}) {
    for (int const generations : {1, 4, 60}) {
      GeneticOptions const options{.population = 4, .generations = generations, .stagnation = stagnation};
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        auto const result = minimise_genetic(FunctionProblem(2, sphere), num::Stream(seed), options);
        EXPECT_EQ(outcome_of(result.history, options), result.outcome);
        auto shorter = result.history, longer = result.history;
        shorter.pop_back();
        longer.push_back(longer.back());
        EXPECT_EQ(outcome_of(shorter, options), Outcome::interrupted);
        EXPECT_EQ(outcome_of(longer, options), Outcome::interrupted);
      }
    }
  }
  EXPECT_EQ(outcome_of(std::vector{infinity}, {}), Outcome::no_finite_value);
  EXPECT_EQ(outcome_of(std::vector{infinity, 1.0}, {}), Outcome::interrupted);
}

}  // namespace
}  // namespace isolaw::opt
