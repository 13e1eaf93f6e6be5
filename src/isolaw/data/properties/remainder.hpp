// Subtracts from a channel the mean cycle of its block. The remainder shows a fault that was found or is suspected in
// this channel: a gain that changes, a zero that jumps, an oscillation, a growing delay, spikes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

struct Remainder {
  bool of_force = true;  // whether the channel is the force; if not, it is displacement
  int block = 0;
  std::size_t first = 0;            // index of the sample to which values[0] belongs
  std::vector<double> values = {};  // kN or mm; NaN between cycles that do not follow one another
  std::vector<double> at = {};      // where the faults are: in s, or sample indices if the record has no time
};

// Subtracts from each sample the mean of the block's cycles at the same phase. If the block has three or more cycles,
// the first one, in which rubber softens, is not in the mean. If an oscillation was found, the mean is averaged over
// the oscillation's period, so that an oscillation that repeats in every cycle stays in the remainder. nullopt if the
// record has no finding of such a fault, or if the block has fewer than two whole cycles.
std::optional<Remainder> remainder(TestRecord const& record, Properties const& properties);

}  // namespace isolaw::data
