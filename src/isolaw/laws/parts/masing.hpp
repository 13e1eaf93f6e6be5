// Masing's rules. The first loading follows the skeleton curve. After each turning point the force follows a branch:
// the skeleton curve at twice its size, drawn from that point. A branch ends where it meets an earlier one, and the
// force goes on along the earlier one. The displacement alone decides at which turning point the present branch began
// (Memory).
// Source: Masing 1926; docs/laws.md.
#pragma once

#include <vector>

#include "isolaw/laws/memory/open_branches.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
template <class N>
struct MasingBranches {
  N force = N(0.0);       // the force after the last step
  std::vector<N> turned;  // the force at each turning point of OpenBranches::turned

  // Moves to the end of a step and returns the force there. skeleton(x) is the odd curve from the origin.
  template <class X, class PathMemory, class Skeleton>
  N move(X const& x, PathMemory const& memory, Skeleton&& skeleton) {
    if (memory.turns) turned[memory.turn_index] = force;
    force = memory.branch_index == memory.none
                ? skeleton(x)
                : turned[memory.branch_index] + N(2.0) * skeleton(X(0.5 * (x - memory.branch_x)));
    return force;
  }
  template <class Points>
  void make_room(Points const& points) {
    hold(turned, points);
  }
  template <class Each>
  void members(Each& each) {
    each(force, turned);
  }
};
// [end]

}  // namespace isolaw::laws
