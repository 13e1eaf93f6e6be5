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

double usual_interval(std::span<double const> time_s);  // the median
// If samples are more than this many usual intervals apart, what a channel did between them is unknown.
inline constexpr double most_intervals = 5.0;

// A jump of the clock by more than most_intervals. taken_s is the time that the motion across the gap takes at the
// speed beside it, at least one interval and at most length_s. without_gaps() is empty if the clock does not jump.
struct Gap {
  std::size_t after = 0;  // last sample before the gap
  double length_s = 0.0;  // by the clock
  double taken_s = 0.0;
};
std::vector<Gap> time_gaps(std::span<double const> disp_mm, std::span<double const> time_s);
std::vector<double> without_gaps(std::span<double const> time_s, std::vector<Gap> const& gaps);

}  // namespace isolaw::data
