// Makes findings from the analyses: the optimiser's noise, devices left out, predicted blocks, undetermined parameters.
#pragma once

#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Returns nothing while runs or analyses of the campaign are missing.
std::vector<Finding> converged_findings(Summary const& summary);

}  // namespace isolaw::study
