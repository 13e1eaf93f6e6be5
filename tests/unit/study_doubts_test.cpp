// Tests the grades of prediction, the adequacy of laws, parameters that only the search box limits, and the warnings
// for a law that a user takes from a campaign. docs/decision.md explains them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "contains.hpp"
#include "finding_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/study/findings.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::study {
namespace {

TEST(Prediction, IsGradedByTheMeanOnThePredictedBlocks) {
  using enum PredictionGrade;
  EXPECT_EQ(graded(0.02, 0.03, 0.05), good);
  EXPECT_EQ(graded(0.02, 0.10, 0.15), good);
  EXPECT_EQ(graded(0.05, 0.1001, 0.15), fair);
  EXPECT_EQ(graded(0.05, 0.30, 0.35), fair);
  EXPECT_EQ(graded(0.05, 0.3001, 0.35), poor);
  EXPECT_EQ(graded(0.07, 0.60, 0.65), poor);
  EXPECT_EQ(graded(0.07, 0.6001, 0.65), unusable);
}

TEST(Prediction, CollapsesWhereABlockIsLostOrFarBeyondTheFit) {
  using enum PredictionGrade;
  EXPECT_EQ(graded(0.02, 0.08, 1.01), unusable);  // on one block the prediction is worse than a constant force
  EXPECT_EQ(graded(0.02, 0.20, 0.25), fair);      // ten times the error of the fit is still allowed
  EXPECT_EQ(graded(0.019, 0.20, 0.25), unusable);
  // This error is many times that of the fit, but too small to be called poor.
  EXPECT_EQ(graded(0.001, 0.19, 0.19), fair);
  double const nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(graded(0.02, nan, nan), unusable);
  EXPECT_EQ(graded(0.02, infinite, infinite), unusable);
}

LawResult& law(Summary& summary, std::string_view id) {
  return *std::ranges::find(summary.laws, id, &LawResult::id);
}

LawVerdict verdict(Summary const& summary, std::string_view id) {
  for (auto const& one : findings(summary).verdicts)
    if (summary.laws[one.law].id == id) return one;
  return {};
}

TEST(Adequacy, OfALawThatMissesTheForceOrTheStiffness) {
  auto summary = fixture::lot(10, 6);
  for (auto const& one : summary.laws) EXPECT_TRUE(is_adequate(one)) << one.id;
  law(summary, "jankowski").objective.mean = 0.51;
  EXPECT_EQ(inadequacy(law(summary, "jankowski"))->numbers, (std::vector<FindingNumber>{{"misfit", 0.51}}));
  for (auto& fit : law(summary, "bilinear").devices) fit.K_eff_error_percent = 467.0;
  EXPECT_EQ(inadequacy(law(summary, "bilinear"))->numbers,
            (std::vector<FindingNumber>{{"K_eff_error_percent", 467.0}}));
  for (auto const* id : {"jankowski", "bilinear"}) {
    EXPECT_EQ(verdict(summary, id).role, Role::inadequate) << id;
    EXPECT_FALSE(contains(findings(summary).headline, id)) << findings(summary).headline;
  }
  EXPECT_TRUE(contains(findings(summary).headline, "worth considering"));
  // A user who takes jankowski from the campaign is warned that it does not describe the devices.
  auto const with_it = doubts(summary, "jankowski", summary.devices.front().name).findings;
  EXPECT_TRUE(contains(
      with_it.front(),
      "Jankowski does not describe the devices. Its mean errors are too large: 51.0 % of the force's standard deviation."));
  for (auto& one : summary.laws) one.objective.mean = 0.5;
  EXPECT_TRUE(contains(findings(summary).headline, "No law describes these devices. The nearest is "))
      << findings(summary).headline;
}

// On half of the devices every parameter lies at its upper bound, so the parameters hardly scatter and beta is small.
// The law must not be called robust.
TEST(Adequacy, ParametersAtBoundsMakeNoLawRobust) {
  auto summary = fixture::lot(10, 6);
  EXPECT_EQ(verdict(summary, "bilinear").role, Role::most_robust);
  auto& robust = law(summary, "bilinear");
  EXPECT_FALSE(pinned(robust).decides());
  for (std::size_t d = 0; d < robust.devices.size() / 2; ++d)
    for (auto& p : robust.devices[d].parameters)
      if (p.free) p.at_bound = fit::AtBound::upper;
  EXPECT_TRUE(pinned(robust).decides());
  auto const found = verdict(summary, "bilinear");
  EXPECT_EQ(found.role, Role::held_by_box);
  EXPECT_TRUE(std::ranges::any_of(findings(summary).warnings, [](Finding const& warning) {
    return warning.kind == FindingKind::held_by_box && contains(warning, "so its beta does not show robustness");
  }));
  EXPECT_EQ(found.findings.back().kind, FindingKind::held_by_box);
  auto const headline = findings(summary).headline;
  EXPECT_TRUE(contains(headline, "3 of 6 laws are worth considering")) << headline;
  EXPECT_TRUE(contains(headline, "robustness (Vaiana)")) << headline;
}

TEST(Prediction, ThatIsPoorIsNoCompromiseAndIsSaid) {
  auto summary = fixture::lot(10, 6);
  ASSERT_EQ(verdict(summary, "vaiana").role, Role::compromise);
  auto& poor = law(summary, "vaiana");
  poor.prediction_grade = PredictionGrade::poor;
  poor.fitted_objective = 0.07, poor.predicted_objective = 0.45, poor.worst_predicted = 0.5;
  EXPECT_EQ(verdict(summary, "vaiana").role, Role::between);
  EXPECT_EQ(verdict(summary, "vaiana").findings.back().kind, FindingKind::prediction_poor);
  auto const found = doubts(summary, "vaiana", summary.devices.front().name);
  EXPECT_TRUE(contains(found.prediction, "poor: objective 0.45 on blocks it was not fitted to (0.5 at worst)"));
  EXPECT_FALSE(found.objection);
  poor.prediction_grade = PredictionGrade::unusable;
  EXPECT_TRUE(contains(doubts(summary, "vaiana", summary.devices.front().name).objection, "unusable"));
}

// doubts() for a law and a device must give only findings on this law and this device.
TEST(Doubts, AreOfTheLawAndTheDevice) {
  auto summary = fixture::lot();
  auto const devices = device_names(summary);
  auto& fit = law(summary, "bilinear").devices[0];
  fit.parameters[0].at_bound = fit::AtBound::lower;
  fit.integration_shift = -0.002;
  law(summary, "bilinear").devices[1].failed_runs = 3;
  auto& lot = law(summary, "bilinear").lot.emplace();
  lot.parameters = {1.0, 1.0, 1.0};
  lot.at_bound = {{"K2", fit::AtBound::upper}};
  summary.devices[0].raw.warnings = {stated("a channel may be late")};
  summary.expected_runs = summary.runs + 5;
  auto const of_first = doubts(summary, "bilinear", devices[0]).findings;
  for (auto const* part :
       {"runs are done", "at its lower bound on ", "finer integration step", "a channel may be late"})
    EXPECT_TRUE(contains(of_first, part)) << part << "\n" << of_first;
  for (auto const* part : {"runs failed", "vaiana", "in the one law for all"})
    EXPECT_FALSE(contains(of_first, part)) << part << "\n" << of_first;
  auto const of_second = doubts(summary, "bilinear", devices[1]).findings;
  EXPECT_TRUE(contains(of_second, "runs failed")) << of_second;
  EXPECT_FALSE(contains(of_second, "late")) << of_second;
  auto const of_lot = doubts(summary, "bilinear", std::nullopt).findings;
  for (auto const* part :
       {"a channel may be late", "runs failed", "in the one law for all devices, K2 at its upper bound"})
    EXPECT_TRUE(contains(of_lot, part)) << part << "\n" << of_lot;
}

void miss_the_stiffness(LawResult& law) {
  for (auto& fit : law.devices) fit.K_eff_error_percent = 467.0;
}

// A law that does not describe the devices must not exclude others from the front.
TEST(Adequacy, OfALawOnTheFrontHidesNoOther) {
  auto summary = fixture::lot(10, 6);
  ASSERT_EQ(verdict(summary, "bouc-wen").role, Role::dominated);  // vaiana alone dominates it
  miss_the_stiffness(law(summary, "vaiana"));
  EXPECT_EQ(verdict(summary, "bouc-wen").role, Role::compromise);
  EXPECT_TRUE(contains(findings(summary).headline, "4 of 6 laws are worth considering")) << findings(summary).headline;
  EXPECT_TRUE(law(summary, "vaiana").on_front) << "as published";
  EXPECT_EQ(verdict(summary, "hwang-wu").dominated_by, (std::vector<std::string>{"jankowski", "abe", "bouc-wen"}));
  summary = fixture::lot(10, 3);
  miss_the_stiffness(law(summary, "vaiana"));
  miss_the_stiffness(law(summary, "bilinear"));
  EXPECT_EQ(text_of(findings(summary).headline),
            "Hwang-Wu is both the most accurate and the most robust law of those that describe the devices.");
  EXPECT_EQ(verdict(summary, "hwang-wu").role, Role::best_of_both);
}

TEST(Adequacy, OfALawWithoutBetaLeavesTheNext) {
  auto summary = fixture::lot(1, 3);
  EXPECT_TRUE(contains(findings(summary).headline, "Vaiana is the most accurate law; how robust it is"));
  miss_the_stiffness(law(summary, "vaiana"));
  EXPECT_TRUE(contains(findings(summary).headline,
                       "Hwang-Wu is the most accurate law of those that describe the devices; how robust it is"))
      << findings(summary).headline;
  EXPECT_TRUE(contains(verdict(summary, "hwang-wu").findings, "the least of those that describe the devices"));
  EXPECT_TRUE(contains(verdict(summary, "bilinear").findings, "1.17 times that of Hwang-Wu"));
}

void hold_by_the_box(LawResult& law) {
  for (auto& fit : law.devices)
    for (auto& p : fit.parameters)
      if (p.free) p.at_bound = fit::AtBound::upper;
}

TEST(Adequacy, AFrontThatTheBoxHoldsHasNoRobustEnd) {
  auto summary = fixture::lot(10, 6);
  for (auto& one : summary.laws) hold_by_the_box(one);
  auto const headline = findings(summary).headline;
  EXPECT_TRUE(contains(headline, "Jankowski is the most accurate law; the laws that scatter less")) << headline;
  EXPECT_EQ(verdict(summary, "bilinear").role, Role::held_by_box);
  summary = fixture::lot(10, 2);
  law(summary, "vaiana").beta = 0.1;
  hold_by_the_box(law(summary, "vaiana"));
  EXPECT_EQ(verdict(summary, "vaiana").role, Role::most_accurate);
  EXPECT_TRUE(contains(findings(summary).headline, "Vaiana is the most accurate law; how robust it is"))
      << findings(summary).headline;
}

// A single device always agrees with itself, so the search box must not be named as the reason why devices agree.
TEST(Adequacy, OneDeviceIsHeldByNoBox) {
  auto summary = fixture::lot(1, 2);
  for (auto& one : summary.laws) hold_by_the_box(one);
  EXPECT_FALSE(contains(findings(summary).headline, "lie at a bound")) << findings(summary).headline;
}

TEST(Prediction, MayBeUnusableWithoutCollapsing) {
  auto summary = fixture::lot(10, 6);
  auto& worse = law(summary, "vaiana");
  worse.prediction_grade = PredictionGrade::unusable;
  worse.fitted_objective = 0.1, worse.predicted_objective = 0.65, worse.worst_predicted = 0.7;
  auto const said = [&] {
    auto found = findings(summary);
    auto all = found.headline;
    for (auto const& more : {verdict(summary, "vaiana").findings, found.converged, found.warnings})
      all.insert(all.end(), more.begin(), more.end());
    return wording::paragraph(all);
  };
  EXPECT_TRUE(contains(said(), "Vaiana: its prediction is unusable: objective 0.65")) << said();
  EXPECT_FALSE(contains(said(), "It misses")) << said();
  worse.fitted_objective = 0.0;
  EXPECT_TRUE(contains(said(), "It misses the predicted blocks, but not the fitted ones.")) << said();
  EXPECT_FALSE(contains(said(), "inf")) << said();
  worse.fitted_objective = 0.01;
  EXPECT_TRUE(contains(said(), "Its error on the predicted blocks is 65 times")) << said();
  worse.worst_predicted = 3.0;
  EXPECT_TRUE(contains(said(), "It misses one of the predicted blocks by more than the force's standard deviation"));
}

TEST(Adequacy, OfTheLotsLawForAnotherDevice) {
  auto summary = fixture::lot(10, 3);
  double objective = 0.05;
  for (auto& one : summary.laws) {
    one.loo_objective = objective += 0.05;
    one.loo_worst = 2.0 * objective;
    one.loo_worst_device = "D1";
  }
  auto const said = [&] { return wording::sentence(findings(summary).converged.front()); };
  EXPECT_TRUE(contains(said(), "with Bilinear, the least of all, and")) << said();
  miss_the_stiffness(law(summary, "bilinear"));
  EXPECT_TRUE(contains(said(), "with Vaiana, the least of those that describe the devices and predict, and")) << said();
}

std::string doubts_of(Summary const& summary, std::string_view id, std::optional<std::string_view> device) {
  std::string text;
  for (auto const& line : wording::sentences(doubts(summary, id, device).findings, wording::with_law))
    text += line + "\n";
  return text;
}

TEST(Doubts, OfDegradationAreOfTheLawAlone) {
  auto summary = fixture::lot();
  law(summary, "bilinear").devices[0].energy_fall = EnergyFall{1, 3, 12, 20.0, 1.0};
  law(summary, "vaiana").devices[0].energy_fall = EnergyFall{1, 3, 12, 20.0, 19.0};
  EXPECT_FALSE(std::ranges::any_of(findings(summary).warnings,
                                   [](auto const& warning) { return warning.kind == FindingKind::energy_falls; }));
  auto const said = doubts_of(summary, "bilinear", "D1");
  EXPECT_FALSE(contains(said, "No law follows")) << said;
  EXPECT_TRUE(contains(said, "Bilinear does not follow this fall (its own energy falls by 1 %)")) << said;
  EXPECT_TRUE(contains(said, "--fit-cycles")) << said;
  EXPECT_FALSE(contains(doubts_of(summary, "vaiana", "D1"), "energy of a cycle falls"));
  summary.settings.push_back({"fit-cycles", "\"2-\""});
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D1"), "--fit-cycles"));
}

// A user who takes a law from the campaign must see the doubts that the recommendation states about this law, and learn
// that no law is recommended.
TEST(Doubts, RepeatThoseOfTheAnswer) {
  auto summary = fixture::lot();
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D1"), "the design asks for"));
  for (auto& one : summary.laws)
    one.beyond_tests = BeyondTests{.tested_mm = 100.0, .asked_mm = 400.0, .stiffness_ratio = 1.0, .damping_ratio = 1.0};
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", "D1"),
                       "Bilinear: the design asks for 400 mm, 4.0 times the largest displacement tested"))
      << doubts_of(summary, "bilinear", "D1");
  for (auto& one : summary.laws)
    one.runs_away = Finding{.kind = FindingKind::law_runs_away, .words = {{"rule", "jumps"}}};
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", "D1"), "No law can be recommended."));
}

// A law is adequate or not for all devices together. A poor fit to one device does not change this.
TEST(Doubts, TakeAdequacyFromTheWhole) {
  auto summary = fixture::lot(10, 3);
  law(summary, "bilinear").devices[0].K_eff_error_percent = 60.0;
  ASSERT_TRUE(is_adequate(law(summary, "bilinear")));
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D1"), "does not describe the devices"));
  for (std::size_t d = 1; d < 10; ++d) law(summary, "bilinear").devices[d].K_eff_error_percent = 60.0;
  law(summary, "bilinear").devices[0].K_eff_error_percent = 1.0;
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", "D1"), "does not describe the devices"));
}

TEST(Doubts, OfADevicesStandingAreOfTheLawAndTheRecord) {
  auto summary = fixture::lot();
  auto const outlying = [](std::string property, std::string law) {
    return OutlyingDevice{.device = "D1", .property = std::move(property), .unit = {}, .law = std::move(law)};
  };
  summary.outliers = {outlying("dissipated energy", ""), outlying("misfit of bilinear", "bilinear"),
                      outlying("misfit of vaiana", "vaiana")};
  auto const said = doubts_of(summary, "bilinear", "D1");
  EXPECT_TRUE(contains(said, "dissipated energy") && contains(said, "misfit of bilinear")) << said;
  EXPECT_FALSE(contains(said, "misfit of vaiana")) << said;
}

TEST(Doubts, NameCopiesOfARecord) {
  auto summary = fixture::lot();
  summary.devices[1].raw = summary.devices[0].raw;
  summary.devices[1].copy_of = "D1";
  auto const copies = "D1 and D2 hold the same record";
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", std::nullopt), copies));
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", "D2"), copies));
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D3"), copies));
}

// A user who takes the law of a lot is told which devices were refused and not used for it, and which rules the lot
// fails.
TEST(Doubts, SayWhatIsNotKeptAndWhichDevicesWereRefused) {
  auto summary = fixture::lot();
  auto const count = summary.devices.size();
  summary.devices.back().status = "refused";
  auto const refused = fmt::format("{} was refused. The lot has {} devices; its law is made from the others.",
                                   printable(summary.devices.back().name), count);
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", std::nullopt), refused))
      << doubts_of(summary, "bilinear", std::nullopt);
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D1"), refused));
  summary.acceptance.rules.id = "mine";
  summary.acceptance.rules.title = "My rules";
  summary.acceptance.rules.verified_by = "me";
  rules::Assessment fails;
  fails.quantity = "K_eff";
  fails.limit = "from -20 % to +20 %";
  fails.verdict = rules::Verdict::fail;
  fails.deviation = "+23.0 %";
  fails.deviation_percent = 23.0;
  summary.devices[1].acceptance.assessments = {fails};
  EXPECT_TRUE(
      contains(doubts_of(summary, "bilinear", std::nullopt), "The lot does not keep its rule set: My rules: 1 of"));
  EXPECT_TRUE(contains(doubts_of(summary, "bilinear", "D2"), "D2 fails My rules: K_eff +23.0 %"));
  EXPECT_FALSE(contains(doubts_of(summary, "bilinear", "D1"), "My rules"));
}

}  // namespace
}  // namespace isolaw::study
