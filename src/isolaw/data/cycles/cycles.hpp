// Cuts a cyclic test into cycles, from displacement alone.
// - Noise: a swing from one extreme to the next is taken as motion only if it is at least twice as large as a band. The
//   band is one hundredth of the half range, or five standard deviations of the noise if that is more, but at most 5 %
//   of the half range. A small interruption of a large swing is ignored.
// - Cuts: cycles are cut where displacement crosses its centre in the direction in which the test starts, or in which
//   it starts again after a rest (data/cycles/excursions.hpp). A motion that starts, turns or rests near the centre is
//   cut at that sample. The centre is zero unless the record is clearly off zero. A test in stages to one side is cut
//   where it comes back to its start.
// - Blocks: data/cycles/cycle_blocks.hpp groups cycles into blocks and decides which of them count, that is, enter the
//   results.
// - Half cycles, if FurtherChannels::half_cycles asks for them: a swing becomes a half cycle if at most half of it lies
//   in full cycles. Half cycles form blocks of their own. They replace the partial cycles that they overlap and, in a
//   record that is not cyclic, all cycles that they overlap. The first and the last sample count as turns of the motion
//   only at zero or at the centre, because tests start and end there.
// - A period leaves out the time in which the device stands still (data/cycles/holds.hpp).
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
  int number = 0;           // from 1, among the counted cycles of its block; 0 if the cycle does not count
  std::string not_counted;  // why the cycle does not count; empty if it counts
  bool partial = false;     // less than a cycle: the record starts or ends within it, or it goes to one side only
  double first = 0.0;       // start and end, as fractional sample indices
  double last = 0.0;
  bool turns_at_start = false;  // at its start, the motion turns at the centre or begins from rest
  bool turns_at_end = false;
  bool half = false;           // a half cycle: a swing from one turn to the next that belongs to no full cycle
  bool one_sided = false;      // goes to one side only, from a return to the start displacement to the next return
  double still_samples = 0.0;  // samples in which the device stands still
  double still_time = 0.0;     // time in which it stands still, in s; in samples if there is no time
};

struct Segmentation {
  bool cyclic = false;
  std::optional<Finding> refusal;  // why the record is not cyclic: not_cyclic or no_complete_cycle
  double band_mm = 0.0;            // swings smaller than twice this are not taken as motion
  double centre_mm = 0.0;          // displacement at which cycles are cut: 0 unless the record is clearly off zero
  double regular_share = 0.0;      // share of the travel in regular cycles, which repeat an amplitude or are symmetric
  std::vector<CycleCut> cycles;    // in order, with partial cycles; also set if the record is not cyclic
};

struct FurtherChannels {                      // the channels may be empty
  std::span<double const> load_kN = {};       // vertical load; where it changes, a new block begins
  std::span<double const> logged_cycle = {};  // the logger's number of the cycle at each sample; used to number cycles
  bool half_cycles = false;                   // swings that belong to no full cycle become half cycles, which count
};
// Cuts a record into cycles. If time_s is empty, periods are in samples. If there are several tests, which begin at
// `starts`, each is cut by itself, and block numbers go on from test to test; the record is cyclic if one of its tests
// is. Never throws; O(n) in time and memory.
Segmentation segment(std::span<double const> disp_mm, std::span<double const> time_s = {},
                     std::span<std::size_t const> starts = {}, FurtherChannels const& further = {});

// The turning points of a motion. `at` holds the first sample, the reversals and the last extreme. It is empty if there
// is no motion.
struct Reversals {
  std::vector<std::size_t> at;
  double band_mm = 0.0;  // see Segmentation
};
Reversals reversals(std::span<double const> disp_mm);

// Where the largest and the smallest displacement lie, as fractional sample indices. Each is the middle of the time
// that displacement spends beyond nine tenths of the amplitude, because noise hardly moves this middle.
struct PeakPositions {
  double largest = 0.0;
  double smallest = 0.0;
};
PeakPositions peak_positions(std::span<double const> disp_mm, double first, double last);
// Standard deviation of the white noise in a signal. It is right for 20 or more samples per cycle. 0 if there are fewer
// than 16 samples in all.
double noise_deviation(std::span<double const> values);
double value_at(std::span<double const> values, double index);
double half_range(std::span<double const> values);  // half the difference of the extremes; 0 without values

}  // namespace isolaw::data
