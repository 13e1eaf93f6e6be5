// Estimates the time skew between force and displacement from the reversals of a record. At a reversal the force of a
// rate-independent device turns together with displacement. Near a reversal, a parabola in displacement before it and a
// cubic after it, which meet at the tip, are fitted to the force (least squares). The skew is the shift with the best
// fit. If the force turns late, the force channel is late. If it turns early, the displacement channel may be late, or
// the device may be viscous or have friction. Known friction is subtracted. Noisy displacement is smoothed first,
// because the loop is steep after a reversal, where noise of displacement looks like an early force.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

struct Skew {
  double force_late = 0.0;  // in s, or in samples without time; negative if the force is early
  // Twice the standard error over the reversals; at least 0.1 sampling intervals, or 0.5 if friction is subtracted.
  double uncertainty = 0.0;
  double phase = 0.0;      // the angle of force_late in a cycle, rad: 2 pi f force_late
  double agreement = 0.0;  // fraction of the reversals that show at least half of force_late
  int reversals = 0;       // reversals that gave a value
  double interval = 0.0;   // longest mean sampling interval of a test, in the unit of force_late
  // The delay of each cycle in the block that contains the reported cycle; a cycle's delay is the median over its
  // reversals. `growth` is how much the delay grows from the first of these cycles to the last, according to a line
  // through the delays at all their reversals.
  struct CycleDelay {
    int number = 0;
    double delay = 0.0;
  };
  std::vector<CycleDelay> cycle_delays = {};
  double growth = 0.0, growth_uncertainty = 0.0;  // in the unit of force_late; uncertainty is two standard errors
  double growth_phase = 0.0;                      // the angle of `growth` in a cycle, rad
  int growth_reversals = 0;
  bool is_followed = true;  // whether the fit leaves only noise; if not, a loop with sharp corners may seem late

  // Whether the skew is real: most reversals agree, and it exceeds four standard errors (more if reversals are few) and
  // a limit. The shape of a loop alone can imitate a skew a little below this limit, which is 0.04 rad for an early
  // force and 0.015 rad for a late one. If is_followed is false, a late force must exceed both 0.045 rad and a sampling
  // interval, because the corners of a steep loop lie between samples.
  bool significant() const;
  // Whether the delay changes by more than 0.03 rad and by more than it would by chance.
  bool grows() const;
};

// Whether displacement stays at an extreme for longer than a sine would. During such a hold the force may relax.
bool held_at_extreme(std::span<double const> disp_mm, Cycle const& cycle, bool upper, double noise_mm);

// Estimates the skew after subtracting friction_kN of rig friction. nullopt if fewer than 4 reversals of counted cycles
// give a value, or if the noise of displacement exceeds 1 % of the smallest amplitude.
std::optional<Skew> estimate_skew(CycleView const& view, Properties const& properties, double friction_kN = 0.0);

}  // namespace isolaw::data
