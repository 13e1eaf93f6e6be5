// Tests the bound laws over the design conditions of a campaign, for the bilinear law of device P4 of `isolaw example
// --conditions`. The factors and numbers come from closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "isolaw/study/design_bounds.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

using conditions::Status;
using rules::Quantity;

std::vector<double> const of_bilinear{3.344383356, 0.557397226, 8.970263513};

Summary example() {
  auto const of = [](double factor, Status status, double share) {
    conditions::Combined combined;
    combined.factor = factor, combined.status = status, combined.share_shown = share;
    return combined;
  };
  ConditionsResult found;
  ConditionsTest reference, large;
  reference.amplitude_mm = 208.0, reference.condition.frequency_Hz = 0.5;
  large.amplitude_mm = 400.0, large.role = TestRole::other_strain;
  found.tests = {reference, large};
  found.bounds = {{.quantity = Quantity::K_eff,
                   .max = of(1.869155861, Status::interpolated, 1.0),
                   .min = of(0.705430235, Status::extrapolated, 0.528110688)},
                  {.quantity = Quantity::energy,
                   .max = of(1.859391152, Status::shown, 1.0),
                   .min = of(0.665827352, Status::interpolated, 0.6)}};
  Summary summary;
  summary.conditions = std::move(found);
  return summary;
}

void expect_near(double value, double wanted) {
  EXPECT_NEAR(value, wanted, 1e-7 * std::abs(wanted));
}

TEST(DesignBounds, have_the_factors_of_K_eff_and_energy) {
  auto const bounds = design_bounds(example(), laws::find_law("bilinear"), of_bilinear);
  ASSERT_FALSE(bounds.obstacle) << wording::remark(*bounds.obstacle);
  expect_near(bounds.upper->law.factors.a, 1.871261438);
  expect_near(bounds.upper->law.factors.b, 1.859391152);
  expect_near(bounds.lower->law.factors.a, 0.713969857);
  expect_near(bounds.lower->law.factors.b, 0.665827352);
  // A bound law rests on K_eff and energy. It has the weaker status and the smaller share of tested effects of the two.
  EXPECT_EQ(bounds.upper->status, Status::interpolated);
  EXPECT_EQ(bounds.lower->status, Status::extrapolated);
  EXPECT_EQ(bounds.lower->share_shown, 0.528110688);
  EXPECT_EQ(wording::remark(about_bound("lower", *bounds.lower)),
            "lower bound over the design conditions (extrapolated; 53 % of it rests on tests at such conditions or "
            "between them): K_eff times 0.705 and energy times 0.666 in the reference cycle; the elastic part of the "
            "force times 0.714, the hysteretic part times 0.666");
}

TEST(DesignBounds, say_when_one_factor_takes_their_place) {
  auto summary = example();
  summary.conditions->bounds[0].max.factor = 0.7;
  summary.conditions->bounds[1].max.factor = 4.0;
  auto const bounds = design_bounds(summary, laws::find_law("bilinear"), of_bilinear);
  ASSERT_FALSE(bounds.obstacle);
  auto const sentence = wording::remark(about_bound("upper", *bounds.upper));
  EXPECT_TRUE(
      sentence.ends_with("the whole force times 0.700, since no positive factors on the two parts give both; "
                         "damping unchanged: energy is off by -82.5 %"))
      << sentence;
}

TEST(DesignBounds, are_missing_with_the_reason) {
  auto const reason = [](Summary const& summary, std::string_view law, std::vector<double> const& parameters) {
    auto const bounds = design_bounds(summary, laws::find_law(law), parameters);
    EXPECT_FALSE(bounds.lower || bounds.upper);
    return bounds.obstacle ? wording::remark(*bounds.obstacle) : std::string();
  };
  std::string const none = "no bound law over the design conditions: ";
  EXPECT_EQ(reason({}, "bilinear", of_bilinear), none + "the lot file has no table of conditions");
  Summary unread;
  unread.no_conditions = "no test can be used";
  EXPECT_EQ(reason(unread, "bilinear", of_bilinear), none + "no test can be used");
  auto open = example();
  open.conditions->bounds[0].max.not_covered = {conditions::Effect::temperature, conditions::Effect::rate};
  open.conditions->bounds[1].min.not_covered = {conditions::Effect::rate};
  EXPECT_EQ(reason(open, "bilinear", of_bilinear), none + "no test covers temperature, rate");
  auto undesigned = example();
  undesigned.conditions->bounds.clear();
  EXPECT_EQ(reason(undesigned, "bilinear", of_bilinear), none + "the design in the table of conditions names none");
  auto timeless = example();
  timeless.conditions->tests[0].condition.frequency_Hz.reset();
  EXPECT_EQ(reason(timeless, "jankowski", std::vector<double>(11, 1.0)),
            none + "this law depends on velocity, and the frequency of the reference tests is not known");
  EXPECT_TRUE(design_bounds(timeless, laws::find_law("bilinear"), of_bilinear).upper);
  EXPECT_EQ(reason(example(), "bilinear", {1.0, 1.0, 10.0}),
            none + "K_eff or energy of this law is not above 0 in cycles of 208 mm");
}

}  // namespace
}  // namespace isolaw::study
