// Writes building.json, the results of the analyses of a building (docs/building-json.md).
#pragma once

#include <string>
#include <vector>

#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/building_results.hpp"

namespace isolaw::render {

// Writes the members of building.json into the JSON object that `out` has open.
void write_building(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits);
inline constexpr std::string_view from_calibration = "From the calibration: ";
std::vector<std::string> building_warnings(building::Answers const& answers, UnitSystem const& units = record_units);
// Returns the same warnings as lines for a terminal. Each line says first whether it is a warning or a note.
std::vector<std::string> building_lines(building::Answers const& answers, UnitSystem const& units);

std::string building_json(building::Study const& study, building::Answers const& answers);

}  // namespace isolaw::render
