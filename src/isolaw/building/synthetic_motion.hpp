// Artificial ground motions for examples, tests and measurements of speed.
// Source: spectral representation (Shinozuka and Deodatis 1991) of the filtered white noise of Clough and Penzien
// (Dynamics of Structures, section 28), within the envelope of Jennings, Housner and Tsai 1968.
#pragma once

#include <cstddef>
#include <cstdint>

#include "isolaw/building/integrate.hpp"

namespace isolaw::building {

struct SyntheticMotion {
  double step_s = 0.005, duration_s = 20.0;
  double peak_g = 0.35;          // largest acceleration along x; the independent motion along y has 0.85 times as much
  double ground_period_s = 0.5;  // natural period of the soil that filters the noise
  double ground_damping = 0.6;   // damping ratio of this soil
  bool two_components = true;
};

// Generates motion `index` of those that belong to `seed`. On two machines it differs only as far as their cos and exp
// differ in the last digits.
Motion synthetic_motion(std::uint64_t seed, std::uint32_t index, SyntheticMotion const& wanted = {});

// The motions of `isolaw example DIR --building`, from 0 to 6.
inline constexpr std::uint32_t example_motions = 7;
Motion example_motion(std::uint32_t index);

}  // namespace isolaw::building
