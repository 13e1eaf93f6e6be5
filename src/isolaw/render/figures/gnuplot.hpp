// Safe text for gnuplot's scripts and data files (names come from users and must never act as commands), and gnuplot
// itself, run without a shell, without the user's settings and with a time limit.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::render {

// A single-quoted string, in which gnuplot substitutes nothing; control characters are spelled out. Draw it with
// `noenhanced`, so that _, ^, {, }, @, & and ~ print as they are.
std::string gnuplot_string(std::string_view text);
// isolaw's own text for labels in enhanced mode: "N/m^3" gets a raised exponent.
std::string gnuplot_text(std::string_view text);
std::string gnuplot_label(std::string_view text);

// A data file: rows of numbers and quoted words, separated by spaces; two empty lines end a block (gnuplot's `index`).
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
  void cell(std::string_view text);  // in double quotes; double quotes inside the text become single quotes
  void cell(std::optional<double> const& number);  // with all digits; NaN without a number
  void cell(double number) { cell(std::optional(number)); }
  void cell(std::vector<std::optional<double>> const& numbers) {
    for (auto const& number : numbers) cell(number);
  }
  void cell(std::size_t number) { text_ += std::to_string(number) + ' '; }
  std::string text_;
};

struct GnuplotEnd {
  bool started = false;
  std::string reason;  // why gnuplot did not finish; else empty
};

// Runs `scripts` one after the other in one process in `directory`; the first error ends it.
GnuplotEnd run_gnuplot(std::vector<std::string> const& scripts, std::filesystem::path const& directory,
                       std::chrono::seconds limit);

}  // namespace isolaw::render
