// Stiffness and damping over the levels of a test: its blocks differ in amplitude, frequency or vertical load, and each
// is compared with the block that counts.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Level {
  int block = 0;
  double amplitude_mm = 0.0;
  std::optional<double> strain_percent, frequency_Hz, N_mean_kN;
  int cycle = 0;  // the third counted cycle, or the last if there are fewer
  double K_eff_kN_per_mm = 0.0, damping_percent = 0.0, energy_kN_mm = 0.0;
  std::optional<double> K_eff_ratio, damping_ratio;  // relative to the reference
  bool reference = false;                            // the block that counts
};

std::vector<Level> levels_of(DeviceResult const& device);

}  // namespace isolaw::study
