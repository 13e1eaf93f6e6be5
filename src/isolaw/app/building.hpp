// Reading a building study, for the commands building and parts.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::app {

// Throws Error if the file or the campaign is not given, or for all faults in them.
building::Study building_study(BuildingArguments const& arguments);

}  // namespace isolaw::app
