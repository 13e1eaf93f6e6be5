// Finds the cycle in which a specimen, or the channel of its force, fails. There the force falls suddenly to a part of
// its size in the cycle before. Or it is nearly gone compared with an earlier cycle under the same load, at a similar
// pace and of no larger amplitude. A force that falls slowly over many cycles is heating or scragging and no failure.
#pragma once

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Sets properties.failure and properties.lost. Cycles whose force is nearly gone no longer count. If the force is still
// nearly gone in the last cycle, no cycle counts from the failing one on. time_s may be empty.
void find_failure(Properties& properties, std::span<double const> time_s);

}  // namespace isolaw::data
