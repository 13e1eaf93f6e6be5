// Makes the figures of a report for print. The files of a figure are its data (NAME.dat), a gnuplot script (NAME.gp)
// and drawings (NAME.svg, NAME.pdf). Figure numbers 4 to 14 refer to Cucuzza et al. 2025. docs/figures.md lists the
// figures.
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
// Returns the choice with this name. Throws Error for any name other than "none", "lot" and "all".
FigureChoice figure_choice(std::string_view name);

struct Figure {
  std::string name;  // the names of the figure's files begin with it
  std::string data, script;
};

// Makes one figure after another and passes it to `use`, because all figures of 160 devices at once would fill the
// memory. Skips figures without data.
void for_each_figure(Summary const& summary, FigureChoice choice, std::function<void(Figure const&)> const& use);
// Returns a file name without extension (a stem) for each name. Stems consist of letters, digits, '.', '-' and '_', are
// short enough for a file system, and differ even if it ignores case. A stem followed by an underscore and one of
// `endings` never equals another stem. Files named in this way therefore do not overwrite one another.
std::vector<std::string> file_stems(std::vector<std::string> const& names,
                                    std::vector<std::string> const& endings = {});

struct FigureOutcome {
  std::size_t figures = 0, drawn = 0;  // `drawn` also counts drawings kept from an earlier call with the same data
  std::size_t removed = 0;             // with `none`: figures of former results that were removed
  bool program_missing = false;
  std::string reason;  // why some figures were not drawn
};

// Writes data and scripts into dir/figures, draws missing figures with gnuplot, and removes those of isolaw's figures
// in this folder that `choice` does not include. If `choice` is `none`, it writes and draws nothing. It then only
// removes isolaw's figures whose data differ from `summary`, so that no figure contradicts the reports beside it.
// Throws Error if it cannot write.
FigureOutcome write_figures(Summary const& summary, FigureChoice choice, std::filesystem::path const& dir);

FigureOutcome write_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);
// Does the same for these figures, but keeps all other figures in dir/figures, which may belong to a campaign.
FigureOutcome add_figures(std::vector<Figure> const& figures, std::filesystem::path const& dir);
// Removes isolaw's figures from dir/figures, and no other file. It recognises them by the first line of their scripts.
void remove_figures(std::filesystem::path const& dir);
// Returns the data files of the lot's figures as pairs of name, relative to the report's directory, and text.
std::vector<std::pair<std::string, std::string>> figure_data(Summary const& summary);

}  // namespace isolaw::render
