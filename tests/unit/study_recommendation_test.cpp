// The recommended law in cases whose answer is known.
#include "isolaw/study/recommendation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/study/build_analysis.hpp"

namespace isolaw::study {
namespace {

struct Law {
  std::string id;
  std::vector<double> errors;  // least objective on each device
  std::vector<double> left_out = {};
  std::optional<double> predicted = {};
  int parameters = 4, open = 0, at_bound = 0;
  std::optional<double> found = 1.0;
};

double mean(std::vector<double> const& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

LawResult result_of(Law const& of) {
  LawResult law;
  law.id = of.id;
  law.objective = {mean(of.errors), 0.0, std::ranges::min(of.errors)};
  law.objective_converged = mean(of.errors);
  law.success_share = of.found;
  if (!of.left_out.empty()) law.loo_objective = mean(of.left_out);
  if (of.predicted) {
    law.predicted_objective = of.predicted;
    law.worst_predicted = of.predicted;
    law.fitted_objective = mean(of.errors);
    law.prediction_grade = graded(mean(of.errors), *of.predicted, *of.predicted);
  }
  for (std::size_t d = 0; d < of.errors.size(); ++d) {
    DeviceFit fit;
    fit.device = "D" + std::to_string(d);
    fit.runs = 1;
    fit.objective = {of.errors[d], 0.0, of.errors[d]};
    fit.optimum = of.errors[d];
    fit.K_eff_error_percent = fit.energy_error_percent = 1.0;
    if (!of.left_out.empty()) fit.left_out_objective = of.left_out[d];
    if (of.predicted) fit.blocks = {{1, true, of.errors[d]}, {2, false, *of.predicted}};
    for (int p = 0; p < of.parameters; ++p) {
      ParameterFit parameter;
      parameter.name = "p" + std::to_string(p);
      parameter.value = {1.0, 0.0, 1.0};
      parameter.upper = 2.0;
      if (p < of.at_bound) parameter.at_bound = fit::AtBound::upper;
      parameter.analysis = ParameterAnalysis{};
      parameter.analysis->identifiability =
          p < of.open ? analysis::Verdict::undetermined : analysis::Verdict::determined;
      fit.parameters.push_back(parameter);
    }
    law.devices.push_back(fit);
  }
  return law;
}

Summary summary_of(std::vector<Law> const& laws) {
  Summary summary;
  for (std::size_t d = 0; d < laws.front().errors.size(); ++d) {
    DeviceResult device;
    device.name = "D" + std::to_string(d);
    device.status = "ok";
    summary.devices.push_back(device);
  }
  for (auto const& law : laws) summary.laws.push_back(result_of(law));
  return summary;
}

Recommendation of(Summary const& summary, Purpose purpose) {
  auto const all = recommendations(summary);
  EXPECT_EQ(all.size(), 3u);
  return all.at(static_cast<std::size_t>(purpose));
}

std::string law_of(Summary const& summary, Recommendation const& recommendation) {
  return recommendation.law ? summary.laws[*recommendation.law].id : "none";
}

TEST(Recommendation, OfAClearWinnerIsClear) {
  auto const summary = summary_of(
      {{"near", {0.02, 0.021, 0.022}, {0.03, 0.031, 0.032}}, {"far", {0.08, 0.081, 0.082}, {0.09, 0.091, 0.092}}});
  for (auto const purpose : {Purpose::untested_device, Purpose::these_tests, Purpose::simplest}) {
    auto const recommendation = of(summary, purpose);
    EXPECT_EQ(law_of(summary, recommendation), "near");
    EXPECT_EQ(recommendation.sure, Sure::clear) << recommendation.why;
    EXPECT_TRUE(recommendation.ties.empty());
  }
  EXPECT_NEAR(*of(summary, Purpose::untested_device).error, 0.031, 1e-12);
  EXPECT_NEAR(*of(summary, Purpose::these_tests).error, 0.021, 1e-12);
}

TEST(Recommendation, OfLawsWithinTheScatterOfTheDevicesIsATie) {
  auto const summary = summary_of({{"a", {0.030, 0.050, 0.040}, {0.040, 0.060, 0.050}, {}, 9},
                                   {"b", {0.045, 0.035, 0.043}, {0.055, 0.045, 0.054}, {}, 4}});
  auto const recommendation = of(summary, Purpose::untested_device);
  EXPECT_EQ(recommendation.sure, Sure::tie) << recommendation.why;
  EXPECT_EQ(law_of(summary, recommendation), "b");  // law b has fewer parameters
  EXPECT_EQ(recommendation.ties, std::vector<std::size_t>{0});
  EXPECT_TRUE(contains(recommendation.why, "a differs from it by less than the scatter over the devices"))
      << recommendation.why;
  EXPECT_FALSE(recommendation.surer.empty());
}

// A law may be closest to the tests used for its fit and still predict other tests badly.
TEST(Recommendation, IsNeverALawThatPredictsBadly) {
  auto const summary =
      summary_of({{"overfit", {0.01}, {}, 2.7}, {"poor", {0.015}, {}, 0.4}, {"sound", {0.05}, {}, 0.08}});
  for (auto const& recommendation : recommendations(summary))
    EXPECT_EQ(law_of(summary, recommendation), "sound") << recommendation.why;
  EXPECT_TRUE(contains(of(summary, Purpose::these_tests).why,
                       "overfit is nearer to the tests (1.0 %), but its prediction is unusable"));
}

TEST(Recommendation, OfAFairPredictionIsWeakAndOneDeviceTiesByShare) {
  auto const summary = summary_of(
      {{"bouc-wen", {0.072}, {}, 0.190, 6}, {"abe", {0.047}, {}, 0.210, 13}, {"bilinear", {0.098}, {}, 0.240, 3}});
  auto const recommendation = of(summary, Purpose::untested_device);
  EXPECT_EQ(law_of(summary, recommendation), "bouc-wen");
  EXPECT_EQ(recommendation.ties, std::vector<std::size_t>{1});
  EXPECT_EQ(recommendation.sure, Sure::weak);
  EXPECT_TRUE(contains(recommendation.why, "Abe differs from it by less than one device can tell"))
      << recommendation.why;
  EXPECT_EQ(recommendation.weak.front().kind, FindingKind::weak_prediction_fair);
  EXPECT_EQ(law_of(summary, of(summary, Purpose::simplest)), "bilinear");
}

TEST(Recommendation, IsNoneWhereAllCollapse) {
  auto const summary = summary_of({{"a", {0.03}, {}, 5.0}, {"b", {0.06}, {}, 0.5}});
  for (auto const& recommendation : recommendations(summary)) {
    EXPECT_FALSE(recommendation.law);
    EXPECT_FALSE(recommendation.error);
    EXPECT_EQ(recommendation.why.front().kind, FindingKind::none_predicts);
    EXPECT_EQ(recommendation.why.front().other_laws, (std::vector<std::string>{"a", "b"}));
  }
  EXPECT_TRUE(contains(study::verdict(recommendations(summary)), "No law can be recommended"));
}

TEST(Recommendation, OfOneDeviceFittedWholeIsForTheseTestsAlone) {
  auto const summary = summary_of({{"a", {0.03}}, {"b", {0.08}}});
  auto const untested = of(summary, Purpose::untested_device);
  EXPECT_FALSE(untested.law);
  EXPECT_TRUE(contains(untested.why, "nothing shows how a law holds elsewhere")) << untested.why;
  EXPECT_TRUE(contains(untested.surer, "leave it out of the fit")) << untested.surer;
  EXPECT_EQ(law_of(summary, of(summary, Purpose::these_tests)), "a");
  EXPECT_EQ(
      wording::sentence(*study::verdict(recommendations(summary))),
      "For these tests take a: it is 3.0 % off fitted to each device. For other devices or amplitudes no law can be recommended.");
}

TEST(Recommendation, IsWeakWhereTheSearchDidNotConverge) {
  auto summary =
      summary_of({{"a", {0.03, 0.031}, {0.04, 0.041}, {}, 4, 0, 0, 0.1}, {"b", {0.08, 0.081}, {0.09, 0.091}}});
  auto const recommendation = of(summary, Purpose::these_tests);
  EXPECT_EQ(law_of(summary, recommendation), "a");
  EXPECT_EQ(recommendation.sure, Sure::weak);
  EXPECT_TRUE(contains(recommendation.weak, "only 10 % of its searches reached the best fit found"))
      << recommendation.weak;
  summary = summary_of({{"a", {0.03, 0.031}, {0.04, 0.041}}});
  summary.expected_runs = 10;
  EXPECT_EQ(of(summary, Purpose::these_tests).sure, Sure::weak);
}

TEST(Recommendation, IsWeakWhereTheTestsLeaveParametersOpenOrTheBoxHoldsThem) {
  Law const other{"b", {0.08, 0.081, 0.082}, {0.09, 0.091, 0.092}};
  auto const open = summary_of({{"a", {0.03, 0.031, 0.032}, {0.04, 0.041, 0.042}, {}, 4, 3}, other});
  EXPECT_EQ(of(open, Purpose::untested_device).sure, Sure::weak);
  EXPECT_EQ(of(open, Purpose::these_tests).sure, Sure::clear);
  auto const held = summary_of({{"a", {0.03, 0.031, 0.032}, {0.04, 0.041, 0.042}, {}, 4, 0, 2}, other});
  EXPECT_EQ(of(held, Purpose::untested_device).sure, Sure::weak) << of(held, Purpose::untested_device).why;
}

// With a single law there is no comparison, so the recommendation is weak even if the error is small.
TEST(Recommendation, OfTheOnlyLawIsWeak) {
  auto const summary = summary_of({{"only", {0.02, 0.021, 0.022}, {0.03, 0.031, 0.032}}});
  for (auto const& recommendation : recommendations(summary)) {
    EXPECT_EQ(law_of(summary, recommendation), "only");
    EXPECT_EQ(recommendation.sure, Sure::weak) << recommendation.why;
    EXPECT_TRUE(contains(recommendation.answer, "Take only, with care: ")) << text_of(recommendation.answer);
    EXPECT_TRUE(contains(recommendation.weak, "no other law was identified to compare it with")) << recommendation.weak;
    EXPECT_TRUE(contains(recommendation.surer, "other laws to compare it with (--laws)")) << recommendation.surer;
  }
}

TEST(Recommendation, OfALawThatErrsByMoreThanATenthIsWeakForTheTestsToo) {
  auto const summary = summary_of({{"near", {0.12, 0.121}}, {"far", {0.2, 0.201}}});
  for (auto const purpose : {Purpose::these_tests, Purpose::simplest})
    EXPECT_EQ(of(summary, purpose).sure, Sure::weak) << of(summary, purpose).why;
  EXPECT_EQ(
      text_of(of(summary, Purpose::these_tests).answer),
      "For these tests take near, with care: it is 12 % off fitted to each device. For other devices or amplitudes no law can be recommended.");
  EXPECT_TRUE(contains(of(summary, Purpose::simplest).answer, " For other devices or amplitudes no law can be"));
}

TEST(Recommendation, LeavesOutALawThatWasRefusedOnADevice) {
  auto summary = summary_of({{"partial", {0.01, 0.011}, {0.02, 0.021}}, {"whole", {0.05, 0.051}, {0.06, 0.061}}});
  summary.laws[0].devices[1] = DeviceFit{};
  summary.laws[0].devices[1].device = "D1";
  summary.laws[0].devices[1].refusal = "no time channel";
  for (auto const& recommendation : recommendations(summary)) EXPECT_EQ(law_of(summary, recommendation), "whole");
  // A device that could not be read does not change the choice.
  DeviceResult refused;
  refused.name = "bad";
  refused.status = "refused";
  summary.devices.push_back(refused);
  for (auto const& recommendation : recommendations(summary)) EXPECT_EQ(law_of(summary, recommendation), "whole");
}

TEST(Recommendation, OfTheSimplestMayLoseHalfOfTheBest) {
  auto const summary = summary_of({{"best", {0.040, 0.041, 0.042}, {0.05, 0.051, 0.052}, {}, 12},
                                   {"plain", {0.055, 0.056, 0.057}, {0.070, 0.071, 0.072}, {}, 3},
                                   {"rough", {0.09, 0.091, 0.092}, {0.10, 0.11, 0.12}, {}, 2}});
  auto const recommendation = of(summary, Purpose::simplest);
  EXPECT_EQ(law_of(summary, recommendation), "plain") << recommendation.why;
  EXPECT_TRUE(contains(recommendation.why,
                       "with 3 parameters. The most accurate law, best, is 5.1 % off and has 12 parameters"))
      << recommendation.why;
}

TEST(Recommendation, OfAnInspectionIsNone) {
  EXPECT_TRUE(recommendations(Summary{}).empty());
  EXPECT_FALSE(study::verdict({}));
}

}  // namespace
}  // namespace isolaw::study
