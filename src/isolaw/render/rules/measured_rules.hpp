// Writes the measured factors of a lot as a rule file, so that other lots can take them as defaults.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// Returns the text of a rule file, marked as verified by nobody. It has a table [[effect]] for each effect and property
// whose largest and smallest factor over the design conditions rest on tests. Comments name these tests and the hashes
// of their records. The rule set gets an id made from `name`, or "measured" if `name` has no letter or digit.
std::string measured_rules(study::ConditionsResult const& result, std::string_view name);

}  // namespace isolaw::render
