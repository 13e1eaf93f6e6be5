// Finds channels that end at the limit of their amplifier or converter: they keep a level while the other channel goes
// on, either exactly or, if noise is added behind the limit, within that noise.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

std::vector<SignalFault> clipped_channels(SignalPair const& pair);

}  // namespace isolaw::data
