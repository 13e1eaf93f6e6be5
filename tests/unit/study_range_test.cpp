// Tests the range test, which tries each law in cycles as large and as fast as those of a building. Such cycles may go
// beyond those of the laboratory tests. A law whose force is implausible in them is refused; a law that passes is
// called sane.
#include "isolaw/study/range_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::study {
namespace {

using NamedValues = std::vector<std::pair<std::string, double>>;

// Returns two cycles of this amplitude with a peak velocity of `speed_mm_s`. The force is an elliptic loop with this
// damping and a stiffness of 1 kN/mm.
DeviceResult tested_device(double amplitude_mm, double speed_mm_s, double damping) {
  DeviceResult device;
  device.name = "device";
  device.status = "ok";
  double const rate = speed_mm_s / amplitude_mm;
  for (int i = 0; i <= 800; ++i) {
    double const angle = 2.0 * std::numbers::pi * i / 400.0;
    device.record.time_s.push_back(angle / rate);
    device.record.disp_mm.push_back(amplitude_mm * std::sin(angle));
    device.record.vel_mm_s.push_back(speed_mm_s * std::cos(angle));
    device.record.force_kN.push_back(amplitude_mm * (std::sin(angle) + 2.0 * damping * std::cos(angle)));
  }
  device.raw.time_s = device.record.time_s;
  device.raw.disp_mm = device.record.disp_mm;
  device.raw.force_kN = device.record.force_kN;
  return device;
}

struct Tested {
  double disp_mm = 100.0, speed_mm_s = 314.0, damping = 0.6;
};

// Makes the range test of one law with these parameters on one device.
LawResult range_test(std::string const& id, NamedValues const& values, Tested const& tested = {}) {
  auto const& entry = laws::find_law(id);
  std::vector<double> parameters(entry.parameters.size());
  for (auto const& [name, value] : values) parameters[entry.index_of(name)] = value;
  Summary summary;
  summary.devices = {tested_device(tested.disp_mm, tested.speed_mm_s, tested.damping)};
  LawResult law;
  law.id = id;
  law.devices.resize(1);
  law.devices[0].device = "device";
  summary.laws = {law};
  campaign::Contents contents;
  contents.runs = {{.device = 0, .law = id, .number = 1, .parameters = parameters}};
  add_range_tests(summary, contents);
  return summary.laws.front();
}

std::string rule(LawResult const& law) {
  return law.runs_away ? std::string(law.runs_away->word("rule")) : std::string("sane");
}

NamedValues bilinear(double K1, double K2, double xy) {
  return {{"K1", K1}, {"K2", K2}, {"xy", xy}};
}

// The laws of devices other than high-damping rubber must pass too. A slider's damping is near 2 / pi, and its
// stiffness halves at twice the amplitude. Rubber that hardens is stiffer there.
TEST(RangeTest, PassesSaneDevicesOfOtherKinds) {
  auto const flat = range_test("bilinear", bilinear(100.0, 0.0, 0.5));
  EXPECT_EQ(rule(flat), "sane");
  EXPECT_NEAR(flat.beyond_tests->stiffness_ratio, 0.5, 1e-9);
  EXPECT_EQ(flat.beyond_tests->asked_mm, 200.0);
  EXPECT_EQ(rule(range_test("bilinear", bilinear(100.0, 0.1, 0.5))), "sane");                    // a curved slider
  EXPECT_EQ(rule(range_test("bilinear", bilinear(10.0, 1.0, 10.0))), "sane");                    // lead-rubber
  EXPECT_EQ(rule(range_test("bilinear", bilinear(1.0, 0.99, 1.0), {.damping = 0.01})), "sane");  // low damping
}

TEST(RangeTest, RefusesALawThatSoftensOrHardensBeyondTheTests) {
  NamedValues hardening{{"a1", 1000.0}, {"a3", 40.0}, {"a6", 100.0}, {"a8", 10.0}};  // in N and cm
  auto const law = range_test("hwang-wu", hardening, {.damping = 0.5});
  EXPECT_EQ(rule(law), "stiffness");
  EXPECT_GT(law.runs_away->number("value"), most_stiffness_ratio);
  EXPECT_EQ(law.runs_away->number("amplitude_mm"), 200.0);
  EXPECT_EQ(law.runs_away->number("tested_mm"), 100.0);
  hardening[1].second = 0.01;
  EXPECT_EQ(rule(range_test("hwang-wu", hardening, {.damping = 0.5})), "sane");
}

// A dashpot that was fitted to a slow test may dominate at the speed of a building. The law must then be refused.
TEST(RangeTest, RefusesADashpotFittedToASlowTest) {
  NamedValues values{{"Y", 40.0}, {"g", 0.7}, {"K", 60.0}, {"U", 1.0}, {"c", 0.005}};
  Tested const tested{.damping = 0.2};
  EXPECT_EQ(rule(range_test("power-masing-viscous", values, tested)), "sane");
  values.back().second = 5.0;
  EXPECT_EQ(rule(range_test("power-masing-viscous", values, tested)), "overdamped");
  // Here the damping is not yet too large in itself, but it is more than 1.5 times that at the tested speed.
  values.back().second = 0.2;
  EXPECT_EQ(rule(range_test("power-masing-viscous", values, {.speed_mm_s = 5.0, .damping = 0.5})), "speed");
  EXPECT_EQ(rule(range_test("power-masing-viscous", values, {.speed_mm_s = 320.0, .damping = 0.5})), "sane");
}

TEST(RangeTest, RefusesALawWithoutFiniteForceOrStiffness) {
  EXPECT_EQ(rule(range_test("bilinear", bilinear(1e308, 1e308, 1e10))), "not-finite");
  EXPECT_EQ(rule(range_test("bilinear", bilinear(1.0, -0.5, 10.0))), "not-stiff");
}

// A device that is only a dashpot has no stiffness to judge, so its law must pass. The warning damping_undefined marks
// such a device; without the warning the same law must not pass.
TEST(RangeTest, ExemptsViscousDevices) {
  Summary summary;
  summary.devices = {tested_device(100.0, 314.0, 0.6)};
  summary.devices[0].raw.warnings = {{.kind = FindingKind::damping_undefined}};
  LawResult law;
  law.id = "power-masing-viscous";
  law.devices.resize(1);
  law.devices[0].device = "device";
  summary.laws = {law};
  auto const& entry = laws::find_law(law.id);
  std::vector<double> parameters(entry.parameters.size());
  for (auto const& [name, value] : NamedValues{{"Y", 0.1}, {"g", 1.0}, {"K", 0.1}, {"U", 1.0}, {"c", 1.0}})
    parameters[entry.index_of(name)] = value;
  campaign::Contents contents;
  contents.runs = {{.device = 0, .law = law.id, .number = 1, .parameters = parameters}};
  add_range_tests(summary, contents);
  EXPECT_EQ(rule(summary.laws[0]), "sane");
  summary.devices[0].raw.warnings.clear();
  add_range_tests(summary, contents);
  EXPECT_NE(rule(summary.laws[0]), "sane");
}

// The range test goes to the displacement that the design asks for. If this is below the tested amplitude, the test
// goes to the tested amplitude instead.
TEST(RangeTest, GoesToTheDisplacementOfTheDesign) {
  Summary summary;
  summary.devices = {tested_device(100.0, 314.0, 0.6)};
  LawResult law;
  law.id = "bilinear";
  law.devices.resize(1);
  law.devices[0].device = "device";
  summary.laws = {law};
  campaign::Contents contents;
  contents.runs = {{.device = 0, .law = "bilinear", .number = 1, .parameters = {100.0, 0.0, 0.5}}};
  for (auto const& [asked, taken] : {std::pair{150.0, 150.0}, {60.0, 100.0}}) {
    summary.acceptance.design.disp_mm = asked;
    add_range_tests(summary, contents);
    EXPECT_NEAR(summary.laws[0].beyond_tests->asked_mm, taken, 1e-9);
  }
}

// One device was tested to 200 mm, the other only to 50 mm. Each law is first tried at twice the tested amplitude of
// its own device, and both pass. If the design asks for 400 mm, the law of the second device softens so much up to
// there that it must be refused.
TEST(RangeTest, TriesADeviceTestedLessNoFartherInProportion) {
  Summary summary;
  summary.devices = {tested_device(200.0, 628.0, 0.3), tested_device(50.0, 157.0, 0.3)};
  summary.devices[1].name = "less";
  LawResult law;
  law.id = "bilinear";
  law.devices.resize(2);
  law.devices[0].device = "device";
  law.devices[1].device = "less";
  summary.laws = {law};
  campaign::Contents contents;
  contents.runs = {{.device = 0, .law = "bilinear", .number = 1, .parameters = {10.0, 1.0, 10.0}},
                   {.device = 1, .law = "bilinear", .number = 1, .parameters = {10.0, 0.3, 10.0}}};
  add_range_tests(summary, contents);
  EXPECT_EQ(rule(summary.laws[0]), "sane");
  EXPECT_NEAR(summary.laws[0].beyond_tests->tested_mm, 200.0, 1e-9);
  summary.acceptance.design.disp_mm = 400.0;
  add_range_tests(summary, contents);
  ASSERT_EQ(rule(summary.laws[0]), "stiffness");
  EXPECT_EQ(summary.laws[0].runs_away->devices, std::vector<std::string>{"less"});
  EXPECT_NEAR(summary.laws[0].runs_away->number("tested_mm"), 50.0, 1e-9);
}

}  // namespace
}  // namespace isolaw::study
