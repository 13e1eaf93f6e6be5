// Two travels on each side of x = 0 that soften a law: G counts motion outwards and back towards 0, C only motion back.
#pragma once

#include <algorithm>
#include <cmath>

#include "isolaw/laws/memory/sides.hpp"

namespace isolaw::laws {

inline double log2_of_travel(double travel) {
  return std::log2(std::max(travel, smallest_power_base));
}

inline double log2_of_softening(double G) {
  return log2_of_travel(G);
}

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// The slope of a power of a travel has no bound at travel 0. It is therefore taken at a travel of at least 1e-3 mm.
inline Dual log2_of_travel(Dual const& travel) {
  return chain(travel, std::log2(max(travel.v, smallest_power_base)), log2_e / max(travel.v, 1e-3));
}
// When the motion first enters a side, G is 0, and x = 0 makes the force 0 for every G. The tangent is then taken at a
// small G, because it changes very fast from its value at G = 0.
inline Dual log2_of_softening(Dual const& G) {
  return log2_of_travel(G.v > 0.0 ? G : Dual(1e-2));
}

template <class X>
struct Softening {
  // G is half the travel outwards plus four times the travel back, at most the side's peak. C is the travel towards 0.
  struct Amounts {
    X G = 0.0, C = 0.0;
    template <class Each>
    void members(Each& each) {
      each(G, C);
    }
  };
  // Computes G and C from the start of the present motion in one direction, so that they do not depend on the number of
  // steps.
  struct SofteningSide {
    // G and C at present (`now`), after the last step that ended on this side (`reported`), and at the start of the
    // present motion in one direction.
    Amounts now, reported, at_start;
    X peak = 0.0, start = 0.0, peak_at_start = 0.0;
    bool goes_out = true;
    template <class Each>
    void members(Each& each) {
      each(now, reported, at_start, peak, start, peak_at_start, goes_out);
    }

    void move(X const& from, X const& to, bool outwards) {
      if (outwards != goes_out) {
        goes_out = outwards;
        start = from;
        peak_at_start = peak;
        at_start = now;
      }
      if (outwards) {
        X const inside = min(to, peak_at_start) - start, beyond = max(X(0.0), to - peak_at_start);
        now.G = min(at_start.G + 0.5 * inside, peak_at_start) + 0.5 * beyond;
        if (reaches(to, peak)) peak = to;
      } else {
        now.C = at_start.C + (start - to);
        now.G = min(at_start.G + 4.0 * (start - to), peak_at_start);
      }
    }
  };
  SofteningSide softening_sides[2];
  X log2_softening = 0.0, log2_way_back = 0.0;  // log2 of G and of C on the side on which the step ends
  bool softens = false, returns = false;  // whether G, or C, has changed since the last step that ended on this side

  void move(X const& x0, X const& x1, double, double direction) {
    bool const left = x1 < 0.0 || (x1 == 0.0 && direction < 0.0);
    if ((x0 < 0.0 && x1 > 0.0) || (x0 > 0.0 && x1 < 0.0)) {
      softening_sides[left ? 0 : 1].move(abs(x0), X(0.0), false);
      softening_sides[left ? 1 : 0].move(X(0.0), left ? -x1 : x1, true);
    } else if (!may_move(x1 - x0)) {
    } else if (x0 < 0.0 || x1 < 0.0 || (x0 == 0.0 && left)) {
      softening_sides[1].move(-x0, -x1, direction < 0.0);
    } else {
      softening_sides[0].move(x0, x1, direction > 0.0);
    }
    auto& side = softening_sides[left ? 1 : 0];
    softens = changes(side.reported.G, side.now.G);
    returns = changes(side.reported.C, side.now.C);
    side.reported = side.now;
    log2_softening = log2_of_softening(side.now.G);
    log2_way_back = log2_of_travel(side.now.C);
  }
  template <class Each>
  void members(Each& each) {
    each(softening_sides[0], softening_sides[1]);
  }
};
// [end]

}  // namespace isolaw::laws
