// Compares the blocks of a test, which differ in amplitude, frequency or vertical load: the stiffness and damping of
// each are divided by those of the block that is assessed.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Level {
  int block = 0;
  double amplitude_mm = 0.0;
  std::optional<double> strain_percent = {}, frequency_Hz, N_mean_kN;
  int cycle = 0;  // the third counted cycle, or the last if there are fewer
  double K_eff_kN_per_mm = 0.0, damping_percent = 0.0, energy_kN_mm = 0.0;
  std::optional<double> K_eff_ratio = {}, damping_ratio = {};  // relative to the block that is assessed
  bool reference = false;                                      // true for the block that is assessed
};

std::vector<Level> levels_of(DeviceResult const& device);

}  // namespace isolaw::study
