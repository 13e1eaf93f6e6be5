// Descriptive statistics as the method uses them. A value that is not finite makes the result not finite; nothing is
// left out silently.
#pragma once

#include <cstddef>
#include <span>

namespace isolaw::num {

struct Moments {
  std::size_t count = 0;
  double mean = 0.0;  // NaN when count is 0
  double std = 0.0;   // sample form (n - 1); 0 when count is 1, NaN when 0
};

// Two-pass, so that a small spread about a large mean keeps its digits.
Moments moments(std::span<double const> values);

// Divides by n; used by the objective's normalisation. NaN when there are no values.
double population_std(std::span<double const> values);

}  // namespace isolaw::num
