// Finds holds: times when a device stands still within a cyclic test, at rest between cycles or at a displacement. The
// motion then stays within a band of half a percent of the amplitude, or of the noise, for longer than a sine does.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

struct Piece {
  double first = 0.0;  // fractional sample indices
  double last = 0.0;
  double amplitude = 0.0;  // mm
  double middle = 0.0;     // mm
};

struct StillTime {
  double samples = 0.0;
  double time = 0.0;  // in s, or in samples without time
};

// `noise` is the standard deviation of disp_mm in mm; if it is too large, no holds are found. At worst O(n log n).
StillTime still_time(std::span<double const> disp_mm, std::span<double const> time_s, Piece const& piece, double noise);

// If two samples are more than this many usual intervals apart, nobody knows what a channel did between them.
inline constexpr double most_intervals = 5.0;

// The clock jumps by more than most_intervals. taken_s is the distance across the gap over the speed beside it, at
// least one interval and at most length_s. without_gaps() returns an empty vector if the clock does not jump.
struct Gap {
  std::size_t after = 0;  // sample
  double length_s = 0.0;  // by the clock
  double taken_s = 0.0;
};
std::vector<Gap> time_gaps(std::span<double const> disp_mm, std::span<double const> time_s);
std::vector<double> without_gaps(std::span<double const> time_s, std::vector<Gap> const& gaps);

}  // namespace isolaw::data
