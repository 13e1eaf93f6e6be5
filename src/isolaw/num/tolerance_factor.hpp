// Tolerance factors k: the interval mean +- k s of a normal sample holds a given share of all values with confidence.
#pragma once

#include <cstddef>

namespace isolaw::num {

// The two-sided k for a sample of `count` values, with `coverage` (the share) and `confidence` in (0, 1). Exact, by
// integration over the distribution of the sample's mean (Odeh, Owen 1980; ISO 16269-6). NaN for fewer than two values.
double tolerance_factor(std::size_t count, double coverage = 0.95, double confidence = 0.95);

}  // namespace isolaw::num
