// Finds channels that an amplifier or converter cuts off at its limit. Such a channel keeps one level while the other
// channel goes on. The level is exactly constant, or noisy if the noise enters the channel after the clipping.
#pragma once

#include <vector>

#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/data/signals/signal_pair.hpp"

namespace isolaw::data {

std::vector<SignalFault> clipped_channels(SignalPair const& pair);

}  // namespace isolaw::data
