// Tests the block lengths of the bootstrap for series of known correlation, and the intervals of parameters in limiting
// cases: a record without errors, no free parameter, a parameter at a bound, a parameter tied to another.
#include "isolaw/analysis/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "isolaw/num/statistics.hpp"
#include "isolaw/opt/multistart.hpp"
#include "twins.hpp"

namespace isolaw::analysis {
namespace {

// Returns a first-order autoregressive series with unit standard deviation.
std::vector<double> series(std::size_t length, double correlation, std::uint32_t number) {
  num::Draws draws(num::Stream(7), number, 0);
  double value = draws.normal();
  std::vector<double> values;
  for (std::size_t i = 0; i < length; ++i) {
    values.push_back(value);
    value = correlation * value + std::sqrt(1.0 - correlation * correlation) * draws.normal();
  }
  return values;
}

double block_length(std::vector<double> const& series) {
  return serial_correlation(series, num::moments(series).mean).block;
}

double mean_block_length(std::size_t length, double correlation) {
  constexpr std::uint32_t many = 50;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < many; ++i) sum += block_length(series(length, correlation, i));
  return sum / many;
}

TEST(BlockLength, OfIndependentValuesIsShort) {
  EXPECT_GE(mean_block_length(300, 0.0), 1.0);
  EXPECT_LT(mean_block_length(300, 0.0), 3.0);
  EXPECT_LT(mean_block_length(3000, 0.0), 3.0);
}

// For n values the block length must be (3/2 (2 rho / (1 - rho^2))^2 n)^(1/3). This is Eq. (14) of Politis and White
// 2004 with the autocovariances of a first-order autoregressive series.
TEST(BlockLength, OfCorrelatedValuesIsThatOfTheirTheory) {
  for (double const rho : {0.5, 0.9}) {
    double const g = 2.0 * rho / (1.0 - rho * rho), theory = std::cbrt(1.5 * g * g * 3000.0);
    EXPECT_NEAR(mean_block_length(3000, rho), theory, 0.25 * theory) << rho;
  }
  EXPECT_GT(mean_block_length(300, 0.9), 5.0 * mean_block_length(300, 0.0));
}

TEST(BlockLength, OfShortAndOfConstantSeriesIsOne) {
  EXPECT_EQ(block_length({}), 1.0);
  EXPECT_EQ(block_length({3.0}), 1.0);
  EXPECT_EQ(block_length(std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0}), 1.0);
  EXPECT_EQ(block_length(std::vector<double>(100, 0.0)), 1.0);
  EXPECT_EQ(block_length(std::vector<double>(100, 4.0)), 1.0);
}

class IntervalsOf : public testing::Test {
 protected:
  explicit IntervalsOf(std::vector<std::string> const& set = {}, std::string_view law = "bilinear") { take(set, law); }
  void take(std::vector<std::string> const& set, std::string_view law = "bilinear") {
    std::vector<fit::Override> overrides;
    for (auto const& text : set) overrides.push_back(fit::parse_override(text));
    twin_ = twins::twin_in_box(law, twins::growing_cycles(3, 60), overrides);
    optimum_ = twin_.truth;
  }
  void disturb() {
    num::Draws draws(num::Stream(3), 0, 0);
    twin_.record = twins::with_noise(twin_.record, {}, draws);
    auto const on_record = model();
    twin_.box.expand(
        opt::descend(fit::IdentificationProblem(on_record, twin_.box), twin_.box.contract(optimum_), 1.0).best,
        optimum_);
  }
  fit::LawOnRecord model() const { return {*twin_.law, twin_.record, laws::Integration::converged}; }
  Intervals found(int replicates = 20, std::uint64_t seed = 1) const {
    return *intervals(model(), twin_.box, optimum_, num::Stream(seed), {.replicates = replicates});
  }

  twins::Twin twin_;
  std::vector<double> optimum_;
};

void expect_equal(Intervals const& a, Intervals const& b) {
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(a.replicates, b.replicates);
  ASSERT_EQ(a.parameters.size(), b.parameters.size());
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(a.parameters[i].linear_lower, b.parameters[i].linear_lower);
    EXPECT_EQ(a.parameters[i].linear_upper, b.parameters[i].linear_upper);
    EXPECT_EQ(a.parameters[i].bootstrap_lower, b.parameters[i].bootstrap_lower);
    EXPECT_EQ(a.parameters[i].bootstrap_upper, b.parameters[i].bootstrap_upper);
  }
}

TEST_F(IntervalsOf, HoldTheOptimumAndAreInOrder) {
  disturb();
  auto const estimate = found(50);
  EXPECT_EQ(estimate.samples, 181u);
  EXPECT_GE(estimate.block, 1u);
  EXPECT_EQ(estimate.replicates, 50);
  ASSERT_EQ(estimate.parameters.size(), 3u);
  ASSERT_EQ(estimate.covariance.size(), 9u);
  for (std::size_t i = 0; i < 3; ++i) {
    auto const& p = estimate.parameters[i];
    EXPECT_LT(p.linear_lower, optimum_[i]);
    EXPECT_GT(p.linear_upper, optimum_[i]);
    EXPECT_LT(*p.bootstrap_lower, *p.bootstrap_upper);
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(estimate.covariance[3 * i + j], estimate.covariance[3 * j + i], 1e-15);
    // The parameters have linear scales, so their intervals extend equally far to either side. That distance is
    // Student's t for 181 - 3 degrees of freedom or somewhat fewer, 1.974 standard deviations. A normal distribution
    // would give 1.960.
    double const deviation = std::sqrt(estimate.covariance[4 * i]);
    EXPECT_NEAR(p.linear_upper - optimum_[i], 1.974 * deviation, 1e-3 * deviation);
  }
}

TEST_F(IntervalsOf, AWiderLevelIsWider) {
  disturb();
  auto const of = [&](double level) {
    return *intervals(model(), twin_.box, optimum_, num::Stream(1), {.level = level, .replicates = 40});
  };
  auto const half = of(0.5), most = of(0.99);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(most.parameters[i].linear_lower, half.parameters[i].linear_lower);
    EXPECT_GT(most.parameters[i].linear_upper, half.parameters[i].linear_upper);
    EXPECT_LT(*most.parameters[i].bootstrap_lower, *half.parameters[i].bootstrap_lower);
    EXPECT_GT(*most.parameters[i].bootstrap_upper, *half.parameters[i].bootstrap_upper);
  }
}

TEST_F(IntervalsOf, SameStreamSameIntervals) {
  disturb();
  expect_equal(found(), found());
  EXPECT_NE(found(20, 1).parameters[0].bootstrap_lower, found(20, 2).parameters[0].bootstrap_lower);
}

TEST_F(IntervalsOf, NoBootstrapWhereNoneIsAsked) {
  disturb();
  auto const estimate = found(0);
  EXPECT_EQ(estimate.replicates, 0);
  for (auto const& p : estimate.parameters) EXPECT_FALSE(p.bootstrap_lower || p.bootstrap_upper);
}

// If the record has no errors, or only rounding errors, the intervals shrink to the true values.
TEST_F(IntervalsOf, WithoutErrorsCollapse) {
  for (double const rounding : {0.0, 1e-13}) {
    for (std::size_t i = 0; i < twin_.record.force_kN.size(); ++i)
      twin_.record.force_kN[i] *= 1.0 + (i % 2 == 0 ? rounding : -rounding);
    auto const estimate = found();
    for (double const c : estimate.covariance) EXPECT_TRUE(std::isfinite(c));
    for (auto const& p : estimate.parameters) {
      double const truth = twin_.truth[p.parameter];
      for (double const end : {p.linear_lower, p.linear_upper, *p.bootstrap_lower, *p.bootstrap_upper})
        EXPECT_NEAR(end, truth, 1e-6 * truth) << twin_.box.parameters[p.parameter].name;
    }
  }
}

TEST_F(IntervalsOf, NothingFreeGivesNone) {
  take({"bilinear.K1=4", "bilinear.K2=0.6", "bilinear.xy=20"});
  auto const estimate = found();
  EXPECT_TRUE(estimate.parameters.empty());
  EXPECT_TRUE(estimate.covariance.empty());
  EXPECT_EQ(estimate.replicates, 0);
}

TEST_F(IntervalsOf, OneFree) {
  take({"bilinear.K1=4", "bilinear.K2=0.6"});
  disturb();
  auto const estimate = found();
  ASSERT_EQ(estimate.parameters.size(), 1u);
  EXPECT_EQ(estimate.parameters[0].parameter, 2u);
  EXPECT_LT(estimate.parameters[0].linear_lower, estimate.parameters[0].linear_upper);
  EXPECT_EQ(estimate.covariance.size(), 1u);
}

TEST_F(IntervalsOf, AParameterAtItsBoundIsThatValue) {
  twin_.box.parameters[1].lower = 1.3 * twin_.truth[1];
  disturb();
  ASSERT_EQ(fit::at_bound(twin_.box.parameters[1], optimum_[1]), fit::AtBound::lower);
  auto const estimate = found();
  auto const& held = estimate.parameters[1];
  for (double const end : {held.linear_lower, held.linear_upper, *held.bootstrap_lower, *held.bootstrap_upper})
    EXPECT_EQ(end, optimum_[1]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(estimate.covariance[3 + i], 0.0);
  EXPECT_LT(estimate.parameters[0].linear_lower, estimate.parameters[0].linear_upper);
  EXPECT_GT(estimate.covariance[8], 0.0);
}

TEST_F(IntervalsOf, EveryParameterAtItsBound) {
  for (auto& p : twin_.box.parameters) p.upper = p.lower + 0.1 * (p.upper - p.lower);
  for (std::size_t i = 0; i < 3; ++i) optimum_[i] = twin_.box.parameters[i].upper;
  auto const estimate = found();
  for (auto const& p : estimate.parameters) EXPECT_EQ(p.linear_lower, p.linear_upper);
  EXPECT_EQ(estimate.replicates, 0);
}

// A parameter without effect on the force may lie anywhere in its box. It must not disturb the intervals of the other
// parameters.
TEST_F(IntervalsOf, OfWhatDoesNotActSpanTheBox) {
  take({"jankowski.a5=4e3:1e4"}, "jankowski");
  disturb();
  auto const estimate = found(0);
  auto const idle = twin_.law->index_of("a5");
  for (auto const& p : estimate.parameters) {
    auto const& parameter = twin_.box.parameters[p.parameter];
    double const share = (p.linear_upper - p.linear_lower) / (parameter.upper - parameter.lower);
    if (p.parameter == idle) {
      EXPECT_GT(share, 0.9);
    } else if (parameter.name == "a8" || parameter.name == "a9") {
      EXPECT_LT(share, 0.1) << parameter.name;
    }
  }
}

TEST_F(IntervalsOf, ATiedParameterHasNoneOfItsOwn) {
  take({"vaiana.Kb-=Kb+"}, "vaiana");
  disturb();
  EXPECT_EQ(optimum_[twin_.law->index_of("Kb-")], optimum_[twin_.law->index_of("Kb+")]);
  auto const estimate = found(5);
  EXPECT_EQ(estimate.parameters.size(), twin_.box.free_count());
  for (auto const& p : estimate.parameters) EXPECT_NE(p.parameter, twin_.law->index_of("Kb-"));
}

// Without a finite force nothing is known about the parameters, so their intervals are the whole box.
TEST_F(IntervalsOf, WithoutAForceAreTheBox) {
  optimum_[1] = std::nan("");
  auto const estimate = found(3);
  EXPECT_EQ(estimate.replicates, 0);
  for (auto const& p : estimate.parameters) {
    EXPECT_EQ(p.linear_lower, twin_.box.parameters[p.parameter].lower);
    EXPECT_EQ(p.linear_upper, twin_.box.parameters[p.parameter].upper);
    EXPECT_FALSE(p.bootstrap_lower || p.bootstrap_upper);
  }
  for (double const c : estimate.covariance) EXPECT_TRUE(std::isfinite(c));
}

TEST_F(IntervalsOf, Interrupted) {
  disturb();
  int asked = 0;
  EXPECT_FALSE(intervals(model(), twin_.box, optimum_, num::Stream(1), {.replicates = 9}, [&] { return ++asked > 4; }));
  EXPECT_EQ(asked, 5);
}

}  // namespace
}  // namespace isolaw::analysis
