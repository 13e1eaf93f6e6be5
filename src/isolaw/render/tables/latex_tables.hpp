// Makes LaTeX tables that a publication can \input. They use booktabs, or longtable if a table may exceed a page.
// Numbers have four significant digits, standard deviations over runs have two. Each table also exists as CSV
// (tables.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Makes a user's text safe for LaTeX. Control characters, and characters that pdfLaTeX cannot print, become visible
// codes.
std::string latex_text(std::string_view text);
// Returns a number such as "$1.600$" or "$-2.320\times10^{5}$", or "--" if there is no number.
std::string latex_number(std::optional<double> const& number, int digits_shown = 4);
// Returns a unit such as "kN/mm" or "N/m$^{3}$", or "" if there is no unit.
std::string latex_unit(std::string_view unit);
std::string table_a5_tex(Summary const& summary);
std::string robustness_tex(Summary const& summary);
std::string front_tex(Summary const& summary);

}  // namespace isolaw::render
