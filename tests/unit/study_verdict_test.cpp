// What the lines of a device come to: never a bare pass where something was not compared.
#include "isolaw/study/verdict.hpp"

#include <gtest/gtest.h>

namespace isolaw::study {
namespace {

using rules::Assessment;
using rules::Verdict;

Assessment line(std::string quantity, Verdict verdict, std::optional<double> deviation = std::nullopt,
                std::string limit = "from -20 % to +20 %") {
  Assessment made;
  made.quantity = std::move(quantity);
  made.verdict = verdict;
  made.limit = std::move(limit);
  made.deviation_percent = deviation;
  if (deviation) made.deviation = rules::deviation_text(*deviation, -20.0, 20.0);
  return made;
}

std::string text_of(std::vector<Assessment> const& lines) {
  return device_verdict(lines).text();
}

TEST(DeviceVerdict, IsABarePassWhereEveryLimitIsKept) {
  EXPECT_EQ(text_of({line("K_eff", Verdict::pass, 1.0), line("damping", Verdict::pass, 2.0),
                     line("Q_d", Verdict::information, 50.0, "")}),
            "pass");
}

TEST(DeviceVerdict, OfWhatWasNotComparedIsNamed) {
  EXPECT_EQ(text_of({line("K_eff, positive side", Verdict::pass), line("K_eff, negative side", Verdict::pass),
                     line("damping, positive side", Verdict::not_assessed),
                     line("damping, negative side", Verdict::not_assessed), line("K_v", Verdict::not_assessed)}),
            "pass (K_eff; not assessed: damping, K_v)");
  // A side that could not be compared leaves the quantity without a pass.
  EXPECT_EQ(text_of({line("K_eff, positive side", Verdict::pass), line("K_eff, negative side", Verdict::not_assessed),
                     line("damping", Verdict::pass)}),
            "pass (damping; not assessed: K_eff)");
  EXPECT_EQ(text_of({line("K_eff, positive side", Verdict::pass), line("K_eff, negative side", Verdict::not_assessed)}),
            "not assessed");
}

// A device whose test in shear was compared with nothing does not pass for its compression test.
TEST(DeviceVerdict, ACompressionTestAloneIsNoPass) {
  EXPECT_EQ(text_of({line("K_eff", Verdict::not_assessed), line("damping", Verdict::not_assessed),
                     line("K_v", Verdict::pass, 8.3)}),
            "not assessed");
  EXPECT_EQ(device_verdict({line("K_eff", Verdict::not_assessed), line("K_v", Verdict::fail, -44.0)}).verdict,
            Verdict::fail);
  EXPECT_EQ(text_of({line("K_eff", Verdict::pass), line("K_v", Verdict::pass)}), "pass");
}

TEST(DeviceVerdict, InformationOnWhatHasNoLimitIsNoVerdict) {
  EXPECT_EQ(text_of({line("K_eff", Verdict::not_assessed), line("Q_d", Verdict::information, 3.0, "")}),
            "not assessed");
  EXPECT_EQ(text_of({line("K_eff", Verdict::information, 3.0), line("damping", Verdict::not_assessed)}),
            "information");  // of a set that is not verified
  EXPECT_EQ(text_of({line("Q_d", Verdict::information, 3.0, ""), line("K_v", Verdict::not_assessed, {}, "")}),
            "information");  // of a set without limits on a device
  EXPECT_EQ(text_of({}), "not assessed");
}

TEST(DeviceVerdict, NamesEveryQuantityThatFails) {
  auto lines = std::vector{line("K_eff, positive side", Verdict::fail, 23.0),
                           line("K_eff, negative side", Verdict::fail, -31.0), line("damping", Verdict::fail, -45.0)};
  EXPECT_EQ(text_of(lines), "fail: damping -45.0 %, K_eff -31.0 %");
  for (auto const* name : {"energy", "Q_d", "K_v"}) lines.push_back(line(name, Verdict::fail, 25.0));
  EXPECT_EQ(text_of(lines), "fail: damping -45.0 %, K_eff -31.0 %, energy +25.0 % and 2 more");
}

TEST(DeviceVerdict, AFailureNamesTheLineFarthestOff) {
  auto const lines = {line("K_eff, positive side", Verdict::fail, 23.0),
                      line("K_eff, negative side", Verdict::fail, -31.0), line("damping", Verdict::pass, 1.0),
                      line("K_v", Verdict::not_assessed)};
  EXPECT_EQ(text_of(lines), "fail: K_eff -31.0 %");
  EXPECT_EQ(device_verdict(lines).failed, std::vector<std::string>{"K_eff"});
}

TEST(VerdictOnADevice, IsNotAssessedWhereItsRecordHasNoPropertiesAndNothingWhereNothingIsAsked) {
  LotAcceptance lot;
  DeviceResult device;
  EXPECT_FALSE(verdict_on(lot, device));
  device.properties.refusal = "not cyclic";
  EXPECT_FALSE(verdict_on(lot, device));
  lot.rules.id = "mine";
  ASSERT_TRUE(verdict_on(lot, device));
  EXPECT_EQ(*verdict_on(lot, device), Verdict::not_assessed);
  device.acceptance.assessments = {line("K_eff", Verdict::not_assessed), line("K_v", Verdict::pass)};
  EXPECT_EQ(*verdict_on(lot, device), Verdict::not_assessed);
}

TEST(VerdictSummary, CountsDevicesAndNamesFailures) {
  Summary summary;
  EXPECT_EQ(verdict_summary(summary), "");
  summary.acceptance.rules.id = "ntc-2018";
  summary.acceptance.rules.title = "NTC 2018, elastomeric isolators";
  EXPECT_EQ(verdict_summary(summary), "NTC 2018: no verdict, the limits of this set are not verified\n");
  summary.acceptance.rules.verified_by = "me";
  auto const add = [&](char const* name, std::vector<Assessment> lines, char const* status = "ok") {
    auto& device = summary.devices.emplace_back();
    device.name = name;
    device.status = status;
    device.acceptance.assessments = std::move(lines);
  };
  add("D01", {line("K_eff", Verdict::pass)});
  add("D02", {line("K_eff", Verdict::pass)});
  EXPECT_EQ(verdict_summary(summary), "NTC 2018: 2 of 2 devices pass\n");
  add("D03", {line("K_eff", Verdict::fail, 23.0), line("damping", Verdict::not_assessed)});
  add("D04", {line("K_eff", Verdict::not_assessed)});
  add("D05", {line("K_eff", Verdict::pass), line("damping", Verdict::not_assessed)});
  add("D06", {}, "refused");
  auto& sample = summary.acceptance.lot.sample;
  sample = line("sample size", Verdict::fail, {}, "6 or more of 28");
  sample.value = 5.0;
  sample.unit = "devices";
  EXPECT_EQ(
      verdict_summary(summary),
      "NTC 2018: 3 of 5 devices pass as far as assessed (not assessed: damping), 1 fails: D03 K_eff +23.0 %, 1 not assessed; the lot fails: sample size 5 devices, limit 6 or more of 28\n");
  add("D07", {line("K_eff", Verdict::fail, 23.0), line("damping", Verdict::fail, 30.0)});
  EXPECT_NE(verdict_summary(summary).find("2 fail: D03 K_eff +23.0 %, D07 damping +30.0 % and K_eff +23.0 %, "),
            std::string::npos)
      << verdict_summary(summary);
  EXPECT_EQ(verdict_against(summary, "D07"), "D07 fails NTC 2018: damping +30.0 %, K_eff +23.0 %");
  EXPECT_EQ(verdict_against(summary, "D01"), "");
  summary.devices.pop_back();
  for (int i = 0; i < 20; ++i) add("X", {line("K_eff", Verdict::fail, 23.0)});
  EXPECT_NE(verdict_summary(summary).find(", 21 fail: D03"), std::string::npos) << verdict_summary(summary);
  EXPECT_NE(verdict_summary(summary).find(" and 11 more, 1 not assessed"), std::string::npos);
}

}  // namespace
}  // namespace isolaw::study
