// Estimates the time skew between force and displacement from the reversals of a record. At a reversal the force of a
// rate-independent device turns together with the displacement. The skew is the shift at which the force comes closest
// to a parabola in displacement before the reversal and a cubic after it, which meet at the tip (least squares). If the
// force turns late, only its channel can be late. If it turns early, the device may also be viscous, or have friction,
// which is subtracted if it is known. Noisy displacement is smoothed first: the loop is steep after a reversal, so
// noise of displacement looks like an early force.
#pragma once

#include <optional>
#include <span>

#include "isolaw/data/properties.hpp"

namespace isolaw::data {

struct Skew {
  double force_late = 0.0;  // in s, or in samples without time; negative: the force is early
  // Twice the standard error over the reversals, at least a tenth of a sampling interval, or half of one with friction.
  double uncertainty = 0.0;
  double phase = 0.0;       // force_late as an angle of the cycle, rad: 2 pi f force_late
  double agreement = 0.0;   // share of the reversals that show at least half of it
  int reversals = 0;        // number of reversals that gave a value
  bool is_followed = true;  // the two curves fit within noise; else the loop is so sharp that its shape may look late

  // Most reversals agree, and the skew exceeds four standard errors (or Student's t at 0.001) and a limit. A loop's
  // shape looks 0.035 rad early or 0.008 rad late; 0.04 rad late if it is too sharp to be followed.
  bool significant() const;
};

// Whether displacement stays at the extreme for longer than a sine does. During a hold a device's force may creep.
bool held_at_extreme(std::span<double const> disp_mm, Cycle const& cycle, bool upper, double noise_mm);

// nullopt if fewer than 4 reversals of counted cycles give a value. friction_kN is subtracted along the motion.
std::optional<Skew> estimate_skew(CycleView const& view, Properties const& properties, double friction_kN = 0.0);

}  // namespace isolaw::data
