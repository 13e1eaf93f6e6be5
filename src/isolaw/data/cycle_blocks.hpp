// Which cut cycles belong together: blocks of one amplitude and one frequency, and the cycles that count in them.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

// One cut cycle, and what numbering needs of it.
struct Shape : CycleCut {
  double least = 0.0;  // mm
  double largest = 0.0;
  double period = 0.0;         // from cut to cut in s or in samples, without the time in which the device stands still
  double rise_and_fall = 0.0;  // twice the time between the tips, stops included, in the same unit
  double unevenness = 0.0;     // |distance of the middle from the centre| over the amplitude
  bool regular = false;        // set by number_cycles: it repeats a neighbour's amplitude, or is symmetric
  bool has_gap = false;        // the time jumps within it
  bool taper = false;          // set by number_cycles: it grows into a run of cycles, or fades out of one

  double amplitude() const { return largest / 2.0 - least / 2.0; }
};

// Blocks and numbers of the cycles. A block is a run of cycles of one amplitude (within 5 %) and one frequency. A lone
// cycle is a block of its own where it is symmetric, as in a test of one cycle per stage; where it is uneven, or within
// 15 % of a run of three or more beside it, as when a rig builds up its amplitude, it belongs uncounted to that block.
// A change of frequency has to last: for two cycles or more, which agree with one another, as those before do, four
// times better than the change of 5 % or more. A cycle whose period is more than a factor of 1.4 from its block's does
// not count. `unit` of the periods.
std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes, std::string_view unit);

}  // namespace isolaw::data
