// The turning points whose branches Masing's rules have not yet closed.
#pragma once

#include <cstddef>
#include <vector>

#include "isolaw/laws/memory/remembered.hpp"

namespace isolaw::laws {

// [export]
// When a branch reaches the point at which the branch before it began, both close. If only one branch is open, it
// closes where it meets the skeleton curve, at the mirror image of its start.
struct OpenBranches {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<double> turned;  // displacements at which the open branches began
  std::size_t kept = none;     // if the motion turned at the step's begin: stack index for the force there
  std::size_t branch = none;   // stack index of the turning point that began the branch; none: on the skeleton
  double branch_x = 0.0;       // displacement of that turning point
  std::size_t depth = 0;       // how many values a stack of the law must hold in this step

  template <class X>
  void move(X const& from, X const& to, double direction_before, double direction) {
    double const x0 = value_of(from), x1 = value_of(to);
    bool const moves = x1 != x0, turns = moves && direction_before != 0.0 && direction != direction_before;
    kept = turns ? turned.size() : none;
    if (turns) turned.push_back(x0);
    depth = turned.size();
    auto const passes = [&](double target) { return moves && direction * (x1 - target) >= 0.0; };
    while (turned.size() >= 2 && passes(turned[turned.size() - 2])) turned.resize(turned.size() - 2);
    if (turned.size() == 1 && passes(-turned[0])) turned.clear();
    branch = turned.empty() ? none : turned.size() - 1;
    branch_x = turned.empty() ? 0.0 : turned.back();
  }
  template <class Each>
  void members(Each& each) {
    each(turned);
  }
};

// Resizes a law's stack, which holds one value for each turning point.
template <class List, class Points>
inline void hold(List& list, Points const& points) {
  list.resize(points.depth);
}
// [end]

}  // namespace isolaw::laws
