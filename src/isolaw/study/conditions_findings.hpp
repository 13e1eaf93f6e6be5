// The findings on the effects of conditions: the bounds over the design conditions, verdicts on limits, which effects
// are assumed or not covered, and which conditions are only stated.
#pragma once

#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/conditions.hpp"

namespace isolaw::study {

std::vector<Finding> conditions_findings(ConditionsResult const& result);

}  // namespace isolaw::study
