// Displacement and force for the search for faults: without spikes, and with noise, resolution and turning points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/spikes.hpp"

namespace isolaw::data {

// Limits that several kinds of fault share.
inline constexpr double same_value = 1e-9;    // times the range
inline constexpr double most_of_force = 0.6;  // times the force's range; no hold relaxes by so much
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t size() const { return last - first + 1; }
};

struct Signal {
  std::vector<double> x;
  double half_range = 0.0;
  double quantum = 0.0;  // the smallest step between two values
  double noise = 0.0;    // standard deviation
};

struct SignalPair {
  Signal disp, force;
  std::span<double const> time;  // as recorded; may be empty
  std::vector<std::size_t> turns;
  std::size_t half_cycle = 0;  // samples, median
  double interval = 0.0;       // s

  SignalPair(std::span<double const> disp_mm, std::span<double const> force_kN, std::span<double const> time_s,
             std::vector<Spike> const& of_disp, std::vector<Spike> const& of_force);

  bool moves() const;  // whether both channels move, by finite amounts
  std::size_t size() const { return disp.x.size(); }
  double stiffness() const { return force.half_range / disp.half_range; }
  bool gap_after(std::size_t i) const;
  // A signal with noise does not repeat a value to the last digit.
  bool has_noise(Signal const& signal) const;
};

double mean_of(std::span<double const> x, std::size_t begin, std::size_t end);

}  // namespace isolaw::data
