// Tables of `isolaw conditions`, with the columns of study/conditions_results.hpp.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// A row for each property, effect and tested level, then the largest and the smallest factor over the design conditions
// for each property and effect, and for all effects together.
std::string conditions_csv(ConditionsResult const& result, UnitSystem const& units);
// A row for each counted cycle of each block of each test, with what the device had gone through before it.
std::string observations_csv(ConditionsResult const& result, UnitSystem const& units);
// The largest and the smallest factor of every effect over the design conditions, as LaTeX (booktabs). It has no units.
std::string conditions_tex(ConditionsResult const& result, UnitSystem const& units);

}  // namespace isolaw::render
