// Finds signals of a compression test that cannot be true: a channel at the end of its range, one that stands still
// while the other goes on, samples that drop out, single samples far off their neighbours.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signal_faults.hpp"

namespace isolaw::data {

// Both positive in compression. A load that is held while the device creeps, a press that lifts off and the steps of a
// digitiser are no faults.
std::vector<SignalFault> vertical_faults(std::span<double const> disp_mm, std::span<double const> load_kN);

}  // namespace isolaw::data
