// What records hold and what their tests say as JSON: `isolaw inspect --json`, and Python's.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// docs/inspection-json.md. One device: its object, with rule_set, design and lot beside its own members; several:
// devices, and the same three.
std::string inspection_json(Summary const& summary);

}  // namespace isolaw::render
