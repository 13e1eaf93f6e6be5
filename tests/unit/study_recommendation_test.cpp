// Tests which law is recommended in cases whose answer is known.
#include "isolaw/study/recommendation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
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
  std::optional<double> larger_swings = {};
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
  law.larger_swings_objective = law.larger_swings_least = of.larger_swings;
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

std::string law_of(Summary const& summary, Recommendation const& recommendation) {
  return recommendation.law ? summary.laws[*recommendation.law].id : "none";
}
std::vector<std::string> ties_of(Summary const& summary, Recommendation const& recommendation) {
  std::vector<std::string> ids;
  for (auto const& standing : recommendation.standings)
    if (standing.rank == Rank::tied) ids.push_back(summary.laws[standing.law].id);
  return ids;
}
Standing const& standing_of(Summary const& summary, Recommendation const& recommendation, std::string_view id) {
  return *std::ranges::find_if(recommendation.standings, [&](auto const& s) { return summary.laws[s.law].id == id; });
}
bool doubts(Recommendation const& recommendation, FindingKind kind) {
  return std::ranges::find(recommendation.doubts(), kind, &Finding::kind) != recommendation.doubts().end();
}
Finding runs_away(std::string_view rule) {
  return {.kind = FindingKind::law_runs_away,
          .numbers = {{"amplitude_mm", 200.0}, {"value", 4.3}, {"tested_mm", 100.0}},
          .words = {{"rule", std::string(rule)}}};
}

// The mean error of a law is the mean of its error in the fit and its error on larger swings. It is least for B. C ties
// with B, since its mean error is at most 10 % larger, and C has fewer parameters, so C must be recommended.
TEST(Recommendation, TakesTheFewestParametersAmongTiedLaws) {
  auto summary = summary_of({{"A", {0.080}, {}, {}, 4, 0, 0, 1.0, 0.120},
                             {"B", {0.070}, {}, {}, 7, 0, 0, 1.0, 0.090},
                             {"C", {0.072}, {}, {}, 6, 0, 0, 1.0, 0.091}});
  auto advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "C");
  EXPECT_EQ(ties_of(summary, advice), std::vector<std::string>{"B"});
  EXPECT_NEAR(*standing_of(summary, advice, "A").error, 0.100, 1e-12);
  EXPECT_NEAR(*standing_of(summary, advice, "B").error, 0.080, 1e-12);
  EXPECT_NEAR(*standing_of(summary, advice, "C").error, 0.0815, 1e-12);
  EXPECT_EQ(wording::paragraph(advice.answer),
            "Take C. It gives back what it was fitted to within 7.2 %, and larger swings that it was not fitted to "
            "within 9.1 %. B is as good.");
  EXPECT_EQ(export_command(summary, advice, "out/lot"),
            "isolaw export out/lot --law C --device D0 --to openseespy-law");
  EXPECT_TRUE(contains(advice.reasons, "The next best, A, has a mean error of 10 %")) << advice.reasons;

  summary.laws[2].larger_swings_objective = 0.1042;  // a mean error of 0.0881, more than 1.10 times that of B
  EXPECT_EQ(law_of(summary, *recommendation(summary)), "B");
  summary.laws[2].larger_swings_objective = 0.091;
  summary.laws[1].runs_away = runs_away("stiffness");
  advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "C");
  EXPECT_TRUE(ties_of(summary, advice).empty());
  EXPECT_EQ(wording::remark(*standing_of(summary, advice, "B").reason),
            "its stiffness at 200 mm is 4.30 times that at 100 mm, where the tests end");
  EXPECT_TRUE(contains(advice.reasons, "B has a smaller mean error (8.0 %), but is ruled out")) << advice.reasons;
}

// In a lot of three devices or more, the error on a device that was left out of the fit takes the place of the fit's
// own error.
TEST(Recommendation, AnswersForADeviceNobodyTested) {
  std::vector<Law> const laws{{"near", {0.02, 0.021, 0.022}, {0.09, 0.091, 0.092}},
                              {"sound", {0.05, 0.051, 0.052}, {0.06, 0.061, 0.062}}};
  auto const lot = summary_of(laws);
  EXPECT_EQ(law_of(lot, *recommendation(lot)), "sound");
  EXPECT_NEAR(*recommendation(lot)->standings.front().error, 0.061, 1e-12);
  EXPECT_TRUE(contains(recommendation(lot)->answer, "It gives back a device that it was not fitted to within 6.1 %."));
  EXPECT_TRUE(contains(recommendation(lot)->answer, "Nothing shows how it goes on to a larger amplitude."));
  auto two = laws;
  for (auto& law : two) law.errors.resize(2), law.left_out.resize(2);
  auto const pair = summary_of(two);
  EXPECT_EQ(law_of(pair, *recommendation(pair)), "near");
  EXPECT_NEAR(*recommendation(pair)->standings.front().error, 0.0205, 1e-12);
}

// A law may be closest to the tests used for its fit and still predict other tests badly. It must not be recommended.
TEST(Recommendation, IsNeverALawThatPredictsBadly) {
  auto const summary =
      summary_of({{"overfit", {0.01}, {}, 2.7}, {"poor", {0.015}, {}, 0.4}, {"sound", {0.05}, {}, 0.08}});
  auto const advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "sound") << advice.reasons;
  EXPECT_EQ(standing_of(summary, advice, "overfit").reason->kind, FindingKind::out_prediction);
}

TEST(Recommendation, IsNoneWhereAllAreRuledOut) {
  auto summary = summary_of({{"a", {0.03}, {}, 5.0}, {"b", {0.06}, {}, 0.5}});
  auto advice = *recommendation(summary);
  EXPECT_FALSE(advice.law);
  EXPECT_EQ(advice.reasons.front().kind, FindingKind::none_predicts);
  EXPECT_EQ(advice.reasons.front().other_laws, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(text_of(advice.answer), "No law can be recommended.");
  EXPECT_FALSE(advice.improvements.empty());
  summary = summary_of({{"a", {0.03}}, {"b", {0.06}}});
  for (auto& law : summary.laws) law.runs_away = runs_away("not-finite");
  EXPECT_EQ(recommendation(summary)->reasons.front().kind, FindingKind::none_for_a_building);
  summary = summary_of({{"a", {0.03}, {}, {}, 4, 0, 0, 1.0, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(wording::remark(*recommendation(summary)->standings.front().reason),
            "fitted to the smaller swings of the tests, its force is not finite in the larger ones");
}

TEST(Recommendation, IsNoneWhereTheLeastErrorIsTooLargeOrTheEnergyOfTheLargestCyclesIsOff) {
  auto summary = summary_of({{"a", {0.31}}, {"b", {0.35}}});
  EXPECT_EQ(recommendation(summary)->reasons.front().kind, FindingKind::none_describes);
  EXPECT_TRUE(contains(recommendation(summary)->reasons, "The law of least error, a, has a mean error of 31 %"));
  summary = summary_of({{"a", {0.08}}, {"b", {0.081}}, {"c", {0.2}}});
  summary.laws[0].devices[0].energy_error_percent = summary.laws[1].devices[0].energy_error_percent = -35.0;
  auto advice = *recommendation(summary);
  EXPECT_FALSE(advice.law);
  EXPECT_EQ(advice.reasons.front().kind, FindingKind::none_energy);
  EXPECT_EQ(advice.reasons.front().other_laws, (std::vector<std::string>{"a", "b"}));
  summary.laws[1].devices[0].energy_error_percent = 20.0;
  advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "a");
  EXPECT_TRUE(doubts(advice, FindingKind::weak_cycle_energy));
  // For a device with little damping, here 4 %, the error of the damping is judged in place of that of the energy, so
  // the energy may be far off.
  summary.laws[1].devices[0].energy_error_percent = -35.0;
  summary.devices[0].notes = {{.kind = FindingKind::largest_swings, .numbers = {{"damping_percent", 4.0}}}};
  summary.laws[0].devices[0].damping_error_percent = 60.0;
  advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "a");
  EXPECT_TRUE(doubts(advice, FindingKind::weak_cycle_damping));
  EXPECT_FALSE(doubts(advice, FindingKind::weak_cycle_energy));
}

TEST(Recommendation, NamesEveryDoubt) {
  auto const with = [](auto change) {
    auto summary = summary_of({{"a", {0.030}}, {"b", {0.08}}});
    change(summary.laws[0], summary);
    return *recommendation(summary);
  };
  EXPECT_EQ(with([](auto&, auto&) {}).confidence, Confidence::clear);
  auto const doubt = [&](FindingKind kind, auto change) {
    auto const advice = with(change);
    return advice.confidence == Confidence::weak && advice.doubts().size() == 1 && doubts(advice, kind);
  };
  using enum FindingKind;
  EXPECT_TRUE(doubt(weak_larger_swings, [](auto& law, auto&) { law.larger_swings_objective = 0.061; }));
  EXPECT_FALSE(doubt(weak_larger_swings, [](auto& law, auto&) { law.larger_swings_objective = 0.059; }));
  EXPECT_TRUE(doubt(weak_cycle_stiffness, [](auto& law, auto&) { law.devices[0].K_eff_error_percent = -16.0; }));
  EXPECT_TRUE(doubt(weak_stiffness_beyond, [](auto& law, auto&) {
    law.beyond_tests = BeyondTests{.tested_mm = 100.0, .asked_mm = 200.0, .stiffness_ratio = 1.6, .damping_ratio = 1.0};
  }));
  EXPECT_TRUE(doubt(weak_damping_beyond, [](auto& law, auto&) {
    law.beyond_tests = BeyondTests{.tested_mm = 100.0, .asked_mm = 200.0, .stiffness_ratio = 1.0, .damping_ratio = 0.3};
  }));
  auto const tried_at = [](double asked_mm) {
    return [=](auto& law, auto&) {
      law.beyond_tests =
          BeyondTests{.tested_mm = 100.0, .asked_mm = asked_mm, .stiffness_ratio = 1.0, .damping_ratio = 1.0};
    };
  };
  EXPECT_TRUE(doubt(weak_far_beyond, tried_at(210.0)));
  EXPECT_EQ(std::ranges::count(with(tried_at(210.0)).improvements, surer_design, &Finding::kind), 1);
  EXPECT_EQ(with(tried_at(200.0)).confidence, Confidence::clear);
  EXPECT_TRUE(doubt(weak_one_sided, [](auto&, Summary& summary) {
    summary.devices[0].record.disp_mm = {0.0, 100.0, -49.0};
  }));
  auto const pulled = with([](auto&, Summary& summary) { summary.devices[0].record.disp_mm = {0.0, 100.0, 0.0}; });
  EXPECT_TRUE(std::ranges::count(pulled.improvements, surer_both_sides, &Finding::kind));
  EXPECT_TRUE(doubt(weak_search, [](auto& law, auto&) { law.success_share = 0.1; }));
  EXPECT_TRUE(doubt(weak_incomplete, [](auto&, Summary& summary) { summary.expected_runs = 10; }));
  auto const fair = summary_of({{"a", {0.09}, {}, 0.16}, {"b", {0.3}, {}, 0.29}});
  EXPECT_TRUE(doubts(*recommendation(fair), weak_prediction_fair));
  auto const large = summary_of({{"a", {0.21}}, {"b", {0.29}}});
  EXPECT_TRUE(doubts(*recommendation(large), weak_error));
}

TEST(Recommendation, IsWeakWhereTheTestsLeaveParametersOpenOrTheBoxHoldsThem) {
  Law const other{"b", {0.08, 0.081, 0.082}, {0.09, 0.091, 0.092}};
  auto open = summary_of({{"a", {0.03, 0.031, 0.032}, {0.04, 0.041, 0.042}, {}, 4, 3}, other});
  EXPECT_TRUE(doubts(*recommendation(open), FindingKind::weak_open));
  open.laws[0].larger_swings_objective = 0.05;  // larger swings show that the open parameters do no harm
  EXPECT_FALSE(doubts(*recommendation(open), FindingKind::weak_open));
  auto const held = summary_of({{"a", {0.03, 0.031, 0.032}, {0.04, 0.041, 0.042}, {}, 4, 0, 2}, other});
  EXPECT_TRUE(doubts(*recommendation(held), FindingKind::weak_bounds));
}

// With a single law there is no comparison, so the recommendation is weak even if the error is small.
TEST(Recommendation, OfTheOnlyLawIsWeak) {
  auto const summary = summary_of({{"only", {0.02, 0.021, 0.022}, {0.03, 0.031, 0.032}}});
  auto const advice = *recommendation(summary);
  EXPECT_EQ(law_of(summary, advice), "only");
  EXPECT_EQ(advice.confidence, Confidence::weak) << advice.reasons;
  EXPECT_TRUE(contains(advice.answer, "Take only, with care. ")) << text_of(advice.answer);
  EXPECT_TRUE(contains(advice.doubts(), "no other law was identified to compare it with"));
  EXPECT_TRUE(contains(advice.improvements, "other laws to compare it with (--laws)")) << advice.improvements;
}

TEST(Recommendation, LeavesOutALawThatWasRefusedOnADevice) {
  auto summary = summary_of({{"partial", {0.01, 0.011}, {0.02, 0.021}}, {"whole", {0.05, 0.051}, {0.06, 0.061}}});
  summary.laws[0].devices[1] = DeviceFit{};
  summary.laws[0].devices[1].device = "D1";
  summary.laws[0].devices[1].refusal = "no time channel";
  EXPECT_EQ(law_of(summary, *recommendation(summary)), "whole");
  EXPECT_TRUE(doubts(*recommendation(summary), FindingKind::weak_only_law));
  // A device that could not be read does not change the choice.
  DeviceResult refused;
  refused.name = "bad";
  refused.status = "refused";
  summary.devices.push_back(refused);
  EXPECT_EQ(law_of(summary, *recommendation(summary)), "whole");
}

// Predictions of blocks that were left out of the fit count as predictions of larger swings only if one of these blocks
// has the largest amplitude of the test.
TEST(Recommendation, TakesBlocksOfLargerAmplitudeForLargerSwings) {
  auto summary = summary_of({{"a", {0.04}, {}, 0.06}, {"b", {0.05}, {}, 0.07}});
  data::Block small, large;
  small.number = 1, small.amplitude_mm = 50.0;
  large.number = 2, large.amplitude_mm = 100.0;
  summary.devices[0].properties.blocks = {small, large};
  EXPECT_NEAR(*recommendation(summary)->standings.front().predicts, 0.06, 1e-12);
  EXPECT_TRUE(contains(recommendation(summary)->answer, "and blocks that it was not fitted to within 6.0 %"));
  summary.laws[0].larger_swings_objective = 0.2;
  EXPECT_FALSE(doubts(*recommendation(summary), FindingKind::weak_larger_swings));
  summary.laws[0].larger_swings_objective = {};
  summary.devices[0].properties.blocks[0].amplitude_mm = 200.0;
  EXPECT_FALSE(recommendation(summary)->standings.front().predicts);
  EXPECT_NEAR(*recommendation(summary)->standings.front().error, 0.04, 1e-12);
}

// The recommendation states the range of stiffness and energy over several laws. These must be the five laws of least
// error that are not ruled out. Law 1 is ruled out here, and law 6 has the largest error.
TEST(Recommendation, SaysHowFarTheBestLawsDisagree) {
  std::vector<Law> laws;
  for (int i = 0; i < 7; ++i) laws.push_back({"law" + std::to_string(i), {0.03 + 0.01 * i}});
  auto summary = summary_of(laws);
  for (int i = 0; i < 7; ++i)
    summary.laws[static_cast<std::size_t>(i)].beyond_tests = BeyondTests{.tested_mm = 100.0,
                                                                         .asked_mm = 200.0,
                                                                         .K_kN_per_mm = 1.0 + i,
                                                                         .energy_kN_mm = 10.0 - i,
                                                                         .stiffness_ratio = 1.0,
                                                                         .damping_ratio = 1.0};
  summary.laws[1].runs_away = runs_away("jumps");
  auto const spread = *recommendation(summary)->spread;
  EXPECT_EQ(spread.count, 5u);
  EXPECT_EQ(spread.disp_mm, 200.0);
  EXPECT_EQ(spread.K_low_kN_per_mm, 1.0);
  EXPECT_EQ(spread.K_high_kN_per_mm, 6.0);
  EXPECT_EQ(spread.energy_low_kN_mm, 5.0);
  EXPECT_EQ(spread.energy_high_kN_mm, 10.0);
}

TEST(Recommendation, OfAnInspectionIsNone) {
  EXPECT_FALSE(recommendation(Summary{}));
}

}  // namespace
}  // namespace isolaw::study
