// Channels that stand for a while in which the other goes on: a slow writer, a cable, a sensor that sticks. A device
// that rests, yields, slips or has play moves one of them too, which is told apart here.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

// A channel that is clipped is not looked at.
std::vector<SignalFault> stuck_channels(SignalPair const& pair, bool clipped_disp, bool clipped_force);

}  // namespace isolaw::data
