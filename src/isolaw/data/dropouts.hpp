// Finds dropouts: samples of one value that begin and end with a jump while the other channel moves.
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

// The force of a device at rest may vanish, so a force drops out only while the motion goes on.
enum class Other { moves, may_stand };
// docs/properties.md has limits and rates.
std::vector<Dropout> dropouts(std::span<double const> values, std::span<double const> other, Other does);
std::vector<double> bridged(std::span<double const> values, std::vector<Dropout> const& gone);

}  // namespace isolaw::data
