// Estimates the time skew between force and displacement from the reversals of a record.
//
// At a reversal the force of a rate-independent device turns together with the displacement: it is one smooth function
// of displacement before and another one after, and both meet at the tip. The skew is the shift at which the record
// comes closest to that (least squares, a parabola in displacement before the reversal and a cubic after it). If the
// force turns late, only its channel can be late. If it turns early, the device may also be viscous or have friction,
// which is subtracted where it is known. Noisy displacement is smoothed in time first: since the loop is steep after a
// reversal, its noise looks like an early force.
#pragma once

#include <optional>
#include <span>

#include "isolaw/data/properties.hpp"

namespace isolaw::data {

struct Skew {
  double force_late = 0.0;  // in s, or in samples without time; negative: the force is early
  // Twice the standard error over the reversals, but at least a tenth of a sampling interval, or half with friction.
  double uncertainty = 0.0;
  double phase = 0.0;       // force_late as an angle of the cycle, rad: 2 pi f force_late
  double agreement = 0.0;   // share of the reversals that show at least half of it
  int reversals = 0;        // number of reversals that gave a value
  bool is_followed = true;  // the two curves fit within noise; else the loop is so sharp that its shape may look late

  // Whether most reversals agree and the skew exceeds two limits. One is four standard errors, or the more that one
  // record in a thousand reaches by chance (Student's t). The other is the skew that the shape of a loop imitates: up
  // to 0.035 rad early and 0.008 rad late if the loop is followed, 0.04 rad late if it is sharper.
  bool significant() const;
};

// Whether the device is held at an extreme of the cycle, longer than a sine lingers there. The reversal is then
// somewhere in the hold, and the force of a device that creeps has changed by its end.
bool held_at_extreme(std::span<double const> disp_mm, Cycle const& cycle, bool upper, double noise_mm);

// nullopt if fewer than 4 reversals of cycles that count give a value: holds, a force that jumps or sticks, few
// samples, too much noise. friction_kN is the friction in the force; it is subtracted in the direction of the motion.
std::optional<Skew> estimate_skew(CycleView const& view, Properties const& properties, double friction_kN = 0.0);

}  // namespace isolaw::data
