// Time skew between force and displacement, from the reversals of a record.
//
// At a reversal the force of a device that does not depend on rate turns with the displacement: before and after it is
// a smooth function of displacement each, and both meet at the tip. The skew is the shift at which the record comes
// closest to that (least squares, a parabola in displacement before the reversal and a cubic after it). A force that
// turns late can only be late in its channel; one that turns early may come from a viscous device as well, or from
// friction, which is taken off where it is known. Displacement that is noisy is smoothed in time first: noise of it
// reads as an early force, for after a reversal the loop is steep.
#pragma once

#include <optional>
#include <span>

#include "isolaw/data/properties.hpp"

namespace isolaw::data {

struct Skew {
  double force_late = 0.0;  // in s, or in samples without time; negative: the force is early
  // Twice the standard error over the reversals, at least a tenth of a sampling interval, half of one with friction.
  double uncertainty = 0.0;
  double phase = 0.0;       // the same angle of a cycle, rad: 2 pi f force_late
  double agreement = 0.0;   // share of the reversals that show at least half of it
  int reversals = 0;        // that gave a value
  bool is_followed = true;  // by the two curves, within noise; else the loop is so sharp that its shape may look late

  // Beyond the standard errors that one record in a thousand reaches by chance (Student's t of as many reversals), four
  // at least, most reversals agreeing, and beyond what the shape of a loop alone comes to: a loop that is followed as
  // up to 0.035 rad early and 0.008 rad late, a sharper one as 0.04 rad late.
  bool significant() const;
};

// Whether the device is held at an extreme of the cycle, longer than a sine lingers there: the reversal is then
// somewhere in the hold, and the force of a device that creeps is elsewhere at its end.
bool held_at_extreme(std::span<double const> disp_mm, Cycle const& cycle, bool upper, double noise_mm);

// nullopt where fewer than 4 reversals of cycles that count give a value: holds, a force that jumps or sticks, few
// samples, too much noise. friction_kN that the force contains is taken off along the motion.
std::optional<Skew> estimate_skew(CycleView const& view, Properties const& properties, double friction_kN = 0.0);

}  // namespace isolaw::data
