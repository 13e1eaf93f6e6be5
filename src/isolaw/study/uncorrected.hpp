// Computes the properties and verdicts that records would have without the corrections that the user asked for, such as
// a shift of the force channel in time.
#pragma once

#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Assesses the lot again, with the uncorrected record of every device. Sets Summary::without_corrections, unless the
// uncorrected record of a device is missing. Adds a warning to every corrected device. `tests` are those from which the
// summary's acceptance was computed.
void add_uncorrected(Summary& summary, std::vector<AssessedTest> tests);

}  // namespace isolaw::study
