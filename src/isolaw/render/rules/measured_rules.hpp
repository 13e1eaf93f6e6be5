// Writes the measured factors of a lot as a rule file, so that other lots can take them as defaults.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// The text of a rule file that nobody has verified. It has a table [[effect]] for each effect and property whose
// largest and smallest factor over the design conditions rest on tests. Comments name these tests with their records.
// `name` stands for the rule set if it has a letter or a digit.
std::string measured_rules(study::ConditionsResult const& result, std::string_view name);

}  // namespace isolaw::render
