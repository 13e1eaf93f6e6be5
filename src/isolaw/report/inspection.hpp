// What records hold and what their tests say, without any law: the output of `isolaw inspect`.
#pragma once

#include <string>

#include "isolaw/report/summary.hpp"

namespace isolaw::report {

// One device in full: recognised columns, channels, every cycle, stability, assessments, warnings, notes. Several: a line
// for each device, then the lot.
std::string inspection_text(Summary const& summary);

// docs/inspection-json.md. One device: its object, with rule_set, design and lot beside its own members; several:
// devices, and the same three.
std::string inspection_json(Summary const& summary);

}  // namespace isolaw::report
