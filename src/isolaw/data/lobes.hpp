// A lobe is an excursion of the motion to one side of its centre; two lobes to opposite sides make a cycle. A lobe ends
// where the motion crosses the centre, or comes back to it and turns there. A lobe after the start, a rest or a turn is
// left out as a pre-load if it differs from the next in size (by 15 %) or in the time it takes to fall (by a factor of
// 1.5) while the lobes after it are alike. A half cycle at the end of a stage is left out as well.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "isolaw/data/cycles.hpp"

namespace isolaw::data {

struct Lobe {
  double first = 0.0;  // fractional sample indices
  double last = 0.0;
  std::size_t tip = 0;       // sample farthest from the centre
  bool positive = false;     // to which side
  double reach_mm = 0.0;     // distance of the tip from the centre
  double fall = 0.0;         // time from 90 to 10 % of the reach, in s or in samples
  bool turns = false;        // starts where the motion turns at the centre, or at rest at the start of the record
  bool rests = false;        // starts after a rest
  bool starts_open = false;  // the record starts within it
  bool ends_open = false;    // the record ends within it
  bool has_gap = false;      // the time jumps within it, so its tip may be missing
};

enum class Part {
  cycle,       // two lobes
  pre_load,    // a lobe before a cycle, but no part of it
  half,        // a lobe that is left over before the motion starts anew
  open_start,  // the record starts within it
  open_end     // the record ends within it, or before the second lobe
};

struct Group {
  Part part = Part::cycle;
  std::size_t begin = 0;  // lobes [begin, end)
  std::size_t end = 0;
};

std::vector<Lobe> lobes(std::span<double const> disp_mm, std::span<double const> time_s, Reversals const& motion,
                        double centre_mm);
std::vector<Group> group_lobes(std::vector<Lobe> const& lobes);

}  // namespace isolaw::data
