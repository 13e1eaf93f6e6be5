// The figures for print of an isolated building, drawn as those of a campaign.
#pragma once

#include <filesystem>
#include <vector>

#include "isolaw/building/answers.hpp"
#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

// building_histograms, building_variance.
std::vector<Figure> building_figures(building::Answers const& answers);

// In dir/figures; as write_figures().
FigureOutcome write_building_figures(building::Answers const& answers, std::filesystem::path const& dir);

}  // namespace isolaw::render
