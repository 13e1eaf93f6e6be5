// Displacement and force for the search for faults, without spikes, with their noise, resolution and turning points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/signals/spikes.hpp"

namespace isolaw::data {

inline constexpr double same_value = 1e-9;    // times the range; values that differ by less are equal
inline constexpr double most_of_force = 0.6;  // times the range of force; in a hold, force relaxes by less
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t size() const { return last - first + 1; }
};

struct Signal {
  std::vector<double> x;
  double half_range = 0.0;
  double quantum = 0.0;  // the smallest step between two values
  double noise = 0.0;    // standard deviation of white noise
};

struct SignalPair {
  Signal disp, force;
  std::span<double const> time;  // in s, as recorded; may be empty
  std::vector<std::size_t> turns;
  std::size_t half_cycle = 0;  // median number of samples in half a cycle
  double interval = 0.0;       // usual sampling interval in s

  SignalPair(std::span<double const> disp_mm, std::span<double const> force_kN, std::span<double const> time_s,
             std::vector<Spike> const& of_disp, std::vector<Spike> const& of_force);

  bool moves() const;  // both channels move, and all values are finite
  std::size_t size() const { return disp.x.size(); }
  double stiffness() const { return force.half_range / disp.half_range; }
  bool gap_after(std::size_t i) const;
  // Whether the signal is so noisy that it does not repeat a value exactly.
  bool has_noise(Signal const& signal) const;
};

double mean_of(std::span<double const> x, std::size_t begin, std::size_t end);

}  // namespace isolaw::data
