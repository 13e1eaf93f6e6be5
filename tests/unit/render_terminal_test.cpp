// Tests the findings and the ranking of laws that the terminal prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "contains.hpp"
#include "isolaw/render/terminal/inspection_text.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/study/findings.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/motions.hpp"
#include "unit/study_fixture.hpp"

namespace isolaw::render {
namespace {

std::size_t widest_line(std::string const& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);)
    widest = std::max(widest, static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
                        return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
                      })));
  return widest;
}

std::size_t times_in(std::string const& text, std::string const& part) {
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

// The cycles of the last stage are complete but do not count, because the device has lost its force.
TEST(Inspection, SaysThatNoCompleteCycleCounts) {
  auto motion = data::testing::Motion().sine(20.0, 0.5, 3).sine(40.0, 0.5, 3).end().loop();
  for (std::size_t i = 600; i < motion.force_kN.size(); ++i) motion.force_kN[i] *= 0.01;
  auto summary = fixture::lot(1, 1);
  summary.devices.resize(1);
  summary.devices[0].properties = motion.properties();
  auto const text = inspection_text(summary, false);
  EXPECT_NE(text.find("Block 2: no cycle counts"), std::string::npos) << text;
  EXPECT_EQ(text.find("no complete cycle"), std::string::npos);
}

TEST(Findings, PublishedLotHasThePublishedFront) {
  auto const summary = fixture::lot(10, 6);
  auto const found = findings(summary);
  std::vector<std::pair<std::string, Role>> order;
  for (auto const& verdict : found.verdicts) order.emplace_back(summary.laws[verdict.law].id, verdict.role);
  EXPECT_EQ(order, (std::vector<std::pair<std::string, Role>>{{"jankowski", Role::most_accurate},
                                                              {"abe", Role::between},
                                                              {"vaiana", Role::compromise},
                                                              {"bilinear", Role::most_robust},
                                                              {"bouc-wen", Role::dominated},
                                                              {"hwang-wu", Role::dominated}}));
  EXPECT_EQ(found.verdicts[4].dominated_by, std::vector<std::string>{"vaiana"});
  EXPECT_EQ(found.verdicts[5].dominated_by, (std::vector<std::string>{"jankowski", "abe", "vaiana"}));
  EXPECT_EQ(
      wording::paragraph(found.verdicts[0].findings),
      "It misses the measured force by 7.9 % of its standard deviation on average; its parameters lie up to 30 % from the lot's mean, averaged over the parameters.");
  EXPECT_EQ(wording::paragraph(found.verdicts[2].findings),
            "It scatters less than Abe (22 % against 26 %) and errs less than Bilinear (8.8 % against 13.7 %).");
  EXPECT_EQ(
      wording::paragraph(found.headline),
      "4 of 6 laws are worth considering: choose between accuracy (Jankowski) and robustness (Bilinear). The best compromise is Vaiana.");
}

// Some laws are on the front of accuracy and robustness only because of the optimiser's noise. Such a law must not be
// named as the best compromise.
TEST(Findings, CompromiseStaysOnTheFrontWithoutNoise) {
  auto summary = fixture::lot(10, 6);
  auto const mark = [&](std::string const& id) {
    std::ranges::find(summary.laws, id, &LawResult::id)->on_front_converged = true;
  };
  mark("jankowski");
  mark("bilinear");
  auto const without = findings(summary).headline;
  EXPECT_EQ(without.front().word("compromise"), "");
  EXPECT_TRUE(contains(without, " No law between them holds up: each leaves the front when the optimiser's noise is "))
      << without;
  mark("abe");
  auto const with = findings(summary).headline;
  EXPECT_EQ(with.front().word("compromise"), "abe");
  EXPECT_TRUE(wording::paragraph(with).ends_with(" The best compromise is Abe.")) << with;
}

TEST(Findings, OneLawOnTheFrontIsBestOfBoth) {
  auto summary = fixture::lot(3, 2);
  summary.laws[1].beta = 0.1;
  summary.laws[0].on_front = false;
  auto const found = findings(summary);
  EXPECT_EQ(found.verdicts[0].role, Role::best_of_both);
  EXPECT_EQ(found.verdicts[1].role, Role::dominated);
}

TEST(Findings, LawWithoutBetaIsNotRankedAndSaysWhy) {
  auto summary = fixture::lot();
  summary.laws[2].beta = std::nullopt;
  summary.laws[2].on_front = true;  // a law without beta is not ranked, even if it is marked as on the front
  summary.laws[2].beta_note = "mean of a9 near zero";
  auto const found = findings(summary);
  EXPECT_EQ(found.verdicts.back().role, Role::unranked);
  EXPECT_TRUE(says(found.verdicts.back().findings, "It has no beta: mean of a9 near zero."));
  EXPECT_EQ(found.beta_note, "");
}

TEST(Findings, WarningsThatMatter) {
  auto summary = fixture::lot();
  summary.laws[0].devices[1].integration_shift = -0.002;
  summary.laws[0].devices[2].failed_runs = 3;
  summary.laws[0].devices[2].failure = "infinite force";
  for (auto d : {0u, 1u}) {
    summary.laws[2].devices[d] = DeviceFit{};
    summary.laws[2].devices[d].device = summary.devices[d].name;
    summary.laws[2].devices[d].refusal = "no time channel";
  }
  std::vector<FindingKind> kinds;
  std::vector<std::string> sentences;
  for (auto const& group : wording::grouped(findings(summary).warnings)) {
    kinds.push_back(group.front().kind);
    sentences.push_back(wording::sentence(group));
  }
  using enum FindingKind;
  ASSERT_EQ(kinds, (std::vector<FindingKind>{device_refused, law_refused, runs_failed, at_bound, integration_coarse}));
  EXPECT_EQ(
      sentences[1],
      "Hwang-Wu was not identified on D1 and D2: no time channel. Its mean and beta cover the other 1 device only");
  EXPECT_EQ(
      sentences[2],
      "Bilinear: 3 of 60 runs failed (3 on D3); its numbers are those of the other 57. The first failure: infinite force");
  EXPECT_EQ(sentences[3], "Vaiana: alpha+ at its upper bound on D1 and D3 (--set vaiana.alpha+=10:500 moves it).");
  EXPECT_EQ(sentences[4], "Bilinear: a finer integration step would move the objective by 0.002 on D2.");
}

TEST(Findings, NothingIdentified) {
  Summary summary;
  EXPECT_EQ(wording::paragraph(findings(summary).headline), "No law could be identified.");
  summary = fixture::lot();
  for (auto& law : summary.laws) {
    law.objective = {};
    law.beta = std::nullopt;
    law.beta_note = "no device";
    law.devices.clear();
  }
  EXPECT_EQ(wording::paragraph(findings(summary).headline), "No law could be identified.");
  EXPECT_FALSE(ranking(summary).empty());
  EXPECT_TRUE(contains(answer(summary, "out/lot", "out/lot"), "No law could be identified."));
}

TEST(Ranking, ByMeanObjectiveWithFrontMarks) {
  auto const text = ranking(fixture::lot(10, 7));
  EXPECT_TRUE(contains(text, "Test lot: 11 devices (1 refused), 7 laws, seed 7")) << text;
  EXPECT_TRUE(contains(text, "  1  jankowski   0.0790 ± 0.0125  0.0743  0.303      ●      0.5      2.0")) << text;
  EXPECT_TRUE(contains(text, "  6  hwang-wu    0.1170 ± 0.0125  0.1100  0.334      ○")) << text;
  EXPECT_LT(text.find("jankowski"), text.find("bilinear"));
  EXPECT_TRUE(contains(text, "beta, lower is more robust")) << text;
}

TEST(Ranking, FitsEightyColumnsAndNarrowTerminals) {
  for (int const width : {60, 80, 120})
    EXPECT_LE(widest_line(ranking(fixture::lot(10, 7), width)), static_cast<std::size_t>(std::max(width, 80)));
  EXPECT_LE(widest_line(ranking(fixture::lot(1, 7))), 80u);
}

TEST(Ranking, ControlCharactersDoNotReachTheTerminal) {
  auto summary = fixture::lot();
  summary.devices[3].name =
      "bad\x1b[2J\xc2\x9b"
      "31m\nname";
  auto const text = ranking(summary);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find("\xc2\x9b"), std::string::npos);
  EXPECT_TRUE(contains(text, R"(bad\x1b[2J\x9b31m\nname was refused)")) << text;
}

// If three devices have the same finding, one line names them all.
TEST(Ranking, FindingsOfOneKindAreOneLine) {
  auto summary = fixture::lot();
  for (std::size_t d = 0; d < 3; ++d)
    summary.devices[d].raw.warnings = {
        {.kind = FindingKind::starts_off_zero,
         .numbers = {{"disp_mm", 1.0 + static_cast<double>(d)}, {"percent", 2.0}, {"half_range_mm", 208.0}}}};
  auto const text = ranking(summary, 200);
  EXPECT_EQ(times_in(text, "the first sample is at"), 1u) << text;
  EXPECT_TRUE(contains(text, "  - D1, D2 and D3: the first sample is at 1 to 3 mm, 2 % of the half range of 208 mm"))
      << text;
}

TEST(Answer, IsOneScreen) {
  for (auto const& summary : {fixture::lot(10, 7), fixture::analysed(fixture::lot(10, 7)), fixture::lot(1, 7),
                              fixture::analysed(fixture::lot(1, 3)), fixture::analysed(fixture::lot(160, 7))}) {
    auto const text = answer(summary, "out/lot", "out/lot");
    EXPECT_LE(times_in(text, "\n"), 25u) << text;
    EXPECT_LE(widest_line(text), 80u) << text;
    EXPECT_TRUE(contains(text, "out/lot/report.html")) << text;
  }
}

TEST(Answer, NamesTheLawTheNextCommandAndTheReport) {
  auto const text = answer(fixture::analysed(fixture::lot(10, 7)), "elsewhere", "out/lot");
  EXPECT_TRUE(contains(text, "Take Abe")) << text;
  EXPECT_TRUE(contains(text, "isolaw export out/lot --law abe --device lot --to openseespy-law")) << text;
  EXPECT_TRUE(contains(text, "elsewhere/report.html")) << text;
}

// Findings about the recommended law and about the records are printed. Findings about other laws are only counted.
TEST(Answer, LeavesOutWarningsAboutOtherLaws) {
  auto summary = fixture::analysed(fixture::lot(10, 7));
  for (auto& device : summary.devices) device.raw.warnings.clear();
  for (auto& law : summary.laws)
    for (auto& fit : law.devices) fit.integration_shift = law.id == "jankowski" ? 0.004 : 0.2;
  auto const text = answer(summary, "out/lot", "out/lot");
  EXPECT_TRUE(contains(text, "Jankowski")) << text;
  EXPECT_FALSE(contains(text, "Vaiana:")) << text;
  EXPECT_FALSE(contains(text, "Bilinear:")) << text;
  EXPECT_TRUE(contains(text, " more warnings: --details")) << text;
}

TEST(Ranking, WithoutBetaBarsInsteadOfTheFront) {
  auto const text = ranking(fixture::lot(1, 3));
  EXPECT_TRUE(contains(text, "The robustness index beta is undefined: one device")) << text;
  EXPECT_TRUE(contains(text, "█")) << text;
  EXPECT_FALSE(contains(text, "○")) << text;
}

TEST(Enumerate, Names) {
  EXPECT_EQ(enumerate({}), "");
  EXPECT_EQ(enumerate({"A"}), "A");
  EXPECT_EQ(enumerate({"A", "B", "C"}), "A, B and C");
  EXPECT_EQ(enumerate({"A", "B", "C", "D"}, 3), "A, B and 2 more");
}

}  // namespace
}  // namespace isolaw::render
