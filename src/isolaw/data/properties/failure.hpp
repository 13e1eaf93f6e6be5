// Finds the cycle in which a specimen, or its force channel, fails. A cycle fails if its force is much smaller than in
// the cycle before it, or nearly gone compared with an earlier cycle under the same load, at a similar pace and of no
// larger amplitude. A slow fall of the force over many cycles is heating or scragging, not a failure.
#pragma once

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Sets properties.failure and properties.samples_without_force. Cycles whose force is nearly gone no longer count. If
// the force is still nearly gone in the last cycle, no cycle counts from the failing one on. time_s may be empty.
void find_failure(Properties& properties, std::span<double const> time_s);

}  // namespace isolaw::data
