// Finds the cycle in which a specimen, or the channel of its force, fails: the force falls suddenly to a part of what
// it was in the cycle before. A force that falls slowly over many cycles is heating or scragging and no failure.
#pragma once

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Sets properties.failure and failed_from. Cycles whose force is nearly gone, in units of what an earlier cycle of no
// larger amplitude had, no longer count; nor do those before them from the cycle that fails on.
void find_failure(Properties& properties);

}  // namespace isolaw::data
