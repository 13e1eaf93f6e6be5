// LaTeX tables to \input into a publication: booktabs, or longtable if a table may exceed a page. Numbers are plain
// math with four significant digits, standard deviations over runs with two. Each table also exists as CSV
// (tables.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Makes a user's text safe for LaTeX. Spells out control characters, and characters that pdfLaTeX has no letter for.
std::string latex_text(std::string_view text);
// "$1.600$", "$-2.320\times10^{5}$"; "--" if there is no number.
std::string latex_number(std::optional<double> const& number, int digits_shown = 4);
// "kN/mm", "N/m$^{3}$"; "" if there is no unit.
std::string latex_unit(std::string_view unit);
std::string table_a5_tex(Summary const& summary);
std::string robustness_tex(Summary const& summary);
std::string front_tex(Summary const& summary);

}  // namespace isolaw::render
