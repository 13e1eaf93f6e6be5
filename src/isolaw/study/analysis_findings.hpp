// The meaning of the analyses as findings: changes without the optimiser's noise and why, the error on a device that was
// not tested, and the parameters that the tests leave open.
#pragma once

#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// For the first screen; empty without analyses.
std::vector<Finding> converged_findings(Summary const& summary);

}  // namespace isolaw::study
