// Groups cycles into blocks of one amplitude and one frequency, and decides which cycles of a block count. Only cycles
// that count are numbered and enter the block's results.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/data/cycles/cycles.hpp"

namespace isolaw::data {

// Whether two vertical loads may belong to one block, that is, differ by at most a tenth of the larger one. `largest`
// is the size of the record's largest load. A difference of up to a hundredth of `largest` is noise.
bool same_load(double load, double other, double largest);

struct Shape : CycleCut {
  double least = 0.0;  // mm
  double largest = 0.0;
  double period = 0.0;         // from start to end without holds and rests, in s (in samples without time)
  double rise_and_fall = 0.0;  // twice the time between the two peaks, with holds and rests, in the unit of period
  // Distance of the midpoint of the two peaks from the displacement at which cycles are cut, divided by the amplitude.
  double unevenness = 0.0;
  double load_kN = 0.0;          // mean vertical load between the two peaks; 0 if it is not known
  double load_scatter_kN = 0.0;  // standard deviation of the load between the two peaks
  int logged = 0;                // the logger's number of the cycle; 0 if it has none
  bool jumps = false;            // the logger left out cycles within this one, so its loop is made of two cycles
  double rest_before = 0.0;      // time near the centre before the cycle, in the unit of period
  bool regular = false;          // set by number_cycles(): the cycle repeats a neighbour's amplitude or is symmetric
  bool has_gap = false;          // the clock jumps within the cycle, so samples are missing
  bool taper = false;            // set by number_cycles(): the cycle grows into a run of cycles or fades out of one

  double amplitude() const { return largest / 2.0 - least / 2.0; }
};

// A block is a run of cycles of one amplitude (within 5 %) and one frequency. A cycle that is alone with its amplitude
// is a block of its own if it is symmetric about the centre. It joins a neighbouring block, but does not count, if it
// is asymmetric or within 15 % of the amplitude of a run of three or more cycles, as when a rig builds up its
// amplitude. A change of frequency splits a block if the period changes by 5 % and keeps its new value for two cycles;
// the periods before the change, and those after it, must scatter by less than a quarter of the change. A block also
// ends where the vertical load changes by a tenth, and at a rest longer than the period if three or more cycles without
// such a rest lie on each side of it. A cycle does not count if its period and the block's period differ by a factor of
// more than 1.4. `unit` is the unit of periods in messages.
std::vector<CycleCut> number_cycles(std::vector<Shape>& shapes, std::string_view unit);

}  // namespace isolaw::data
