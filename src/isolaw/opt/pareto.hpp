// Finds the points that no other point beats in two objectives (Pareto front). Both objectives are minimised.
#pragma once

#include <span>
#include <vector>

namespace isolaw::opt {

// a[i] and b[i] are the objectives of point i. A point beats another if none of its objectives is larger and one is
// smaller. Element i of the result is true if no point beats point i and both of its objectives are finite.
std::vector<bool> non_dominated(std::span<double const> a, std::span<double const> b);

}  // namespace isolaw::opt
