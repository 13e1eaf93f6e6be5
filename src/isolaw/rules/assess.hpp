// Compares one device with a rule set. Each limit gives a measured value, its deviation from the design value and a
// verdict. Only a set that somebody verified gives pass or fail, and only under the conditions that it asks for.
// Otherwise the verdict is information or not assessed. A value equal to the limit passes. Values are compared as
// measured, not rounded, but with a slack of 1e-12 of the bound, since in binary 1.2 times a value is rarely exactly
// 20 % more.
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

// A limit concerns a device's property, the change of a property over cycles or loads, the lot's mean, or the size of
// the sample.
enum class Subject { device, cycles, loads, lot, sample };
std::string_view name(Subject subject);  // "device", "cycles", "loads", "lot", "sample"

struct Assessment {
  std::string quantity;              // for messages: "K_eff, positive side", "K_eff over cycles", "sample size"
  std::optional<Quantity> property;  // the property; nullopt for a sample size
  Subject subject = Subject::device;
  Side side = Side::both;
  std::string clause, formula;
  std::optional<double> value;
  std::string unit;
  std::optional<double> nominal;
  std::optional<double> deviation_percent;             // 100 (value - nominal)/nominal
  std::string deviation;                               // deviation_percent by deviation_text()
  std::string limit;                                   // "from -20 % to +20 %"; empty without a limit
  std::optional<double> lower_percent, upper_percent;  // limits of deviation_percent, if any
  Verdict verdict = Verdict::not_assessed;
  std::string reason;  // why there is no verdict
};

// True if the assessment is of one device's value of `property`, not of its change over cycles or loads, nor of a lot's
// mean.
bool is_of(Assessment const& assessment, Quantity property);

struct LoadPair {  // properties of one device at the largest and smallest vertical load, for the limit on variation
  BlockValues largest, smallest;
};

// All assessments of a device. The set's limits on each device, on stability and on vertical load come first. After
// them come, as information, K_v and the quantities with a design value but no limit.
std::vector<Assessment> assess(RuleSet const& rules, BlockValues const& block, Design const& design,
                               std::optional<LoadPair> const& loads = std::nullopt);
std::string same_record_as(std::string_view device);  // "the same record as D01"
// Makes the verdicts on a shear test "not assessed" for this reason. Verdicts on K_v, from a compression test, stay.
void withhold_verdicts(std::vector<Assessment>& assessments, std::string_view reason);
// Whether nominal (1 + lower/100) <= value <= nominal (1 + upper/100), with a slack of 1e-12.
bool is_within(double value, double nominal, std::optional<double> lower_percent, std::optional<double> upper_percent);
// "from -20 % to +20 %", "at least -25 %". The text starts with a word, since spreadsheets take a sign for a formula.
std::string limit_text(std::optional<double> lower_percent, std::optional<double> upper_percent);
// "+19.9 %": one decimal, or as many as put the text on the same side of the limit as the value. With one decimal, a
// deviation of 20.04 % would read +20.0 %, which seems to be within 20 %.
std::string deviation_text(double deviation_percent, std::optional<double> lower_percent,
                           std::optional<double> upper_percent);
// Sets the verdict: information if the set is not verified, not assessed if `unmet` names a condition that is not met,
// else pass if `holds`, and fail if not.
void give_verdict(Assessment& assessment, RuleSet const& rules, bool holds, std::vector<std::string> const& unmet);
// Compares the value with design value and limit, and sets verdict and texts. `without` is the reason to give if there
// is no value.
void hold_to(Assessment& assessment, RuleSet const& rules, Limit const& limit, std::string_view without,
             std::vector<std::string> const& unmet);

}  // namespace isolaw::rules
