// Computes everything that reports print, from a campaign's store.
#pragma once

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Computes statistics over runs and devices, robustness, the front, and the forces and errors of the best fits, from
// the contents alone. It counts the runs that an incomplete campaign lacks.
Summary build_summary(campaign::Contents const& contents);

}  // namespace isolaw::study
