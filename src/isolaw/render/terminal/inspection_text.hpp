// Prints the output of `isolaw inspect`: the content of records and the results of their tests, without any law.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns the output. If there is one device, it has all about the device: recognised columns, channels, every cycle,
// stability, assessments, warnings and notes. If there are several, each device gets a line, and the results of the lot
// follow. `details` adds tables for each device: its skeleton curve, the bilinear loop of each block, and how work,
// residual displacement and stiffness go on from cycle to cycle.
std::string inspection_text(Summary const& summary, bool details);

}  // namespace isolaw::render
