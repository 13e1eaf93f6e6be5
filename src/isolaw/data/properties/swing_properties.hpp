// Stiffness and damping of a record from its largest swings, also where the motion has no cycles, as in an earthquake.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/cycles/swings.hpp"

namespace isolaw::data {

// Two neighbouring swings stand for a cycle. A pair is used if the mean of its half ranges is at least 0.8 times the
// mean of the largest pair. The sums below are over both swings of every pair used, so a swing that belongs to two
// pairs enters twice.
struct SwingProperties {
  std::size_t pairs = 0;
  double amplitude_mm = 0.0;     // mean of the half ranges
  double force_kN = 0.0;         // sum of the changes of force from turn to turn, positive along the motion
  double energy_kN_mm = 0.0;     // sum of the area between force and chord, the straight line between the turns
  double K_kN_per_mm = 0.0;      // force_kN / sum of the ranges
  double damping_percent = 0.0;  // 100 energy / (pi K sum of the squared half ranges)
};

// nullopt if there are fewer than two swings, or if the stiffness is not above 0.
std::optional<SwingProperties> swing_properties(std::span<double const> disp_mm, std::span<double const> force_kN,
                                                std::span<double const> time_s);
// The properties of the record's test that has the largest amplitude.
std::optional<SwingProperties> swing_properties(TestRecord const& record);
// The properties of these swings with another force, such as the force that a law computes at the same samples.
SwingProperties properties_on(std::span<Swing const> swings, std::span<double const> disp_mm,
                              std::span<double const> force_kN);

}  // namespace isolaw::data
