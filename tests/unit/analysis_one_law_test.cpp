// Tests the fit of one set of parameters to several devices: with the least mean objective, with the least worst
// objective, with each device left out in turn, and in a box that all devices share.
#include "isolaw/analysis/one_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/opt/multistart.hpp"
#include "twins.hpp"

namespace isolaw::analysis {
namespace {

// A lot of bilinear devices whose records have a little noise. The fixture also holds the optimum of each device. The
// strength of a device is a factor on all its free parameters.
class Lot : public testing::Test {
 protected:
  void take(std::vector<double> const& strengths, std::vector<std::string> const& set = {}) {
    std::vector<fit::Override> overrides;
    for (auto const& text : set) overrides.push_back(fit::parse_override(text));
    auto const first = twins::twin_in_box("bilinear", twins::growing_cycles(3, 60), overrides);
    box_ = first.box;
    for (std::size_t d = 0; d < strengths.size(); ++d) {
      auto truth = first.truth;
      for (std::size_t i = 0; i < truth.size(); ++i)
        if (box_.parameters[i].free) truth[i] *= strengths[d];
      auto twin = twins::twin_of(*first.law, first.record, box_, truth);
      num::Draws draws(num::Stream(11), 0, 0);
      models_.emplace_back(*first.law, twins::with_noise(twin.record, {}, draws), laws::Integration::converged);
      optima_.push_back(truth);
      if (box_.free_count() == 0) continue;
      auto const found = opt::descend(fit::IdentificationProblem(models_.back(), box_), box_.contract(truth), 1.0).best;
      box_.expand(found, optima_.back());
    }
    for (auto const& model : models_) pointers_.push_back(&model);
  }
  double objective(std::size_t device, std::vector<double> const& parameters) const {
    std::vector<double> work;
    return models_[device].objective(parameters, work);
  }
  double mean_of(std::vector<double> const& parameters) const {
    double sum = 0.0;
    for (std::size_t d = 0; d < models_.size(); ++d) sum += objective(d, parameters);
    return sum / static_cast<double>(models_.size());
  }

  fit::SearchBox box_;
  std::vector<fit::LawOnRecord> models_;
  std::vector<fit::LawOnRecord const*> pointers_;
  std::vector<std::vector<double>> optima_;
};

TEST_F(Lot, OfTwoIdenticalDevicesHasTheirOptimum) {
  take({1.0, 1.0});
  auto const found = least_mean(pointers_, box_, optima_);
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found->parameters[i], optima_[0][i], 1e-3 * optima_[0][i]);
  EXPECT_LE(found->mean, objective(0, optima_[0]) * (1.0 + 1e-9));
  EXPECT_NEAR(found->mean, objective(0, optima_[0]), 1e-4 * found->mean);
  EXPECT_EQ(found->objectives[0], found->objectives[1]);
  EXPECT_EQ(found->worst, found->objectives[0]);
  auto const worst = least_worst(pointers_, box_, *found);
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->law.parameters, found->parameters);
  EXPECT_NEAR(worst->bound, worst->law.worst, 1e-12);
}

TEST_F(Lot, TheLeastMeanIsBelowThatOfAnyDevicesOwn) {
  take({0.85, 1.0, 1.1, 1.2});
  auto const found = least_mean(pointers_, box_, optima_);
  ASSERT_TRUE(found);
  for (auto const& own : optima_) EXPECT_LT(found->mean, mean_of(own));
  ASSERT_EQ(found->objectives.size(), 4u);
  for (std::size_t d = 0; d < 4; ++d) {
    EXPECT_EQ(found->objectives[d], objective(d, found->parameters));
    EXPECT_GE(found->objectives[d], objective(d, optima_[d]));
  }
  EXPECT_NEAR(found->mean, mean_of(found->parameters), 1e-15);
  EXPECT_EQ(found->worst, std::ranges::max(found->objectives));
  EXPECT_GT(found->evaluations, 0);
}

TEST_F(Lot, TheLeastWorstLiesBetweenItsBoundAndTheWorstOfTheLeastMean) {
  take({0.85, 1.0, 1.0, 1.0, 1.2});
  auto const mean = *least_mean(pointers_, box_, optima_);
  auto const found = least_worst(pointers_, box_, mean);
  ASSERT_TRUE(found);
  // Three of the five devices are equal, so they decide the least mean. The least worst objective depends on the
  // extreme devices.
  EXPECT_LT(found->law.worst, 0.95 * mean.worst);
  EXPECT_GE(found->law.worst, found->bound);
  EXPECT_GE(found->bound, mean.mean);
  EXPECT_GT(found->bound, 0.9 * found->law.worst);
  EXPECT_GE(found->law.mean, mean.mean * (1.0 - 1e-9));
  EXPECT_EQ(found->law.worst, std::ranges::max(found->law.objectives));
  // No parameters keep the objectives of all devices below the bound, so the optimum of a single device does not
  // either.
  for (auto parameters : optima_) {
    double worst = 0.0;
    for (std::size_t d = 0; d < models_.size(); ++d) worst = std::max(worst, objective(d, parameters));
    EXPECT_GE(worst, found->bound);
  }
}

TEST_F(Lot, OfTwoDevicesOneLeftOutMeetsTheOthersLaw) {
  take({0.9, 1.1});
  auto const all = *least_mean(pointers_, box_, optima_);
  for (std::size_t out = 0; out < 2; ++out) {
    auto const found = leave_out(pointers_, box_, all.parameters, optima_, out);
    ASSERT_TRUE(found);
    auto const& other = optima_[1 - out];
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found->parameters[i], other[i], 2e-3 * other[i]);
    EXPECT_LE(objective(1 - out, found->parameters), objective(1 - out, other) * (1.0 + 1e-9));
    EXPECT_EQ(found->objective, objective(out, found->parameters));
  }
}

TEST_F(Lot, NoParameterIsFree) {
  take({1.0, 1.0}, {"bilinear.K1=4", "bilinear.K2=0.6", "bilinear.xy=20"});
  auto const mean = least_mean(pointers_, box_, optima_);
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->parameters, (std::vector{4.0, 0.6, 20.0}));
  EXPECT_EQ(mean->objectives.size(), 2u);
  auto const worst = least_worst(pointers_, box_, *mean);
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->law.parameters, mean->parameters);
  auto const out = leave_out(pointers_, box_, mean->parameters, optima_, 0);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->parameters, mean->parameters);
  EXPECT_EQ(out->objective, mean->objectives[0]);
}

TEST_F(Lot, OfOneDeviceHasItsOptimum) {
  take({1.0});
  auto const mean = least_mean(pointers_, box_, optima_);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->mean, objective(0, optima_[0]), 1e-4 * mean->mean);
  auto const worst = least_worst(pointers_, box_, *mean);
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->law.worst, mean->worst);
}

TEST_F(Lot, TheOrderOfTheDevicesDoesNotMatter) {
  take({0.85, 1.0, 1.1, 1.2});
  auto const one = *least_mean(pointers_, box_, optima_);
  std::ranges::reverse(pointers_);
  std::ranges::reverse(optima_);
  auto const other = *least_mean(pointers_, box_, optima_);
  EXPECT_NEAR(one.mean, other.mean, 1e-9 * one.mean);
  EXPECT_NEAR(one.worst, other.worst, 1e-4 * one.worst);
}

TEST_F(Lot, NoFiniteStartGivesNone) {
  take({1.0, 1.1});
  for (auto& own : optima_) own.assign(3, std::nan(""));
  EXPECT_FALSE(least_mean(pointers_, box_, optima_));
}

TEST_F(Lot, Interrupted) {
  take({0.9, 1.1, 1.1});
  EXPECT_FALSE(least_mean(pointers_, box_, optima_, [] { return true; }));
  int asked = 0;
  EXPECT_FALSE(least_mean(pointers_, box_, optima_, [&] { return ++asked == 2; }));
  auto const mean = *least_mean(pointers_, box_, optima_);
  EXPECT_FALSE(least_worst(pointers_, box_, mean, [] { return true; }));
}

fit::SearchBox box_of(std::vector<std::string> const& set, double size = 1.0) {
  std::vector<fit::Override> overrides;
  for (auto const& text : set) overrides.push_back(fit::parse_override(text));
  auto motion = twins::growing_cycles(2, 40);
  for (double& x : motion.disp_mm) x *= size;
  auto const& law = laws::find_law("vaiana");
  return fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(motion, law.info), overrides);
}

fit::SearchBox common(fit::SearchBox const& a, fit::SearchBox const& b) {
  return common_box(std::vector<fit::SearchBox const*>{&a, &b});
}

TEST(CommonBox, IsTheHull) {
  auto const a = box_of({}), b = box_of({}, 0.5), hull = common(a, b);
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    EXPECT_EQ(hull.parameters[i].lower, std::min(a.parameters[i].lower, b.parameters[i].lower));
    EXPECT_EQ(hull.parameters[i].upper, std::max(a.parameters[i].upper, b.parameters[i].upper));
    EXPECT_EQ(hull.parameters[i].scale, a.parameters[i].scale);
  }
  EXPECT_NE(a.parameters[0].upper, b.parameters[0].upper);
}

TEST(CommonBox, AScaleThatDiffersBecomesLinear) {
  auto const a = box_of({"vaiana.beta1+=1:100"}), b = box_of({"vaiana.beta1+=-1:100"});
  auto const i = laws::find_law("vaiana").index_of("beta1+");
  ASSERT_NE(a.parameters[i].scale, b.parameters[i].scale);
  auto const parameter = common(a, b).parameters[i];
  EXPECT_EQ(parameter.scale, laws::Scale::linear);
  EXPECT_EQ(parameter.lower, -1.0);
}

TEST(CommonBox, RefusesWhatIsFixedDifferently) {
  auto const free = box_of({}), fixed = box_of({"vaiana.Kb+=1e5"}), other = box_of({"vaiana.Kb+=2e5"});
  EXPECT_THROW(common(free, fixed), Error);
  EXPECT_THROW(common(fixed, free), Error);
  EXPECT_NO_THROW(common(fixed, fixed));
  try {
    common(fixed, other);
    FAIL();
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find("Kb+"), std::string::npos);
  }
}

TEST(CommonBox, RefusesWhatIsTiedDifferently) {
  auto const tied = box_of({"vaiana.Kb-=Kb+"}), fixed = box_of({"vaiana.Kb-=0"}),
             otherwise = box_of({"vaiana.f0-=f0+"});
  EXPECT_NO_THROW(common(tied, tied));
  EXPECT_THROW(common(tied, fixed), Error);
  EXPECT_THROW(common(fixed, tied), Error);
  EXPECT_THROW(common(tied, otherwise), Error);
}

}  // namespace
}  // namespace isolaw::analysis
