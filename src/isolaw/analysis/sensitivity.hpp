// Derivatives of the residuals with respect to the free parameters, at an optimum. Used only inside this module.
#pragma once

#include <span>
#include <vector>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/linear.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::analysis {

struct Sensitivity {
  num::Vector residuals, weights;  // one for each sample with a weight above 0
  // Derivatives of the residuals of these samples (rows) with respect to the free parameters' coordinates in the unit
  // box (columns).
  num::Matrix jacobian;
};

// Uses central differences inside the box. A parameter's column is zero if one of its differences is not finite.
Sensitivity sensitivity(opt::DeviationProblem const& problem, std::span<double const> point);
// Derivative of a parameter's value with respect to its coordinate in the unit box.
double slope(fit::SearchParameter const& parameter, double coordinate);
// The divisor for relative changes of a parameter: |value|. If the box spans zero or the value is 0, the divisor is at
// least a hundredth of the box's width.
double natural_size(fit::SearchParameter const& parameter, double value);

std::vector<fit::SearchParameter const*> free_parameters(fit::SearchBox const& box);

}  // namespace isolaw::analysis
