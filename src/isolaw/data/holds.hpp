// Holds: where a device stands still within a cyclic test, at rest between cycles or held at a displacement.
//
// A hold is a stretch within a narrow band, of half a percent of the amplitude or of the noise, that lasts longer than
// the motion takes to pass the band there: a sine lingers at its peaks without standing still.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

struct Piece {
  double first = 0.0;  // fractional sample indices
  double last = 0.0;
  double amplitude = 0.0;  // of the motion, mm
  double middle = 0.0;     // mm
};

struct StillTime {
  double samples = 0.0;
  double time = 0.0;  // in s, or in samples without time
};

// How long the device stands still within the piece. `noise` is the standard deviation of disp_mm in mm; where it hides
// holds none are found. O(n log n) of the piece's samples at worst.
StillTime still_time(std::span<double const> disp_mm, std::span<double const> time_s, Piece const& piece, double noise);

// Between two samples this many times farther apart than most nobody knows what a channel did.
inline constexpr double most_intervals = 5.0;

// Time as the motion took it: where the clock jumps between two samples (by more than most_intervals), what the speed
// on both sides needs for the way between them, at least one interval and at most what the clock says. Empty where
// nothing jumps.
struct Gap {
  std::size_t after = 0;  // sample
  double length_s = 0.0;  // by the clock
  double taken_s = 0.0;
};
std::vector<Gap> time_gaps(std::span<double const> disp_mm, std::span<double const> time_s);
std::vector<double> without_gaps(std::span<double const> time_s, std::vector<Gap> const& gaps);

}  // namespace isolaw::data
