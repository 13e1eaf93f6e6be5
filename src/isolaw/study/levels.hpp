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
  // The bilinear loop that has the cycle's peaks, energy and Q_d: its stiffness before yielding (K_1) and after (K_d),
  // and the displacement and force at which it yields.
  std::optional<double> K_1_kN_per_mm, D_y_mm, F_y_kN;
  double K_d_kN_per_mm = 0.0;
  std::optional<double> K_eff_ratio = {}, damping_ratio = {};  // relative to the block that is assessed
  bool reference = false;                                      // true for the block that is assessed
};

std::vector<Level> levels_of(DeviceResult const& device);

// The first and third counted cycles of each amplitude; their peaks form the skeleton curve. All first cycles come
// first, by rising amplitude, then all third cycles. Blocks whose amplitudes differ by at most 5 % count as one
// amplitude, for which the earliest of them is taken.
std::vector<data::Cycle> skeleton_of(DeviceResult const& device);

// K_eff of a counted cycle divided by that of the first counted cycle, of its block (in_block) or of the record
// (in_test). nullopt if one of the two cycles has hardly any stiffness, or if the cycle does not count.
struct Decay {
  std::optional<double> in_block, in_test;
};
Decay stiffness_decay(DeviceResult const& device, data::Cycle const& cycle);

}  // namespace isolaw::study
