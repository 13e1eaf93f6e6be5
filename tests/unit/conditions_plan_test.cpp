// Tests the plan of missing laboratory tests and the conversion of values to reference conditions. The values belong to
// the devices of `isolaw example --conditions`; an independent program computed them from closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isolaw/conditions/at_reference.hpp"
#include "isolaw/conditions/history_effects.hpp"
#include "isolaw/conditions/plan.hpp"

namespace isolaw::conditions {
namespace {

void expect_close(double value, double wanted, double relative) {
  EXPECT_NEAR(value, wanted, relative * std::abs(wanted));
}

Condition const at_20_C{.temperature_C = 20.0, .frequency_Hz = 0.5, .load_kN = 2000.0, .strain_percent = 100.0};

Condition with_temperature(double temperature_C) {
  auto condition = at_20_C;
  condition.temperature_C = temperature_C;
  return condition;
}
Condition with_frequency(double frequency_Hz) {
  auto condition = at_20_C;
  condition.frequency_Hz = frequency_Hz;
  return condition;
}
Condition with_ageing(double days, double at_C) {
  auto condition = at_20_C;
  condition.ageing = Ageing{.days = days, .at_C = at_C};
  return condition;
}

// Returns the response to temperature of three devices, from their K_eff at 20 C (the reference), -20, 0 and 40 C.
Response response_to_temperature() {
  std::vector<Sample> reference, others;
  auto const add = [&](std::string const& device, double at_m20, double at_0, double at_20, double at_40) {
    reference.push_back({.device = device, .condition = at_20_C, .ln = std::log(at_20)});
    for (auto const& [temperature_C, value] : {std::pair(-20.0, at_m20), std::pair(0.0, at_0), std::pair(40.0, at_40)})
      others.push_back({.device = device, .condition = with_temperature(temperature_C), .ln = std::log(value)});
  };
  add("P1", 0.920443205, 0.795688097, 0.699623055, 0.606563886);
  add("P2", 0.874677545, 0.760675817, 0.662182831, 0.583363248);
  add("P3", 0.887009150, 0.781493843, 0.680305320, 0.599928246);
  return {Effect::temperature, reference, others, at_20_C, {}};
}
Response response_to_frequency() {
  std::vector<Sample> const reference{{.device = "P4", .condition = at_20_C, .ln = 0.0}},
      others{{.device = "P4", .condition = with_frequency(0.1), .ln = std::log(0.927280900)},
             {.device = "P4", .condition = with_frequency(2.0), .ln = std::log(1.067708704)}};
  return {Effect::rate, reference, others, at_20_C, {}};
}

TEST(AtReference, is_the_measured_value_over_the_factors_of_its_conditions) {
  auto const temperature = response_to_temperature(), frequency = response_to_frequency();
  auto condition = with_temperature(26.0);
  condition.frequency_Hz = 0.1;
  std::vector<Part> const parts{{.effect = Effect::temperature, .factor = temperature.paired_at(condition)},
                                {.effect = Effect::rate, .factor = frequency.paired_at(condition)}};
  EXPECT_EQ(parts[0].factor.status, Status::interpolated);
  expect_close(parts[0].factor.lambda(), 0.961251217, 1e-8);
  EXPECT_EQ(parts[1].factor.status, Status::shown);
  auto const converted = at_reference(std::log(0.603681447), parts);
  ASSERT_TRUE(converted.ln);
  expect_close(std::exp(*converted.ln), 0.677266527, 1e-8);
  EXPECT_FALSE(converted.half_width) << "the frequency has one device";
  EXPECT_FALSE(converted.obstacle);
  auto const warm = at_reference(std::log(0.603681447), std::span(parts).first(1));
  ASSERT_TRUE(warm.half_width);
  expect_close(*warm.half_width, 0.014331821, 1e-6);
  expect_close(std::exp(*warm.ln), 0.603681447 / 0.961251217, 1e-8);
  auto const twice = at_reference(0.0, std::vector{parts[0], parts[0]});
  expect_close(*twice.half_width, std::sqrt(2.0) * 0.014331821, 1e-6);
  EXPECT_EQ(at_reference(1.5, {}).ln, 1.5);
}

TEST(AtReference, needs_factors_that_tests_show) {
  for (auto const status :
       {Status::extrapolated, Status::unpaired, Status::scaled, Status::assumed, Status::not_covered}) {
    std::vector<Part> const parts{{.effect = Effect::load, .factor = {.se = 0.01, .df = 2.0}},
                                  {.effect = Effect::rate, .factor = {.status = status, .se = 0.01, .df = 2.0}}};
    auto const converted = at_reference(0.0, parts);
    EXPECT_FALSE(converted.ln) << name(status);
    EXPECT_EQ(converted.obstacle, Effect::rate) << name(status);
  }
}

TEST(Response, names_the_levels_behind_a_factor) {
  auto const response = response_to_temperature();
  auto const at = [&](double temperature_C) {
    std::vector<double> levels;
    for (auto const* level : response.behind("P1", {.temperature_C = temperature_C})) levels.push_back(level->at);
    return levels;
  };
  EXPECT_EQ(at(-20.0), std::vector{-20.0});
  EXPECT_EQ(at(26.0), (std::vector{20.0, 40.0}));
  EXPECT_EQ(at(45.0), (std::vector{20.0, 40.0}));
  EXPECT_EQ(at(52.0), std::vector<double>());
}

// A device without a reference test cannot be compared with itself. Its test must not count in the factor from devices
// that are compared with themselves (the paired factor).
TEST(Response, leaves_unpaired_levels_out_of_the_paired_factor) {
  std::vector<Sample> const reference{{.device = "A", .condition = at_20_C, .ln = 0.0},
                                      {.device = "B", .condition = at_20_C, .ln = 0.1}},
      others{{.device = "A", .condition = with_temperature(40.0), .ln = -0.2},
             {.device = "C", .condition = with_temperature(30.0), .ln = 5.0}};
  Response const response(Effect::temperature, reference, others, at_20_C, {});
  EXPECT_EQ(response.at(30.0).status, Status::unpaired);
  auto const paired = response.paired_at(with_temperature(30.0));
  EXPECT_EQ(paired.status, Status::interpolated);
  EXPECT_NEAR(paired.ln, -0.1, 1e-15);
}

// With an activation energy of 90 kJ/mol, 100.9527 days at 70 C or 41.3230 days at 80 C stand for 60 years at 20 C.
TEST(Ageing, in_an_oven_that_stands_for_a_life) {
  expect_close(ageing_for(60.0, 70.0, 20.0, 90.0).days, 100.9527, 1e-6);
  expect_close(ageing_for(60.0, 80.0, 20.0, 90.0).days, 41.3230, 2e-6);
}

std::vector<std::string> texts(std::vector<PlannedTest> const& tests) {
  std::vector<std::string> all;
  for (auto const& test : tests)
    all.push_back(test.device + ' ' + std::string(test.is_reference ? "reference" : name(test.effect)));
  return all;
}
using Texts = std::vector<std::string>;

DesignEnd cold(std::vector<std::string> shown_on = {}, std::vector<std::string> tested = {}) {
  return {.effect = Effect::temperature,
          .condition = with_temperature(-15.0),
          .status = Status::interpolated,
          .devices = 3,
          .shown_on = std::move(shown_on),
          .tested = std::move(tested)};
}

TEST(Plan, begins_with_devices_that_have_tests_of_the_effect) {
  std::vector<Candidate> const candidates{{.device = "A"},
                                          {.device = "B", .has_reference = true},
                                          {.device = "C", .has_reference = true},
                                          {.device = "D", .has_reference = true}};
  std::vector const ends{cold({}, {"C", "D"})};
  auto const listed = [&](int devices) { return texts(plan(ends, candidates, devices, at_20_C, 3)); };
  EXPECT_EQ(listed(1), Texts{"C temperature"});
  EXPECT_EQ(listed(3), (Texts{"C temperature", "D temperature", "B temperature"}));
  // The fourth device, A, has no reference test and needs one first. The fifth is a new device, which needs a reference
  // test too.
  EXPECT_EQ(listed(5), (Texts{"C temperature", "D temperature", "B temperature", "A reference", "A temperature",
                              "new 1 reference", "new 1 temperature"}));
  auto const tests = plan(ends, candidates, 4, at_20_C, 3);
  EXPECT_EQ(tests[0].condition.temperature_C, -15.0);
  EXPECT_EQ(tests[0].condition.frequency_Hz, 0.5);
  EXPECT_EQ(tests[3].condition.temperature_C, 20.0);
  EXPECT_EQ(tests[3].before, Status::interpolated);
  EXPECT_EQ(tests[0].devices_before, 3);
  EXPECT_EQ(tests[0].after, Status::shown);
  EXPECT_EQ(tests[4].devices_after, 4);
  EXPECT_EQ(texts(plan(std::vector{cold({"B", "C"})}, candidates, 2, at_20_C, 3)), Texts());
}

// Device A was tested at the end of the design range and lacks only its reference test. A plan has at most one
// reference test for each device, even if several effects need it.
TEST(Plan, adds_reference_tests_once) {
  auto end = cold();
  end.without_reference = {"A"};
  EXPECT_EQ(texts(plan(std::vector{end}, {{.device = "A"}}, 1, at_20_C, 3)), Texts{"A reference"});
  DesignEnd const fast{.effect = Effect::rate, .condition = with_frequency(0.65)};
  EXPECT_EQ(texts(plan(std::vector{fast, end}, {{.device = "A"}}, 1, at_20_C, 3)), (Texts{"A reference", "A rate"}));
}

// Ageing cannot be undone, so an aged device is of no use for other effects. It can be aged further at the same
// temperature.
TEST(Plan, tests_no_aged_device_as_if_it_were_not) {
  std::vector<Candidate> const candidates{
      {.device = "A", .has_reference = true, .aged = Ageing{.days = 14.0, .at_C = 70.0}},
      {.device = "B", .has_reference = true}};
  EXPECT_EQ(texts(plan(std::vector{cold({}, {"A"})}, candidates, 1, at_20_C, 3)), Texts{"B temperature"});
  auto const aged = [&](double days, double at_C) {
    DesignEnd const end{.effect = Effect::ageing, .condition = with_ageing(days, at_C), .tested = {"A"}};
    return texts(plan(std::vector{end}, candidates, 1, at_20_C, 3));
  };
  EXPECT_EQ(aged(101.0, 70.0), Texts{"A ageing"});
  EXPECT_EQ(aged(7.0, 70.0), Texts{"B ageing"});
  EXPECT_EQ(aged(101.0, 80.0), Texts{"B ageing"});
}

// How much a new device softens is shown only by its first test. How much of the lost stiffness comes back after a rest
// is shown by devices whose first test was made when they were new.
TEST(Plan, takes_new_devices_for_scragging) {
  std::vector<Candidate> const candidates{{.device = "A", .has_reference = true, .was_new = true},
                                          {.device = "B", .has_reference = true}};
  DesignEnd end{.effect = Effect::scragging, .condition = at_20_C};
  EXPECT_EQ(texts(plan(std::vector{end}, candidates, 1, at_20_C, 3)), Texts{"new 1 reference"});
  end.rest_h = 24.0;
  auto const after_rest = plan(std::vector{end}, candidates, 2, at_20_C, 3);
  EXPECT_EQ(texts(after_rest), (Texts{"A scragging", "new 1 reference", "new 1 scragging"}));
  EXPECT_EQ(after_rest[0].rest_h, 24.0);
  EXPECT_EQ(after_rest[1].rest_h, std::nullopt);
  // A reference test of a new device that is planned for another effect shows the scragging too.
  std::vector const ends{cold(), DesignEnd{.effect = Effect::scragging, .condition = at_20_C}};
  EXPECT_EQ(texts(plan(ends, {}, 1, at_20_C, 3)), (Texts{"new 1 reference", "new 1 temperature"}));
}

// The plan asks for two devices tested at the end of the design range. With the results of the planned tests, the
// factor there must count as shown by two devices.
TEST(Plan, makes_the_end_shown) {
  auto const ln = [](std::string const& device, double temperature_C) {
    return Sample{.device = device, .condition = with_temperature(temperature_C), .ln = -0.006 * temperature_C};
  };
  std::vector<Sample> const reference{ln("A", 20.0), ln("B", 20.0), ln("C", 20.0)};
  std::vector<Sample> others{ln("B", -20.0)};
  EXPECT_EQ(Response(Effect::temperature, reference, others, at_20_C, {}).at(-15.0).status, Status::interpolated);
  for (auto const& test : plan(std::vector{cold({}, {"B"})},
                               {{.device = "A", .has_reference = true},
                                {.device = "B", .has_reference = true},
                                {.device = "C", .has_reference = true}},
                               2, at_20_C, 3))
    others.push_back(ln(test.device, *test.condition.temperature_C));
  auto const after = Response(Effect::temperature, reference, others, at_20_C, {}).at(-15.0);
  EXPECT_EQ(after.status, Status::shown);
  EXPECT_EQ(after.devices, 2);
}

}  // namespace
}  // namespace isolaw::conditions
