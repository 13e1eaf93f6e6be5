// Finds the points that no other point beats in two objectives (Pareto front). Both objectives are minimised.
#pragma once

#include <span>
#include <vector>

namespace isolaw::opt {

// Element i is true if no other point is at least as small in both objectives and smaller in one. a[i] and b[i] are the
// objectives of point i. Equal points do not beat each other. Points with a value that is not finite are never true.
std::vector<bool> non_dominated(std::span<double const> a, std::span<double const> b);

}  // namespace isolaw::opt
