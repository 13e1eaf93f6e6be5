// Computes the properties and verdicts that records would have without the corrections that the user asked for, such as
// a moved force.
#pragma once

#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// True if a correction by hand changed the record. Multiplying the force is none: it says what the rig measures, such
// as two devices in double shear.
bool is_corrected(DeviceResult const& device);

// Assesses the lot again, with every corrected record as it was read. Sets Summary::without_corrections, and adds a
// warning to every corrected device. `tests` are those from which the summary's acceptance was computed.
void add_uncorrected(Summary& summary, std::vector<AssessedTest> tests);

}  // namespace isolaw::study
