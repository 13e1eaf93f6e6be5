// Descriptive statistics as the method uses them.
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

double population_std(std::span<double const> values);  // divides by n; used by the objective's normalisation

}  // namespace isolaw::num
