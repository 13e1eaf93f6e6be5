// Channels that drop out: a few samples of one value off the path, entered and left by a jump, while the other channel
// goes on.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

struct Dropout {
  SampleRange samples;
  double level = 0.0;                // of all of them
  double before = 0.0, after = 0.0;  // the values beside them
};

// What the other channel does meanwhile. A device whose motion stands may let go of its force; a force may stand while
// the device moves.
enum class Other { moves, may_stand };
// Of `values`, beside the other channel of the record. Limits and rates: docs/properties.md.
std::vector<Dropout> dropouts(std::span<double const> values, std::span<double const> other, Other does);

// The values with a straight way in place of each dropout.
std::vector<double> bridged(std::span<double const> values, std::vector<Dropout> const& gone);

}  // namespace isolaw::data
