// The rows of a building's analyses as CSV, and as tables of a publication.
#pragma once

#include <string>

#include "isolaw/study/building_results.hpp"

namespace isolaw::render {

// Every quantity by every law: the analyses without draws, fractiles, parts of the spread.
std::string building_csv(building::Answers const& answers);
// Of every law what its bounds cover.
std::string coverage_csv(building::Answers const& answers);
// Of every law the nominal building under each motion: implicit path, checks, equivalent linear analysis.
std::string building_checks_csv(building::Study const& study, building::Answers const& answers);

// The content of the first two, law by law.
std::string building_tex(building::Study const& study, building::Answers const& answers);

}  // namespace isolaw::render
