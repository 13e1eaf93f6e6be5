// One classical fourth-order Runge-Kutta step in displacement.
#pragma once

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// Returns y at the end of a step of length dx; slope(t, y) = dy/dx at the fraction t = 0, 1/2, 1 of the step.
template <class T, class Slope>
T runge_kutta(T const& y, double dx, Slope&& slope) {
  T const half(0.5 * dx), whole(dx), two(2.0);
  T const k1 = rounded(slope(0.0, y));
  T const k2 = rounded(slope(0.5, y + half * k1));
  T const k3 = rounded(slope(0.5, y + half * k2));
  T const k4 = rounded(slope(1.0, y + whole * k3));
  return y + T(dx / 6.0) * (k1 + two * (k2 + k3) + k4);
}

}  // namespace isolaw::laws
