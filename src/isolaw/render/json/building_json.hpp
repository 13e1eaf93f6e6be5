// building.json: what the analyses of a building say (docs/building-json.md).
#pragma once

#include <string>

#include "isolaw/render/json/results_json.hpp"
#include "isolaw/study/building_results.hpp"

namespace isolaw::render {

// Members of the open object.
void write_building(JsonWriter& out, building::Study const& study, building::Answers const& answers, Digits digits);

std::string building_json(building::Study const& study, building::Answers const& answers);

}  // namespace isolaw::render
