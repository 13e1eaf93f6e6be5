// Drawing: of figures whose data and scripts are there, by gnuplot in a folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/render/figures/figures.hpp"

namespace isolaw::render {

std::filesystem::path figure_file(std::filesystem::path const& dir, std::string const& name, char const* extension);

// Empty where there is no such file, or none that can be read.
std::string text_of(std::filesystem::path const& path);

// Draws `names` of `dir` and says in `outcome` how many, and why not all of them. Throws Error where files cannot be
// written.
void draw(std::filesystem::path const& dir, std::vector<std::string> const& names, FigureOutcome& outcome);

}  // namespace isolaw::render
