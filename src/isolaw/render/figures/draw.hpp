// Draws figures with gnuplot in a temporary folder; their data and scripts must exist.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

std::filesystem::path figure_file(std::filesystem::path const& dir, std::string const& name, char const* extension);
// Returns "" if the file is missing or cannot be read.
std::string text_of(std::filesystem::path const& path);
// Draws `names` in `dir`. `outcome` gets their number and why some failed. Throws Error if files cannot be written.
void draw(std::filesystem::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome);

}  // namespace isolaw::render
