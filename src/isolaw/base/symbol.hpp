// Turns the plain name of a quantity or parameter into a typeset symbol: xi_eff becomes the letter xi with index eff.
// The page, figures and LaTeX use symbols; input and data files keep plain names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isolaw {

struct Symbol {
  std::string_view letter;  // UTF-8
  std::string_view latex;   // for LaTeX's math mode; empty if `letter` serves there too
  std::string index;        // UTF-8, with Greek letters in place of their names; empty if there is none

  bool is_greek() const { return !latex.empty() && letter != "OF"; }
  bool operator==(Symbol const&) const = default;
};

Symbol symbol_of(std::string_view name);

std::string latex_symbol(std::string_view name);    // "$\xi_{\mathrm{eff}}$"
std::string gnuplot_symbol(std::string_view name);  // for gnuplot's enhanced text: "{/:Italic ξ}_{eff}"
// Returns the words that sentences and headings show typeset: the names of some properties and of Greek letters.
std::vector<std::string_view> symbol_words();

}  // namespace isolaw
