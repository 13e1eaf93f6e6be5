// The figures of a report for print: of each the data (NAME.dat), a gnuplot script that draws them (NAME.gp), and what
// it draws (NAME.svg, NAME.pdf). Numbers 4 to 14 are those of Cucuzza et al. 2025. docs/figures.md lists them.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

enum class FigureChoice { none, lot, all };  // lot: one of a device too, as an example; all: those of every device

// Throws Error: none of the names "none", "lot", "all".
FigureChoice figure_choice(std::string_view name);

struct Figure {
  std::string name;  // of its files, safe for every file system
  std::string data, script;
};

// One after the other, so that those of 160 devices need not be held at once. A figure without anything to draw is left
// out.
void for_each_figure(Summary const& summary, FigureChoice choice, std::function<void(Figure const&)> const& use);

// Letters, digits, '.', '-' and '_', no longer than a file system takes, different even where case does not count, and
// so that none is another one with an underscore and one of the endings behind it.
std::vector<std::string> file_stems(std::vector<std::string> const& names,
                                    std::vector<std::string> const& endings = {});

struct FigureOutcome {
  std::size_t figures = 0, drawn = 0;  // drawn: or drawn before from the same data
  bool program_missing = false;
  std::string reason;  // why some were not drawn
};

// Writes data and scripts into dir/figures, lets gnuplot draw those that are not there yet, and removes figures of
// isolaw that are not among the chosen ones. Nothing is done for `none`. Throws Error where files cannot be written.
FigureOutcome write_figures(Summary const& summary, FigureChoice choice, std::filesystem::path const& dir);

// The same of these figures.
FigureOutcome write_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);

// Those of isolaw, by the first line of their scripts. Nothing else of dir/figures.
void remove_figures(std::filesystem::path const& dir);

// Names relative to the report's directory and texts of the data of the lot's figures.
std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary);

}  // namespace isolaw::render
