// Tests the comparison of a campaign with the published study. The comparison sets the campaign's numbers beside those
// of Table A.5 and says which of the study's statements hold in the campaign. A campaign made of the table's numbers
// must give these numbers back, and the same statements must hold in it as in the table. Further cases have other
// numbers, missing laws, or law 5 as abe instead of abe-y0.
#include "isolaw/study/published.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/lot/robustness.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/study/table_a5.hpp"

namespace isolaw::study {
namespace {

LawResult law_of_table(table_a5::Law const& printed) {
  LawResult law;
  law.id = printed.id;
  for (std::size_t d = 0; d < table_a5::devices; ++d) {
    DeviceFit fit;
    fit.device = "D" + std::to_string(d + 1);
    fit.objective = {printed.objective_mean[d], printed.objective_std[d], printed.objective_mean[d]};
    law.devices.push_back(fit);
  }
  law.objective.mean = num::moments(printed.objective_mean).mean;
  std::vector<std::string> names;
  std::vector<std::vector<double>> means;
  for (auto const& parameter : printed.parameters) {
    names.emplace_back(parameter.name);
    means.emplace_back(parameter.mean.begin(), parameter.mean.end());
  }
  law.beta = lot::robustness_index(names, means).beta;
  return law;
}

Summary campaign_of_table() {
  Summary summary;
  for (auto const& law : table_a5::laws) summary.laws.push_back(law_of_table(law));
  return summary;
}

LawResult& the(Summary& summary, std::string const& id) {
  return *std::ranges::find(summary.laws, id, &LawResult::id);
}

PublishedStatement const& statement(Published const& comparison, std::string const& start) {
  auto const found =
      std::ranges::find_if(comparison.statements, [&](auto const& one) { return one.text.starts_with(start); });
  EXPECT_NE(found, comparison.statements.end()) << start;
  return *found;
}

PublishedLaw const& row(Published const& comparison, std::string const& id) {
  return *std::ranges::find(comparison.laws, id, &PublishedLaw::law);
}

// Each law states whether it belongs to the study. The printed table must have numbers for exactly those laws.
TEST(PublishedTable, has_a_row_for_each_law_of_the_study) {
  std::set<std::string_view> printed, known;
  for (auto const& law : table_a5::laws) {
    printed.insert(law.id);
    if (!law.other_reading.empty()) printed.insert(law.other_reading);
  }
  for (auto const& law : laws::catalogue())
    if (law.info.set == laws::LawSet::paper) known.insert(law.info.id);
  EXPECT_EQ(printed, known);
}

TEST(Published, ItsOwnNumbersAreFoundAgain) {
  auto const comparison = published(campaign_of_table());
  ASSERT_TRUE(comparison);
  ASSERT_EQ(comparison->laws.size(), 6u);
  // The mean objective and the beta of each law of the printed table, computed without isolaw.
  std::map<int, std::pair<double, double>> const expected{{1, {0.137, 0.1421}}, {2, {0.079, 0.3030}},
                                                          {3, {0.088, 0.2164}}, {4, {0.089, 0.2171}},
                                                          {5, {0.085, 0.2590}}, {6, {0.117, 0.3341}}};
  std::vector<int> front;
  for (auto const& law : comparison->laws) {
    EXPECT_TRUE(law.compared);
    EXPECT_NEAR(*law.printed.objective, expected.at(law.number).first, 5e-5);
    EXPECT_NEAR(*law.printed.beta, expected.at(law.number).second, 5e-5);
    EXPECT_DOUBLE_EQ(*law.computed.objective, *law.printed.objective);
    EXPECT_DOUBLE_EQ(*law.computed.std_over_runs, *law.printed.std_over_runs);
    EXPECT_DOUBLE_EQ(*law.computed.std_over_devices, *law.printed.std_over_devices);
    EXPECT_EQ(law.computed.on_front, law.printed.on_front);
    if (law.printed.on_front) front.push_back(law.number);
  }
  EXPECT_EQ(front, (std::vector<int>{1, 2, 3, 5}));
  EXPECT_NEAR(*row(*comparison, "vaiana").printed.std_over_runs, 1.45e-4, 1e-5);
  for (auto const& one : comparison->statements) {
    ASSERT_TRUE(one.holds_here) << one.text << ": " << one.found;
    EXPECT_EQ(*one.holds_here, one.holds_in_table) << one.text;
  }
}

// Three statements of the study disagree with the study's own table.
TEST(Published, StatementsOfTheStudyInItsOwnTable) {
  auto const comparison = published(campaign_of_table());
  ASSERT_TRUE(comparison);
  std::vector<std::string> wrong;
  for (auto const& one : comparison->statements)
    if (!one.holds_in_table) wrong.push_back(one.text.substr(0, one.text.find(' ', 10)));
  EXPECT_EQ(wrong.size(), 3u);
  EXPECT_FALSE(statement(*comparison, "Laws 2 to 6").holds_in_table) << "law 6 has 0.117";
  EXPECT_FALSE(statement(*comparison, "Law 5 is both").holds_in_table) << "beta of law 4 is smaller";
  EXPECT_FALSE(statement(*comparison, "Laws 3 and 4").holds_in_table) << "law 1 scatters less than law 4";
  EXPECT_EQ(comparison->verdict,
            "7 of 10 statements of the published study hold here, 3 do not; 7 hold in its own Table A.5.");
  EXPECT_EQ(
      statement(*comparison, "Law 5 is both").found,
      "objective Abe (constant yield) 0.085, Bouc-Wen 0.089, Hwang-Wu 0.117; beta Bouc-Wen 0.217, Abe (constant yield) 0.259, Hwang-Wu 0.334");
}

TEST(Published, OtherNumbersAreJudgedAnew) {
  auto summary = campaign_of_table();
  the(summary, "bilinear").beta = 0.5;
  the(summary, "hwang-wu").beta = 0.01;
  auto const comparison = published(summary);
  EXPECT_EQ(statement(*comparison, "Law 1 is the most robust").holds_here, false);
  EXPECT_TRUE(statement(*comparison, "Law 1 is the most robust").holds_in_table);
  EXPECT_EQ(statement(*comparison, "From law 1").holds_here, false);
  EXPECT_EQ(statement(*comparison, "Laws 1, 2, 3 and 5").holds_here, false);
  EXPECT_TRUE(row(*comparison, "hwang-wu").computed.on_front);
  EXPECT_FALSE(row(*comparison, "hwang-wu").printed.on_front);
  EXPECT_EQ(statement(*comparison, "Laws 2 and 5").holds_here, true);
  EXPECT_TRUE(comparison->verdict.starts_with("3 of 10 statements")) << comparison->verdict;
}

TEST(Published, WhatCannotBeJudgedIsOpenWithItsReason) {
  auto summary = campaign_of_table();
  std::erase_if(summary.laws, [](auto const& law) { return law.id == "bouc-wen"; });
  for (auto& law : summary.laws) law.beta.reset();  // a campaign of one device has no beta
  auto const comparison = published(summary);
  EXPECT_EQ(statement(*comparison, "Laws 2 to 6").holds_here, std::nullopt);
  EXPECT_EQ(statement(*comparison, "Laws 2 to 6").found, "no objective of law 4");
  EXPECT_EQ(statement(*comparison, "Law 1 is").holds_here, std::nullopt);
  EXPECT_EQ(statement(*comparison, "Law 1 is").found, "no beta of law 1");
  EXPECT_EQ(statement(*comparison, "Laws 2 and 5").holds_here, true);
  EXPECT_FALSE(row(*comparison, "bouc-wen").compared);
  EXPECT_EQ(row(*comparison, "bouc-wen").computed.objective, std::nullopt);
  EXPECT_TRUE(row(*comparison, "bouc-wen").printed.objective);
  for (auto const& law : comparison->laws) EXPECT_FALSE(law.computed.on_front) << law.law << " has no beta";
  EXPECT_NE(comparison->verdict.find("cannot be judged"), std::string::npos) << comparison->verdict;
}

TEST(Published, NeedsTwoOfItsLaws) {
  auto summary = campaign_of_table();
  summary.laws.erase(summary.laws.begin() + 2, summary.laws.end());
  EXPECT_TRUE(published(summary));
  summary.laws.pop_back();
  EXPECT_FALSE(published(summary));
  summary.laws.push_back(summary.laws[0]);
  summary.laws[1].id = "power-masing";
  EXPECT_FALSE(published(summary)) << "not a law of the study";
  EXPECT_FALSE(published(Summary{}));
}

TEST(Published, RunsThatEndAtOnePlaceHaveNoScatterToCompare) {
  auto summary = campaign_of_table();
  for (auto& law : summary.laws)
    for (auto& fit : law.devices) fit.objective.std = 1e-7;
  EXPECT_EQ(statement(*published(summary), "Law 3 scatters").holds_here, std::nullopt);
  EXPECT_EQ(statement(*published(summary), "Law 3 scatters").found, "the runs of each law end at one place");
  for (auto& fit : the(summary, "bilinear").devices) fit.objective.std = 1e-3;
  for (auto& fit : the(summary, "vaiana").devices) fit.objective.std = 1e-8;
  EXPECT_EQ(statement(*published(summary), "Law 3 scatters").holds_here, true);
}

// The text of the study allows two readings of law 5, abe-y0 and abe. If a campaign has both, abe-y0 is compared,
// because its loops are closer to the printed ones, and the two count as one law.
TEST(Published, TwoReadingsOfLaw5) {
  auto summary = campaign_of_table();
  auto other = the(summary, "abe-y0");
  other.id = "abe";
  other.objective.mean = 0.5;
  for (auto& fit : other.devices) fit.objective.mean = 0.5;
  summary.laws.push_back(other);
  auto const comparison = published(summary);
  ASSERT_EQ(comparison->laws.size(), 7u);
  EXPECT_TRUE(row(*comparison, "abe-y0").compared);
  EXPECT_FALSE(row(*comparison, "abe").compared);
  EXPECT_EQ(row(*comparison, "abe").number, 5);
  EXPECT_DOUBLE_EQ(*row(*comparison, "abe").computed.objective, 0.5);
  EXPECT_EQ(statement(*comparison, "Laws 2 and 5").holds_here, true);

  std::erase_if(summary.laws, [](auto const& law) { return law.id == "abe-y0"; });
  EXPECT_TRUE(row(*published(summary), "abe").compared);
  EXPECT_EQ(statement(*published(summary), "Laws 2 and 5").holds_here, false);

  std::erase_if(summary.laws, [](auto const& law) { return law.id != "abe"; });
  summary.laws.push_back(law_of_table(table_a5::laws[4]));
  EXPECT_FALSE(published(summary)) << "one law of the study, read twice";
}

}  // namespace
}  // namespace isolaw::study
