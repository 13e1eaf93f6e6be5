// An excursion is a motion to one side of the centre and back. It ends where the motion crosses the centre, or comes
// back to the centre and turns there. Its tip is the sample farthest from the centre, and its reach is the distance
// from the centre to the tip. Two excursions to opposite sides make a cycle. Some excursions belong to no cycle:
// - A pre-load is an excursion after the start, a rest or a turn that differs from the excursions after it: its reach
//   is less than a fifth of the next one's, or the next two are alike and it is not like them. Excursions are alike if
//   their reaches differ by at most 15 % and the times in which they fall by at most a factor of 1.5.
// - Half a cycle is an excursion that ends a series of alike ones and is not like the next two, which are alike.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/cycles/cycles.hpp"

namespace isolaw::data {

struct Excursion {
  double first = 0.0;  // fractional sample indices
  double last = 0.0;
  std::size_t tip = 0;       // sample farthest from the centre
  bool positive = false;     // on the positive side of the centre
  double reach_mm = 0.0;     // distance of the tip from the centre
  double fall = 0.0;         // time of its fall from 90 to 10 % of the reach, in s (in samples without time)
  bool turns = false;        // at the start of the excursion the motion turns, or the record begins at rest
  double rest = 0.0;         // time near the centre before it, in s (in samples without time)
  bool rests = false;        // it starts after a rest
  bool starts_open = false;  // the record starts within it
  bool ends_open = false;    // the record ends within it
  bool has_gap = false;      // the clock jumps within it, so the sample at its tip may be missing
};

enum class Part {
  cycle,       // two excursions
  pre_load,    // an excursion before cycles that belongs to none of them
  half,        // a single excursion, after which the motion starts anew
  open_start,  // part of a cycle at the start of the record
  open_end     // part of a cycle at the end of the record
};

struct Group {
  Part part = Part::cycle;
  std::size_t begin = 0;  // excursions [begin, end)
  std::size_t end = 0;
};

std::vector<Excursion> excursions(std::span<double const> disp_mm, std::span<double const> time_s,
                                  Reversals const& motion, double centre_mm);
std::vector<Group> group_excursions(std::vector<Excursion> const& excursions);

}  // namespace isolaw::data
