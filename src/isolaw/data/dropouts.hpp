// Finds dropouts of a channel: a few samples of one value off the path, which begin and end with a jump, while the
// other channel goes on.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signal_pair.hpp"

namespace isolaw::data {

struct Dropout {
  SampleRange samples;
  double level = 0.0;                // the value of these samples
  double before = 0.0, after = 0.0;  // the values beside them
};

// Whether the other channel must move meanwhile. A dropout of the force needs a motion that goes on, since the force of
// a device at rest may vanish; beside a dropout of the motion the force may stand.
enum class Other { moves, may_stand };
// The dropouts of `values`; `other` is the other channel of the record. docs/properties.md has limits and rates.
std::vector<Dropout> dropouts(std::span<double const> values, std::span<double const> other, Other does);

// The values with a straight line in place of each dropout.
std::vector<double> bridged(std::span<double const> values, std::vector<Dropout> const& gone);

}  // namespace isolaw::data
