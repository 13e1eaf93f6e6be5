// Makes the figures of a report on an isolated building, in the same style as the figures of a campaign.
#pragma once

#include <filesystem>
#include <vector>

#include "isolaw/building/answers.hpp"
#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

std::vector<Figure> building_figures(building::Answers const& answers, UnitSystem const& units);
FigureOutcome write_building_figures(building::Answers const& answers, UnitSystem const& units,
                                     std::filesystem::path const& dir);

}  // namespace isolaw::render
