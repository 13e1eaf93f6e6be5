// From what a campaign holds to what its reports print.
#pragma once

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Statistics over runs and devices, robustness, front, and the best fits' forces and errors, recomputed from the
// contents alone. Also for a campaign that is not complete: runs that are missing are counted as such.
Summary build_summary(campaign::Contents const& contents);

}  // namespace isolaw::study
