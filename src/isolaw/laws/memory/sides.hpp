// The peak, which is the largest |x| so far, and the travel of each side, x >= 0 and x < 0.
#pragma once

#include <cmath>

#include "isolaw/laws/memory/peaks.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
inline double shrunk(double ratio) {
  return std::pow(ratio, 60.0);
}
inline Dual shrunk(Dual const& ratio) {
  return chain(ratio, std::pow(ratio.v, 60.0), 60.0 * std::pow(ratio.v, 59.0));
}
using std::cbrt;
inline Dual cbrt(Dual const& a) {
  double const root = std::cbrt(a.v);
  return chain(a, root, root != 0.0 ? 1.0 / (3.0 * root * root) : 0.0);
}

// Returns the travel N relative to a peak m, after the peak has grown from `from` to `to`. Meanwhile N changes by dN =
// |dx|/m - 60 N dm/m: the second term makes it fade. During a first motion from 0, N is therefore 1/60. The 60 was
// chosen on one measured device (docs/laws.md).
template <class X>
inline X travel_as_the_peak_grows(X const& travel, X const& from, X const& to) {
  constexpr double virgin_travel = 1.0 / 60.0;
  return virgin_travel + (travel - virgin_travel) * shrunk(from / to);
}

template <class X>
struct Sides {
  struct Side {
    X peak = 0.0, travel = 0.0;
    template <class Each>
    void members(Each& each) {
      each(peak, travel);
    }

    // Moves between two distances from 0 on this side.
    void move(X const& from, X const& to, bool outwards) {
      if (peak > 0.0) travel += abs(min(peak, to) - min(peak, from)) / peak;
      if (!outwards || !reaches(to, peak)) return;
      travel = travel_as_the_peak_grows(travel, peak, to);
      peak = to;
    }
  };
  Side sides[2];                 // the side x >= 0, and the side x < 0
  X side_peak = 0.0;             // largest |x| so far on the side on which the step ends
  X travel = 0.0;                // N: travel on that side divided by side_peak; it fades as side_peak grows
  X virgin_share = 1.0;          // (1 + N)^(-1/3): 1 without travel, falling as the device is cycled
  bool side_peak_grows = false;  // whether side_peak grows in this step

  void move(X const& x0, X const& x1, double, double direction) {
    bool const left = x1 < 0.0 || (x1 == 0.0 && direction < 0.0);
    std::size_t const side = left ? 1 : 0;
    X const before = sides[side].peak;
    if ((x0 < 0.0 && x1 > 0.0) || (x0 > 0.0 && x1 < 0.0)) {
      sides[1 - side].move(abs(x0), X(0.0), false);
      sides[side].move(X(0.0), left ? -x1 : x1, true);
    } else if (x0 < 0.0 || x1 < 0.0 || (x0 == 0.0 && left)) {
      sides[1].move(-x0, -x1, direction < 0.0);
    } else {
      sides[0].move(x0, x1, direction > 0.0);
    }
    Side const& now = sides[side];
    side_peak = now.peak;
    travel = now.travel;
    virgin_share = 1.0 / cbrt(1.0 + now.travel);
    side_peak_grows = grows(now.peak - before);
  }
  template <class Each>
  void members(Each& each) {
    each(sides[0], sides[1]);
  }
};
// [end]

}  // namespace isolaw::laws
