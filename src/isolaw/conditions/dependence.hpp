// Judges limits of a rule set on how far a property may change with temperature, frequency, vertical load or ageing.
// Each device is judged by itself: its value under one condition is divided by its value under reference conditions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/conditions/contrast.hpp"
#include "isolaw/rules/assess.hpp"

namespace isolaw::conditions {

// Why a device is not held to a limit.
enum class NotAssessed {
  no_condition,  // the limit has no levels, and the design does not state this condition
  no_test,       // no device has a reference test and tests at the condition or on both sides of it
  extrapolated,  // the condition is beyond those tested on the device
  scaled,        // the specimen is not of full size
  other_tests,   // the reference tests are not those that the rule set asks for
};
std::string_view name(NotAssessed reason);

struct AskedAgeing {
  Ageing test;  // the ageing of the test that is used
  // The life of the design, and the life that the test stands for. Both are 0 if the design states a test and no life.
  double years = 0.0, test_stands_for_years = 0.0;
};
// The conditions of the design. A limit for which the rule set states no levels holds at these conditions.
struct DesignConditions {
  std::vector<double> ends = {};  // ends of the design's range of the condition, in C, Hz or kN
  std::optional<AskedAgeing> ageing = {};
};

struct DeviceDependence {            // one device at one condition
  std::string device = {};           // empty: no device was tested at any condition but the reference
  std::optional<double> at = {};     // the condition in C, Hz or kN; empty for ageing
  std::optional<Factor> ratio = {};  // value at the condition / value at reference; empty if no test shows it
  rules::Verdict verdict = rules::Verdict::not_assessed;
  std::optional<NotAssessed> reason = {};  // why the verdict is "not assessed", if it is
};

// Judges every device that was tested at another condition than the reference, at every level of the limit. A level
// that agrees with the reference is left out, because its ratio is 1. Only a ratio that is shown or interpolated is
// judged; a ratio equal to the limit passes. If the rule set is not `verified`, the verdict is information. `as_asked`
// says that the reference cycles are those of the rule set and that the reference tests meet its conditions
// (rules::unmet_conditions()).
std::vector<DeviceDependence> judge_dependence(rules::DependenceLimit const& limit, bool verified,
                                               Response const& response, DesignConditions const& design,
                                               bool as_asked = true);

}  // namespace isolaw::conditions
