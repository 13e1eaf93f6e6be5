// Finds spikes: single samples that are far from their neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {
struct Spike {
  std::size_t at = 0;
  double value = 0.0;
  double expected = 0.0;
};
std::vector<Spike> spikes(std::span<double const> values);

// Whether a spike of force is no fault: a device's force may jump at each turn of displacement. The spike is no fault
// if it lies at a turn and the force also stands out from its neighbours at two or more other turns. Displacement turns
// at the samples `turns`, and `all` holds the spikes of force.
bool is_of_every_turn(Spike const& spike, std::vector<Spike> const& all, std::span<double const> force,
                      std::span<std::size_t const> turns);

// The smallest step between two values: the resolution of a digitiser or of a file's digits. At most `range`.
double smallest_step(std::span<double const> values, double range);

}  // namespace isolaw::data
