// Computes what reports print from what a campaign holds.
#pragma once

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Recomputes everything from the contents alone: statistics over runs and devices, robustness, front, and the forces
// and errors of the best fits. The campaign may be incomplete; missing runs are then counted.
Summary build_summary(campaign::Contents const& contents);

}  // namespace isolaw::study
