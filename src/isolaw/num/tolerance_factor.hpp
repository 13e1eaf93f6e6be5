// Tolerance factors k. The interval mean +- k s of a sample, where s is the sample's standard deviation, contains a
// given share of the normal population from which the sample was drawn, with a given confidence.
#pragma once

#include <cstddef>

namespace isolaw::num {

// Two-sided k for a sample of `count` values; the share `coverage` and `confidence` are in (0, 1). It is computed
// exactly, by integration over the distribution of the sample's mean (Odeh, Owen 1980; ISO 16269-6). NaN for fewer than
// two values.
double tolerance_factor(std::size_t count, double coverage = 0.95, double confidence = 0.95);

}  // namespace isolaw::num
