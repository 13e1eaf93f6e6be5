// Writes the analyses of a building as CSV and as a LaTeX table for a publication.
#pragma once

#include <string>

#include "isolaw/study/building_results.hpp"

namespace isolaw::render {

// Returns a table with a row for each law and quantity. The columns are the results of the bound and nominal analyses,
// fractiles of the draws, and how much of the scatter comes from each cause.
std::string building_csv(building::Study const& study, building::Answers const& answers);
std::string coverage_csv(building::Study const& study, building::Answers const& answers);
// Returns a table about the nominal building with a row for each law and motion. The columns are the results of
// implicit integration, of checks, and of an equivalent linear analysis.
std::string building_checks_csv(building::Study const& study, building::Answers const& answers);
// Returns a LaTeX table with the main numbers of building_csv() and coverage_csv(), one law after another.
std::string building_tex(building::Study const& study, building::Answers const& answers);

}  // namespace isolaw::render
