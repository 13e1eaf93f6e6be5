// For devices whose acceptance test was made under other conditions than the reference: the measured values, and the
// values that they would have had under reference conditions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/conditions/at_reference.hpp"
#include "isolaw/conditions/observe.hpp"

namespace isolaw::study {

struct ConditionsResult;

struct ConvertingFactor {
  conditions::Effect effect;
  conditions::Factor factor;
  std::vector<std::string> records;  // SHA-256 of the records that show the factor
};

struct AtReferenceRow {  // one property in one block of an acceptance test
  std::string device, test;
  int block = 0;
  conditions::Condition condition;
  rules::Quantity quantity = rules::Quantity::K_eff;
  std::optional<double> measured = {}, at_reference = {};
  std::optional<conditions::Interval> interval = {};  // 95 % interval of `at_reference` for this device
  std::vector<ConvertingFactor> factors = {};
  // Why there is no value at reference: the effect whose factor is neither shown nor interpolated, or, if the test
  // cannot be compared with reference tests at all, the name of its TestRole.
  std::optional<conditions::Effect> obstacle = {};
  std::string not_comparable = {};
};

// Rows of stiffness, energy and damping for each device whose acceptance test is not at reference.
std::vector<AtReferenceRow> values_at_reference(ConditionsResult const& result);

}  // namespace isolaw::study
