// The travel on both sides, and how much more the peak has grown at x > 0 than at x < 0.
#pragma once

#include "isolaw/laws/memory/sides.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
template <class X>
struct Wear : Peaks<X> {
  X worn = 0.0;  // travel at |x| below the peak / the peak (the largest |x| so far); it fades as the peak grows
  X one_sided_growth = 0.0;  // growth of the largest |x| at x > 0 minus its growth at x < 0
  X log2_worn = 0.0;         // log2(1 + worn)

  void move(X const& x0, X const& x1, double before, double direction) {
    Peaks<X>::move(x0, x1, before, direction);
    if (this->peak0 > 0.0) worn += this->length_below_peak / this->peak0;
    if (this->peak_grows) {
      worn = travel_as_the_peak_grows(worn, this->peak0, this->peak);
      one_sided_growth += direction * (this->peak - this->peak0);
    }
    log2_worn = log2(1.0 + worn);
  }
  template <class Each>
  void members(Each& each) {
    Peaks<X>::members(each);
    each(worn, one_sided_growth);
  }
};
// [end]

}  // namespace isolaw::laws
