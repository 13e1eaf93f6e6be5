// Writes the content of records and the results of their tests as JSON, for `isolaw inspect --json` and Python.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// docs/inspection-json.md has the schema. A single device's members are in the object itself, and several devices are
// in its array `devices`. `assessment` holds rule_set, design and lot.
std::string inspection_json(Summary const& summary);

}  // namespace isolaw::render
