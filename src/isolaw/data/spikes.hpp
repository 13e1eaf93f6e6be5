// Single samples far off their neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

// A single sample off its neighbours, and what they say it should be.
struct Spike {
  std::size_t at = 0;
  double value = 0.0;
  double expected = 0.0;
};
std::vector<Spike> spikes(std::span<double const> values);

// Where motion turns force may jump, and a sample in the jump lies off its neighbours: at some turns more, by where the
// samples happen to lie. What other turns have too is how the device or its rig is. `turns`: samples at which the
// displacement turns; `all`: the spikes of the force.
bool is_of_every_turn(Spike const& spike, std::vector<Spike> const& all, std::span<double const> force,
                      std::span<std::size_t const> turns);

// The smallest step between two values that differ: what a digitiser or the digits of a file resolve. At most `range`.
double smallest_step(std::span<double const> values, double range);

}  // namespace isolaw::data
