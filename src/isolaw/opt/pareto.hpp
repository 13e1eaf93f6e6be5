// Non-dominated points of two objectives, both minimised.
#pragma once

#include <span>
#include <vector>

namespace isolaw::opt {

// on_front[i] is true where no other point is at least as small in both objectives and smaller in one; equal points
// do not dominate each other, so duplicates are on the front together.
// A point with a value that is not finite is never on the front and dominates nothing. a and b: equal length.
std::vector<bool> non_dominated(std::span<double const> a, std::span<double const> b);

}  // namespace isolaw::opt
