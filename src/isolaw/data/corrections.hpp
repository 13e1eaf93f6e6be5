// Corrects a record for errors of the rig if the user asks for it. Each correction leaves a finding in the record.
#pragma once

#include <optional>

namespace isolaw::data {

struct TestRecord;

struct Corrections {
  bool repair_spikes = false;                       // replaces single samples far from their neighbours
  std::optional<double> skew_s = {};                // delay of the force behind displacement, to be removed
  std::optional<double> friction_kN = {};           // friction of the rig in the measured force, to be subtracted
  std::optional<double> friction_coefficient = {};  // friction of the rig over the measured vertical load
  std::optional<double> moving_mass_kg = {};        // mass between device and load cell; its inertia is subtracted
  std::optional<double> force_factor = {};  // multiplies the force at the end: 0.5 for two devices in double shear

  bool any() const;
  bool operator==(Corrections const&) const = default;
  void validate() const;  // throws Error that names the options
};

// Repairs spikes if the user asks for it. Must run before the search for faults and before correct().
void repair(TestRecord& record, Corrections const& corrections);

// Makes all corrections except the repair of spikes, in the order of the members. The shift by the skew leaves no force
// for some samples at one end of the record, which are dropped. Friction acts against the motion, except while the
// record rests at its start or end. Acceleration is the second difference of displacement over 1/40 of a cycle, after
// averaging (0.5 % too small for a sine). Throws Error if a correction is invalid or lacks its channel.
void correct(TestRecord& record, Corrections const& corrections);

}  // namespace isolaw::data
