// Finds channels that are cut off at the limit of an amplifier or converter. Such a channel keeps one level while the
// other channel goes on: exactly, or within the noise that is added behind the limit.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

std::vector<SignalFault> clipped_channels(SignalPair const& pair);

}  // namespace isolaw::data
