// Reads a building study for the commands building and parts.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::app {

// Throws Error if no file or campaign is given. One Error lists all faults in them.
building::Study building_study(BuildingArguments const& arguments);

}  // namespace isolaw::app
