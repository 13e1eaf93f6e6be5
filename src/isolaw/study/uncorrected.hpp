// Computes the properties and verdicts that records would have without the corrections that the user asked for, such as
// a moved force.
#pragma once

#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Assesses the lot again, with every corrected record as it was read. Sets Summary::without_corrections unless a record
// as it was read is missing, and adds a warning to every corrected device. `tests` are those from which the summary's
// acceptance was computed.
void add_uncorrected(Summary& summary, std::vector<AssessedTest> tests);

}  // namespace isolaw::study
