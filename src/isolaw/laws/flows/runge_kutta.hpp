// One classical fourth-order Runge-Kutta step in displacement.
#pragma once

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// Returns y at the end of a step of length dx; slope(t, y) = dy/dx at the fraction t = 0, 1/2, 1 of the step.
template <class N, class X, class Slope>
N runge_kutta(N const& y, X const& dx, Slope&& slope) {
  N const half(0.5 * dx), whole(dx), two(2.0);
  N const k1 = rounded(slope(0.0, y));
  N const k2 = rounded(slope(0.5, y + half * k1));
  N const k3 = rounded(slope(0.5, y + half * k2));
  N const k4 = rounded(slope(1.0, y + whole * k3));
  return y + N(dx / 6.0) * (k1 + two * (k2 + k3) + k4);
}
// [end]

}  // namespace isolaw::laws
