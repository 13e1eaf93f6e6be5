// Channels that end at the limit of their amplifier or converter: a level that is kept while the other channel goes on,
// exactly or within noise that comes after it.
#pragma once

#include <vector>

#include "isolaw/data/signal_faults.hpp"
#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

std::vector<SignalFault> clipped_channels(SignalPair const& pair);

}  // namespace isolaw::data
