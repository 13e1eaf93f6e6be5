// Which cut cycles belong together: blocks of one amplitude and one frequency, and the cycles that count in them.
#pragma once

#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

// What numbering needs of one cut cycle.
struct Shape {
  double first = 0.0;  // fractional sample indices
  double last = 0.0;
  double least = 0.0;  // mm
  double largest = 0.0;
  double period = 0.0;      // twice the time between the extremes, in s or in samples: a hold at the cut counts nothing
  double unevenness = 0.0;  // |distance of the middle from the centre| over the amplitude
  bool regular = false;     // set by number_cycles: it repeats a neighbour's amplitude, or is symmetric
  bool taper = false;       // set by number_cycles: it grows into a run of cycles, or fades out of one

  double amplitude() const { return largest / 2.0 - least / 2.0; }
};

// Blocks and numbers of the cycles. A block is a run of cycles of one amplitude and frequency; a lone cycle is a block
// of its own where it is symmetric, as in a test of one cycle per stage, and else belongs to the block it leads to or
// comes from, uncounted. A change of frequency has to last: a hold at a peak, or a slow first cycle, is none.
std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes);

}  // namespace isolaw::data
