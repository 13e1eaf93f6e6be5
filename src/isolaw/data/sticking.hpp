// Finds channels that stand still while the other goes on, because of a slow writer, a cable or a sensor that sticks.
// In a device that rests, yields, slips or has play one of them stands still as well; these cases are told apart.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

// A clipped channel is not examined.
std::vector<SignalFault> stuck_channels(SignalPair const& pair, bool clipped_disp, bool clipped_force);

}  // namespace isolaw::data
