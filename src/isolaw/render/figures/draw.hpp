// Draws figures with gnuplot in a temporary folder. The data and scripts of the figures must exist.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

std::filesystem::path figure_file(std::filesystem::path const& dir, std::string const& name, char const* extension);
// The content of the file; "" if it is missing or cannot be read.
std::string text_of(std::filesystem::path const& path);
// Draws the figures `names` in `dir`. `outcome` gets the number of figures drawn and why the first one failed. Throws
// Error if a file cannot be written.
void draw(std::filesystem::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome);

}  // namespace isolaw::render
