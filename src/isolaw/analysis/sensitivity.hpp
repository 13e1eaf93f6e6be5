// How the residuals at an optimum answer to small changes of the free parameters. Internal to this module.
#pragma once

#include <span>
#include <vector>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/linear.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::analysis {

struct Sensitivity {
  num::Vector residuals, weights;  // of the samples that count
  num::Matrix jacobian;            // samples x free parameters: derivatives by coordinates of the unit box
};

// By central differences inside the box; a column is zero where a neighbour has no finite force.
Sensitivity sensitivity(opt::DeviationProblem const& problem, std::span<double const> point);

// d value / d coordinate of the unit box.
double slope(fit::SearchParameter const& parameter, double coordinate);

// What a relative change of a parameter refers to: its size; for one whose box spans zero no less than a hundredth of
// the box.
double natural_size(fit::SearchParameter const& parameter, double value);

// Free parameters of a box, in its order.
std::vector<fit::SearchParameter const*> free_parameters(fit::SearchBox const& box);

}  // namespace isolaw::analysis
