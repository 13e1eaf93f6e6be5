// The figures of a report for print. Each consists of its data (NAME.dat), a gnuplot script (NAME.gp) and drawings
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

enum class FigureChoice { none, lot, all };  // lot: loops of one device as an example; all: loops of every device
// Throws Error for any name but "none", "lot" and "all".
FigureChoice figure_choice(std::string_view name);

struct Figure {
  std::string name;  // the names of the figure's files begin with it
  std::string data, script;
};

// Passes one figure after another to `use`, because all figures of 160 devices would fill the memory. Skips empty ones.
void for_each_figure(Summary const& summary, FigureChoice choice, std::function<void(Figure const&)> const& use);
// Makes file names of letters, digits, '.', '-' and '_'. They are short enough for a file system and differ even if it
// ignores case. A stem with an underscore and one of `endings` after it never equals another stem, so that files whose
// names are made in this way do not collide.
std::vector<std::string> file_stems(std::vector<std::string> const& names,
                                    std::vector<std::string> const& endings = {});

struct FigureOutcome {
  std::size_t figures = 0, drawn = 0;  // `drawn` also counts drawings kept from an earlier call with the same data
  std::size_t removed = 0;             // with `none`: figures of former results that were removed
  bool program_missing = false;
  std::string reason;  // why some figures were not drawn
};

// Writes data and scripts into dir/figures, draws missing figures with gnuplot, and removes isolaw's figures that are
// not chosen. For `none` it writes and draws nothing. It then only removes isolaw's figures whose data differ from
// those of `summary`, so that no figure contradicts the reports beside it. Throws Error if it cannot write.
FigureOutcome write_figures(Summary const& summary, FigureChoice choice, std::filesystem::path const& dir);

FigureOutcome write_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);
// Does the same for these figures, but keeps all other figures in dir/figures, which may belong to a campaign.
FigureOutcome add_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);
// Removes isolaw's figures from dir/figures, and no other file. It recognises them by the first line of their scripts.
void remove_figures(std::filesystem::path const& dir);
// The data files of the lot's figures: name relative to the report's directory, and text.
std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary);

}  // namespace isolaw::render
