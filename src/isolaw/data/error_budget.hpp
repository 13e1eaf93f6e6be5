// Effects of sampling, rig and filters on the cyclic properties: closed forms for a sine and its loops.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/data/properties.hpp"

namespace isolaw::data {

struct Effect {
  std::string effect;  // "samples per cycle", "skew", ...
  double value = 0.0;
  std::string unit;             // empty for a pure number
  std::optional<double> limit;  // if there is one
  bool exceeds = false;
};

struct Budget {
  std::vector<Finding> warnings;  // something exceeds its limit
  std::vector<Finding> notes;     // numbers worth knowing
  std::vector<Effect> effects;    // all that was assessed
};

// Effects whose values are points of damping that they add.
inline constexpr char const *damping_by_skew = "damping by skew", *damping_by_jump = "damping by the jump",
                            *damping_by_rig_friction = "damping by rig friction of 0.5 % of the vertical load";

// `smooth` is the window, in samples, of the moving average before the fit; 1 for none.
Budget error_budget(CycleView const& view, Properties const& properties, int smooth = 1);
Budget error_budget(TestRecord const& record, Properties const& properties, int smooth = 1);

// The percent of a loop lost between samples, and of a sine removed by a moving average of an odd window.
double energy_loss_percent(double samples_per_cycle);  // share of the energy: 1 - N / (2 pi) sin(2 pi / N)
double peak_loss_percent(double samples_per_cycle);    // share of a peak halfway between samples: 1 - cos(pi / N)
double average_loss_percent(int window, double samples_per_cycle);
// The mean distance of a sine's largest sample beyond its peak, with white noise of this standard deviation.
double peak_gain_mm(double noise_mm, double amplitude_mm, double samples_per_cycle);
// Points of equivalent damping: 200 F_f / (pi K D)
double friction_damping_points(double friction_kN, double K_eff_kN_per_mm, double amplitude_mm);
// The stiffness in kN/mm by which a mass moved by a sine lowers the measured stiffness: m (2 pi f)^2
double mass_stiffness_kN_per_mm(double mass_kg, double frequency_Hz);

}  // namespace isolaw::data
