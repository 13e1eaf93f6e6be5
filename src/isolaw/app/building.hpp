// What commands know of a study of a building.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::app {

// Of the building file and the campaign's directory. Throws Error: one that is not given, all that is wrong in them.
building::Study building_study(BuildingArguments const& arguments);

}  // namespace isolaw::app
