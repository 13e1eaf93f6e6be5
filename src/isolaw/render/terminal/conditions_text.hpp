// Prints the results of `isolaw conditions` on a terminal.
#pragma once

#include <string>

#include "isolaw/study/conditions.hpp"

namespace isolaw::render {

// The bounds of each property first, with the effects behind them, then the factor of every tested level, and with
// `details` every test and how it is used.
std::string conditions_text(study::ConditionsResult const& result, bool details);

}  // namespace isolaw::render
