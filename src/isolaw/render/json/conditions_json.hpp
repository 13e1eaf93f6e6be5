// Writes the results of `isolaw conditions` as JSON.
#pragma once

#include <string>

#include "isolaw/base/json.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::render {

// Returns the text of conditions.json, which docs/conditions.md describes.
std::string conditions_json(study::ConditionsResult const& result);
// Writes the member "conditions" of a summary or an inspection, if the lot has a table [conditions]; or
// "no_conditions", the reason why its tests cannot be compared.
void write_conditions(JsonWriter& out, study::Summary const& summary);

}  // namespace isolaw::render
