// The largest |x| so far.
#pragma once

#include "isolaw/laws/memory/remembered.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
template <class X>
struct Peaks {
  X peak0 = 0.0;              // largest |x| before the step
  X peak = 0.0;               // largest |x| after the step
  X length_below_peak = 0.0;  // the part of the step's length in which |x| is below peak0
  bool peak_grows = false;    // whether `peak` exceeds peak0

  void move(X const& x0, X const& x1, double, double direction) {
    X const outward = direction * x1;
    peak0 = peak;
    peak = reaches(outward, peak) ? outward : peak;
    peak_grows = grows(peak - peak0);
    length_below_peak = direction * (x1 - x0) - (peak - peak0);
  }
  template <class Each>
  void members(Each& each) {
    each(peak);
  }
};
// [end]

}  // namespace isolaw::laws
