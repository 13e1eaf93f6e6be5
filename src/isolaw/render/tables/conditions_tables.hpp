// Makes the tables of `isolaw conditions`. study/conditions_results.hpp lists their columns.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns a table with a row for each property, effect and tested level. Further rows have the largest and the smallest
// factor over the design conditions, for each property and effect and for all effects together.
std::string conditions_csv(ConditionsResult const& result, UnitSystem const& units);
// Returns a table with a row for each counted cycle of each block of each test. A row also says what the device had
// gone through before this cycle.
std::string observations_csv(ConditionsResult const& result, UnitSystem const& units);
// Returns a LaTeX table (booktabs) with the largest and the smallest factor of every effect over the design conditions.
// Factors have no units, so `units` changes nothing.
std::string conditions_tex(ConditionsResult const& result, UnitSystem const& units);

}  // namespace isolaw::render
