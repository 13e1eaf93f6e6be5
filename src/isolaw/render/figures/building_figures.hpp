// Figures for print of an isolated building, drawn like those of a campaign.
#pragma once

#include <filesystem>
#include <vector>

#include "isolaw/building/answers.hpp"
#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

// The figures building_histograms and building_variance.
std::vector<Figure> building_figures(building::Answers const& answers);

// Writes and draws them in dir/figures, as write_figures() does.
FigureOutcome write_building_figures(building::Answers const& answers, std::filesystem::path const& dir);

}  // namespace isolaw::render
