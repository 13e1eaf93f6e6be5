// Writes the results of `isolaw conditions` as JSON.
#pragma once

#include <string>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// The text of conditions.json; docs/conditions.md describes it.
std::string conditions_json(study::ConditionsResult const& result);

}  // namespace isolaw::render
