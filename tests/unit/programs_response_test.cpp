// If an export replaces a law by another law that was fitted to it, isolaw compares the response of a rigid mass on a
// bearing with either law. These tests check what the export says about this comparison.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contains.hpp"
#include "isolaw/wording/table.hpp"
#include "unit/programs_models.hpp"

namespace isolaw::programs_test {
namespace {

RefitResponse response(Subject const& subject, std::string_view law, std::vector<double> const& parameters) {
  return BuildingOnLaw(subject).compare("the stand-in", laws::find_law(law), parameters);
}

// Returns a spring of stiffness k, as a bilinear law.
std::vector<double> spring(double k) {
  return {k, k, 18.0};
}

TEST(Responses, of_the_law_itself_are_not_off) {
  auto const found = response(subject_of("bouc-wen", bouc_wen_parameters), "bouc-wen", bouc_wen_parameters);
  ASSERT_TRUE(found.finding);
  EXPECT_EQ(found.finding->kind, FindingKind::refit_response);
  for (auto const* name : {"disp_percent", "shear_percent", "disp_least_percent", "shear_most_percent"})
    EXPECT_EQ(found.finding->number(name, 1.0), 0.0) << name;
  EXPECT_EQ(found.why_not, "");
}

TEST(Responses, without_a_motion_reach_the_tested_displacement_under_the_artificial_ones) {
  auto const subject = subject_of("bouc-wen", bouc_wen_parameters);
  auto const found = response(subject, "bilinear", bilinear_parameters);
  ASSERT_EQ(found.motions.size(), 7U);
  for (auto const& each : found.motions) {
    EXPECT_LE(each.law_disp_mm, 150.0);
    EXPECT_GE(each.law_disp_mm, 0.98 * 150.0);
    EXPECT_TRUE(contains(building_text(subject, found, unit_systems[0]), each.motion));
  }
}

// If the ground acceleration jumps from 0 to a and stays there, a mass m on a spring k moves by at most 2 m a/k. The
// largest force is 2 m a, whatever k is.
TEST(Responses, of_springs_are_those_of_the_closed_form) {
  auto subject = subject_of("bilinear", spring(1.0));
  constexpr double acceleration = 500.0;
  subject.motions = {{.file = "sudden.csv",
                      .step_s = 0.01,
                      .acceleration_mm_s2 = std::vector<double>(500, acceleration),
                      .recognised = "made here"}};
  auto const found = response(subject, "bilinear", spring(4.0));
  ASSERT_TRUE(found.finding);
  ASSERT_EQ(found.motions.size(), 1U);
  // The mass has the period of 2.5 s. Steps of 0.005 s are 1/250 of the period with the stiffer spring.
  EXPECT_DOUBLE_EQ(found.period_s, usual_period_s);
  double const mass = std::pow(usual_period_s / (2.0 * std::numbers::pi), 2);
  EXPECT_NEAR(found.mass_Mg, 1e3 * mass, 1e-9);
  EXPECT_NEAR(found.motions[0].law_disp_mm, 2.0 * mass * acceleration, 1e-3 * 2.0 * mass * acceleration);
  EXPECT_NEAR(found.motions[0].refit_shear_kN, 2.0 * mass * acceleration, 1e-3 * 2.0 * mass * acceleration);
  EXPECT_NEAR(found.finding->number("disp_percent"), -75.0, 0.1);
  EXPECT_NEAR(found.finding->number("shear_percent"), 0.0, 0.1);
  EXPECT_EQ(found.finding->kind, FindingKind::refit_response_off);
  auto const said = wording::sentence(*found.finding);
  EXPECT_TRUE(said.starts_with(
      "Bilinear: with the stand-in in its place, a building's peak displacement is off by -75.0 % and "))
      << said;
  EXPECT_TRUE(said.ends_with(
      "0.0 % under sudden.csv. That is more than 10 %: use the law itself, or allow for it in the design."))
      << said;
}

// As in building codes, the worst motion counts if there are fewer than seven, and the mean over the motions otherwise.
TEST(Responses, under_few_motions_are_judged_by_the_worst) {
  auto subject = subject_of("bilinear", bilinear_parameters);
  for (double const size : {200.0, 900.0}) subject.motions.push_back(shaking(size));
  auto const of = [&] { return *response(subject, "bilinear", {2.5, 0.35, 18.0}).finding; };
  auto found = of();
  EXPECT_GT(found.number("shear_percent"), -response_off_percent);
  EXPECT_LT(found.number("shear_least_percent"), -response_off_percent);
  EXPECT_EQ(found.kind, FindingKind::refit_response_off);
  auto const said = wording::sentence(found);
  EXPECT_TRUE(contains(said, fmt::format("({:+.1f} to {:+.1f} %) under 2 motions", found.number("shear_least_percent"),
                                         found.number("shear_most_percent"))))
      << said;
  while (subject.motions.size() < 7) subject.motions.push_back(shaking(200.0));
  found = of();
  EXPECT_LT(found.number("shear_least_percent"), -response_off_percent);
  EXPECT_EQ(found.kind, FindingKind::refit_response);
}

TEST(Responses, take_mass_and_motion_of_a_model_and_the_load_of_the_tests) {
  auto subject = subject_of("bouc-wen", bouc_wen_parameters);
  subject.tested.load_min_kN = -1.0;  // the load begins with a ramp, so only its mean may give the mass
  subject.tested.load_max_kN = 110.0;
  subject.tested.load_mean_kN = 100.0;
  EXPECT_NEAR(response(subject, "bilinear", bilinear_parameters).mass_Mg, 100.0 / 9.80665, 1e-9);
  subject.model = four(450.0);
  subject.model->scale = 1.5;
  auto const found = response(subject, "bilinear", bilinear_parameters);
  EXPECT_NEAR(found.mass_Mg, carried_kN / 9.80665, 1e-9);
  ASSERT_EQ(found.motions.size(), 1U);
  EXPECT_EQ(found.motions[0].motion, "made here");
  subject.model->scale = 1.0;
  EXPECT_LT(response(subject, "bilinear", bilinear_parameters).motions[0].law_disp_mm, found.motions[0].law_disp_mm);
}

}  // namespace
}  // namespace isolaw::programs_test
