// Finds channels that keep one value while the other channel moves. Rest, yielding, slip and play are no faults.
#pragma once

#include <vector>

#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/data/signals/signal_pair.hpp"

namespace isolaw::data {

// Does not search a channel that is clipped, as clipped_disp and clipped_force say.
std::vector<SignalFault> stuck_channels(SignalPair const& pair, bool clipped_disp, bool clipped_force);

}  // namespace isolaw::data
