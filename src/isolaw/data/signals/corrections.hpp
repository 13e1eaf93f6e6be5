// Corrects a record for errors of the rig if the user asks for it. Each correction leaves a finding in the record.
#pragma once

#include "isolaw/data/channels/record.hpp"

namespace isolaw::data {

// Repairs spikes if the user asks for it. Must run before the search for faults and before correct().
void repair(TestRecord& record, Corrections const& corrections);

// Makes all corrections except the repair of spikes, in the order of the members of Corrections. The shift by the skew
// leaves some samples at one end of the record without a force; these samples are dropped. Friction acts against the
// motion, except while the record rests at its start or end. The inertia of a moving mass is computed from averaged
// displacements 1/40 of a cycle before and after each sample, which makes it 0.5 % too small for a sine. Throws Error
// if a correction is invalid or if the record lacks a channel for it.
void correct(TestRecord& record, Corrections const& corrections);

}  // namespace isolaw::data
