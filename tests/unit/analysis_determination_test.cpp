// Tests the sentences about parameters that can replace one another, and whether parameters are called determined in
// limiting cases: no free parameter, one free parameter, a parameter tied to another, a start that is no optimum.
#include "isolaw/analysis/determination.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "twins.hpp"

namespace isolaw::analysis {
namespace {

std::string sentence(std::vector<std::string> const& names, std::vector<double> const& change) {
  return trade_off_sentence(names, change);
}

TEST(TradeOffSentence, OfOneOfAProductOfARatioAndOfMore) {
  EXPECT_EQ(sentence({"a5"}, {1.0}), "a5 does not act on this record");
  EXPECT_EQ(sentence({"a", "b"}, {1.0, -0.95}), "a and b trade off: only their product shapes the loop");
  EXPECT_EQ(sentence({"a", "b"}, {-1.0, 1.0}), "a and b trade off: only their product shapes the loop");
  EXPECT_EQ(sentence({"a", "b"}, {0.95, 1.0}), "a and b trade off: only their ratio shapes the loop");
  EXPECT_EQ(sentence({"a", "b"}, {0.5, 1.0}), "a and b trade off: b +10 % is undone by a +5 %");
  EXPECT_EQ(sentence({"a", "b", "c"}, {0.25, 1.0, -0.5}),
            "a, b and c trade off: b +10 % is undone by a +2.5 % and c -5 %");
  EXPECT_EQ(sentence({"a", "b", "c"}, {0.25, -1.0, -0.5}),
            "a, b and c trade off: b +10 % is undone by a -2.5 % and c +5 %");
}

TEST(VerdictNames, AreWords) {
  EXPECT_EQ(name(Verdict::determined), "determined");
  EXPECT_EQ(name(Verdict::weakly_determined), "weakly determined");
  EXPECT_EQ(name(Verdict::undetermined), "undetermined");
  EXPECT_EQ(name(Verdict::at_bound), "at its bound");
}

class Determine : public testing::Test {
 protected:
  static twins::Twin twin(std::vector<std::string> const& set = {}, std::string_view law = "bilinear") {
    std::vector<fit::Override> overrides;
    for (auto const& text : set) overrides.push_back(fit::parse_override(text));
    return twins::twin_in_box(law, twins::growing_cycles(3, 60), overrides);
  }
  static fit::LawOnRecord model(twins::Twin const& twin) {
    return {*twin.law, twin.record, laws::Integration::converged};
  }
};

TEST_F(Determine, NothingIsFree) {
  auto const given = twin({"bilinear.K1=4", "bilinear.K2=0.6", "bilinear.xy=20"});
  auto const found = determine(model(given), given.box, given.truth);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->parameters.empty());
  EXPECT_TRUE(found->trade_offs.empty());
  EXPECT_TRUE(found->singular_values.empty());
  EXPECT_EQ(found->optimum, given.truth);
  EXPECT_LT(found->objective, 1e-12);
}

TEST_F(Determine, OneIsFree) {
  auto const given = twin({"bilinear.K1=4", "bilinear.K2=0.6"});
  auto const found = determine(model(given), given.box, given.truth);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->parameters.size(), 1u);
  EXPECT_EQ(found->parameters.front().parameter, 2u);
  EXPECT_EQ(found->parameters.front().verdict, Verdict::determined);
  EXPECT_EQ(found->singular_values.size(), 1u);
  EXPECT_TRUE(found->trade_offs.empty());
}

// The profile of a parameter is the least objective for each of its values. With one free parameter no other parameter
// can adjust, so the profile is the objective itself. At both ends of the range that is found, the objective must have
// risen by about the stated rise.
TEST_F(Determine, AnOpenRangeEndsWhereTheObjectiveHasRisen) {
  auto const given = twin({"bilinear.K1=4", "bilinear.K2=0.6"});
  auto const on_record = model(given);
  auto const found = determine(on_record, given.box, given.truth);
  ASSERT_TRUE(found);
  std::vector<double> work;
  for (double const end : {found->parameters.front().lower, found->parameters.front().upper}) {
    auto values = given.truth;
    values[2] = end;
    double const rise = on_record.objective(values, work) - found->objective;
    EXPECT_GT(rise, 0.3 * found->rise);
    EXPECT_LT(rise, 3.0 * found->rise);
  }
}

TEST_F(Determine, ATiedParameterGoesWithTheOther) {
  auto const given = twin({"vaiana.Kb-=Kb+", "vaiana.f0-=f0+"}, "vaiana");
  ASSERT_EQ(given.truth[given.law->index_of("Kb-")], given.truth[given.law->index_of("Kb+")]);
  auto const found = determine(model(given), given.box, given.truth);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->parameters.size(), given.box.free_count());
  for (auto const& p : found->parameters) EXPECT_TRUE(given.box.parameters[p.parameter].free);
  EXPECT_EQ(found->optimum[given.law->index_of("Kb-")], found->optimum[given.law->index_of("Kb+")]);
  EXPECT_LT(found->objective, 1e-9);
}

// The start lies 2 % beside the optimum. If a profile reaches a lower objective than that of the start, the examination
// begins again from the point of the lower objective. In the end it must have found the optimum.
TEST_F(Determine, AStartBesideTheOptimumEndsAtIt) {
  auto const given = twin();
  auto start = given.truth;
  for (double& value : start) value *= 1.02;
  auto const found = determine(model(given), given.box, start);
  ASSERT_TRUE(found);
  EXPECT_LT(found->objective, 1e-9);
  for (std::size_t i = 0; i < start.size(); ++i) EXPECT_NEAR(found->optimum[i], given.truth[i], 1e-6 * given.truth[i]);
}

TEST_F(Determine, AnOptimumOutsideTheBoxIsTakenIntoIt) {
  auto const given = twin();
  auto outside = given.truth;
  outside[0] = 2.0 * given.box.parameters[0].upper;
  auto const found = determine(model(given), given.box, outside);
  ASSERT_TRUE(found);
  for (std::size_t i = 0; i < outside.size(); ++i) {
    EXPECT_GE(found->optimum[i], given.box.parameters[i].lower);
    EXPECT_LE(found->optimum[i], given.box.parameters[i].upper);
  }
  EXPECT_TRUE(std::isfinite(found->objective));
}

// Without a finite force no parameter is determined: each may lie anywhere in its box.
TEST_F(Determine, WithoutAForceNothingIsDetermined) {
  auto const given = twin();
  auto start = given.truth;
  start[1] = std::nan("");
  auto const found = determine(model(given), given.box, start);
  ASSERT_TRUE(found);
  EXPECT_FALSE(std::isfinite(found->objective));
  ASSERT_EQ(found->parameters.size(), 3u);
  for (auto const& p : found->parameters) {
    EXPECT_EQ(p.verdict, Verdict::undetermined);
    EXPECT_TRUE(p.open_below && p.open_above);
    EXPECT_EQ(p.lower, given.box.parameters[p.parameter].lower);
    EXPECT_EQ(p.upper, given.box.parameters[p.parameter].upper);
  }
  EXPECT_TRUE(found->trade_offs.empty());
}

TEST_F(Determine, Interrupted) {
  auto const given = twin();
  EXPECT_FALSE(determine(model(given), given.box, given.truth, [] { return true; }));
  int asked = 0;
  EXPECT_FALSE(determine(model(given), given.box, given.truth, [&] { return ++asked == 3; }));
  EXPECT_TRUE(determine(model(given), given.box, given.truth, [] { return false; }));
}

}  // namespace
}  // namespace isolaw::analysis
