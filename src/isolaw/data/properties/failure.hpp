// Finds the cycle in which a specimen, or the channel of its force, fails. The force falls suddenly to a part of its
// size in the cycle before, or is nearly gone compared with an earlier cycle of the same load and pace and no larger
// amplitude. A force that falls slowly over many cycles is heating or scragging and no failure.
#pragma once

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Sets properties.failure and `lost`. Cycles whose force is nearly gone no longer count. If it is still nearly gone in
// the last cycle, all cycles from the one that fails on no longer count. time_s may be empty.
void find_failure(Properties& properties, std::span<double const> time_s);

}  // namespace isolaw::data
