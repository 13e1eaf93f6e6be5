// From the raw record to the one the laws are fitted to (section 3 of the paper; every step is recorded).
#pragma once

#include <optional>

#include "isolaw/data/record.hpp"

namespace isolaw::data {

struct CleanOptions {
  int smooth = 1;                            // window of the centred moving average, odd; 1 = none
  std::optional<int> samples_per_cycle = 200;  // thinning; nullopt = all samples
  bool center = false;                       // remove the mean of the extremes of displacement and force

  void validate() const;  // throws Error
};

// Centred moving average of `window` (odd) samples; the window shrinks symmetrically at the ends.
std::vector<double> moving_average(std::vector<double> const& values, int window);

// Central differences at true time stamps (second order on uneven spacing), one-sided at the ends. Units of x per s.
std::vector<double> central_difference(std::vector<double> const& time_s, std::vector<double> const& values);

FitRecord clean(TestRecord const& raw, CleanOptions const& options);

}  // namespace isolaw::data
