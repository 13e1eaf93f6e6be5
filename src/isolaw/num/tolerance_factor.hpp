// Tolerance factors k: with a given confidence, the interval mean +- k s of a sample contains a given share of the
// normal population that the sample was drawn from; s is the sample's standard deviation.
#pragma once

#include <cstddef>

namespace isolaw::num {

// Two-sided k for a sample of `count` values; the share `coverage` and `confidence` are in (0, 1). Exact, by
// integration over the distribution of the sample's mean (Odeh, Owen 1980; ISO 16269-6). NaN for fewer than two values.
double tolerance_factor(std::size_t count, double coverage = 0.95, double confidence = 0.95);

}  // namespace isolaw::num
