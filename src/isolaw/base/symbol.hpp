// How the plain name of a quantity or a parameter is set: xi_eff as the letter xi with the index eff, beta1 as beta
// with 1, Fy as F with y. The page, the figures and LaTeX take it from here; what is typed and files hold stays plain.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isolaw {

struct Symbol {
  std::string_view letter;  // UTF-8
  std::string_view latex;   // the same in mathematics; empty: as `letter`
  std::string index;        // UTF-8, Greek words as letters; empty: none

  bool is_greek() const { return !latex.empty() && letter != "OF"; }
  bool operator==(Symbol const&) const = default;
};

Symbol symbol_of(std::string_view name);

// "$\xi_{\mathrm{eff}}$"
std::string latex_symbol(std::string_view name);
// Enhanced text of gnuplot: "{/:Italic ξ}_{eff}"
std::string gnuplot_symbol(std::string_view name);

// Words of sentences and headings that are set so wherever they stand: of properties, and the Greek letters.
std::vector<std::string_view> symbol_words();

}  // namespace isolaw
