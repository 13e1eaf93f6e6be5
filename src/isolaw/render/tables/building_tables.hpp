// Writes the analyses of a building as CSV and as a LaTeX table for a publication.
#pragma once

#include <string>

#include "isolaw/study/building_results.hpp"

namespace isolaw::render {

// A row for each law and quantity: bound and nominal analyses, fractiles of the draws, scatter by its causes.
std::string building_csv(building::Study const& study, building::Answers const& answers);
std::string coverage_csv(building::Study const& study, building::Answers const& answers);
// A row for each law and motion, for the nominal building: implicit integration, checks, equivalent linear analysis.
std::string building_checks_csv(building::Study const& study, building::Answers const& answers);
// A LaTeX table of the main numbers of building_csv() and coverage_csv(), one law after another.
std::string building_tex(building::Study const& study, building::Answers const& answers);

}  // namespace isolaw::render
