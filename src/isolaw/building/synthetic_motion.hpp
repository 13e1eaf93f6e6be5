// Ground motions made here, for examples, tests and measurements of speed: none was recorded anywhere.
// Source: spectral representation (Shinozuka and Deodatis 1991) of the filtered white noise of Clough and Penzien
// (Dynamics of Structures, section 28), within the envelope of Jennings, Housner and Tsai 1968.
#pragma once

#include <cstddef>
#include <cstdint>

#include "isolaw/building/integrate.hpp"

namespace isolaw::building {

struct SyntheticMotion {
  double step_s = 0.005, duration_s = 20.0;
  double peak_g = 0.35;          // of x; y is independent, with 0.85 of it
  double ground_period_s = 0.5;  // of the soil that filters
  double ground_damping = 0.6;
  bool two_components = true;
};

// Number `index` of a family; the same for the same seed everywhere but for the last digits of cos and exp.
Motion synthetic_motion(std::uint64_t seed, std::uint32_t index, SyntheticMotion const& wanted = {});

}  // namespace isolaw::building
