// Averages and derivatives of sampled values.
#pragma once

#include <vector>

namespace isolaw::data {

// `window` is an odd number of samples. Near the ends of `values` it shrinks symmetrically. A wide window takes no more
// time than a narrow one.
std::vector<double> moving_average(std::vector<double> const& values, int window);

// Derivative of the parabola through three neighbouring samples, in units of `values` per second. It is exact for
// quadratics even if the samples are unevenly spaced, also at the ends, where both other samples lie on one side.
// time_s must increase.
std::vector<double> central_difference(std::vector<double> const& time_s, std::vector<double> const& values);

}  // namespace isolaw::data
