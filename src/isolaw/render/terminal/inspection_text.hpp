// What records hold and what their tests say, without any law: the output of `isolaw inspect`.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// One device in full: recognised columns, channels, every cycle, stability, assessments, warnings, notes. Several: a
// line for each device, then the lot.
std::string inspection_text(Summary const& summary);

}  // namespace isolaw::render
