// LaTeX tables to \input into a publication: booktabs (longtable if a table may exceed a page), numbers in plain math
// with four significant digits, standard deviations over runs with two. Each has a CSV with the same content
// (tables.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Makes a user's text safe for LaTeX. Control characters, and characters that pdfLaTeX has no letter for, are spelled
// out.
std::string latex_text(std::string_view text);
// "$1.600$", "$-2.320\times10^{5}$"; "--" without a number.
std::string latex_number(std::optional<double> const& number, int digits_shown = 4);
// "kN/mm", "N/m$^{3}$"; "" without a unit.
std::string latex_unit(std::string_view unit);
std::string table_a5_tex(Summary const& summary);
std::string robustness_tex(Summary const& summary);
std::string front_tex(Summary const& summary);

}  // namespace isolaw::render
