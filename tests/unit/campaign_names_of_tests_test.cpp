// Tests that isolaw proposes the conditions of tests from the names of their records.
#include "isolaw/campaign/names_of_tests.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace isolaw::campaign {
namespace {

ProposedTest proposed(std::string const& name) {
  return propose_tests(std::vector{name}).front();
}

TEST(NamesOfTests, conditions_are_read_from_a_name) {
  auto const whole = proposed("P1_T-20C_0.1Hz_2000kN_aged");
  EXPECT_EQ(whole.device, "P1");
  EXPECT_EQ(whole.temperature_C, -20.0);
  EXPECT_EQ(whole.load_kN, 2000.0);
  EXPECT_TRUE(whole.is_aged);

  struct Case {
    std::string name, device;
    std::optional<double> temperature_C, load_kN;
    bool is_aged;
  };
  std::vector<Case> const cases{
      {"P1_-20C", "P1", -20.0, {}, false},
      {"P1 T-20", "P1", -20.0, {}, false},
      {"HDRB-600_01_23.5°C", "HDRB-600_01", 23.5, {}, false},
      {"HDRB-600_01_23.5degC_2", "HDRB-600_01", 23.5, {}, false},
      {"600x208 +40C N1500kN", "600x208", 40.0, 1500.0, false},
      {"-20C", "-20C", -20.0, {}, false},
      {"P4-1000kN", "P4", {}, 1000.0, false},
      {"P4_Aged", "P4", {}, {}, true},
      {"P4 aged14d", "P4", {}, {}, true},
      // These names state no condition.
      {"device-01", "device-01", {}, {}, false},
      {"damaged", "damaged", {}, {}, false},
      {"P5-after-24h", "P5-after-24h", {}, {}, false},
      {"T1", "T1", {}, {}, false},
  };
  for (auto const& each : cases) {
    auto const test = proposed(each.name);
    EXPECT_EQ(test.device, each.device) << each.name;
    EXPECT_EQ(test.temperature_C, each.temperature_C) << each.name;
    EXPECT_EQ(test.load_kN, each.load_kN) << each.name;
    EXPECT_EQ(test.is_aged, each.is_aged) << each.name;
  }
}

TEST(NamesOfTests, a_temperature_that_may_be_another_one_is_not_proposed) {
  for (std::string const name : {"P1-20C", "cold-20C", "P4_aged_70C", "P1_20C_40C"}) {
    EXPECT_EQ(proposed(name).temperature_C, std::nullopt) << name;
    EXPECT_NE(proposed(name).device, name);
  }
  EXPECT_EQ(proposed("P4_20C_aged_70C").temperature_C, 20.0);
}

TEST(NamesOfTests, the_names_together_tell_devices_and_dashes) {
  std::vector<std::string> const names{"P1--20C", "P1-20C", "P1-warm", "P10-warm", "P1"};
  auto const tests = propose_tests(names);
  EXPECT_EQ(tests[0].temperature_C, -20.0);
  EXPECT_EQ(tests[1].temperature_C, 20.0);
  std::vector<std::string> devices;
  for (auto const& test : tests) devices.push_back(test.device);
  EXPECT_EQ(devices, (std::vector<std::string>{"P1", "P1", "P1", "P10-warm", "P1"}));
}

}  // namespace
}  // namespace isolaw::campaign
