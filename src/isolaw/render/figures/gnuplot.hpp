// Text that stands in gnuplot's scripts and data files, and gnuplot itself, run as a program: without a shell, without
// the settings of its user, with a limit of time. Names come from users; nothing of them is ever a command there.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::render {

// A single-quoted string of a script, in which gnuplot substitutes nothing; control characters are spelled out. Set
// `noenhanced` wherever it is drawn: _, ^, {, }, @, & and ~ are then printed as they are.
std::string gnuplot_string(std::string_view text);

// Text of our own for labels in enhanced mode: "N/m^3" has its exponent raised.
std::string gnuplot_text(std::string_view text);
// The same as a single-quoted string.
std::string gnuplot_label(std::string_view text);

// Rows of numbers and quoted words, columns separated by spaces, blocks (gnuplot's `index`) by two empty lines.
class DataTable {
 public:
  DataTable& comment(std::string_view text);
  template <class... Of>
  void row(Of const&... cells) {
    (cell(cells), ...);
    text_.back() = '\n';
  }
  void end_block() { text_ += "\n\n"; }
  std::string take();

 private:
  // Each with a blank after it.
  void cell(std::string_view text);                // in double quotes; one in the text becomes a single quote
  void cell(std::optional<double> const& number);  // all its digits; NaN where there is none
  void cell(double number) { cell(std::optional(number)); }
  void cell(std::vector<std::optional<double>> const& numbers) {
    for (auto const& number : numbers) cell(number);
  }
  void cell(std::size_t number) { text_ += std::to_string(number) + ' '; }
  std::string text_;
};

struct GnuplotEnd {
  bool started = false;
  std::string reason;  // why it did not do all of it; empty when it did
};

// Runs `scripts` one after the other in one process in `directory`; an error in one ends it.
GnuplotEnd run_gnuplot(std::vector<std::string> const& scripts, std::filesystem::path const& directory,
                       std::chrono::seconds limit);

}  // namespace isolaw::render
