// Compares one device with a rule set: each limit gives a measured value, a deviation from the design value, a verdict.
// Only a set that somebody verified gives a pass or a fail, and only under the conditions that it asks for; everything
// else is information, or not assessed with a reason. A value on the limit passes. Values are compared as measured,
// never rounded, with a slack of 1e-12 of the bound, since in binary 1.2 times a value is rarely exactly 20 % more.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {

enum class Verdict { pass, fail, information, not_assessed };
std::string_view name(Verdict verdict);  // "pass", "fail", "information", "not assessed"

// The subject of a limit: a device's property, its change over cycles or loads, the lot's mean, or the sample size.
enum class Subject { device, cycles, loads, lot, sample };
std::string_view name(Subject subject);  // "device", "cycles", "loads", "lot", "sample"

struct Assessment {
  std::string quantity;              // in words: "K_eff, positive side", "K_eff over cycles", "sample size"
  std::optional<Quantity> property;  // the property concerned; none for a sample
  Subject subject = Subject::device;
  Side side = Side::both;
  std::string clause, formula;
  std::optional<double> value;
  std::string unit;
  std::optional<double> nominal;
  std::optional<double> deviation_percent;             // 100 (value - nominal)/nominal
  std::string deviation;                               // deviation_percent as text, see deviation_text()
  std::string limit;                                   // "from -20 % to +20 %"; empty if the set has none
  std::optional<double> lower_percent, upper_percent;  // limits of deviation_percent, if the rule limits the deviation
  Verdict verdict = Verdict::not_assessed;
  std::string reason;  // why there is no verdict
};

// Whether the assessment compares this property of a device, one side or both, with a limit or the design value.
bool is_of(Assessment const& assessment, Quantity property);

struct LoadPair {  // properties of one device at the largest and smallest vertical load, for the limit on variation
  BlockValues largest, smallest;
};

// All assessments of a device in the order of the set: limits on each device, stability, vertical load. Then, as
// information, quantities with a design value but no limit, and always K_v.
std::vector<Assessment> assess(RuleSet const& rules, BlockValues const& block, Design const& design,
                               std::optional<LoadPair> const& loads = std::nullopt);
std::string same_record_as(std::string_view device);  // "the same record as D01"
// Removes the verdicts of a device whose record is a copy of another device's, since that record does not test it.
void withhold_verdicts(std::vector<Assessment>& assessments, std::string_view copy_of);
// Whether nominal (1 + lower/100) <= value <= nominal (1 + upper/100), with the slack of 1e-12.
bool is_within(double value, double nominal, std::optional<double> lower_percent, std::optional<double> upper_percent);
// "from -20 % to +20 %", "at least -25 %". A word comes first, since spreadsheets read a leading sign as a formula.
std::string limit_text(std::optional<double> lower_percent, std::optional<double> upper_percent);
// "+19.9 %": one decimal, or as many as it takes for the text to lie on the same side of the limit as the value. With
// one decimal, a deviation of 20.04 % would read as +20.0 %, which seems to be within 20 %.
std::string deviation_text(double deviation_percent, std::optional<double> lower_percent,
                           std::optional<double> upper_percent);
// Gives pass or fail if the set is verified and its conditions are met, else information or not assessed, with reason.
void give_verdict(Assessment& assessment, RuleSet const& rules, bool holds, std::vector<std::string> const& unmet);
// Compares value and design value with a limit and fills in verdict and texts. `without`: why there is no value.
void hold_to(Assessment& assessment, RuleSet const& rules, Limit const& limit, std::string_view without,
             std::vector<std::string> const& unmet);

}  // namespace isolaw::rules
