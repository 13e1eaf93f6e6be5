// Corrects a record for errors of the rig, only on request. Each correction leaves a finding in the record.
#pragma once

#include <optional>

namespace isolaw::data {

struct TestRecord;

struct Corrections {
  bool repair_spikes = false;                       // replaces single samples far from their neighbours
  std::optional<double> skew_s = {};                // the force is later than displacement by this much
  std::optional<double> friction_kN = {};           // friction of the rig in the measured force, to be subtracted
  std::optional<double> friction_coefficient = {};  // the same, as a share of the measured vertical load
  std::optional<double> moving_mass_kg = {};        // mass between device and load cell; m a is subtracted
  std::optional<double> force_factor = {};  // multiplies the force at the end: 0.5 for two devices in double shear

  bool any() const;
  bool operator==(Corrections const&) const = default;
  void validate() const;  // throws Error that names the options
};

// Makes the correction repair_spikes. It runs before the search for faults and before all other corrections.
void repair(TestRecord& record, Corrections const& corrections);

// Makes the other corrections, in the order of the members: friction and inertia are subtracted from the force as
// measured. Samples at the end of the record (at its start for a negative skew) whose interpolated force is not known
// are dropped from all channels. Friction acts against the motion between reversals (noise apart), not while the record
// rests at its start or end. Acceleration is the second difference over a 40th of a cycle, of displacement averaged
// three times over as much; for a sine it is 0.5 % too small. Throws Error if a correction is invalid or lacks its
// channel.
void correct(TestRecord& record, Corrections const& corrections);

}  // namespace isolaw::data
