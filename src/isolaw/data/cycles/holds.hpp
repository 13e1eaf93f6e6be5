// Finds holds: times when a device stands still within a cyclic test, at rest between cycles or at a displacement. In a
// hold, displacement varies by less than half a percent of the amplitude, or only by its noise, and does so for longer
// than in a sinusoidal motion.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolaw::data {

struct Stretch {
  std::size_t first = 0;  // first and last sample
  std::size_t last = 0;
  std::size_t intervals() const { return last - first; }
};
// Returns the stretches of samples in [begin, end) in which x varies by at most `width` and which cannot be extended.
// Leaves out stretches of fewer than `least` intervals. Stretches may overlap. Takes O(n).
std::vector<Stretch> stretches_within(std::span<double const> x, std::size_t begin, std::size_t end, double width,
                                      std::size_t least);

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

// Returns for how long the device stands still within a cycle. `noise` is the standard deviation of the noise of
// disp_mm, in mm; if it is too large, no holds are found. O(n log n) at worst.
StillTime still_time(std::span<double const> disp_mm, std::span<double const> time_s, Piece const& piece, double noise);

}  // namespace isolaw::data
