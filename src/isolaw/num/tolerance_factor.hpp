// Tolerance factors of the normal distribution: mean +- k s of a sample holds a share of all values with a confidence.
#pragma once

#include <cstddef>

namespace isolaw::num {

// Two-sided k of a sample of `count` values for `coverage` and `confidence`, both in (0, 1): exact, by integration over
// the distribution of the sample's mean (Odeh, Owen 1980; ISO 16269-6). NaN for fewer than two values.
double tolerance_factor(std::size_t count, double coverage = 0.95, double confidence = 0.95);

}  // namespace isolaw::num
