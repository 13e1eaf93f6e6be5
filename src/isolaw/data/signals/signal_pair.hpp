// Displacement and force for the search for faults, without spikes, with their noise, resolution and turning points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/signals/spikes.hpp"

namespace isolaw::data {

// Two values of a channel are equal if they differ by less than this fraction of its range (largest minus smallest).
inline constexpr double same_value = 1e-9;
// During a hold of displacement the force may relax, but by less than this fraction of its range. If the force changes
// by more while displacement stands still, the displacement signal is faulty.
inline constexpr double most_of_force = 0.6;
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t size() const { return last - first + 1; }
};

// One channel. Each spike is replaced by the value that its neighbours suggest. All numbers are in mm, or in kN.
struct Signal {
  std::vector<double> x;
  double half_range = 0.0;  // half the difference between the largest and the smallest value
  double quantum = 0.0;     // step of the digitiser: the smallest difference between two different values
  double noise = 0.0;       // standard deviation of the white noise in the signal
};

struct SignalPair {
  Signal disp, force;              // displacement in mm, force in kN
  std::span<double const> time;    // in s, as recorded; may be empty
  std::vector<std::size_t> turns;  // samples at which displacement turns
  std::size_t half_cycle = 0;      // median number of samples from one turn to the next
  double interval = 0.0;           // usual sampling interval in s; 0 without time

  SignalPair(std::span<double const> disp_mm, std::span<double const> force_kN, std::span<double const> time_s,
             std::vector<Spike> const& of_disp, std::vector<Spike> const& of_force);

  bool moves() const;  // whether displacement and force both change, and all their values are finite
  std::size_t size() const { return disp.x.size(); }
  double stiffness() const { return force.half_range / disp.half_range; }
  bool gap_after(std::size_t i) const;
  // Whether the signal is so noisy that it does not repeat a value exactly.
  bool has_noise(Signal const& signal) const;
};

double mean_of(std::span<double const> x, std::size_t begin, std::size_t end);

}  // namespace isolaw::data
