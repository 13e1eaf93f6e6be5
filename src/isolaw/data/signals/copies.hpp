// Finds a record that was made from another one: scaled, with noise added, thinned, resampled or shifted in time.
// Method: a pass is an instant at which the displacement passes through the middle of its range. The passes bring both
// records to one time scale. If the forces then agree except for a factor and an offset, the noise decides. A copy
// contains the noise of the original, so the noises of the two correlate in step and not out of step; the noises of two
// tests do not correlate. If much noise was added to the force alone, the noise of the displacement decides in the same
// way. docs/records.md says how many copies are found.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"

namespace isolaw::data {

// The features by which a record is compared with others. A Trace takes about as much memory as the record.
struct Trace {
  // The record's channels in s, mm and kN. If the record has no time, or one that does not rise throughout, `time` is
  // the number of the sample.
  std::vector<double> time, disp, force;
  std::vector<double> passes;   // the values of `time` at which the displacement passes through the middle of its range
  bool rises_first = true;      // whether the displacement rises at the first pass
  std::vector<double> outline;  // the force [kN] at 16 equally spaced times from each pass to the next
  // Noise of the displacement [mm], and noise of the force [kN] without the part that the displacement's noise causes.
  std::vector<double> disp_noise, noise;
  std::size_t stride = 1;    // only every `stride`th sample is compared, because nearer samples share noise
  double noise_share = 0.0;  // rms of `noise` / standard deviation of the force

  double samples_per_pass() const { return static_cast<double>(time.size()) / static_cast<double>(passes.size()); }
};
Trace trace_of(TestRecord const& record);

// Whether one of the two records was made from the other. False if one has fewer than four passes, too few to compare.
bool is_altered_copy(Trace const& one, Trace const& other);

// Whether two records have the same samples or, if neither has any, the same file.
bool is_same_record(TestRecord const& one, TestRecord const& other);
// If there are more records than this, only identical ones are looked for, because the time to find altered copies
// grows with the square of the number of records.
inline constexpr std::size_t most_compared = 1000;
// Returns groups of two or more records, as rising indices. Every later record of a group equals the first one, was
// made from it, or is the record that the first one was made from.
std::vector<std::vector<std::size_t>> groups_of_copies(std::span<TestRecord const* const> records);

}  // namespace isolaw::data
