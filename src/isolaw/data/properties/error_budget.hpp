// Estimates how sampling, the rig and filters change the cyclic properties, by formulas for a sinusoidal motion and its
// loops.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

struct Effect {
  std::string effect;  // such as "samples per cycle" or "skew"
  double value = 0.0;
  std::string unit;             // empty for a number without unit
  std::optional<double> limit;  // nullopt: no limit
  bool exceeds = false;
};

struct Budget {
  std::vector<Finding> warnings;  // effects that exceed their limits
  std::vector<Finding> notes;     // other effects worth knowing
  std::vector<Effect> effects;    // values and limits of all effects
};

// Names of the effects of the rig that add to the measured equivalent damping. Their values are percentage points of
// damping.
inline constexpr char const *damping_by_skew = "damping by skew", *damping_by_jump = "damping by the jump",
                            *damping_by_rig_friction = "damping by rig friction of 0.5 % of the vertical load";

// `smooth` is the window, in samples, of the moving average before a law is fitted; 1 for none.
Budget error_budget(CycleView const& view, Properties const& properties, int smooth = 1);
Budget error_budget(TestRecord const& record, Properties const& properties, int smooth = 1);

// How much too small, in percent, a value is if a cycle has N samples: the energy of a sinusoidal loop, and the peak of
// a sine that lies halfway between two samples.
double energy_loss_percent(double samples_per_cycle);  // 1 - N / (2 pi) sin(2 pi / N)
double peak_loss_percent(double samples_per_cycle);    // 1 - cos(pi / N)
// The corner of a triangle may lie between two samples; at most 2 / N of its peak is then lost. If a device's force
// jumps when the motion turns, the same part of its energy is lost.
double corner_loss_percent(double samples_per_cycle);
// By how much, in percent, a moving average over `window` samples reduces the amplitude of a sine.
double average_loss_percent(int window, double samples_per_cycle);
// How far the largest sample of a noisy sine lies beyond the true peak on average, for white noise of standard
// deviation noise_mm.
double peak_gain_mm(double noise_mm, double amplitude_mm, double samples_per_cycle);
// Percentage points of equivalent damping that friction adds: 200 F_f / (pi K D), where D is the amplitude.
double friction_damping_points(double friction_kN, double K_eff_kN_per_mm, double amplitude_mm);
// How much a mass that moves sinusoidally with the device lowers the measured stiffness [kN/mm]: m (2 pi f)^2.
double mass_stiffness_kN_per_mm(double mass_kg, double frequency_Hz);

}  // namespace isolaw::data
