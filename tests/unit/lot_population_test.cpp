// Tests the estimate of a lot's population, the distribution of the parameters of its devices, on covariances that can
// be worked out by hand.
#include "isolaw/lot/population.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "not_finite.hpp"

namespace isolaw::lot {
namespace {

using Values = std::vector<double>;
using Names = std::vector<std::string>;

void expect_near(SquareMatrix const& found, SquareMatrix const& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].size(), expected[i].size());
    for (std::size_t j = 0; j < found.size(); ++j)
      EXPECT_NEAR(found[i][j], expected[i][j], tolerance) << i << ", " << j;
  }
}

SquareMatrix scaled(SquareMatrix m, double factor) {
  for (auto& row : m)
    for (double& x : row) x *= factor;
  return m;
}

std::vector<DeviceEstimate> with(std::vector<Values> const& values, SquareMatrix const& covariance = {}) {
  std::vector<DeviceEstimate> devices;
  for (auto const& value : values) devices.push_back({value, covariance});
  return devices;
}

// Returns ten devices about (0, 0): two at each of (a, a), (-a, -a), (b, -b), (-b, b) and (0, 0). Each parameter has
// both signs, so none is taken as a logarithm. The variance of the estimates is 8 a^2 / 9 along (1, 1) and 8 b^2 / 9
// along (1, -1).
std::vector<Values> ellipse(double a, double b) {
  return {{a, a}, {-a, -a}, {a, a}, {-a, -a}, {b, -b}, {-b, b}, {b, -b}, {-b, b}, {0, 0}, {0, 0}};
}
SquareMatrix about_the_diagonal(double along, double across) {
  return {{0.5 * (along + across), 0.5 * (along - across)}, {0.5 * (along - across), 0.5 * (along + across)}};
}

Names const two{"K1", "xy"};

TEST(Transform, IsTheLogarithmForOneSign) {
  EXPECT_EQ(transform_for(Values{1, 2e-200, 3e200}), Transform::logarithm);
  EXPECT_EQ(transform_for(Values{-1, -2}), Transform::logarithm);
  for (auto const& values : {Values{}, Values{0, 1}, Values{1, 0}, Values{-1, 2}, Values{1, nan}, Values{infinity}})
    EXPECT_EQ(transform_for(values), Transform::identity);
  EXPECT_EQ(name(Transform::logarithm), "logarithm");
  EXPECT_EQ(name(Transform::identity), "identity");
}

TEST(Population, HasMedianAndRelativeScatterOfLogarithms) {
  double const e = std::exp(0.1);
  auto const found = estimate_population({"K1", "beta1-"}, with({{2 * e, -3 / e}, {2 / e, -3 * e}, {2, -3}}));
  EXPECT_EQ(found.devices, 3u);
  EXPECT_EQ(found.transforms, (std::vector{Transform::logarithm, Transform::logarithm}));
  EXPECT_NEAR(found.medians[0], 2.0, 1e-12);
  EXPECT_NEAR(found.medians[1], -3.0, 1e-12);
  EXPECT_NEAR(found.mean[1], std::log(3.0), 1e-12);
  EXPECT_NEAR(found.std[0], 0.1, 1e-12);
  EXPECT_NEAR(found.relative_std[1], 0.1, 1e-12);
  EXPECT_NEAR(found.correlation[0][1], -1.0, 1e-9);
  EXPECT_EQ(found.directions, 1u);
}

TEST(Population, KeepsTheUnitWhereSignsDiffer) {
  auto const found = estimate_population({"a1"}, with({{-1}, {2}, {5}}));
  EXPECT_EQ(found.transforms[0], Transform::identity);
  EXPECT_DOUBLE_EQ(found.medians[0], 2.0);
  EXPECT_NEAR(found.std[0], 3.0, 1e-9);
  EXPECT_NEAR(found.relative_std[0], 1.5, 1e-9);
  EXPECT_TRUE(std::isnan(estimate_population({"a1"}, with({{-1}, {1}})).relative_std[0]));
}

TEST(Population, WithoutErrorsHasTheCovarianceOfTheEstimates) {
  auto const found = estimate_population(two, with(ellipse(3, 0.5)));
  auto const expected = about_the_diagonal(8.0, 2.0 / 9.0);
  expect_near(found.estimates, expected, 1e-12);
  expect_near(found.covariance, expected, 1e-12);
  expect_near(found.uncertainty, {{0, 0}, {0, 0}}, 0.0);
  EXPECT_EQ(found.directions, 2u);
  EXPECT_TRUE(found.undetermined.empty());
  EXPECT_EQ(found.note, "");
}

// Along (1, 1) the variance of the estimates is 8 and that of the error is 2, which leaves 6. Along (1, -1) the
// variance of 2/9 is less than the error of 1, so nothing is left.
TEST(Population, KeepsWhatExceedsTheErrorInEachDirection) {
  auto const found = estimate_population(two, with(ellipse(3, 0.5), about_the_diagonal(2.0, 1.0)));
  expect_near(found.covariance, about_the_diagonal(6.0, 0.0), 1e-12);
  EXPECT_NEAR(found.correlation[0][1], 1.0, 1e-12);
  EXPECT_EQ(found.directions, 1u);
  ASSERT_EQ(found.undetermined.size(), 1u);
  EXPECT_NEAR(found.undetermined[0].ratio, 2.0 / 9.0, 1e-12);
  EXPECT_NEAR(std::abs(found.undetermined[0].weights[0]), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(found.undetermined[0].weights[0], -found.undetermined[0].weights[1], 1e-9);
  EXPECT_EQ(
      found.note,
      "the devices differ by more than the uncertainty of their fits in only 1 of 2 independent combinations of the parameters");
}

// The covariances C of the errors and S of the estimates have different axes here. Each lambda of S x = lambda C x
// solves the quadratic det(S - lambda C) = 0. Only one lambda is above 1. The population's covariance is therefore
// (lambda - 1) p p^T with p = C x and x^T C x = 1.
TEST(Population, SolvesTheGeneralisedProblem) {
  SquareMatrix const C{{1.0, 0.0}, {0.0, 4.0}};
  auto const found = estimate_population(two, with(ellipse(1.5, 0.75), C));
  double const along = 2.0, across = 0.5, s = 0.5 * (along + across), c = 0.5 * (along - across);
  // S = [[s, c], [c, s]], so det(S - lambda C) = 4 lambda^2 - 5 s lambda + s^2 - c^2.
  double const lambda = (5.0 * s + std::sqrt(25.0 * s * s - 16.0 * (s * s - c * c))) / 8.0;
  ASSERT_GT(lambda, 1.0);
  double const ratio = (lambda - s) / c;  // x = (1, ratio)
  double const length2 = 1.0 + 4.0 * ratio * ratio;
  Values const p{1.0 / std::sqrt(length2), 4.0 * ratio / std::sqrt(length2)};
  SquareMatrix expected(2, Values(2));
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) expected[i][j] = (lambda - 1.0) * p[i] * p[j];
  expect_near(found.covariance, expected, 1e-12);
}

TEST(Population, TakesTheMeanOfTheErrors) {
  auto devices = with(ellipse(3, 3));
  for (std::size_t d = 0; d < devices.size(); ++d)
    devices[d].covariance = scaled(about_the_diagonal(1.0, 1.0), d % 2 == 0 ? 1.0 : 5.0);
  auto const found = estimate_population(two, devices);
  expect_near(found.uncertainty, about_the_diagonal(3.0, 3.0), 1e-12);
  expect_near(found.covariance, about_the_diagonal(5.0, 5.0), 1e-12);
}

TEST(Population, OfDevicesThatDifferByLessThanTheirErrorHasNoVariance) {
  for (double const factor : {1.0, 1.001, 1e12}) {
    auto const found =
        estimate_population(two, with(ellipse(3, 0.5), scaled(about_the_diagonal(8.0, 2.0 / 9), factor)));
    expect_near(found.covariance, {{0, 0}, {0, 0}}, 0.0);
    EXPECT_EQ(found.directions, 0u);
    EXPECT_EQ(found.undetermined.size(), 2u);
    EXPECT_TRUE(std::isnan(found.correlation[0][1]));
    EXPECT_EQ(found.correlation[1][1], 1.0);
  }
}

// Along (1, 1) the error of the fits is so large that they practically determine nothing. Along (1, -1) the fits are
// exact, so the scatter in this direction is known.
TEST(Population, KeepsADirectionBesideOneThatIsNotDetermined) {
  auto const found = estimate_population(two, with(ellipse(3, 0.5), about_the_diagonal(1e9, 0.0)));
  expect_near(found.covariance, about_the_diagonal(0.0, 2.0 / 9.0), 1e-6);
  EXPECT_EQ(found.directions, 1u);
}

// The second parameter has no effect on the force, and its estimates are noise that follows the first parameter by
// chance. If the caller names it as undetermined, it keeps no scatter.
TEST(Population, HoldsWhatDoesNotActAtItsMedian) {
  SquareMatrix const error{{0.01, 0.0}, {0.0, 9.0}};
  auto const devices = with(ellipse(1.5, 0.75), error);
  std::vector<std::size_t> const second{1};
  auto const taken = estimate_population(two, devices), held = estimate_population(two, devices, second);
  EXPECT_GT(taken.covariance[1][1], 0.1);
  EXPECT_NEAR(held.covariance[0][0], held.estimates[0][0] - error[0][0], 1e-12);
  EXPECT_NEAR(held.covariance[1][1], 0.0, 1e-12);
  EXPECT_NEAR(held.covariance[0][1], 0.0, 1e-12);
  EXPECT_EQ(held.directions, 1u);
}

// Each of the two parameters is undetermined by itself. Their sum is determined, so it keeps its scatter.
TEST(Population, KeepsWhatTwoUndeterminedParametersShare) {
  std::vector<std::size_t> const both{0, 1};
  auto const found = estimate_population(two, with(ellipse(3, 0.5), about_the_diagonal(0.01, 1e9)), both);
  expect_near(found.covariance, about_the_diagonal(8.0 - 0.01, 0.0), 1e-6);
}

TEST(Population, TakesErrorsToLogarithms) {
  // Relative to (2, -6) the errors are 0.1 and 0.1, with a correlation of 0.5.
  SquareMatrix const error{{0.04, -0.06}, {-0.06, 0.36}};
  auto const found = estimate_population(two, with({{2, -6}, {2, -6}}, error));
  expect_near(found.uncertainty, {{0.01, 0.005}, {0.005, 0.01}}, 1e-15);
  expect_near(found.covariance, {{0, 0}, {0, 0}}, 0.0);
}

TEST(Population, InOtherUnitsIsTheSame) {
  SquareMatrix const error{{0.02, 0.004}, {0.004, 0.03}};
  std::vector<Values> const values{{1.0, -3.0}, {1.5, 2.0}, {0.8, 1.0}, {1.1, 4.0}, {1.3, -1.0}};
  double const u0 = 1e6, u1 = 1e-7;
  auto changed = with(values);
  for (auto& device : changed) {
    device.values = {device.values[0] * u0, device.values[1] * u1};
    device.covariance = {{error[0][0] * u0 * u0, error[0][1] * u0 * u1},
                         {error[1][0] * u0 * u1, error[1][1] * u1 * u1}};
  }
  auto const a = estimate_population(two, with(values, error)), b = estimate_population(two, changed);
  EXPECT_EQ(a.directions, b.directions);
  EXPECT_NEAR(b.medians[0], a.medians[0] * u0, 1e-9 * u0);
  EXPECT_NEAR(b.std[0], a.std[0], 1e-9);  // a change of units shifts logarithms and does not change their scatter
  EXPECT_NEAR(b.std[1], a.std[1] * u1, 1e-9 * u1);
  EXPECT_NEAR(b.relative_std[1], a.relative_std[1], 1e-9);
  expect_near(b.correlation, a.correlation, 1e-9);
  num::Stream const stream(5);
  auto const x = sample(a, 20, stream).values, y = sample(b, 20, stream).values;
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(y[i][0], x[i][0] * u0, 1e-7 * u0);
    EXPECT_NEAR(y[i][1], x[i][1] * u1, 1e-7 * u1);
  }
}

TEST(Population, OfFewerDevicesThanParametersSaysWhatTheyCanShow) {
  Names const names{"a", "b", "c", "d"};
  auto const devices = with({{1, 2, 3, 4}, {1.2, 2.1, 3.3, 3.9}, {0.9, 2.2, 3.1, 4.4}});
  auto const found = estimate_population(names, devices);
  EXPECT_EQ(found.directions, 2u);
  expect_near(found.covariance, found.estimates, 1e-12);
  EXPECT_EQ(
      found.note,
      "the devices differ by more than the uncertainty of their fits in only 2 of 4 independent combinations of the parameters; from 3 devices no more than 2 can be seen");
}

TEST(Population, OfEqualDevicesHasNoVariance) {
  auto const found = estimate_population(two, with({{1.1, 0.3}, {1.1, 0.3}, {1.1, 0.3}}));
  expect_near(found.covariance, {{0, 0}, {0, 0}}, 0.0);
  EXPECT_EQ(found.directions, 0u);
  EXPECT_TRUE(found.undetermined.empty());  // parameters with neither scatter nor error are constants, not undetermined
  EXPECT_NEAR(sample(found, 1, num::Stream(1)).values[0][1], 0.3, 1e-15);
}

TEST(Population, OfOneDeviceOrNoneSaysSo) {
  auto const one = estimate_population(two, with({{2, -3}}));
  EXPECT_FALSE(one.has_covariance());
  EXPECT_EQ(one.note, "one device: no scatter between devices");
  EXPECT_NEAR(one.medians[1], -3.0, 1e-12);
  auto const none = estimate_population(two, {});
  EXPECT_EQ(none.note, "no device");
  EXPECT_TRUE(none.mean.empty());
  EXPECT_EQ(estimate_population({}, with({{}, {}})).note, "no free parameter");
  EXPECT_THROW(sample(one, 1, num::Stream(1)), Error);
  EXPECT_THROW(sample(none, 1, num::Stream(1)), Error);
}

TEST(Population, RefusesWhatIsNoEstimateAllAtOnce) {
  auto const complaints = [](std::vector<DeviceEstimate> const& devices) -> std::size_t {
    try {
      estimate_population(two, devices);
    } catch (Error const& error) {
      return error.complaints().size();
    }
    return 0;
  };
  EXPECT_EQ(complaints(with({{1, 2}, {3, 4}})), 0u);
  EXPECT_EQ(complaints(with({{1, nan}, {infinity, 2}, {1}})), 3u);
  EXPECT_EQ(complaints(with({{1, 2}}, {{1, 0}})), 1u);
  EXPECT_EQ(complaints(with({{1, 2}}, {{1, 0, 0}, {0, 1, 0}})), 1u);
  EXPECT_EQ(complaints(with({{1, 2}}, {{1, nan}, {0, -1}})), 2u);
  // The relative error is 1 / 1e-160, whose square is not finite.
  EXPECT_EQ(complaints(with({{1e-160, 2}, {1, 2}}, {{1, 0}, {0, 1}})), 1u);
}

Population correlated() {
  Population population =
      estimate_population(two, with({{1.0, -1.0}, {1.3, -1.4}, {0.8, 0.5}, {1.1, 0.4}, {0.7, -0.8}}));
  EXPECT_EQ(population.transforms, (std::vector{Transform::logarithm, Transform::identity}));
  return population;
}

TEST(PopulationSample, HasTheMomentsOfThePopulation) {
  auto const population = correlated();
  constexpr std::size_t count = 20'000;
  auto const drawn = sample(population, count, num::Stream(11));
  ASSERT_EQ(drawn.values.size(), count);
  EXPECT_EQ(drawn.rejected, 0u);
  Values mean(2, 0.0);
  SquareMatrix covariance(2, Values(2, 0.0));
  auto const at = [](Values const& v) { return Values{std::log(v[0]), v[1]}; };
  for (auto const& v : drawn.values)
    for (std::size_t i = 0; i < 2; ++i) mean[i] += at(v)[i] / count;
  for (auto const& v : drawn.values)
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j) covariance[i][j] += (at(v)[i] - mean[i]) * (at(v)[j] - mean[j]) / count;
  auto const& truth = population.covariance;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(mean[i], population.mean[i], 4.0 * std::sqrt(truth[i][i] / count));
    for (std::size_t j = 0; j < 2; ++j)
      EXPECT_NEAR(covariance[i][j], truth[i][j],
                  4.0 * std::sqrt((truth[i][i] * truth[j][j] + truth[i][j] * truth[i][j]) / count));
  }
}

TEST(PopulationSample, DoesNotDependOnTheCount) {
  auto const population = correlated();
  std::vector<Limits> const limits{{.lower = 0.9}, {.upper = 0.0}};
  auto const few = sample(population, 5, num::Stream(3), limits), many = sample(population, 50, num::Stream(3), limits);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(few.values[i], many.values[i]);
  EXPECT_NE(few.values[0], few.values[1]);
  EXPECT_NE(few.values, sample(population, 5, num::Stream(4), limits).values);
}

// Both parameters have the same variance. A tiny correlation then decides by its sign which of two perpendicular
// directions is the principal axis of the covariance. The draws must not jump when this axis changes.
TEST(PopulationSample, DoesNotJumpWhereVariancesCoincide) {
  auto population = estimate_population(two, with(ellipse(3, 3)));
  expect_near(population.covariance, about_the_diagonal(8.0, 8.0), 1e-12);
  auto const drawn = [&](double correlation) {
    population.covariance = about_the_diagonal(8.0 * (1.0 + correlation), 8.0 * (1.0 - correlation));
    return sample(population, 20, num::Stream(6)).values;
  };
  expect_near({drawn(1e-9)[0], drawn(1e-9)[1]}, {drawn(-1e-9)[0], drawn(-1e-9)[1]}, 1e-7);
}

// In all devices xy = 3 K1^2, so this must hold in all draws too. Draws from independent distributions of K1 and xy
// would not keep it.
TEST(PopulationSample, KeepsParametersThatDependOnOneAnotherOnTheirLine) {
  std::vector<Values> values;
  for (double const K1 : {1.0, 1.2, 0.9, 1.5, 1.1}) values.push_back({K1, 3.0 * K1 * K1, -2.0 / K1});
  auto const population = estimate_population({"K1", "xy", "z"}, with(values));
  EXPECT_EQ(population.directions, 1u);
  auto const drawn = sample(population, 200, num::Stream(7)).values;
  for (auto const& v : drawn) {
    EXPECT_NEAR(v[1], 3.0 * v[0] * v[0], 1e-5 * v[1]);
    EXPECT_NEAR(v[2], -2.0 / v[0], 1e-5 * -v[2]);
  }
  auto const [low, high] = std::ranges::minmax_element(drawn, {}, [](Values const& v) { return v[0]; });
  EXPECT_GT((*high)[0], 1.3 * (*low)[0]);
}

TEST(PopulationSample, StaysWithinLimitsAndSaysWhatItCost) {
  auto const population = correlated();
  double const median = population.medians[0];
  auto const drawn = sample(population, 400, num::Stream(9), std::vector<Limits>{{.lower = median}, {}});
  for (auto const& v : drawn.values) EXPECT_GE(v[0], median);
  // Each draw is accepted with probability one half. The number of rejected draws before an accepted one then has mean
  // 1 and variance 2 (a geometric distribution). For 400 accepted draws all rejected draws have mean 400 and variance
  // 800.
  EXPECT_NEAR(static_cast<double>(drawn.rejected), 400.0, 4.0 * std::sqrt(800.0));
  EXPECT_EQ(drawn.pulled_back, 0u);
}

// The limits are so narrow that no draw lies within them. A draw is then pulled back towards the medians on a line that
// keeps the relation between the parameters.
TEST(PopulationSample, IsPulledBackWhereNoDrawFits) {
  std::vector<Values> values;
  for (double const K1 : {1.0, 1.2, 0.9, 1.5, 1.1}) values.push_back({K1, 3.0 * K1 * K1});
  auto const population = estimate_population(two, with(values));
  double const median = population.medians[0];
  std::vector<Limits> const narrow{{.lower = median * (1 - 1e-6), .upper = median * (1 + 1e-6)}, {}};
  auto const drawn = sample(population, 10, num::Stream(9), narrow);
  EXPECT_EQ(drawn.pulled_back, 10u);
  EXPECT_EQ(drawn.rejected, 10u * most_tries);
  for (auto const& v : drawn.values) {
    EXPECT_NEAR(v[0], median, 1e-6 * median);
    EXPECT_NEAR(v[1], 3.0 * v[0] * v[0], 1e-9);
  }
  auto const pinned =
      sample(population, 1, num::Stream(9), std::vector<Limits>{{.lower = median, .upper = median}, {}});
  EXPECT_EQ(pinned.values[0][0], median);
}

TEST(PopulationSample, RefusesLimitsThatDoNotFit) {
  auto const population = correlated();
  EXPECT_THROW(sample(population, 1, num::Stream(1), std::vector<Limits>{{}}), Error);
  EXPECT_THROW(sample(population, 1, num::Stream(1), std::vector<Limits>{{.upper = 0.1}, {}}), Error);
}

}  // namespace
}  // namespace isolaw::lot
