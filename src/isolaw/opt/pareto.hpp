// The non-dominated points (Pareto front) of two objectives, both minimised.
#pragma once

#include <span>
#include <vector>

namespace isolaw::opt {

// Element i is true if no other point is at least as small in both objectives and smaller in one. Equal points do not
// dominate each other. A point with a value that is not finite is never on the front. a[i] and b[i] belong to point i.
std::vector<bool> non_dominated(std::span<double const> a, std::span<double const> b);

}  // namespace isolaw::opt
