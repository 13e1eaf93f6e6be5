// The reference amplitude, 100 mm. If a force follows a power of the amplitude, a parameter gives the force at 100 mm.
#pragma once

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
inline constexpr double reference_mm = 100.0;
// [end]
// The record's largest force, scaled to 100 mm as if it grew with the power 0.4 of the amplitude, about as the force of
// high damping rubber does.
inline double force_at_reference(RecordScales const& s) {
  return s.force * std::pow(reference_mm / s.disp, 0.4);
}

}  // namespace isolaw::laws
