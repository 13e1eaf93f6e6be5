// Cuts a cyclic test into cycles from the displacement history alone.
// A swing smaller than twice a floor is no motion; the floor is 1 % of the half range, or five standard deviations of
// the noise where that is more (at most 5 % of the half range). A small interruption of a large swing is none either.
// Cuts are where displacement crosses its centre in the direction the test, or a part of it after a rest, starts in
// (data/lobes.hpp); a motion that starts, turns or comes to rest near the centre is cut there. The centre is zero,
// unless the record is clearly off it. Blocks: data/cycle_blocks.hpp. Time in which the device stands still is no part
// of a period (data/holds.hpp).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"

namespace isolaw::data {

struct CycleCut {
  int block = 0;            // number of its block, from 1
  int number = 0;           // among the nominal cycles of its block, which count, from 1; 0 for one that does not
  std::string not_counted;  // why it does not count; empty when it does
  bool partial = false;     // less than a cycle: the record starts or ends within it, or it goes to one side alone
  double first = 0.0;       // start and end as fractional sample indices
  double last = 0.0;
  bool turns_at_start = false;  // the motion comes back to the centre and turns there, or starts from rest
  bool turns_at_end = false;
  double still_samples = 0.0;  // in which the device stands still
  double still_time = 0.0;     // the same in s, or in samples without time
};

struct Segmentation {
  bool cyclic = false;
  std::optional<Finding> refusal;  // not_cyclic or no_complete_cycle; empty when cyclic
  double band_mm = 0.0;            // swings of less than twice this are no motion
  double centre_mm = 0.0;          // level of the cuts: 0 unless the record is clearly off zero
  double regular_share = 0.0;      // share of the travel in cycles that repeat an amplitude or are symmetric
  std::vector<CycleCut> cycles;    // in order, partial start and end ones included; complete ones even when not cyclic
};

// In mm and s; time_s may be empty: periods are then compared in samples. Never throws; O(n) in time and memory.
Segmentation segment(std::span<double const> disp_mm, std::span<double const> time_s = {});

// Reversal samples between the first sample and the last extreme, both included; fewer than two without motion.
struct Reversals {
  std::vector<std::size_t> at;
  double band_mm = 0.0;  // as in Segmentation
};
Reversals reversals(std::span<double const> disp_mm);

// Middle of the time spent beyond nine tenths of the way from the centre: noise moves it less than the largest sample.
struct PeakPositions {
  double largest = 0.0;
  double smallest = 0.0;
};
PeakPositions peak_positions(std::span<double const> disp_mm, double first, double last);
// Standard deviation of white noise, for 20 samples in a cycle or more; 0 for fewer than 16 samples.
double noise_deviation(std::span<double const> values);
double value_at(std::span<double const> values, double index);

}  // namespace isolaw::data
