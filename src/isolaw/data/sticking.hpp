// Finds channels that keep one value while the other channel goes on. Rest, yielding, slip and play are no faults.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

// A clipped channel is not examined.
std::vector<SignalFault> stuck_channels(SignalPair const& pair, bool clipped_disp, bool clipped_force);

}  // namespace isolaw::data
