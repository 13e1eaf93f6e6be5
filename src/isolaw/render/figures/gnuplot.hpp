// Writes users' text into gnuplot's scripts and data files so that it never acts as a command, and runs gnuplot without
// a shell, without the user's settings and with a time limit.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::render {

// Returns the text as a single-quoted string, in which gnuplot replaces nothing. Control characters become visible
// codes. A label with this string needs the option `noenhanced`, so that _, ^, {, }, @, & and ~ are drawn as they are.
std::string gnuplot_string(std::string_view text);
// Returns a text of isolaw itself for labels in gnuplot's enhanced mode, in which for example "N/m^3" gets a raised
// exponent.
std::string gnuplot_text(std::string_view text);
std::string gnuplot_label(std::string_view text);

// Builds the text of a data file: rows of numbers and quoted words, separated by spaces. Two empty lines end a block,
// which gnuplot's `index` selects.
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
  void cell(std::optional<double> const& number);  // with all digits; NaN if it is empty
  void cell(double number) { cell(std::optional(number)); }
  void cell(std::vector<std::optional<double>> const& numbers) {
    for (auto const& number : numbers) cell(number);
  }
  void cell(std::size_t number) { text_ += std::to_string(number) + ' '; }
  std::string text_;
};

struct GnuplotEnd {
  bool started = false;
  std::string reason;  // why gnuplot did not finish; empty if it did
};

// Runs `scripts` one after another in one process in `directory`. The process ends at the first error.
GnuplotEnd run_gnuplot(std::vector<std::string> const& scripts, std::filesystem::path const& directory,
                       std::chrono::seconds limit);

}  // namespace isolaw::render
