// Cuts a cyclic test into cycles, from the displacement history alone. A swing counts as motion if it is at least twice
// a floor: 1 % of the half range, or five standard deviations of the noise if that is more (at most 5 % of the half
// range). A small interruption of a large swing does not count. Cycles are cut where displacement crosses its centre in
// the direction in which the test, or a part of it after a rest, starts (data/lobes.hpp). A motion that starts, turns
// or comes to rest near the centre is cut at that sample. The centre is zero unless the record is clearly off zero.
// data/cycle_blocks.hpp makes blocks of the cycles, and data/holds.hpp finds the time in which the device stands still,
// which is no part of a period.
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
  int number = 0;           // from 1, among the cycles of its block that count; 0 if it does not count
  std::string not_counted;  // why it does not count; empty if it counts
  bool partial = false;     // less than a cycle: the record starts or ends within it, or it goes to one side only
  double first = 0.0;       // start and end as fractional sample indices
  double last = 0.0;
  bool turns_at_start = false;  // the motion comes back to the centre and turns, or starts from rest
  bool turns_at_end = false;
  double still_samples = 0.0;  // for which the device stands still
  double still_time = 0.0;     // the same in s, or in samples without time
};

struct Segmentation {
  bool cyclic = false;
  std::optional<Finding> refusal;  // not_cyclic or no_complete_cycle; empty when cyclic
  double band_mm = 0.0;            // smaller swings than twice this are no motion
  double centre_mm = 0.0;          // level of the cuts: 0 unless the record is clearly off zero
  double regular_share = 0.0;      // share of the travel in cycles that repeat an amplitude or are symmetric
  std::vector<CycleCut> cycles;  // in order, also the partial ones, and complete ones even if the record is not cyclic
};

// In mm and s. If time_s is empty, periods are compared in samples. Never throws; O(n) in time and memory.
Segmentation segment(std::span<double const> disp_mm, std::span<double const> time_s = {});

// The first sample, the reversals and the last extreme; fewer than two samples if there is no motion.
struct Reversals {
  std::vector<std::size_t> at;
  double band_mm = 0.0;  // as in Segmentation
};
Reversals reversals(std::span<double const> disp_mm);

// The middle of the time spent beyond nine tenths of the amplitude, as a sample index that noise moves but little.
struct PeakPositions {
  double largest = 0.0;
  double smallest = 0.0;
};
PeakPositions peak_positions(std::span<double const> disp_mm, double first, double last);
// Standard deviation of the white noise in a signal with 20 or more samples per cycle; 0 for fewer than 16 samples.
double noise_deviation(std::span<double const> values);
double value_at(std::span<double const> values, double index);

}  // namespace isolaw::data
