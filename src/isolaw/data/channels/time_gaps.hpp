// Finds gaps in time, where the clock of a record jumps.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

double usual_interval(std::span<double const> time_s);  // the median
// If samples are more than this many usual intervals apart, what a channel did between them is unknown.
inline constexpr double most_intervals = 5.0;

// A jump of the clock by more than most_intervals usual intervals. taken_s is the time that the device needs to cross
// the gap at the speed that it has beside the gap; it is at least one interval and at most length_s.
struct Gap {
  std::size_t last_before = 0;  // last sample before the gap
  double length_s = 0.0;        // by the clock
  double taken_s = 0.0;
};
// Finds the gaps of a record. If it holds several tests, which begin at `starts`, each test has its own usual interval.
std::vector<Gap> time_gaps(std::span<double const> disp_mm, std::span<double const> time_s,
                           std::span<std::size_t const> starts = {});
// The times with every gap shortened to its taken_s; empty if there are no gaps.
std::vector<double> without_gaps(std::span<double const> time_s, std::vector<Gap> const& gaps);

}  // namespace isolaw::data
