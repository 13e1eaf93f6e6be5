// The figures of a report for print. Each has its data (NAME.dat), a gnuplot script (NAME.gp) and the drawings
// (NAME.svg, NAME.pdf). Figure numbers 4 to 14 refer to Cucuzza et al. 2025. docs/figures.md lists the figures.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

enum class FigureChoice { none, lot, all };  // lot: with one device's loops as an example; all: every device's figures
// Throws Error for other names than "none", "lot" and "all".
FigureChoice figure_choice(std::string_view name);

struct Figure {
  std::string name;  // stem of its files, safe for every file system
  std::string data, script;
};

// Makes one figure after the other, since the figures of 160 devices would fill the memory. Skips those without data.
void for_each_figure(Summary const& summary, FigureChoice choice, std::function<void(Figure const&)> const& use);
// Makes file names of letters, digits, '.', '-' and '_', short enough for a file system and different even if case does
// not count. No stem equals another stem followed by an underscore and one of the endings.
std::vector<std::string> file_stems(std::vector<std::string> const& names,
                                    std::vector<std::string> const& endings = {});

struct FigureOutcome {
  std::size_t figures = 0, drawn = 0;  // `drawn` includes drawings kept from the same data
  bool program_missing = false;
  std::string reason;  // why some were not drawn
};

// Writes data and scripts into dir/figures, lets gnuplot draw missing figures, and removes figures of isolaw that are
// not chosen. Does nothing for `none`. Throws Error if files cannot be written.
FigureOutcome write_figures(Summary const& summary, FigureChoice choice, std::filesystem::path const& dir);

FigureOutcome write_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);
// Removes isolaw's figures, recognised by the first line of their scripts, and nothing else in dir/figures.
void remove_figures(std::filesystem::path const& dir);
// Data of the lot's figures: file name relative to the report's directory, and text.
std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary);

}  // namespace isolaw::render
