// Prints the results of `isolaw conditions` on a terminal.
#pragma once

#include <string>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// Returns, in this order: for each property its bounds and the factors of the effects whose product they are; the
// factors at the tested levels; the recovery. Only with `details`, Q_d and K_d have the factors of effects, properties
// besides K_eff and damping have levels, and the tests are listed.
std::string conditions_text(study::ConditionsResult const& result, bool details);
struct ConditionsSections {
  bool at_reference = false;  // the acceptance tests under other conditions, as measured and at reference
  bool plan = false;          // the tests that are missing, with the status of the factors now and after them
};
// Only these sections.
std::string conditions_text(study::ConditionsResult const& result, ConditionsSections const& sections);

}  // namespace isolaw::render
