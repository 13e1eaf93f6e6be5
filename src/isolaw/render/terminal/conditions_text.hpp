// Prints the results of `isolaw conditions` on a terminal.
#pragma once

#include <string>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// Returns a text with three parts. The first has the bounds of each property and the factors of effects that were
// combined to these bounds. The second has the factors at the tested levels, and the third the recovery after rests.
// Without `details`, Q_d and K_d have no factors of effects, only K_eff and damping have factors at levels, and the
// tests are not listed.
std::string conditions_text(study::ConditionsResult const& result, bool details);
struct ConditionsSections {
  bool at_reference = false;  // values of acceptance tests as measured, and converted to the reference conditions
  bool plan = false;          // the tests still to be made; status of the factors now and after them
};
// Returns the text of the chosen sections only.
std::string conditions_text(study::ConditionsResult const& result, ConditionsSections const& sections);

}  // namespace isolaw::render
