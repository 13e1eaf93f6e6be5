// Makes findings from the campaign's analyses: the front and beta of the best fits (not of the means over the runs),
// the error on devices left out, the prediction of blocks, and the share of parameters that the tests determine.
#pragma once

#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Returns nothing while runs or analyses of the campaign are missing.
std::vector<Finding> converged_findings(Summary const& summary);

}  // namespace isolaw::study
