// Corrections of a record for what the rig did to it, only on request; each leaves a finding in the record.
#pragma once

#include <optional>

namespace isolaw::data {

struct TestRecord;

struct Corrections {
  bool repair_spikes = false;                       // single samples off their neighbours take what these say
  std::optional<double> skew_s = {};                // the force is later than displacement by this, and is moved back
  std::optional<double> friction_kN = {};           // the rig's, in the force's path: taken off along the motion
  std::optional<double> friction_coefficient = {};  // the same as a share of the measured vertical load
  std::optional<double> moving_mass_kg = {};        // between the device and the load cell: m a is taken off
  std::optional<double> force_factor = {};  // multiplies the force last of all: 0.5 for two devices in double shear

  bool any() const;
  bool operator==(Corrections const&) const = default;
  void validate() const;  // throws Error that names the options
};

// Replaces single samples only. It runs before the search for faults and before all other corrections.
void repair(TestRecord& record, Corrections const& corrections);

// The corrections left after repair(), in the order of the members, friction and mass as the load cell feels them.
// Samples at the end of the record (at its start for a negative skew) whose interpolated force is not known are dropped
// from all channels. Friction acts against the motion between reversals (noise apart), not while the record rests at
// its start or end. Acceleration is the second difference over a 40th of a cycle of displacement averaged three times
// over as much: 0.5 % too little of a sine. Throws Error for invalid corrections and for ones whose channel is missing.
void correct(TestRecord& record, Corrections const& corrections);

}  // namespace isolaw::data
