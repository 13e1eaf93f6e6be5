// Findings from the analyses: what changes without the optimiser's noise and why, the error on a device that was not
// tested, how the laws predict blocks, and how many parameters the tests determine.
#pragma once

#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Empty while runs or analyses of the campaign are missing.
std::vector<Finding> converged_findings(Summary const& summary);

}  // namespace isolaw::study
