// Tests the verdicts on a device and on the lot. A verdict is never a plain pass if a value was not compared with its
// limit.
#include "finding_text.hpp"
#include "isolaw/data/signals/copies.hpp"
#include "isolaw/study/verdict.hpp"

#include <gtest/gtest.h>

#include "isolaw/study/findings.hpp"
#include "isolaw/study/value_doubts.hpp"
#include "isolaw/study/warnings.hpp"

namespace isolaw::study {
namespace {

using rules::Assessment;
using rules::Verdict;

Assessment line(std::string quantity, Verdict verdict, std::optional<double> deviation = std::nullopt,
                std::string limit = "from -20 % to +20 %") {
  Assessment assessment;
  for (auto const property : {rules::Quantity::K_eff, rules::Quantity::damping, rules::Quantity::energy,
                              rules::Quantity::Q_d, rules::Quantity::K_d, rules::Quantity::K_v}) {
    auto const name = std::string(rules::name(property));
    if (quantity == name || quantity.starts_with(name + ", ")) assessment.property = property;
  }
  assessment.quantity = std::move(quantity);
  assessment.verdict = verdict;
  assessment.limit = std::move(limit);
  assessment.deviation_percent = deviation;
  if (deviation) assessment.deviation = rules::deviation_text(*deviation, -20.0, 20.0);
  return assessment;
}

DeviceVerdict verdict_of(std::vector<Assessment> const& lines) {
  return device_verdict({.block = {}, .choice = {}, .copy_of = {}, .assessments = lines});
}

std::string text_of(std::vector<Assessment> const& lines) {
  return verdict_of(lines).text();
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
            "pass on 1 of 3 (K_eff; not assessed: damping, K_v)");
  // A quantity does not pass if one of its sides could not be compared.
  EXPECT_EQ(text_of({line("K_eff, positive side", Verdict::pass), line("K_eff, negative side", Verdict::not_assessed),
                     line("damping", Verdict::pass)}),
            "pass on 1 of 2 (damping; not assessed: K_eff)");
  EXPECT_EQ(text_of({line("K_eff, positive side", Verdict::pass), line("K_eff, negative side", Verdict::not_assessed)}),
            "not assessed");
}

// If nothing in the shear test was compared, a passed compression test alone is no pass.
TEST(DeviceVerdict, ACompressionTestAloneIsNoPass) {
  EXPECT_EQ(text_of({line("K_eff", Verdict::not_assessed), line("damping", Verdict::not_assessed),
                     line("K_v", Verdict::pass, 8.3)}),
            "not assessed");
  EXPECT_EQ(verdict_of({line("K_eff", Verdict::not_assessed), line("K_v", Verdict::fail, -44.0)}).verdict,
            Verdict::fail);
  EXPECT_EQ(text_of({line("K_eff", Verdict::pass), line("K_v", Verdict::pass)}), "pass");
}

TEST(DeviceVerdict, InformationOnWhatHasNoLimitIsNoVerdict) {
  EXPECT_EQ(text_of({line("K_eff", Verdict::not_assessed), line("Q_d", Verdict::information, 3.0, "")}),
            "not assessed");
  EXPECT_EQ(text_of({line("K_eff", Verdict::information, 3.0), line("damping", Verdict::not_assessed)}),
            "information");  // the rule set is not verified
  EXPECT_EQ(text_of({line("Q_d", Verdict::information, 3.0, ""), line("K_v", Verdict::not_assessed, {}, "")}),
            "information");  // the rule set has no limits on a single device
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
  EXPECT_EQ(verdict_of(lines).failed, std::vector<std::string>{"K_eff"});
}

TEST(VerdictOnADevice, IsNotAssessedWhereItsRecordHasNoPropertiesAndNothingWhereNothingIsAsked) {
  LotAcceptance lot;
  DeviceResult device;
  EXPECT_FALSE(verdict_on(lot, device));
  device.properties.refusal = {stated("not cyclic")};
  EXPECT_FALSE(verdict_on(lot, device));
  lot.rules.id = "mine";
  ASSERT_TRUE(verdict_on(lot, device));
  EXPECT_EQ(*verdict_on(lot, device), Verdict::not_assessed);
  device.acceptance.assessments = {line("K_eff", Verdict::not_assessed), line("K_v", Verdict::pass)};
  EXPECT_EQ(*verdict_on(lot, device), Verdict::not_assessed);
}

Summary verified_lot() {
  Summary summary;
  summary.acceptance.rules.id = "ntc-2018";
  summary.acceptance.rules.title = "NTC 2018, elastomeric isolators";
  summary.acceptance.rules.verified_by = "me";
  return summary;
}

void add(Summary& summary, std::string name, std::vector<Assessment> lines, std::string status = "ok") {
  auto& device = summary.devices.emplace_back();
  device.name = std::move(name);
  device.status = std::move(status);
  if (device.status != "ok") device.message = "line 7: not a number";
  device.acceptance.assessments = std::move(lines);
}

TEST(OverallVerdict, PassesOnlyWhereEveryRequirementAndEveryDeviceIsAssessed) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass), line("damping", Verdict::pass)});
  add(summary, "D02",
      {line("K_eff", Verdict::pass), line("damping", Verdict::pass), line("Q_d", Verdict::information, 3.0, "")});
  EXPECT_EQ(overall_verdict(summary).text(), "PASS: NTC 2018: 2 devices keep all 2 requirements");
  EXPECT_EQ(overall_verdict(summary).mark, "");

  auto open = summary;
  open.devices[1].acceptance.assessments[1].verdict = Verdict::not_assessed;
  EXPECT_EQ(overall_verdict(open).text(), "INCOMPLETE: NTC 2018: pass on 1 of 2 requirements; not assessed: damping");
  EXPECT_EQ(overall_verdict(open).mark, "INCOMPLETE");
  EXPECT_TRUE(overall_verdict(open).is_red);

  auto refused = summary;
  add(refused, "D03", {}, "refused");
  EXPECT_EQ(overall_verdict(refused).text(),
            "INCOMPLETE: NTC 2018: pass on 2 of 2 requirements with 2 of 3 devices; without a verdict: D03");
  ASSERT_EQ(overall_verdict(refused).not_assessed.size(), 1u);
  EXPECT_EQ(overall_verdict(refused).not_assessed[0].remark, "line 7: not a number");

  auto sample = summary;
  sample.acceptance.rules.sample.emplace();
  sample.acceptance.lot.sample.quantity = "sample size";
  EXPECT_EQ(overall_verdict(sample).text(),
            "INCOMPLETE: NTC 2018: pass on 2 of 3 requirements; not assessed: sample size");

  auto shear = verified_lot();
  add(shear, "D01", {line("K_v", Verdict::pass)});
  EXPECT_EQ(overall_verdict(shear).word, "INCOMPLETE");
}

// A device whose record is a copy is not assessed. The verdict must give only this reason, even if there is another
// reason not to assess the device.
TEST(OverallVerdict, NamesACopyThatIsWithheldOnce) {
  auto summary = verified_lot();
  for (auto const* name : {"D01", "D02"}) {
    add(summary, name, {line("K_eff", Verdict::not_assessed)});
    summary.devices.back().acceptance.withheld = "block 2 is faulty: the force is clipped";
  }
  summary.devices[1].acceptance.copy_of = "D01";
  auto const overall = overall_verdict(summary);
  ASSERT_EQ(overall.not_assessed.size(), 2u);
  EXPECT_EQ(overall.not_assessed[1].device, "D02");
  EXPECT_EQ(overall.not_assessed[1].remark, rules::same_record_as("D01"));
}

TEST(Warnings, SayThatAlteredCopiesAreNotSoughtInLargeLots) {
  auto const is_said = [](std::size_t devices) {
    Summary summary;
    summary.devices.resize(devices);
    return std::ranges::count(warnings(summary), FindingKind::copies_not_sought, &Finding::kind);
  };
  EXPECT_EQ(is_said(data::most_compared), 0);
  EXPECT_EQ(is_said(data::most_compared + 1), 1);
}

TEST(OverallVerdict, APassThatRestsOnCorrectionsSaysSo) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass)});
  summary.without_corrections = Finding{.kind = FindingKind::verdict_rests_on_corrections};
  EXPECT_EQ(overall_verdict(summary).word, "PASS");
  EXPECT_EQ(overall_verdict(summary).text(), "PASS as corrected: NTC 2018: 1 device keeps the requirement");
  summary.without_corrections->kind = FindingKind::verdict_without_corrections_same;
  EXPECT_EQ(overall_verdict(summary).text(), "PASS: NTC 2018: 1 device keeps the requirement");
}

TEST(DeviceVerdict, APassThatRestsOnCorrectionsSaysSo) {
  DeviceAcceptance acceptance{.block = {}, .choice = {}, .copy_of = {}, .assessments = {line("K_eff", Verdict::pass)}};
  acceptance.as_corrected = true;
  EXPECT_EQ(device_verdict(acceptance).text(), "pass as corrected");
  acceptance.assessments.push_back(line("damping", Verdict::not_assessed));
  EXPECT_EQ(device_verdict(acceptance).brief(), "pass as corrected on 1 of 2");
  acceptance.assessments.push_back(line("Q_d", Verdict::fail, 30.0));
  EXPECT_EQ(device_verdict(acceptance).brief(), "fail");
}

TEST(OverallVerdict, OfTestsUnderDifferentConditionsIsIncomplete) {
  auto summary = verified_lot();
  for (auto const* name : {"D01", "D02"}) add(summary, name, {line("K_eff", Verdict::pass)});
  ASSERT_EQ(overall_verdict(summary).word, "PASS");
  summary.conditions_differ = Finding{.kind = FindingKind::conditions_differ};
  EXPECT_EQ(overall_verdict(summary).word, "INCOMPLETE");
  EXPECT_NE(overall_verdict(summary).sentence.find("not assessed: one condition for all tests"), std::string::npos);
}

TEST(OverallVerdict, FailsByADeviceOrTheLotWhateverIsOpen) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass), line("damping", Verdict::not_assessed)});
  add(summary, "D02", {line("K_eff", Verdict::fail, 23.0), line("damping", Verdict::pass)});
  add(summary, "D03", {}, "refused");
  auto overall = overall_verdict(summary);
  EXPECT_EQ(
      overall.text(),
      "FAIL: NTC 2018: 1 of 3 devices fails: D02 K_eff +23.0 %; pass on 0 of 2 requirements with 2 of 3 devices; not assessed: damping; "
      "without a verdict: D03");
  ASSERT_EQ(overall.failing.size(), 1u);
  EXPECT_EQ(overall.failing[0].device, "D02");
  EXPECT_EQ(overall.mark, "FAIL");
  EXPECT_EQ(overall.requirements[0].verdict, Verdict::fail);

  auto lot = verified_lot();
  add(lot, "D01", {line("K_eff", Verdict::pass)});
  auto& quantity = lot.acceptance.lot.quantities.emplace_back();
  quantity.mean_limits = {line("K_eff, mean of 1 devices", Verdict::fail, 30.0)};
  EXPECT_EQ(
      overall_verdict(lot).text(),
      "FAIL: NTC 2018: the lot fails: K_eff, mean of 1 devices +30.0 %, limit from -20 % to +20 %; pass on 1 of 2 "
      "requirements");
  EXPECT_EQ(overall_verdict(lot).failing[0].device, "");
}

TEST(OverallVerdict, HasNoWordWithoutAVerifiedSet) {
  Summary summary;
  add(summary, "D01", {});
  EXPECT_EQ(overall_verdict(summary).text(), "no verdict: no rule set");
  EXPECT_EQ(overall_verdict(summary).mark, "");
  EXPECT_EQ(verdict_summary(summary), "");
  summary = verified_lot();
  summary.acceptance.rules.verified_by.clear();
  add(summary, "D01", {line("K_eff", Verdict::information, 90.0)});
  EXPECT_EQ(overall_verdict(summary).word, "");
  EXPECT_EQ(verdict_summary(summary), "NTC 2018: no verdict, the limits of this set are not verified\n");
  EXPECT_EQ(overall_verdict(summary).mark, "LIMITS NOT VERIFIED");
  EXPECT_FALSE(overall_verdict(summary).is_red);
}

TEST(OverallVerdict, OfWhatWasNotMeasuredIsMarkedSoWhateverItIs) {
  auto summary = verified_lot();
  summary.title = "Example lot: rebuilt, not measured";
  add(summary, "D01", {line("K_eff", Verdict::pass)});
  EXPECT_EQ(overall_verdict(summary).word, "PASS");
  EXPECT_EQ(overall_verdict(summary).mark, "NOT MEASURED");
  EXPECT_FALSE(overall_verdict(summary).is_red);
  summary.devices[0].acceptance.assessments[0].verdict = Verdict::fail;
  EXPECT_EQ(overall_verdict(summary).mark, "NOT MEASURED");
}

TEST(OverallVerdict, NamesTenDevicesThatFailAndCountsTheOthers) {
  auto summary = verified_lot();
  for (int i = 0; i < 21; ++i)
    add(summary, "X", {line("K_eff", Verdict::fail, 23.0), line("damping", Verdict::fail, 30.0)});
  auto const text = verdict_summary(summary);
  EXPECT_NE(text.find("21 of 21 devices fail: X damping +30.0 % and K_eff +23.0 %, X "), std::string::npos) << text;
  EXPECT_NE(text.find(" and 11 more; pass on 0 of 2"), std::string::npos) << text;
  EXPECT_EQ(overall_verdict(summary).failing.size(), 21u);
  EXPECT_EQ(text_of(verdict_against(summary, "X")), "X fails NTC 2018: damping +30.0 %, K_eff +23.0 %");
  summary.devices[0].name = "Y";
  summary.devices[0].acceptance.assessments = {line("K_eff", Verdict::pass)};
  EXPECT_FALSE(verdict_against(summary, "Y"));
}

// Two devices hold the same record. The second device gets no verdict, and the reason is stated.
TEST(OverallVerdict, OneRecordIsNoTestOfTwoDevices) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass)});
  add(summary, "D02", {line("K_eff", Verdict::pass)});
  EXPECT_EQ(overall_verdict(summary).word, "PASS");
  auto& copy = summary.devices[1].acceptance;
  copy.copy_of = "D01";
  rules::withhold_verdicts(copy.assessments, rules::same_record_as(copy.copy_of));
  auto const overall = overall_verdict(summary);
  EXPECT_EQ(overall.text(),
            "INCOMPLETE: NTC 2018: pass on 1 of 1 requirement with 1 of 2 devices; without a verdict: D02");
  ASSERT_EQ(overall.not_assessed.size(), 1u);
  EXPECT_EQ(overall.not_assessed[0].remark, "the same record as D01");
  EXPECT_EQ(overall.mark, "INCOMPLETE");
  EXPECT_EQ(device_verdict(copy).text(), "not assessed: the same record as D01");
  EXPECT_EQ(device_verdict(copy).brief(), "not assessed");
}

// D02 is a copy: it holds the record of D01, which fails. A law taken from D02 therefore carries the failure of D01.
TEST(OverallVerdict, OfACopyTheFirstDeviceFails) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::fail, 23.0)});
  add(summary, "D02", {line("K_eff", Verdict::fail, 23.0), line("K_v", Verdict::pass)});
  auto& copy = summary.devices[1].acceptance;
  copy.copy_of = "D01";
  rules::withhold_verdicts(copy.assessments, rules::same_record_as(copy.copy_of));
  EXPECT_EQ(copy.assessments[1].verdict, Verdict::pass);  // device D02 has a compression test of its own
  EXPECT_EQ(overall_verdict(summary).failing.size(), 1u);
  EXPECT_EQ(text_of(verdict_against(summary, "D02")), "D01 fails NTC 2018: K_eff +23.0 %");
}

TEST(OverallVerdict, SaysWhatWasStatedAndIsNotCompared) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass)});
  summary.acceptance.design.K_eff_kN_per_mm = 0.7;
  EXPECT_EQ(overall_verdict(summary).text(), "PASS: NTC 2018: 1 device keeps the requirement");
  summary.acceptance.design.disp_mm = 400.0;
  summary.acceptance.design.K_v_kN_per_mm = 1000.0;
  EXPECT_EQ(overall_verdict(summary).text(),
            "PASS: NTC 2018: 1 device keeps the requirement; stated and not compared: K_v, disp");
  summary.acceptance.rules.test.displacement_tolerance_percent = 5.0;
  EXPECT_EQ(overall_verdict(summary).text(),
            "PASS: NTC 2018: 1 device keeps the requirement; stated and not compared: K_v");
}

TEST(OverallVerdict, SaysWhatWouldNotBeKept) {
  auto summary = verified_lot();
  auto damping = line("damping", Verdict::pass);
  damping.value = 18.5;
  damping.nominal = 18.0;
  damping.lower_percent = -15.0;
  add(summary, "D01", {damping});
  summary.devices[0].effects = {{data::damping_by_skew, 3.0, "points", std::nullopt, false}};
  EXPECT_EQ(overall_verdict(summary).text(), "PASS: NTC 2018: 1 device keeps the requirement") << "15.5 % is kept";
  summary.devices[0].effects[0].value = 6.0;
  summary.devices.push_back(summary.devices[0]);
  summary.devices[1].effects = {{data::damping_by_rig_friction, 6.0, "points", std::nullopt, false}};
  EXPECT_EQ(overall_verdict(summary).text(),
            "PASS: NTC 2018: 2 devices keep the requirement; check the rig: damping of 1 device would be outside its "
            "limit if the force channel is early, and of 1 device if the rig's friction is 0.5 % of the vertical load");
}

TEST(OverallVerdict, SaysThatNothingWasMeasured) {
  auto summary = verified_lot();
  add(summary, "D01", {line("K_eff", Verdict::pass)});
  summary.title = "Rebuilt, not measured";
  EXPECT_EQ(overall_verdict(summary).text(), "PASS: NTC 2018: 1 device keeps the requirement; not measured");
  EXPECT_EQ(overall_verdict(summary).mark, "NOT MEASURED");
}

TEST(ValueDoubts, ALeadOrFrictionSaysWhatTheDampingWouldBe) {
  DeviceResult device;
  auto damping = line("damping, positive side", Verdict::pass);
  damping.value = 18.0;
  device.acceptance.assessments = {damping, damping, line("damping over vertical load", Verdict::not_assessed)};
  device.acceptance.assessments[1].value = 19.0;
  device.acceptance.assessments[2].value = 99.0;
  EXPECT_TRUE(value_doubts(device).empty());
  device.effects = {{data::damping_by_skew, 6.3, "points", std::nullopt, false}};
  ASSERT_EQ(value_doubts(device).size(), 1u);
  EXPECT_EQ(value_doubts(device)[0].text(), "damping 18.5 %, or 12.2 % if the force channel is early");
  device.effects = {{data::damping_by_skew, -2.0, "points", std::nullopt, true},
                    {data::damping_by_rig_friction, 0.3, "points", std::nullopt, false}};
  ASSERT_EQ(value_doubts(device).size(), 1u) << "0.3 points of 18.5 are none";
  EXPECT_EQ(value_doubts(device)[0].text(), "damping 18.5 %, or 20.5 % if the late force channel is moved back");
  device.effects = {{data::damping_by_rig_friction, 1.5, "points", std::nullopt, false}};
  EXPECT_EQ(value_doubts(device)[0].otherwise, 17.0);
  device.raw.corrections = {{.kind = FindingKind::friction_removed, .numbers = {{"friction_kN", 2.0}}}};
  EXPECT_TRUE(value_doubts(device).empty());
}

}  // namespace
}  // namespace isolaw::study
