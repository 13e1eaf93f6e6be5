// The findings and the ranking on the terminal.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "contains.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/study/findings.hpp"
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
      found.verdicts[0].sentence,
      "Misses the measured force by 7.9 % of its standard deviation on average; its parameters lie up to 30 % from the lot's mean, averaged over the parameters.");
  EXPECT_EQ(found.verdicts[2].sentence,
            "Scatters less than Abe (22 % against 26 %) and errs less than Bilinear (8.8 % against 13.7 %).");
  EXPECT_EQ(
      found.headline,
      "4 of 6 laws are worth considering: the choice lies between accuracy (Jankowski) and robustness (Bilinear); the best compromise is Vaiana.");
}

// A law that is on the front only through the optimiser's noise is no compromise.
TEST(Findings, CompromiseStaysOnTheFrontWithoutNoise) {
  auto summary = fixture::lot(10, 6);
  auto const mark = [&](std::string const& id) {
    std::ranges::find(summary.laws, id, &LawResult::id)->on_front_converged = true;
  };
  mark("jankowski");
  mark("bilinear");
  EXPECT_NE(findings(summary).headline.find("none between them holds up"), std::string::npos);
  mark("abe");
  EXPECT_NE(findings(summary).headline.find("the best compromise is Abe"), std::string::npos);
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
  summary.laws[2].on_front = true;  // whatever the caller says
  summary.laws[2].beta_note = "mean of a9 near zero";
  auto const found = findings(summary);
  EXPECT_EQ(found.verdicts.back().role, Role::unranked);
  EXPECT_TRUE(contains(found.verdicts.back().sentence, "mean of a9 near zero"));
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
  std::vector<std::string> topics;
  std::string all;
  for (auto const& warning : findings(summary).warnings) {
    topics.push_back(warning.topic);
    all += warning.sentence + "\n";
  }
  EXPECT_EQ(topics,
            (std::vector<std::string>{"refused", "law not identified", "failed runs", "at bound", "integration"}));
  EXPECT_TRUE(contains(all, "Hwang-Wu was not identified on D1 and D2: no time channel")) << all;
  EXPECT_TRUE(contains(all, "Bilinear: 3 of 60 runs failed, the first on D3: infinite force")) << all;
  EXPECT_TRUE(contains(all, "Vaiana: alpha+ at its upper bound on D1 and D3")) << all;
  EXPECT_TRUE(contains(all, "Bilinear: a finer integration step would move the objective by up to 0.002 on D2")) << all;
}

TEST(Findings, NothingIdentified) {
  Summary summary;
  EXPECT_EQ(findings(summary).headline, "No law could be identified.");
  summary = fixture::lot();
  for (auto& law : summary.laws) {
    law.objective = {};
    law.beta = std::nullopt;
    law.beta_note = "no device";
    law.devices.clear();
  }
  EXPECT_EQ(findings(summary).headline, "No law could be identified.");
  EXPECT_FALSE(ranking(summary).empty());
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
  EXPECT_TRUE(contains(text, "bad [2J 31m name was refused")) << text;
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
