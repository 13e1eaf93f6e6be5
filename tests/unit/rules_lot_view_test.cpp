// Tests the rules applied to a lot: spread, sample, outliers, limits on the mean and modification factors, all worked
// out by hand.
#include <cmath>
#include <random>

#include "rules_fixture.hpp"

namespace isolaw::rules {
namespace {

using testing::block;
using testing::cycle;
using testing::expect_parts;
using testing::rules_of;

constexpr std::string_view limits =
    "[[limit]]\nquantity = \"K_eff\"\napplies_to = \"each\"\nwithin_percent = 20\n"
    "[[limit]]\nquantity = \"K_eff\"\napplies_to = \"mean\"\nwithin_percent = 10\nclause = \"mean\"\n";

std::vector<DeviceValues> lot_of(std::vector<double> const& factors) {
  std::vector<DeviceValues> devices;
  for (double const factor : factors) devices.push_back({fmt::format("D{}", devices.size() + 1), block(factor)});
  return devices;
}

LotQuantity const& of(LotView const& lot, Quantity quantity) {
  for (auto const& view : lot.quantities)
    if (view.quantity == quantity) return view;
  throw std::logic_error("every quantity has a view");
}

Bound const& bound(LotQuantity const& view, std::string_view source) {
  for (auto const& one : view.bounds)
    if (one.source == source) return one;
  throw std::logic_error("no bound " + std::string(source));
}

TEST(LotView, SaysTheLimitOnEachDevice) {
  auto const lot = lot_view(rules_of(R"([[limit]]
quantity = "K_eff"
applies_to = "each"
within_percent = 20
[[limit]]
quantity = "K_eff"
applies_to = "mean"
within_percent = 10
[[limit]]
quantity = "damping"
applies_to = "each"
lower_percent = -10
)"),
                            lot_of({1.0, 1.0}), {});
  auto const &stiffness = of(lot, Quantity::K_eff), &damping = of(lot, Quantity::damping);
  EXPECT_EQ(stiffness.limit_individual, "from -20 % to +20 %");
  EXPECT_EQ(stiffness.lower_percent, -20.0);
  EXPECT_EQ(stiffness.upper_percent, 20.0);
  EXPECT_EQ(damping.limit_individual, "at least -10 %");
  EXPECT_EQ(damping.lower_percent, -10.0);
  EXPECT_EQ(damping.upper_percent, std::nullopt);
  EXPECT_EQ(of(lot, Quantity::Q_d).limit_individual, "");
}

TEST(LotView, DescribesTheSpread) {
  // K_eff is 1.08, 1.2, 1.32 and 1.2: the mean is 1.2, the standard deviation s = sqrt(2 x 0.12^2/3) = 0.0979796 and
  // the coefficient of variation (CoV) 8.16497 %. The fractiles are mean ± 1.644854 s = 1.038838 and 1.361162. With the
  // exact tolerance factor k = 6.3411 of four devices, the tolerance bounds are 1.2 ± 0.621298.
  auto const lot = lot_view(rules_of(limits), lot_of({0.9, 1.0, 1.1, 1.0}), parse_design("K_eff=1"), 28);
  auto const& view = of(lot, Quantity::K_eff);
  EXPECT_EQ(view.count, 4u);
  EXPECT_EQ(view.unit, "kN/mm");
  EXPECT_NEAR(*view.mean, 1.2, 1e-12);
  EXPECT_NEAR(*view.std, 0.0979796, 1e-7);
  EXPECT_NEAR(*view.cov_percent, 8.16497, 1e-5);
  EXPECT_NEAR(*view.min, 1.08, 1e-12);
  EXPECT_EQ(view.min_device, "D1");
  EXPECT_EQ(view.max_device, "D3");
  EXPECT_NEAR(*view.mean_deviation_percent, 20.0, 1e-10);
  EXPECT_NEAR(*view.worst_deviation_percent, 32.0, 1e-10);
  EXPECT_EQ(view.worst_device, "D3");
  EXPECT_NEAR(*view.fractile_5, 1.038838, 1e-6);
  EXPECT_NEAR(*view.fractile_95, 1.361162, 1e-6);
  EXPECT_NEAR(*view.tolerance_factor, 6.3411, 1e-4);
  EXPECT_NEAR(*view.tolerance_low, 1.2 - 0.621298, 2e-5);
  EXPECT_NEAR(*view.tolerance_high, 1.2 + 0.621298, 2e-5);
  EXPECT_NEAR(*view.largest_from_mean_percent, 10.0, 1e-10);
  EXPECT_TRUE(view.outliers.empty());
  EXPECT_EQ(view.outlier_note, "");
}

TEST(LotView, NamesOutliersOfFourDevicesOrMore) {
  auto const of_three = lot_view(find_rule_set("ntc-2018"), lot_of({1.0, 1.0, 2.0}), {}, 3);
  EXPECT_TRUE(of(of_three, Quantity::K_eff).outliers.empty());
  expect_parts(of(of_three, Quantity::K_eff).outlier_note, {"too few devices to name outliers: 3, at least 4"});
  auto const of_four = lot_view(find_rule_set("ntc-2018"), lot_of({1.0, 1.0, 1.01, 2.0}), {}, 4);
  ASSERT_EQ(of(of_four, Quantity::K_eff).outliers.size(), 1u);
  EXPECT_EQ(of(of_four, Quantity::K_eff).outliers[0].device, "D4");
}

TEST(LotView, TakesTheMeanOfBothSides) {
  auto devices = lot_of({1.0, 1.0});
  devices[0].block.cycles[2].F_plus_kN = 130;  // the sides have 1.3 and 1.2 kN/mm, whose mean is 1.25
  auto const lot = lot_view(find_rule_set("ntc-2018"), devices, {}, 2);
  EXPECT_NEAR(*of(lot, Quantity::K_eff).max, 1.25, 1e-12);
  EXPECT_EQ(of(lot, Quantity::K_eff).max_device, "D1");
}

TEST(LotView, SaysWhichDevicesHaveNoValue) {
  auto devices = lot_of({1.0, 1.0, 1.0});
  devices[1].block.cycles.pop_back();
  auto const lot = lot_view(rules_of(limits), devices, parse_design("K_eff=1.2"), 3);
  EXPECT_EQ(of(lot, Quantity::K_eff).count, 2u);
  EXPECT_EQ(of(lot, Quantity::K_eff).devices_without_value, std::vector<std::string>{"D2"});
  auto const& line = of(lot, Quantity::K_eff).mean_limits.at(0);
  EXPECT_EQ(line.verdict, Verdict::not_assessed);
  expect_parts(line.reason, {"no value of D2"});
}

TEST(LotView, OfOneDeviceOrNoneHasNoSpread) {
  auto const one = lot_view(rules_of(limits), lot_of({1.0}), {}, 1);
  EXPECT_NEAR(*of(one, Quantity::K_eff).mean, 1.2, 1e-12);
  EXPECT_FALSE(of(one, Quantity::K_eff).std);
  EXPECT_FALSE(of(one, Quantity::K_eff).largest_from_mean_percent);
  EXPECT_TRUE(of(one, Quantity::K_eff).bounds.empty());
  auto const none = lot_view(rules_of(limits), std::vector<DeviceValues>(), {});
  EXPECT_FALSE(of(none, Quantity::K_eff).mean);
  EXPECT_TRUE(of(none, Quantity::K_eff).bounds.empty());
}

TEST(LotView, OneDeviceIsNoLot) {
  auto const design = parse_design("K_eff=1.2");
  auto const one = lot_view(rules_of(limits), lot_of({1.0}), design, 10);
  expect_parts(one.note, {"one device is no lot"});
  auto const& line = of(one, Quantity::K_eff).mean_limits.at(0);
  EXPECT_EQ(line.verdict, Verdict::not_assessed);
  expect_parts(line.reason, {"one device is no lot"});
  EXPECT_EQ(lot_view(rules_of(limits), lot_of({1.0, 1.0}), design, 10).note, "");
  // If the lot has one device in all, its value is the mean of the lot.
  auto const whole = lot_view(rules_of(limits), lot_of({1.0}), design, 1);
  EXPECT_EQ(whole.note, "");
  EXPECT_EQ(of(whole, Quantity::K_eff).mean_limits.at(0).verdict, Verdict::pass);
}

TEST(LotView, WithoutRulesTheSampleSaysSo) {
  EXPECT_EQ(lot_view({}, lot_of({1.0, 1.0}), {}).sample.reason, "no rule set was asked for");
}

TEST(LotView, ANegativeBoundIsNone) {
  // K_eff is 0.96 and 1.44: the mean is 1.2 and s = 0.339411. With the exact tolerance factor k = 36.519 of two
  // devices, the lower bound 1.2 - 12.4 is negative.
  auto const lot = lot_view({}, lot_of({0.8, 1.2}), {}, 28);
  auto const& view = of(lot, Quantity::K_eff);
  EXPECT_FALSE(view.tolerance_low);
  EXPECT_NEAR(*view.tolerance_factor, 36.519, 1e-3);
  EXPECT_NEAR(*view.tolerance_high, 1.2 + 36.519 * 0.339411, 1e-3);
  EXPECT_NEAR(*view.fractile_5, 1.2 - 1.644854 * 0.339411, 1e-5);
  expect_parts(view.no_lower, {"too few devices for a lower bound"});
  auto const& each = bound(view, "statistical, each device");
  for (double const none : {each.spec.min, each.combined.min, each.lower}) EXPECT_TRUE(std::isnan(none));
  EXPECT_GT(each.upper, 1.2);
  expect_parts(each.no_lower, {"too few devices for a lower bound"});
  expect_parts(each.note, {"k = 36.52"});
  // The predicted mean of all 28 devices has the half width t(0.975, 1) = 12.7062 times the CoV 28.2843 % times
  // sqrt(1/2 - 1/28): 244.9 % of the mean.
  expect_parts(bound(view, "statistical, system predicted").no_lower, {"245 % of the mean"});
  EXPECT_EQ(bound(view, "observed").no_lower, "");
  EXPECT_GT(bound(view, "observed").lower, 0.0);
}

TEST(LotView, LimitsTheMean) {
  auto const line = [](std::vector<double> const& factors) {
    auto const lot = lot_view(rules_of(limits), lot_of(factors), parse_design("K_eff=1.2"), 10);
    return of(lot, Quantity::K_eff).mean_limits.at(0);
  };
  EXPECT_EQ(line({1.05, 1.15}).verdict, Verdict::pass);  // the mean is 10 % above, exactly at the limit
  EXPECT_EQ(line({1.05, 1.151}).verdict, Verdict::fail);
  EXPECT_EQ(line({0.9, 0.9}).verdict, Verdict::pass);
  EXPECT_NEAR(*line({1.05, 1.15}).deviation_percent, 10.0, 1e-9);
  EXPECT_EQ(line({1.0, 1.0}).quantity, "K_eff, mean of 2 devices");
  EXPECT_EQ(line({1.0, 1.0}).clause, "mean");
}

TEST(LotView, JudgesTheSample) {
  auto const ntc = find_rule_set("ntc-2018");
  auto const sample = [&](std::size_t tested, std::optional<int> size) {
    return lot_view(ntc, lot_of(std::vector(tested, 1.0)), {}, size).sample;
  };
  EXPECT_EQ(sample(6, 28).verdict, Verdict::pass);
  EXPECT_EQ(sample(6, 28).limit, "6 or more of 28");
  EXPECT_EQ(sample(5, 28).verdict, Verdict::fail);
  EXPECT_EQ(sample(6, {}).verdict, Verdict::not_assessed);
  EXPECT_EQ(lot_view(rules_of(limits), lot_of({1.0}), {}, 28).sample.verdict, Verdict::not_assessed);
  expect_parts(refusal_of([&] { sample(6, 5); }), {"--lot-size: 5 with 6 devices tested"});
  EXPECT_EQ(lot_view(RuleSet{}, lot_of({1.0}), {}, 28).sample.reason, "no rule set was asked for");
  EXPECT_EQ(lot_view(rules_of(limits), lot_of({1.0}), {}, 28).sample.reason,
            rules_of(limits).id + " has no rule for the sample");
}

// One of three devices has the same record as another. It counts neither in the sample nor in means and spreads.
TEST(LotView, ACopyIsNoFurtherDeviceTested) {
  auto const rules = rules_of(fmt::format("[sample]\nshare_percent = 20\nleast = 3\n{}", limits));
  auto devices = lot_of({0.99, 1.01, 1.01});
  auto const three = lot_view(rules, devices, parse_design("K_eff=1.2"), 3);
  EXPECT_EQ(three.sample.verdict, Verdict::pass);
  EXPECT_EQ(of(three, Quantity::K_eff).mean_limits.at(0).verdict, Verdict::pass);
  devices[2].copy_of = "D2";
  auto const lot = lot_view(rules, devices, parse_design("K_eff=1.2"), 3);
  EXPECT_EQ(lot.devices, 2u);
  EXPECT_EQ(lot.sample.value, 2.0);
  EXPECT_EQ(lot.sample.verdict, Verdict::fail);
  auto const& stiffness = of(lot, Quantity::K_eff);
  auto const two = lot_view(rules, lot_of({0.99, 1.01}), {});
  EXPECT_EQ(stiffness.count, 2u);
  EXPECT_EQ(stiffness.mean, of(two, Quantity::K_eff).mean);
  EXPECT_EQ(stiffness.std, of(two, Quantity::K_eff).std);
  EXPECT_EQ(stiffness.tolerance_factor, of(two, Quantity::K_eff).tolerance_factor);
  EXPECT_EQ(stiffness.mean_limits.at(0).verdict, Verdict::not_assessed);
  expect_parts(stiffness.mean_limits.at(0).reason,
               {"2 devices with this property, 3 required", "D3: the same record as D2, left out of the mean"});
  EXPECT_EQ(name(stiffness.mean_limits.at(0).subject), "lot");
  expect_parts(bound(stiffness, "statistical, system").note, {"mean of 3 devices, 2 of them tested"});
  EXPECT_EQ(name(bound(stiffness, "statistical, system").scope), "system");
  EXPECT_EQ(name(bound(stiffness, "observed").scope), "device");
  devices.erase(devices.begin());
  auto const one = lot_view(rules, devices, parse_design("K_eff=1.2"), 3);
  expect_parts(one.note, {"one device is no lot"});
  EXPECT_FALSE(of(one, Quantity::K_eff).cov_percent);
}

// Exports use these bounds. With the same standard deviation, bounds from fewer devices are wider.
TEST(LotView, BoundsFromFewDevicesAreWider) {
  auto const width = [](std::size_t devices) {
    auto const n = static_cast<double>(devices);
    std::vector<double> values(devices, 1.0);  // with a standard deviation of 1 %
    values.front() += 0.01 * std::sqrt((n - 1.0) / 2.0), values.back() -= 0.01 * std::sqrt((n - 1.0) / 2.0);
    auto const lot = lot_view({}, lot_of(values), {});
    auto const& stiffness = of(lot, Quantity::K_eff);
    EXPECT_NEAR(*stiffness.cov_percent, 1.0, 1e-9);
    auto const& spec = bound(stiffness, "statistical, each device").spec;
    return spec.max - spec.min;
  };
  EXPECT_NEAR(width(3), 2.0 * 9.7888 * 0.01, 1e-5);  // exact factors of ISO 16269-6
  EXPECT_NEAR(width(10), 2.0 * 3.3934 * 0.01, 1e-5);
  EXPECT_NEAR(width(30), 2.0 * 2.5549 * 0.01, 1e-5);
}

TEST(LotView, ASampleTooSmallLeavesTheMeanOpen) {
  auto const rules = rules_of(fmt::format("[sample]\nshare_percent = 20\nleast = 4\n{}", limits));
  auto const line = [&](std::size_t tested, std::optional<int> size) {
    auto const lot = lot_view(rules, lot_of(std::vector(tested, 1.0)), parse_design("K_eff=1.2"), size);
    return of(lot, Quantity::K_eff).mean_limits.at(0);
  };
  EXPECT_EQ(line(6, 28).verdict, Verdict::pass);
  EXPECT_EQ(line(5, 28).reason, "5 devices with this property, 6 required");
  expect_parts(line(6, {}).reason, {"size of the lot not known"});
}

TEST(Outliers, AreNamedWithTheProperty) {
  // The median is 1.2 and the deviations are 0.012, 0, 0.012, 0.024 and 0.6. The MAD is 0.012 and the score 0.6/(1.4826
  // x 0.012) = 33.7.
  auto const lot = lot_view(rules_of(limits), lot_of({0.99, 1.0, 1.01, 0.98, 1.5}), {});
  auto const& view = of(lot, Quantity::K_eff);
  ASSERT_EQ(view.outliers.size(), 1u);
  EXPECT_EQ(view.outliers[0].device, "D5");
  EXPECT_NEAR(view.outliers[0].score, 0.6 / (1.4826 * 0.012), 1e-9);
  EXPECT_EQ(view.outliers[0].reason, "50 % above the median: modified z 33.7, above 3.5");
  EXPECT_EQ(view.outlier_note, "");
  EXPECT_TRUE(of(lot, Quantity::damping).outliers.empty());
}

TEST(Outliers, AreNotNamedAmongNearlyIdenticalDevices) {
  std::vector<std::string> const names{"A", "B", "C", "D", "E"};
  auto const count = [&](std::vector<double> const& values) { return find_outliers(names, values).size(); };
  EXPECT_EQ(count({1, 1, 1, 1, 1}), 0u);
  EXPECT_EQ(count({1, 1, 1, 1, 1.0174}), 0u);  // 1.74 % is below the threshold, 3.5 x 0.5 % = 1.75 %
  EXPECT_EQ(count({1, 1, 1, 1, 1.0176}), 1u);
  EXPECT_EQ(count({1, 1, 1, 1, 0.9}), 1u);
  EXPECT_EQ(count({0, 0, 0, 0, 0}), 0u);
  EXPECT_TRUE(find_outliers(std::span(names).first(3), std::vector<double>{1, 1, 9}).empty());
}

// The values of Q_d are those of a measured bearing, in kN. They rise from the first cycle to the second and fall
// afterwards, so the factors must be those of cycles 2 and 7, relative to the mean of the first three cycles.
TEST(TestFactors, EncloseEveryCountedCycle) {
  auto tested = block(1.0, 7);
  std::vector<double> const Q_d{56.93, 58.96, 57.98, 57.1, 56.5, 56.07, 55.21};
  for (std::size_t i = 0; i < Q_d.size(); ++i) tested.cycles[i].Q_d_kN = Q_d[i];
  auto const factors = test_factors(Quantity::Q_d, tested);
  double const mean = (56.93 + 58.96 + 57.98) / 3.0;
  EXPECT_NEAR(factors->max, 58.96 / mean, 1e-12);
  EXPECT_NEAR(factors->min, 55.21 / mean, 1e-12);
  EXPECT_EQ(factors->max_cycle, 2);
  EXPECT_EQ(factors->min_cycle, 7);
  auto const lot = lot_view({}, std::vector<DeviceValues>{{"A", tested}, {"B", block(1.0, 7)}}, {});
  auto const& view = of(lot, Quantity::Q_d);
  EXPECT_EQ(view.test_max_device, "A");
  EXPECT_GT(bound(view, "observed").upper, 57.98);  // the reported cycle, the third, has 57.98 kN
  EXPECT_FALSE(test_factors(Quantity::Q_d, [&] {
    tested.cycles[4].Q_d_kN = 0.0;
    return tested;
  }()));
}

TEST(TestFactors, CompareTheFirstAndTheLastWithTheFirstThree) {
  // K_eff is 1.5, 1.2 and 1.2 in the first three cycles (mean 1.3) and 1.0 in the last. The largest and the smallest
  // factor are 1.5/1.3 and 1.0/1.3.
  auto tested = block(1.0, 5);
  tested.cycles[0] = cycle(1, 1.25);
  tested.cycles[4].K_eff_kN_per_mm = 1.0;
  auto const factors = test_factors(Quantity::K_eff, tested);
  EXPECT_NEAR(factors->max, 1.5 / 1.3, 1e-12);
  EXPECT_NEAR(factors->min, 1.0 / 1.3, 1e-12);
  EXPECT_EQ(factors->max_cycle, 1);
  EXPECT_EQ(factors->min_cycle, 5);
  // If K_eff grows, here 0.7, 0.9 and 0.9 (mean 2.5/3) and 1.0 in the last cycle, the factors are 1.2 and 0.84.
  for (auto& c : tested.cycles) c.K_eff_kN_per_mm = c.number == 1 ? 0.7 : c.number == 5 ? 1.0 : 0.9;
  auto const growing = test_factors(Quantity::K_eff, tested);
  EXPECT_NEAR(growing->max, 1.2, 1e-12);
  EXPECT_NEAR(growing->min, 0.84, 1e-12);
  tested.cycles.erase(tested.cycles.begin());
  EXPECT_FALSE(test_factors(Quantity::K_eff, tested));
  EXPECT_FALSE(test_factors(Quantity::K_v, block()));
}

TEST(Combine, IsTheFormulaOfTheRules) {
  // The products are (1 + 0.75 x 0.3) 1.1 x 1.15 = 1.549625 and (1 - 0.75 x 0.1) 0.9 x 0.85 = 0.707625.
  FactorPair const environment{.min = 0.9, .max = 1.3}, test{.min = 0.9, .max = 1.1}, spec{.min = 0.85, .max = 1.15};
  FactorRule rule;
  rule.system_factor = 0.75;
  auto const free = combine(rule, environment, test, spec);
  EXPECT_NEAR(free.max, 1.549625, 1e-12);
  EXPECT_NEAR(free.min, 0.707625, 1e-12);
  EXPECT_FALSE(free.max_is_default || free.min_is_default);
  rule.max_not_below = 1.8;
  rule.min_not_above = 0.6;
  auto const bounded = combine(rule, environment, test, spec);
  EXPECT_EQ(bounded.max, 1.8);
  EXPECT_EQ(bounded.min, 0.6);
  EXPECT_TRUE(bounded.max_is_default && bounded.min_is_default);
  EXPECT_GT(combine(rule, {.min = 1, .max = 2}, test, spec).max, 1.8);
}

TEST(BoundScope, KeepsTheDeviceAndTheSystemApart) {
  // If the CoV is known to be 7 %, the mean of 28 devices has the half width 1.95996 x 7/sqrt(28) = 2.5928 %. If six of
  // them are tested, only the other 22 are unknown, and this half width times sqrt(22/27) is 2.3404 %. If the CoV too
  // is estimated from the six, the half width is t(0.975, 5) = 2.570582 times 7 sqrt(1/6 - 1/28) = 6.5116 %.
  EXPECT_NEAR(system_half_width_percent(7, 28, 0), 2.5928, 1e-4);
  EXPECT_NEAR(system_half_width_percent(7, 28, 1), 2.5928, 1e-4);
  EXPECT_NEAR(system_half_width_percent(7, 28, 6), 2.3404, 1e-4);
  EXPECT_EQ(system_half_width_percent(7, 28, 28), 0.0);
  EXPECT_EQ(system_half_width_percent(7, 1, 1), 0.0);
  EXPECT_NEAR(system_half_width_percent(7, 1, 0), 13.7197, 1e-4);
  EXPECT_NEAR(prediction_half_width_percent(7, 28, 6), 6.5116, 1e-4);
  EXPECT_EQ(prediction_half_width_percent(7, 28, 28), 0.0);
  EXPECT_TRUE(std::isnan(prediction_half_width_percent(7, 28, 1)));
}

// The prediction from six tested devices must contain the mean of the lot in 95 % of lots drawn from a normal
// distribution.
TEST(BoundScope, ThePredictionOfTheSystemHolds95PercentOfLots) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> device(1.0, 0.07);
  int held = 0, lots = 20'000;
  for (int i = 0; i < lots; ++i) {
    double sum = 0.0, tested_sum = 0.0, squares = 0.0;
    for (int d = 0; d < 28; ++d) {
      double const value = device(random);
      sum += value;
      if (d >= 6) continue;
      tested_sum += value;
      squares += value * value;
    }
    double const mean = tested_sum / 6, s = std::sqrt((squares - 6 * mean * mean) / 5);
    held += std::abs(sum / 28 - mean) <= mean * prediction_half_width_percent(100 * s / mean, 28, 6) / 100;
  }
  EXPECT_NEAR(held / static_cast<double>(lots), 0.95, 0.005);  // the tolerance is three standard errors
}

TEST(Bounds, AreLabelledBySource) {
  auto const rules = rules_of(fmt::format(
      "{}[factors]\nsystem_factor = 0.75\n[[factor]]\nquantity = \"K_eff\"\nenvironment_min = 0.9\nenvironment_max = 1.3\nspec_min = 0.85\nspec_max = 1.15\n",
      limits));
  // The mean equals the design value of 1.2. The CoV is 8.16497 %. All cycles of a device are alike except the third.
  auto const lot = lot_view(rules, lot_of({0.9, 1.0, 1.1, 1.0}), parse_design("K_eff=1.2"), 28);
  auto const& view = of(lot, Quantity::K_eff);
  // The cycles of device 0.9 are in the ratio 1 : 1 : 0.9, so the third over the mean of the three is 2.7/2.9, the
  // least factor. Those of device 1.1 are in the ratio 1 : 1 : 1.1, so the third over the mean is 3.3/3.1, the largest
  // factor.
  EXPECT_NEAR(view.test_factors->max, 3.3 / 3.1, 1e-12);
  EXPECT_NEAR(view.test_factors->min, 2.7 / 2.9, 1e-12);
  auto const& contract = bound(view, "contract band");
  EXPECT_NEAR(contract.combined.max, 1.225 * 3.3 / 3.1 * 1.15, 1e-12);
  EXPECT_NEAR(contract.upper, 1.2 * 1.225 * 3.3 / 3.1 * 1.15, 1e-12);
  EXPECT_NEAR(contract.lower, 1.2 * 0.925 * 2.7 / 2.9 * 0.85, 1e-12);
  EXPECT_NEAR(bound(view, "observed").spec.min, 0.9, 1e-12);
  EXPECT_NEAR(bound(view, "observed").spec.max, 1.1, 1e-12);
  // The tolerance factor times the CoV is 6.3411 x 8.16497 = 51.7749 %.
  EXPECT_NEAR(bound(view, "statistical, each device").spec.max, 1.517749, 1e-5);
  EXPECT_NEAR(bound(view, "statistical, each device").spec.min, 1 - 0.517749, 1e-5);
  // If four of the 28 devices are tested and the CoV is known, the mean of all 28 has the half width 1.95996 x
  // 8.16497/sqrt(28) x sqrt(24/27) = 2.85130 %. If the CoV is estimated, the half width is t(0.975, 3) = 3.182446 times
  // 8.16497 sqrt(1/4 - 1/28) = 12.0286 %.
  EXPECT_NEAR(bound(view, "statistical, system").spec.max, 1.0285130, 1e-6);
  EXPECT_NEAR(bound(view, "statistical, system predicted").spec.min, 1 - 0.120286, 1e-6);
  EXPECT_EQ(view.bounds.size(), 5u);
}

TEST(Bounds, TakeTheDefaultsOnlyOfPropertiesTheSetNames) {
  // All cycles are alike, so the test factors are 1 and only the factors 1.15 and 0.85 of the supply remain. For K_d
  // the file of ASCE 7 has the default factors 1.8 and 0.6, which replace them. The file has no [[factor]] for K_eff.
  auto const lot = lot_view(find_rule_set("asce-7-22"), lot_of({1.0, 1.0}), parse_design("K_eff=1.2,K_d=0.9"));
  auto const& named = bound(of(lot, Quantity::K_d), "contract band");
  EXPECT_NEAR(named.upper, 0.9 * 1.8, 1e-12);
  EXPECT_NEAR(named.lower, 0.9 * 0.6, 1e-12);
  EXPECT_TRUE(named.combined.max_is_default && named.combined.min_is_default);
  EXPECT_NEAR(named.spec.max, 1.15, 1e-12);
  EXPECT_NEAR(bound(of(lot, Quantity::K_eff), "observed").upper, 1.2, 1e-12);
}

TEST(Bounds, AreRelativeToTheMeanWithoutADesignValue) {
  auto const lot = lot_view(rules_of(limits), lot_of({0.9, 1.0, 1.1, 1.0}), {});
  auto const& view = of(lot, Quantity::K_eff);
  EXPECT_NEAR(bound(view, "observed").spec.max, 1.1, 1e-12);
  EXPECT_EQ(view.bounds.size(), 2u);  // neither a contract band nor the size of the lot is given
}

TEST(MeanAnalysis, IsPermittedUpTo20Percent) {
  auto const ntc = find_rule_set("ntc-2018");
  auto const permitted = [&](std::vector<double> const& factors) {
    return of(lot_view(ntc, lot_of(factors), {}, 3), Quantity::K_eff).mean_analysis_permitted;
  };
  EXPECT_EQ(permitted({0.8, 1.0, 1.2}), true);
  EXPECT_EQ(permitted({0.79, 1.0, 1.21}), false);
  EXPECT_EQ(permitted({0.79, 1.1, 1.11}), false);
  EXPECT_EQ(permitted({1.0}), std::nullopt);
  EXPECT_EQ(of(lot_view(rules_of(limits), lot_of({1, 1}), {}), Quantity::K_eff).mean_analysis_permitted, std::nullopt);
}

TEST(MeanAnalysis, IsPermittedOnlyByASampleTheSetAsksFor) {
  auto const ntc = find_rule_set("ntc-2018");
  auto const view = [&](std::vector<double> const& factors, std::optional<int> size) {
    return of(lot_view(ntc, lot_of(factors), {}, size), Quantity::K_eff);
  };
  EXPECT_EQ(view({1.0, 1.0, 1.0, 1.0}, 20).mean_analysis_permitted, true);
  EXPECT_EQ(view({1.0, 1.0, 1.0}, 20).mean_analysis_permitted, std::nullopt);
  EXPECT_EQ(view({1.0, 1.0, 1.0}, 20).mean_analysis_open, "3 devices with this property, 4 required");
  expect_parts(view({1.0, 1.0, 1.0}, {}).mean_analysis_open, {"size of the lot not known"});
  EXPECT_EQ(view({0.7, 1.0, 1.3}, 20).mean_analysis_permitted, false);
  EXPECT_EQ(view({0.7, 1.0, 1.3}, 20).mean_analysis_open, "");
}

TEST(LotView, DoesNotDependOnTheUnits) {
  auto const rules = find_rule_set("asce-7-22");
  auto devices = lot_of({0.93, 1.02, 1.1, 0.97, 1.01, 1.6});
  auto const lot = lot_view(rules, devices, parse_design("K_eff=1.2,K_d=0.9"), 28);
  for (auto& device : devices)
    for (auto& one : device.block.cycles) {
      one.K_eff_kN_per_mm *= 57.1;
      one.K_d_kN_per_mm *= 57.1;
    }
  Design design;
  design.K_eff_kN_per_mm = 1.2 * 57.1;
  design.K_d_kN_per_mm = 0.9 * 57.1;
  auto const scaled = lot_view(rules, devices, design, 28);
  for (auto const quantity : {Quantity::K_eff, Quantity::K_d}) {
    auto const &a = of(lot, quantity), &b = of(scaled, quantity);
    EXPECT_NEAR(*a.cov_percent, *b.cov_percent, 1e-10);
    EXPECT_NEAR(*a.worst_deviation_percent, *b.worst_deviation_percent, 1e-10);
    EXPECT_EQ(a.worst_device, b.worst_device);
    ASSERT_EQ(a.outliers.size(), b.outliers.size());
    ASSERT_EQ(a.bounds.size(), b.bounds.size());
    for (std::size_t i = 0; i < a.bounds.size(); ++i) {
      EXPECT_NEAR(a.bounds[i].combined.max, b.bounds[i].combined.max, 1e-10);
      EXPECT_NEAR(a.bounds[i].upper * 57.1, b.bounds[i].upper, 1e-9);
    }
  }
}

}  // namespace
}  // namespace isolaw::rules
