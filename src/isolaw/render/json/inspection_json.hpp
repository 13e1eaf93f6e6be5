// Writes the content of records and the results of their tests as JSON, for `isolaw inspect --json` and Python.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns the text of the JSON (schema: docs/inspection-json.md). The outermost object has the members of a single
// device, or an array `devices` if there are several. It also has `assessment` with rule_set, design and lot.
std::string inspection_json(Summary const& summary);

}  // namespace isolaw::render
