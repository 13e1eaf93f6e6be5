// The turning points of the open branches, which Masing's rules (parts/masing.hpp) have not yet closed. At most 256 are
// kept, so that the state of a trial is bounded. If another one comes, the two neighbours in the list whose loss
// changes the force least are dropped. Their loop then no longer closes where it began, and the force is wrong up to
// the next larger loop. In a motion of 3000 shrinking turns, the error is up to 0.4 % of the largest force. A test
// record keeps a few tens of turning points at most.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "isolaw/laws/memory/remembered.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// When a branch reaches the point at which the branch before it began, both close. If only one branch is open, it
// closes where it meets the skeleton curve, at the mirror image of its start.
struct OpenBranches {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr std::size_t most = 256;
  // Displacements at which the open branches began, the oldest first. A law's stack has its force at each of them.
  std::vector<double> turned;
  std::size_t first_dropped = none;  // stack index of the first of two turning points that are dropped before this step
  // If the motion turned when the step began: the stack index at which a law keeps its force at this turn.
  std::size_t turn_index = none;
  // The turning point at which the present branch began: its stack index (none: on the skeleton), and its displacement.
  std::size_t branch_index = none;
  double branch_x = 0.0;
  std::size_t depth = 0;  // the number of values that a law's stack must hold in this step

  template <class X>
  void move(X const& from, X const& to, double direction_before, double direction) {
    double const x0 = value_of(from), x1 = value_of(to);
    bool const moves = x1 != x0, turns = moves && direction_before != 0.0 && direction != direction_before;
    first_dropped = none;
    if (turns && turned.size() == most) {
      first_dropped = least_needed(x0);
      auto const first = turned.begin() + static_cast<std::ptrdiff_t>(first_dropped);
      turned.erase(first, first + 2);
    }
    turn_index = turns ? turned.size() : none;
    if (turns) turned.push_back(x0);
    depth = turned.size();
    auto const passes = [&](double target) { return moves && direction * (x1 - target) >= 0.0; };
    while (turned.size() >= 2 && passes(turned[turned.size() - 2])) turned.resize(turned.size() - 2);
    if (turned.size() == 1 && passes(-turned[0])) turned.clear();
    branch_index = turned.empty() ? none : turned.size() - 1;
    branch_x = turned.empty() ? 0.0 : turned.back();
  }
  template <class Each>
  void members(Each& each) {
    each(turned);
  }

 private:
  // Returns the i whose removal, together with i + 1, changes the force least. The change is estimated as the product
  // of the two gaps that the points would leave, [i-2, i+2] and [i-1, i+3], divided by the distance [i-2, i-1], since
  // longer branches are less curved. `next`, where the motion turns now, stands for the points after the last. The
  // first turning point always stays, and its mirror image stands for the point before it.
  std::size_t least_needed(double next) const {
    auto const at = [&](std::size_t i) { return i < turned.size() ? turned[i] : next; };
    std::size_t best = 1;
    double least = 0.0;
    for (std::size_t i = 1; i + 1 < turned.size(); ++i) {
      double const outer = i > 1 ? turned[i - 2] : -turned[0];
      double const gaps = (outer - at(i + 2)) * (turned[i - 1] - at(i + 3)) / (outer - turned[i - 1]);
      if (i == 1 || std::abs(gaps) < least) {
        best = i;
        least = std::abs(gaps);
      }
    }
    return best;
  }
};

// Fits a law's stack, which holds one value for each turning point, to the turning points of this step.
template <class List, class Points>
inline void hold(List& list, Points const& points) {
  if (points.first_dropped != OpenBranches::none) {
    auto const first = list.begin() + static_cast<std::ptrdiff_t>(points.first_dropped);
    list.erase(first, first + 2);
  }
  list.resize(points.depth);
}
// [end]

}  // namespace isolaw::laws
