// Corrects a record for errors of the rig if the user asks for it. Each correction leaves a finding in the record.
#pragma once

#include "isolaw/data/channels/record.hpp"

namespace isolaw::data {

// Repairs spikes, if asked for. Call it before the search for faults and before correct().
void repair(TestRecord& record, Corrections const& corrections);

// Makes all corrections except the repair of spikes, in the order of the members. Samples whose shifted force would lie
// outside the record are dropped from all channels. Friction acts against the motion, except while the record rests at
// its start or end. Acceleration is the second difference over a 40th of a cycle, of displacement averaged three times
// over as many samples; for a sine it is 0.5 % too small. Throws Error if a correction is invalid or lacks its channel.
void correct(TestRecord& record, Corrections const& corrections);

}  // namespace isolaw::data
