// The derivatives of the residuals at an optimum by the free parameters. Internal to this module.
#pragma once

#include <span>
#include <vector>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/linear.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::analysis {

struct Sensitivity {
  num::Vector residuals, weights;  // for the samples with a weight above 0
  num::Matrix jacobian;            // samples x free parameters: derivatives by coordinates of the unit box
};

// By central differences inside the box. A column is zero if a neighbour has no finite force.
Sensitivity sensitivity(opt::DeviationProblem const& problem, std::span<double const> point);
double slope(fit::SearchParameter const& parameter, double coordinate);  // d value / d coordinate of the unit box
// Relative changes of a parameter are divided by this size: |value|. If the box spans zero or the value is 0, it is at
// least a hundredth of the box's width.
double natural_size(fit::SearchParameter const& parameter, double value);

std::vector<fit::SearchParameter const*> free_parameters(fit::SearchBox const& box);

}  // namespace isolaw::analysis
