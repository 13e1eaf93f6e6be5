// Averages and derivatives of sampled values.
#pragma once

#include <vector>

namespace isolaw::data {

// `window`, an odd number of samples, shrinks symmetrically at both ends of `values`. It does not change the cost.
std::vector<double> moving_average(std::vector<double> const& values, int window);

// Derivative of the parabola through three neighbouring samples, in units of `values` per second. It is exact for
// quadratics on uneven spacing, also at the ends, where the parabola is one-sided. time_s must increase.
std::vector<double> central_difference(std::vector<double> const& time_s, std::vector<double> const& values);

}  // namespace isolaw::data
