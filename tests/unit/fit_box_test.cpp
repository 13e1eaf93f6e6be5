// Tests search boxes, the intervals in which a fit searches the parameters of a law: linear and logarithmic scales, the
// bounds of the paper's Table 4, bounds in proportion to the sizes of a record, overrides by the option --set, and when
// a value is reported as at a bound.
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/parts/scragging.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/fit/joint_limits.hpp"
#include "laws/unit_powers.hpp"
#include "refusal.hpp"

namespace isolaw::fit {
namespace {

SearchParameter parameter(double lower, double upper, laws::Scale scale) {
  return {.name = "k", .unit = "1", .free = true, .value = 0.0, .lower = lower, .upper = upper, .scale = scale};
}

TEST(SearchParameter, LinearScale) {
  auto const p = parameter(-2.0, 6.0, laws::Scale::linear);
  EXPECT_EQ(p.at(0.0), -2.0);
  EXPECT_EQ(p.at(1.0), 6.0);
  EXPECT_DOUBLE_EQ(p.at(0.25), 0.0);
  EXPECT_DOUBLE_EQ(p.coordinate(2.0), 0.5);
}

TEST(SearchParameter, LogarithmicScale) {
  auto const p = parameter(1e-3, 10.0, laws::Scale::logarithmic);
  EXPECT_NEAR(p.at(0.5), 0.1, 1e-15);
  EXPECT_NEAR(p.at(0.25), 1e-2, 1e-16);
  EXPECT_NEAR(p.coordinate(1.0), 0.75, 1e-15);
}

TEST(SearchParameter, LogarithmicScaleOfNegativeValues) {
  auto const p = parameter(-1e-4, -1e-8, laws::Scale::logarithmic);
  EXPECT_NEAR(p.at(0.0), -1e-4, 1e-18);
  EXPECT_NEAR(p.at(1.0), -1e-8, 1e-22);
  EXPECT_NEAR(p.at(0.5), -1e-6, 1e-20);
  EXPECT_NEAR(p.at(0.25), -1e-5, 1e-19);
  EXPECT_NEAR(p.coordinate(-1e-7), 0.75, 1e-14);
}

// A search moves in the coordinate, which goes from 0 at the lower bound to 1 at the upper. The scale has six decades
// on each side of zero. Within them, equal steps of the coordinate multiply the value by equal factors.
TEST(SearchParameter, LogarithmicScaleAcrossZero) {
  auto const p = parameter(-1.0, 1.0, laws::Scale::logarithmic);
  EXPECT_EQ(p.at(0.0), -1.0);
  EXPECT_NEAR(p.at(0.5), 0.0, 1e-15);
  EXPECT_EQ(p.at(1.0), 1.0);
  double const decade = p.coordinate(1.0) - p.coordinate(0.1);
  EXPECT_NEAR(p.coordinate(1e-3) - p.coordinate(1e-4), decade, 1e-4 * decade);
  EXPECT_NEAR(p.coordinate(-1e-4) - p.coordinate(-1e-3), decade, 1e-4 * decade);
  // Near zero the scale is linear, with the slope that the logarithm has at a millionth of the bound.
  EXPECT_NEAR(p.coordinate(1e-9) - 0.5, 1e-3 * decade / std::log(10.0), 1e-6 * decade);

  auto const uneven = parameter(-1e-2, 10.0, laws::Scale::logarithmic);
  EXPECT_NEAR(uneven.at(0.0), -1e-2, 1e-14);
  EXPECT_NEAR(uneven.at(1.0), 10.0, 1e-12);
  EXPECT_NEAR(uneven.at(uneven.coordinate(0.0)), 0.0, 1e-15);
  EXPECT_LT(uneven.coordinate(0.0), 0.5);
}

TEST(SearchParameter, RoundTripAndNeverOutsideTheInterval) {
  for (auto const& p :
       {parameter(-2.0, 6.0, laws::Scale::linear), parameter(1e-3, 10.0, laws::Scale::logarithmic),
        parameter(-5e-6, -1e-9, laws::Scale::logarithmic), parameter(3.3e5, 3.5e6, laws::Scale::logarithmic),
        parameter(-1.0, 1.0, laws::Scale::logarithmic), parameter(-3e4, 0.7, laws::Scale::logarithmic)})
    for (int i = 0; i <= 1000; ++i) {
      double const u = i / 1000.0, value = p.at(u);
      EXPECT_NEAR(p.coordinate(value), u, 1e-12);
      EXPECT_GE(value, p.lower);
      EXPECT_LE(value, p.upper);
    }
}

TEST(SearchParameter, ClampsWhatLiesOutside) {
  for (auto const scale : {laws::Scale::linear, laws::Scale::logarithmic}) {
    auto const p = parameter(1.0, 4.0, scale);
    EXPECT_EQ(p.at(-0.5), 1.0);
    EXPECT_NEAR(p.at(1.5), 4.0, 1e-15);
    EXPECT_EQ(p.coordinate(0.5), 0.0);
    EXPECT_EQ(p.coordinate(5.0), 1.0);
  }
}

TEST(AtBound, IsAThousandthOfTheWidthOnTheSearchScale) {
  auto const linear = parameter(10.0, 30.0, laws::Scale::linear);  // a thousandth of the width is 0.02
  EXPECT_EQ(at_bound(linear, 10.0), AtBound::lower);
  EXPECT_EQ(at_bound(linear, 10.0199), AtBound::lower);
  EXPECT_EQ(at_bound(linear, 10.0201), AtBound::no);
  EXPECT_EQ(at_bound(linear, 29.9799), AtBound::no);
  EXPECT_EQ(at_bound(linear, 29.9801), AtBound::upper);
  EXPECT_EQ(at_bound(linear, 30.0), AtBound::upper);

  double const width = std::log(1e4);  // the width of the box from 1e-3 to 10 on the logarithmic scale
  auto const logarithmic = parameter(1e-3, 10.0, laws::Scale::logarithmic);
  EXPECT_EQ(at_bound(logarithmic, 1e-3 * std::exp(0.99e-3 * width)), AtBound::lower);
  EXPECT_EQ(at_bound(logarithmic, 1e-3 * std::exp(1.01e-3 * width)), AtBound::no);
  EXPECT_EQ(at_bound(logarithmic, 10.0 * std::exp(-1.01e-3 * width)), AtBound::no);
  EXPECT_EQ(at_bound(logarithmic, 10.0 * std::exp(-0.99e-3 * width)), AtBound::upper);

  auto const negative = parameter(-10.0, -1e-3, laws::Scale::logarithmic);  // the lower bound has the larger magnitude
  EXPECT_EQ(at_bound(negative, -10.0 * std::exp(-0.99e-3 * width)), AtBound::lower);
  EXPECT_EQ(at_bound(negative, -10.0 * std::exp(-1.01e-3 * width)), AtBound::no);
  EXPECT_EQ(at_bound(negative, -1e-3 * std::exp(1.01e-3 * width)), AtBound::no);
  EXPECT_EQ(at_bound(negative, -1e-3 * std::exp(0.99e-3 * width)), AtBound::upper);
}

TEST(AtBound, AFixedParameterIsNowhere) {
  auto p = parameter(1.0, 2.0, laws::Scale::linear);
  p.free = false;
  p.value = 1.0;
  EXPECT_EQ(at_bound(p, 1.0), AtBound::no);
}

// --- the option --set ---

TEST(ParseOverride, EveryForm) {
  auto const fixed = parse_override("bilinear.K1=1.5");
  EXPECT_EQ(fixed.law, "bilinear");
  EXPECT_EQ(fixed.parameter, "K1");
  ASSERT_TRUE(fixed.interval);
  EXPECT_EQ(fixed.interval->lower, 1.5);
  EXPECT_EQ(fixed.interval->upper, 1.5);

  auto const interval = parse_override("hwang-wu.a9=-5e-6:-1e-9");
  EXPECT_EQ(interval.law, "hwang-wu");
  EXPECT_EQ(interval.parameter, "a9");
  ASSERT_TRUE(interval.interval);
  EXPECT_EQ(interval.interval->lower, -5e-6);
  EXPECT_EQ(interval.interval->upper, -1e-9);

  auto const with_sign = parse_override("vaiana.Kb+=+1e5:2.5e5");  // the name of this parameter ends in +
  EXPECT_EQ(with_sign.parameter, "Kb+");
  ASSERT_TRUE(with_sign.interval);
  EXPECT_EQ(with_sign.interval->lower, 1e5);
  EXPECT_EQ(with_sign.interval->upper, 2.5e5);

  auto const freed = parse_override("vaiana.gamma1-=free");
  EXPECT_EQ(freed.parameter, "gamma1-");
  EXPECT_FALSE(freed.interval);

  EXPECT_EQ(parse_override("bilinear.xy=0").interval->upper, 0.0);  // the physical limit itself is allowed
  EXPECT_EQ(parse_override("jankowski.a1=-3e5:0").interval->lower, -3e5);
}

TEST(ParseOverride, TextReadsBackExactly) {
  for (auto const* text :
       {"bilinear.K1=1.5", "hwang-wu.a9=-5e-06:-1e-09", "vaiana.gamma1+=free", "vaiana.Kb-=0.1:123456.789",
        "bouc-wen.n=1.0000000000000002", "abe.p=0.1:0.30000000000000004"}) {
    auto const first = parse_override(text), again = parse_override(first.text());
    EXPECT_EQ(again.law, first.law);
    EXPECT_EQ(again.parameter, first.parameter);
    ASSERT_EQ(again.interval.has_value(), first.interval.has_value()) << text;
    if (first.interval) {
      EXPECT_EQ(again.interval->lower, first.interval->lower) << text;
      EXPECT_EQ(again.interval->upper, first.interval->upper) << text;
    }
    EXPECT_EQ(again.text(), first.text());
  }
}

TEST(ParseOverride, ATieNamesTheOtherAndReadsBack) {
  for (auto const* text : {"vaiana.Kb-=Kb+", "vaiana.f0+=f0-", "bilinear.K2=K1"}) {
    auto const tie = parse_override(text);
    EXPECT_FALSE(tie.interval) << text;
    EXPECT_EQ(tie.text(), text);
    auto const again = parse_override(tie.text());
    EXPECT_EQ(again.law, tie.law);
    EXPECT_EQ(again.parameter, tie.parameter);
    EXPECT_EQ(again.tied_to, tie.tied_to);
  }
  EXPECT_EQ(parse_override("vaiana.Kb-=Kb+").tied_to, "Kb+");
  EXPECT_TRUE(parse_override("vaiana.Kb-=free").tied_to.empty());
}

// Returns the message about a wrong --set option, or "" if the option was accepted.
std::string refusal(std::string_view text) {
  return refusal_of([&] { parse_override(text); });
}

void expect_parts(std::string_view override_text, std::vector<std::string> const& parts) {
  auto const message = refusal(override_text);
  EXPECT_FALSE(message.empty()) << override_text << " was accepted";
  for (auto const& part : parts)
    EXPECT_NE(message.find(part), std::string::npos)
        << override_text << ": '" << part << "' is missing in: " << message;
}

TEST(ParseOverride, RefusesWhatHasNotTheForm) {
  for (auto const* text : {"", "K1", "K1=1", "bilinear.K1", "bilinear=1.5", ".=", "=bilinear.K1"})
    EXPECT_FALSE(refusal(text).empty()) << text;
  for (auto const* text : {"K1=1", "bilinear.K1", "bilinear=1.5"})
    expect_parts(text, {"--set", text, "law.parameter=value", "lower:upper", "free"});
}

TEST(ParseOverride, RefusesUnknownLawsAndParametersAndListsTheKnown) {
  expect_parts("bilinar.K1=1",
               {"'bilinar'", "bilinear", "jankowski", "vaiana", "bouc-wen", "abe", "abe-y0", "hwang-wu"});
  expect_parts("bilinear.K3=1", {"bilinear", "'K3'", "K1", "K2", "xy"});
  expect_parts("abe-y0.p=1", {"abe-y0", "'p'", "Y0", "Uh", "U0", "Us"});
  expect_parts("bilinear.k1=1", {"'k1'", "K1"});
}

TEST(ParseOverride, RefusesWhatIsNoNumber) {
  for (auto const* value : {"", "x", "1.5mm", "1,5", "1:", ":2", ":", "1:2:3", "nan", "inf", "-inf", "1e999", "Free",
                            "1 : 2", "+-5", "++5", "0x10"})
    expect_parts(std::string("jankowski.a1=") + value, {"--set jankowski.a1", "law.parameter=value"});
}

TEST(ParseOverride, RefusesAnIntervalThatIsNone) {
  expect_parts("bilinear.K1=2:1", {"--set bilinear.K1=2:1", "2", "1", "lower < upper", "bilinear.K1=1:2"});
  expect_parts("bilinear.K1=2:2", {"--set bilinear.K1=2:2", "lower < upper"});
  expect_parts("hwang-wu.a9=-1e-9:-5e-6", {"lower < upper", "-5e-06:-1e-09"});
}

TEST(LimitsText, SaysBothEnds) {
  double const infinite = std::numeric_limits<double>::infinity(), least = std::numeric_limits<double>::min();
  EXPECT_EQ(limits_text({0.0, infinite}, "mm"), "0 mm or more");
  EXPECT_EQ(limits_text({-infinite, 0.0}, "1"), "0 or less");
  EXPECT_EQ(limits_text({least, infinite}, "1"), "above 0");
  EXPECT_EQ(limits_text({-infinite, infinite}, "kN"), "any number of kN");
  EXPECT_EQ(limits_text({0.0, 1.0}, "1"), "0 to 1");
  EXPECT_EQ(limits_text({-2.0, 0.5}, "mm"), "-2 to 0.5 mm");
  EXPECT_EQ(limits_text({least, 1.0}, "mm"), "above 0, up to 1 mm");
  EXPECT_EQ(limits_text({2.0, infinite}, "mm"), "2 mm or more");
}

// --- limits on several parameters together ---

std::string joint_refusal(std::string_view law, std::vector<char const*> const& texts,
                          std::optional<laws::RecordScales> const& record = {}) {
  std::vector<Override> overrides;
  for (auto const* text : texts) overrides.push_back(parse_override(text));
  return refusal_of([&] {
    auto const& entry = laws::find_law(law);
    if (record)
      require_joint_limits(entry, make_box(entry, BoxKind::scaled, *record, overrides), overrides);
    else
      require_joint_limits(entry, overrides);
  });
}

TEST(JointLimits, WhatLiesWhollyOutsideIsRefused) {
  auto const refusal = joint_refusal("bilinear", {"bilinear.K1=0.1", "bilinear.K2=0.42"});
  for (auto const* part : {"--set bilinear.K1=0.1 bilinear.K2=0.42", "K1 = 0.1, K2 = 0.42", "allowed: K1 >= K2"})
    EXPECT_NE(refusal.find(part), std::string::npos) << part << " is missing in: " << refusal;
  EXPECT_NE(joint_refusal("bilinear", {"bilinear.K1=0.1:0.2", "bilinear.K2=0.3:1"}).find("K2 from 0.3 to 1"),
            std::string::npos);
  EXPECT_NE(joint_refusal("bouc-wen", {"bouc-wen.beta=-2:0"}).find("allowed: beta > 0"), std::string::npos);
  EXPECT_NE(joint_refusal("bouc-wen", {"bouc-wen.beta=1", "bouc-wen.gamma=-2:-1"}).find("allowed: beta + gamma > 0"),
            std::string::npos);
  EXPECT_NE(joint_refusal("bouc-wen", {"bouc-wen.beta=-1", "bouc-wen.gamma=beta"}), "");
}

TEST(JointLimits, WhatCrossesThemIsLeft) {
  for (auto const& texts : {std::vector{"bilinear.K1=0.1"},
                            {"bilinear.K1=0.1:0.2", "bilinear.K2=0.2:1"},
                            {"bilinear.K1=0.42", "bilinear.K2=0.42"},
                            {"bilinear.K2=K1"}})
    EXPECT_EQ(joint_refusal("bilinear", texts), "") << texts.front();
  for (auto const& texts : {std::vector{"bouc-wen.beta=-0.05:0.05"}, {"bouc-wen.gamma=-5"}, {"bouc-wen.gamma=beta"}})
    EXPECT_EQ(joint_refusal("bouc-wen", texts), "") << texts.front();
}

// With a record, the parameter without an override, K2, has an interval scaled from the record: 0.035 to 0.7. Joint
// limits hold for this interval too. K1 = 0.01 is therefore refused, because it is below every K2 of this interval.
TEST(JointLimits, HoldForTheBoxOfARecordToo) {
  laws::RecordScales const record{
      .disp = 100.0, .force = 70.0, .stiffness = 0.7, .strength = 20.0, .velocity = 300.0, .work = 1e4};
  EXPECT_NE(joint_refusal("bilinear", {"bilinear.K1=0.01"}, record).find("K1 = 0.01, K2 from 0.035 to 0.7"),
            std::string::npos);
  EXPECT_EQ(joint_refusal("bilinear", {"bilinear.K1=0.1"}, record), "");
  for (auto const& law : laws::catalogue()) EXPECT_EQ(joint_refusal(law.info.id, {}, record), "") << law.info.id;
}

TEST(ParseOverride, RefusesWhatIsNotPhysical) {
  expect_parts("bilinear.xy=-1", {"--set bilinear.xy=-1", "xy", "physical", "0 mm or more"});
  expect_parts("bilinear.xy=-1:10", {"physical"});
  expect_parts("bouc-wen.n=0", {"physical", "n"});
  expect_parts("hwang-wu.a9=-1e-6:1e-6", {"physical", "a9", "1/(N cm)"});
  expect_parts("bilinear.K1=0:1", {"physical", "K1"});
}

TEST(ParseOverride, RefusesATieToItselfToAnotherUnitAndToWhatTheLawHasNot) {
  expect_parts("vaiana.Kb+=Kb+", {"--set vaiana.Kb+=Kb+", "Kb+ is tied to itself", "another parameter", "same unit"});
  expect_parts("vaiana.Kb-=f0+", {"Kb- is in N/m, f0+ in N", "same unit"});
  expect_parts("bilinear.K2=xy", {"K2 is in kN/mm, xy in mm"});
  expect_parts("vaiana.Kb-=K1", {"'K1'", "parameter of the law"});
}

// --- boxes of the laws ---

struct Published {
  std::string parameter;
  double lower, upper;
};

// These are the bounds of Table 4 of Cucuzza et al. 2025, typed by hand. The table lacks bounds for alpha of bouc-wen
// and a1 of hwang-wu; theirs are from docs/source.md.
std::map<std::string, std::vector<Published>> const table_4{
    {"bilinear", {{"K1", 1, 1.9}, {"K2", 0.35, 0.95}, {"xy", 30, 80}}},
    {"jankowski",
     {{"a1", 1e4, 1e6},
      {"a2", 1e6, 9e6},
      {"a3", 1e6, 9e6},
      {"a4", 1e3, 1e5},
      {"a5", 1e3, 1e4},
      {"a6", 1e5, 3.5e6},
      {"a7", 0, 10},
      {"a8", 5, 20},
      {"a9", 1e4, 1e5},
      {"a10", 1e4, 1e5},
      {"a11", 0, 10}}},
    {"vaiana",
     {{"Kb+", 1e5, 6e5},
      {"Kb-", 1e5, 6e5},
      {"f0+", 1e4, 1e5},
      {"f0-", 1e4, 1e5},
      {"alpha+", 0, 50},
      {"alpha-", 0, 50},
      {"beta1+", 0, 0.9},
      {"beta1-", -0.9, 0},
      {"beta2+", 15, 50},
      {"beta2-", -50, -15}}},
    {"bouc-wen",
     {{"alpha", 0.1, 0.3}, {"Ke", 2, 4}, {"A", 1, 2}, {"beta", 0.025, 0.075}, {"n", 1, 1.25}, {"gamma", 0.025, 0.075}}},
    {"abe",
     {{"K1", 5, 10},
      {"alpha", 0, 10},
      {"beta", 0.01, 1},
      {"a", 0.5, 1},
      {"b", 5, 10},
      {"n", 0.01, 0.5},
      {"Y0", 10, 70},
      {"Uh", 50, 150},
      {"p", 0.01, 2},
      {"U0", 2, 6},
      {"Us", 5, 50},
      {"K2", 0.01, 0.5},
      {"r", 0.01, 0.2}}},
    {"abe-y0",
     {{"K1", 5, 10},
      {"alpha", 0, 10},
      {"beta", 0.01, 1},
      {"a", 0.5, 1},
      {"b", 5, 10},
      {"n", 0.01, 0.5},
      {"Y0", 10, 70},
      {"Uh", 50, 150},
      {"U0", 2, 6},
      {"Us", 5, 50},
      {"K2", 0.01, 0.5},
      {"r", 0.01, 0.2}}},
    {"hwang-wu",
     {{"a1", 2.8e3, 6e3},
      {"a2", -5, -0.04},
      {"a3", 1e-4, 0.01},
      {"a4", 20.75, 90},
      {"a5", 1e-3, 0.9},
      {"a6", 1e4, 1.5e5},
      {"a7", 1, 8},
      {"a8", 50, 150},
      {"a9", -5e-6, -1e-9},
      {"a10", -2.925e-5, 0}}},
};

// Returns the sizes of a record of a bearing like the paper's, in the law's units. The caller may multiply its lengths
// by `size`, its forces by `strength` and its velocity by `speed`.
laws::RecordScales scales(laws::LawInfo const& law, double size = 1.0, double strength = 1.0, double speed = 1.0) {
  double const L = law.length.in_record_units, F = law.force.in_record_units;
  return {.disp = 200.0 * size / L,
          .force = 130.0 * strength / F,
          .stiffness = 0.65 * strength / size * L / F,
          .strength = 40.0 * strength / F,
          .velocity = 650.0 * speed / L,
          .work = 80e3 * strength * size / (F * L)};
}

TEST(Box, PublishedIsTable4SearchedLinearly) {
  for (auto const& law : laws::catalogue()) {
    auto const box = make_box(law, BoxKind::published, scales(law.info), {});
    if (!table_4.contains(std::string(law.info.id))) continue;
    auto const& expected = table_4.at(std::string(law.info.id));
    ASSERT_EQ(box.free_count(), expected.size()) << law.info.id;
    ASSERT_EQ(box.parameters.size(), law.parameters.size()) << law.info.id;
    for (auto const& row : expected) {
      auto const& p = box.parameters[law.index_of(row.parameter)];
      EXPECT_EQ(p.name, row.parameter);
      EXPECT_DOUBLE_EQ(p.lower, row.lower) << law.info.id << " " << p.name;
      EXPECT_DOUBLE_EQ(p.upper, row.upper) << law.info.id << " " << p.name;
      EXPECT_EQ(p.scale, laws::Scale::linear) << law.info.id << " " << p.name;
      EXPECT_TRUE(p.free);
    }
  }
}

TEST(Box, PublishedFallsBackToTheScaledIntervalWhereThePaperHasNone) {
  auto const& law = laws::find_law("vaiana");
  auto const published = make_box(law, BoxKind::published, scales(law.info), {});
  auto const scaled = make_box(law, BoxKind::scaled, scales(law.info), {});
  for (auto const* name : {"gamma1+", "gamma1-", "gamma2+", "gamma2-", "gamma3+", "gamma3-"}) {
    auto const i = law.index_of(name);
    EXPECT_FALSE(published.parameters[i].free) << name;
    EXPECT_EQ(published.parameters[i].value, 0.0) << name;
    EXPECT_EQ(published.parameters[i].lower, scaled.parameters[i].lower) << name;
    EXPECT_EQ(published.parameters[i].upper, scaled.parameters[i].upper) << name;
    EXPECT_EQ(published.parameters[i].scale, scaled.parameters[i].scale) << name;
  }
}

TEST(Box, EveryIntervalCanBeSearched) {
  for (auto const& law : laws::catalogue())
    for (auto const kind : {BoxKind::published, BoxKind::scaled})
      for (double const size : {0.01, 1.0, 10.0})
        for (auto const& p : make_box(law, kind, scales(law.info, size, size * size), {}).parameters) {
          auto const& info = law.parameters[law.index_of(p.name)];
          EXPECT_LT(p.lower, p.upper) << law.info.id << " " << p.name;
          EXPECT_TRUE(std::isfinite(p.lower) && std::isfinite(p.upper)) << law.info.id << " " << p.name;
          EXPECT_GE(p.lower, info.physical.lower) << law.info.id << " " << p.name;
          EXPECT_LE(p.upper, info.physical.upper) << law.info.id << " " << p.name;
          EXPECT_TRUE(p.scale == laws::Scale::linear || p.lower * p.upper != 0.0) << law.info.id << " " << p.name;
          for (double const u : {0.0, 0.25, 0.5, 0.75, 1.0})
            EXPECT_NEAR(p.coordinate(p.at(u)), u, 1e-9) << law.info.id << " " << p.name;
        }
}

// If the sizes of the record grow, the bounds of a scaled box must grow as the unit of the parameter demands. The unit
// 1/mm^n of bouc-wen is taken at n = 1. Some parameters are values at a fixed displacement, whatever the size of the
// record. Their bounds grow with a further power of the length, which at_reference() gives.
TEST(Box, ScaledFollowsTheSizeOfTheRecordInTheUnitOfEachParameter) {
  double const size = 3.0, strength = 5.0, speed = 7.0;
  for (auto const& law : laws::catalogue()) {
    auto const small = make_box(law, BoxKind::scaled, scales(law.info), {});
    auto const large = make_box(law, BoxKind::scaled, scales(law.info, size, strength, speed), {});
    for (std::size_t i = 0; i < small.parameters.size(); ++i) {
      auto const &a = small.parameters[i], &b = large.parameters[i];
      auto const powers = law_tests::powers_of(a.unit);
      ASSERT_TRUE(powers) << law.info.id << " " << a.name << ": unknown unit " << a.unit;
      auto const [force, length, time] = *powers;
      double const factor = std::pow(strength, force) *
                            std::pow(size, length + law_tests::at_reference(law.parameters[i].scaled.size)) *
                            std::pow(size / speed, time);
      EXPECT_NEAR(b.lower, factor * a.lower, 1e-12 * std::abs(factor * a.lower)) << law.info.id << " " << a.name;
      EXPECT_NEAR(b.upper, factor * a.upper, 1e-12 * std::abs(factor * a.upper)) << law.info.id << " " << a.name;
    }
  }
}

TEST(Box, OverridesFixBoundAndFree) {
  auto const& law = laws::find_law("vaiana");
  std::vector const overrides{parse_override("vaiana.Kb+=3e5"), parse_override("vaiana.alpha+=1:2"),
                              parse_override("vaiana.gamma2+=free"), parse_override("bilinear.K1=1.2")};
  for (auto const kind : {BoxKind::published, BoxKind::scaled}) {
    auto const box = make_box(law, kind, scales(law.info), overrides);
    auto const plain = make_box(law, kind, scales(law.info), {});
    EXPECT_EQ(box.free_count(), 10u);  // of ten free parameters one was fixed, and one fixed parameter was freed
    auto const& fixed = box.parameters[law.index_of("Kb+")];
    EXPECT_FALSE(fixed.free);
    EXPECT_EQ(fixed.value, 3e5);
    auto const& bounded = box.parameters[law.index_of("alpha+")];
    EXPECT_TRUE(bounded.free);
    EXPECT_EQ(bounded.lower, 1.0);
    EXPECT_EQ(bounded.upper, 2.0);
    auto const& freed = box.parameters[law.index_of("gamma2+")];
    EXPECT_TRUE(freed.free);
    EXPECT_LT(freed.lower, freed.upper);
    for (auto const* untouched : {"Kb-", "alpha-", "beta2+"}) {
      auto const i = law.index_of(untouched);
      EXPECT_EQ(box.parameters[i].lower, plain.parameters[i].lower);
      EXPECT_EQ(box.parameters[i].upper, plain.parameters[i].upper);
      EXPECT_TRUE(box.parameters[i].free);
    }
  }
}

TEST(Box, AnIntervalAcrossZeroIsSearchedLinearly) {
  auto const& law = laws::find_law("vaiana");
  for (auto const* text : {"vaiana.beta1+=-5:5", "vaiana.beta1+=0:5", "vaiana.beta1+=-5:0"}) {
    std::vector const overrides{parse_override(text)};
    auto const p = make_box(law, BoxKind::scaled, scales(law.info), overrides).parameters[law.index_of("beta1+")];
    EXPECT_EQ(p.scale, laws::Scale::linear) << text;
    EXPECT_TRUE(std::isfinite(p.at(0.5))) << text;
  }
  std::vector const positive{parse_override("vaiana.beta1+=0.01:100")};
  auto const box = make_box(law, BoxKind::scaled, scales(law.info), positive);
  EXPECT_NEAR(box.parameters[law.index_of("beta1+")].at(0.5), 1.0, 1e-12);  // the search scale stays logarithmic
}

TEST(Box, TheLastOverrideOfAParameterCounts) {
  auto const& law = laws::find_law("bilinear");
  auto const of = [&](std::vector<char const*> const& texts) {
    std::vector<Override> overrides;
    for (auto const* text : texts) overrides.push_back(parse_override(text));
    return make_box(law, BoxKind::published, scales(law.info), overrides).parameters.front();
  };
  EXPECT_EQ(of({"bilinear.K1=1.5", "bilinear.K1=1.6"}).value, 1.6);
  auto const bounded = of({"bilinear.K1=1.5", "bilinear.K1=1:3"});
  EXPECT_TRUE(bounded.free);
  EXPECT_EQ(bounded.upper, 3.0);
  EXPECT_FALSE(of({"bilinear.K1=1:3", "bilinear.K1=1.5"}).free);
  // A parameter that is fixed and then freed has the box of Table 4 again.
  auto const freed = of({"bilinear.K1=1.5", "bilinear.K1=free"});
  EXPECT_TRUE(freed.free);
  EXPECT_EQ(freed.lower, 1.0);
  EXPECT_EQ(freed.upper, 1.9);
}

TEST(Box, ExpandPutsFixedValuesAmongTheFree) {
  auto const& law = laws::find_law("bilinear");
  std::vector const overrides{parse_override("bilinear.K2=0.4")};
  auto const box = make_box(law, BoxKind::published, scales(law.info), overrides);
  ASSERT_EQ(box.free_count(), 2u);
  std::vector<double> const point{0.5, 0.1};
  std::vector<double> values(3);
  box.expand(point, values);
  EXPECT_DOUBLE_EQ(values[0], 1.45);
  EXPECT_EQ(values[1], 0.4);
  EXPECT_DOUBLE_EQ(values[2], 35.0);
}

SearchBox vaiana_box(std::vector<char const*> const& texts) {
  auto const& law = laws::find_law("vaiana");
  std::vector<Override> overrides;
  for (auto const* text : texts) overrides.push_back(parse_override(text));
  return make_box(law, BoxKind::scaled, scales(law.info), overrides);
}

TEST(Box, ATiedParameterTakesTheValueOfTheOther) {
  auto const& law = laws::find_law("vaiana");
  auto const plus = law.index_of("Kb+"), minus = law.index_of("Kb-");
  // The parameter may come after or before the one to which it is tied.
  for (auto const& [tied, other, text] : {std::tuple(minus, plus, "vaiana.Kb-=Kb+"), {plus, minus, "vaiana.Kb+=Kb-"}}) {
    auto const box = vaiana_box({text});
    EXPECT_EQ(box.free_count(), vaiana_box({}).free_count() - 1);
    EXPECT_FALSE(box.parameters[tied].free);
    ASSERT_TRUE(box.parameters[tied].tied_to);
    EXPECT_EQ(*box.parameters[tied].tied_to, other);
    EXPECT_EQ(box.parameters[tied].lower, box.parameters[other].lower);
    EXPECT_EQ(box.parameters[tied].upper, box.parameters[other].upper);
    EXPECT_EQ(at_bound(box.parameters[tied], box.parameters[tied].upper), AtBound::no);

    std::vector<double> point(box.free_count()), values(box.parameters.size());
    for (std::size_t k = 0; k < point.size(); ++k) point[k] = 0.1 + 0.08 * static_cast<double>(k);
    box.expand(point, values);
    EXPECT_EQ(values[tied], values[other]);
    EXPECT_GT(values[other], box.parameters[other].lower);
    auto const back = box.contract(values);
    ASSERT_EQ(back.size(), point.size());
    for (std::size_t k = 0; k < point.size(); ++k) EXPECT_NEAR(back[k], point[k], 1e-12);
  }
}

TEST(Box, ATieToAFixedParameterIsItsValue) {
  auto const& law = laws::find_law("vaiana");
  auto const box = vaiana_box({"vaiana.Kb-=Kb+", "vaiana.Kb+=2e5"});
  EXPECT_EQ(box.free_count(), vaiana_box({}).free_count() - 2);
  std::vector<double> point(box.free_count(), 0.5), values(box.parameters.size());
  box.expand(point, values);
  EXPECT_EQ(values[law.index_of("Kb-")], 2e5);
  EXPECT_EQ(box.parameters[law.index_of("Kb-")].value, 2e5);
}

TEST(Box, TheLastWordOnATieCounts) {
  auto const minus = laws::find_law("vaiana").index_of("Kb-");
  EXPECT_FALSE(vaiana_box({"vaiana.Kb-=Kb+", "vaiana.Kb-=free"}).parameters[minus].tied_to);
  EXPECT_TRUE(vaiana_box({"vaiana.Kb-=Kb+", "vaiana.Kb-=free"}).parameters[minus].free);
  EXPECT_TRUE(vaiana_box({"vaiana.Kb-=1e5", "vaiana.Kb-=Kb+"}).parameters[minus].tied_to);
}

TEST(Box, RefusesAChainOfTies) {
  for (auto const& texts : {std::vector{"vaiana.Kb-=Kb+", "vaiana.Kb+=Kb-"}, {"vaiana.beta1-=f0+", "vaiana.f0+=f0-"}})
    try {
      vaiana_box(texts);
      ADD_FAILURE() << texts.front() << " was accepted with " << texts.back();
    } catch (Error const& error) {
      EXPECT_NE(std::string(error.what()).find("is tied to"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("free or fixed"), std::string::npos) << error.what();
    }
}

// A parameter stays tied to another when the search scales are made logarithmic.
TEST(Box, ATieOutlivesLogarithmicScales) {
  auto const& law = laws::find_law("vaiana");
  auto const box = on_logarithmic_scales(vaiana_box({"vaiana.f0-=f0+"}), law);
  std::vector<double> point(box.free_count(), 0.3), values(box.parameters.size());
  box.expand(point, values);
  EXPECT_EQ(values[law.index_of("f0-")], values[law.index_of("f0+")]);
}

// --- scales of a record ---

// Returns three cycles of ±100 mm of a bilinear device from rest: K1 = 2.5 and K2 = 0.5 kN/mm, xy = 20 mm. Then
// Qd = (K1 - K2) xy = 40 kN, the peak force is K2 100 + Qd = 90 kN and the effective stiffness is 0.9 kN/mm.
data::FitRecord bilinear_loop() {
  data::FitRecord record;
  constexpr int samples_per_cycle = 4000;
  double z = 0.0, before = 0.0;
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples_per_cycle, x = 100.0 * std::sin(phase);
    z = std::min(40.0, std::max(-40.0, z + 2.0 * (x - before)));
    before = x;
    record.time_s.push_back(2.0 * i / samples_per_cycle);
    record.disp_mm.push_back(x);
    record.vel_mm_s.push_back(100.0 * std::numbers::pi * std::cos(phase));
    record.force_kN.push_back(0.5 * x + z);
  }
  return record;
}

TEST(Scales, OfABilinearLoopInTheUnitsOfEveryLaw) {
  auto const record = bilinear_loop();
  // The work done over the whole record is the sum of two parts. The device dissipates 40 kN times a plastic travel of
  // 80 + 5 * 160 + 60 mm. At the end it stores Qd^2 / (2 (K1 - K2)) = 400 kN mm.
  double const work_kN_mm = 40.0 * 940.0 + 400.0;
  for (auto const& law : laws::catalogue()) {
    double const L = law.info.length.in_record_units, F = law.info.force.in_record_units;
    auto const s = scales_of(record, law.info);
    EXPECT_NEAR(s.disp * L, 100.0, 1e-9) << law.info.id;
    EXPECT_NEAR(s.force * F, 90.0, 1e-9) << law.info.id;
    EXPECT_NEAR(s.stiffness * F / L, 0.9, 1e-9) << law.info.id;
    EXPECT_NEAR(s.strength * F, 40.0, 1e-6) << law.info.id;
    EXPECT_NEAR(s.velocity * L, 100.0 * std::numbers::pi, 1e-9) << law.info.id;
    EXPECT_NEAR(s.work * F * L, work_kN_mm, 2e-4 * work_kN_mm) << law.info.id;
  }
  // scales_of() must give scales in the units of the law: N and m for Jankowski, N and cm for Hwang-Wu.
  auto const newton_metre = scales_of(record, laws::find_law("jankowski").info);
  EXPECT_NEAR(newton_metre.stiffness, 0.9e6, 1.0);
  EXPECT_NEAR(newton_metre.strength, 40e3, 1.0);
  EXPECT_NEAR(newton_metre.disp, 0.1, 1e-9);
  EXPECT_NEAR(newton_metre.work, 38e3, 10.0);
  auto const newton_centimetre = scales_of(record, laws::find_law("hwang-wu").info);
  EXPECT_NEAR(newton_centimetre.stiffness, 9000.0, 1e-3);
  EXPECT_NEAR(newton_centimetre.work, 38e5, 1e3);
  EXPECT_NEAR(newton_centimetre.velocity, 10.0 * std::numbers::pi, 1e-9);
}

TEST(Scales, DoNotDependOnTheSignOfTheFirstMotion) {
  auto record = bilinear_loop();
  auto const& law = laws::find_law("bilinear").info;
  auto const expected = scales_of(record, law);
  for (double& x : record.disp_mm) x = -x;
  for (double& f : record.force_kN) f = -f;
  auto const s = scales_of(record, law);
  EXPECT_DOUBLE_EQ(s.stiffness, expected.stiffness);
  EXPECT_DOUBLE_EQ(s.strength, expected.strength);
  EXPECT_DOUBLE_EQ(s.work, expected.work);
}

TEST(Scales, OfARecordWithoutTimeHaveNoVelocity) {
  auto record = bilinear_loop();
  record.vel_mm_s.clear();
  EXPECT_EQ(scales_of(record, laws::find_law("bilinear").info).velocity, 0.0);
  EXPECT_NEAR(scales_of(record, laws::find_law("bilinear").info).strength, 40.0, 1e-6);
}

// Expects that the record gives every rate-independent law a box that can be searched.
void expect_usable(data::FitRecord const& record, std::string const& what) {
  for (auto const& law : laws::catalogue()) {
    if (!law.info.traits.rate_independent) continue;  // the other laws need velocities, and these records have no time
    auto const id = law.info.id;
    auto const s = scales_of(record, law.info);
    for (double const value : {s.disp, s.force, s.stiffness, s.strength, s.work}) {
      EXPECT_GT(value, 0.0) << what << ", " << id;
      EXPECT_TRUE(std::isfinite(value)) << what << ", " << id;
    }
    for (auto const& p : make_box(law, BoxKind::scaled, s, {}).parameters) {
      EXPECT_LT(p.lower, p.upper) << what << ", " << id << " " << p.name;
      EXPECT_TRUE(std::isfinite(p.at(0.5))) << what << ", " << id << " " << p.name;
    }
  }
}

TEST(Scales, OfDegenerateRecordsAreStillUsable) {
  auto const record = [](std::vector<double> x, std::vector<double> f) {
    data::FitRecord fit_record{
        .time_s = {}, .disp_mm = std::move(x), .vel_mm_s = {}, .force_kN = std::move(f), .cleaning = {}};
    for (std::size_t i = 0; i < fit_record.disp_mm.size(); ++i) fit_record.time_s.push_back(static_cast<double>(i));
    return fit_record;
  };
  expect_usable(record({50, 100, 150, 100, 50}, {10, 60, 90, 20, 5}), "no crossing of zero");
  expect_usable(record({-50, -100, -150, -100}, {-10, -60, -90, -20}), "never positive");
  expect_usable(record({0, 100, 0, -100, 0}, {0, -90, 0, 90, 0}), "negative slope");
  expect_usable(record({0, 100, 0, -100, 0}, {0, 80, 0, -80, 0}), "no dissipation");
  expect_usable(record({0, 100, 0, -100, 0}, {0, 80, -30, -80, 30}), "dissipation of the wrong sign");
  expect_usable(record({0, 100, 0, -100, 0}, {50, 50, 50, 50, 51}), "no slope");
  expect_usable(record({0, 1e-3}, {0, 1e-3}), "two samples");
}

}  // namespace
}  // namespace isolaw::fit
