// Draws figures with gnuplot in a temporary folder. The data and scripts of the figures must exist.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

std::filesystem::path figure_file(std::filesystem::path const& dir, std::string const& name, char const* extension);
// Returns the content of the file, or "" if the file is missing or cannot be read.
std::string text_of(std::filesystem::path const& path);
// Draws the figures `names` in `dir`. Writes into `outcome` how many figures were drawn, and why the first one that
// failed did so. Throws Error if a file cannot be written.
void draw(std::filesystem::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome);

}  // namespace isolaw::render
