// Groups the cut cycles into blocks of one amplitude and one frequency, and tells which cycles count in them.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

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

// A block is a run of cycles of one amplitude (within 5 %) and one frequency. A lone cycle is a block of its own if it
// is symmetric. If it is uneven, or within 15 % of a run of three or more beside it, as when a rig builds up its
// amplitude, it belongs to that block uncounted. A change of frequency must be 5 % or more and last for two cycles or
// more; these, and those before, must agree among themselves four times better than the change. A cycle whose period is
// off its block's by more than a factor of 1.4 does not count. `unit` is that of the periods.
std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes, std::string_view unit);

}  // namespace isolaw::data
