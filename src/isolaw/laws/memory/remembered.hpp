// The memory of a path consists of parts, such as OpenBranches and Peaks. A law lists the parts that it reads:
//     template <class X> using Memory = Remembered<X, OpenBranches, Peaks<X>>;
// For a record they are computed once and serve all parameter sets (memory.cpp). A trial computes them with each step.
#pragma once

#include "isolaw/laws/online/numbers.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
template <class X, class... Parts>
struct Remembered : Parts... {
  double direction = 0.0;  // direction of the step, +1 or -1; 0 before the first motion
  double moved = 0.0;      // direction of the last step that was not at rest
  std::size_t side = 0;    // the side of 0 on which the step ends; 0: x >= 0, 1: x < 0
  bool turns = false;      // whether the motion turned at the begin of this step

  // Moves from x0 to x1. A trial at rest, before any motion, has the direction `otherwise`.
  void move(X const& x0, X const& x1, double otherwise) {
    double const before = moved;
    if (x1 < x0 || x1 > x0) moved = x1 > x0 ? 1.0 : -1.0;
    direction = moved != 0.0 ? moved : otherwise;
    turns = before != 0.0 && before != moved;
    side = x1 < 0.0 || (x1 == 0.0 && direction < 0.0) ? 1 : 0;
    (Parts::move(x0, x1, before, direction), ...);
  }
  template <class Each>
  void members(Each& each) {
    each(moved);
    (Parts::members(each), ...);
  }
};
// [end]

}  // namespace isolaw::laws
