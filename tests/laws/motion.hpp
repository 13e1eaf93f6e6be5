// Makes displacement histories for the tests of the laws, in mm and mm/s, and converts them to a law's Path.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numbers>
#include <span>
#include <vector>

#include "isolaw/laws/law.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::law_tests {

struct Motion {
  std::vector<double> disp_mm, velocity_mm_s;

  std::size_t size() const { return disp_mm.size(); }
};

// Returns x = A sin(2 pi f t), which starts at x = 0, with its exact velocity.
inline Motion sine(double amplitude_mm, double frequency_Hz, int cycles, int samples_per_cycle) {
  Motion motion;
  double const omega = 2.0 * std::numbers::pi * frequency_Hz;
  for (int i = 0; i <= cycles * samples_per_cycle; ++i) {
    double const time_s = i / (frequency_Hz * samples_per_cycle);
    motion.disp_mm.push_back(amplitude_mm * std::sin(omega * time_s));
    motion.velocity_mm_s.push_back(amplitude_mm * omega * std::cos(omega * time_s));
  }
  return motion;
}

// Moves at constant speed from each given displacement to the next, each time in `steps` equal steps. The first sample
// is the first displacement. At a corner the velocity is that of the line that ends there.
inline Motion polyline(std::span<double const> corners_mm, int steps, double speed_mm_s = 100.0) {
  Motion motion;
  motion.disp_mm.push_back(corners_mm[0]);
  motion.velocity_mm_s.push_back(0.0);
  for (std::size_t i = 1; i < corners_mm.size(); ++i) {
    double const rise = corners_mm[i] - corners_mm[i - 1];
    for (int k = 1; k <= steps; ++k) {
      motion.disp_mm.push_back(k == steps ? corners_mm[i] : corners_mm[i - 1] + rise * k / steps);
      motion.velocity_mm_s.push_back(rise > 0.0 ? speed_mm_s : -speed_mm_s);
    }
  }
  return motion;
}

// Returns the displacements of polyline(), for laws that do not depend on velocity.
inline std::vector<double> through(std::span<double const> corners, int steps) {
  return polyline(corners, steps).disp_mm;
}
inline std::vector<double> through(std::initializer_list<double> corners, int steps) {
  return through(std::span(corners.begin(), corners.size()), steps);
}

// Displacements in mm between which the path runs straight: small loops inside larger ones. Several tests compare the
// forces of a law along this path with those that other programs computed.
inline std::vector<double> const corners{0, 20, 50, 10, -40, -60, 30, 20, 45, 80};

inline double sign(double x) {
  return x < 0.0 ? -1.0 : x > 0.0 ? 1.0 : 0.0;
}

// Returns cycles of growing, then shrinking amplitude with noise. The noise reverses the motion at almost every sample
// near the peaks and so makes small loops inside large ones. New peaks occur throughout the first half. The sampling
// rate is 50 Hz, and the velocity is the difference quotient of the displacements.
inline Motion irregular(std::uint64_t seed, double amplitude_mm, int cycles, int samples_per_cycle,
                        double noise_share = 0.02) {
  num::Draws draws(num::Stream(seed), 0, 0);
  Motion motion;
  int const count = cycles * samples_per_cycle;
  for (int i = 0; i <= count; ++i) {
    double const envelope = std::sin(std::numbers::pi * (i + 0.05 * count) / (1.1 * count));
    double const phase = 2.0 * std::numbers::pi * i / samples_per_cycle;
    motion.disp_mm.push_back(amplitude_mm * (envelope * std::sin(phase) + noise_share * draws.normal()));
  }
  constexpr double rate_Hz = 50.0;
  auto const& x = motion.disp_mm;
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::size_t const before = i == 0 ? 0 : i - 1, after = std::min(i + 1, x.size() - 1);
    motion.velocity_mm_s.push_back((x[after] - x[before]) * rate_Hz / static_cast<double>(after - before));
  }
  return motion;
}

inline Motion scaled(Motion motion, double disp_factor, double velocity_factor) {
  for (double& x : motion.disp_mm) x *= disp_factor;
  for (double& v : motion.velocity_mm_s) v *= velocity_factor;
  return motion;
}

// Converts a motion from mm to the law's unit of length and makes the law's Path of it.
template <class Law>
laws::Path path_of(Motion const& motion, int refinement = 1) {
  auto const x = scaled(motion, 1.0 / Law::info.length.in_record_units, 1.0 / Law::info.length.in_record_units);
  return laws::make_path(x.disp_mm, x.velocity_mm_s, refinement);
}

inline double largest_magnitude(std::span<double const> values) {
  double largest = 0.0;
  for (double const value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

// Returns the largest |a - b|, or NaN or infinity if any difference is not finite.
inline double largest_difference(std::span<double const> a, std::span<double const> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double const difference = std::abs(a[i] - b[i]);
    if (!(difference <= largest)) largest = difference;
    if (!std::isfinite(largest)) return largest;
  }
  return largest;
}

inline bool all_finite(std::span<double const> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace isolaw::law_tests
