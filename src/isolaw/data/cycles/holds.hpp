// Finds holds: times when a device stands still within a cyclic test, at rest between cycles or at a displacement. In a
// hold, displacement stays within half a percent of the amplitude, or within its noise, for longer than in a sine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

struct Piece {
  double first = 0.0;  // start and end of a cycle, as fractional sample indices
  double last = 0.0;
  double amplitude = 0.0;  // mm
  double middle = 0.0;     // mm
};

struct StillTime {
  double samples = 0.0;
  double time = 0.0;  // in s; in samples if the record has no time
};

// `noise` is the standard deviation of disp_mm in mm. If noise is too large, no holds are found. O(n log n) at worst.
StillTime still_time(std::span<double const> disp_mm, std::span<double const> time_s, Piece const& piece, double noise);

}  // namespace isolaw::data
