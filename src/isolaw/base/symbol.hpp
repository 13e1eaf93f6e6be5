// Turns the plain name of a quantity or parameter into a typeset symbol: xi_eff into the letter xi with the index eff,
// beta1 into beta with 1, Fy into F with y. Page, figures and LaTeX use it; input and data files keep the plain names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isolaw {

struct Symbol {
  std::string_view letter;  // UTF-8
  std::string_view latex;   // the letter in LaTeX's math mode; empty if `letter` serves there too
  std::string index;        // UTF-8, with Greek letters for their names; empty if there is none

  bool is_greek() const { return !latex.empty() && letter != "OF"; }
  bool operator==(Symbol const&) const = default;
};

Symbol symbol_of(std::string_view name);

std::string latex_symbol(std::string_view name);    // "$\xi_{\mathrm{eff}}$"
std::string gnuplot_symbol(std::string_view name);  // gnuplot's enhanced text: "{/:Italic ξ}_{eff}"
// Words that are typeset wherever they occur in sentences and headings: some properties' names and all Greek letters.
std::vector<std::string_view> symbol_words();

}  // namespace isolaw
