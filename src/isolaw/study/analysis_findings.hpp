// What the analyses mean, in sentences: what changes without the optimiser's noise and why, what an engineer meets, what
// the tests leave open.
#pragma once

#include <string>
#include <vector>

#include "isolaw/study/findings.hpp"

namespace isolaw::study {

// For the first screen; empty without analyses.
std::vector<std::string> converged_sentences(Summary const& summary);

void warn_of_analysis(Summary const& summary, std::vector<Warning>& warnings);

}  // namespace isolaw::study
