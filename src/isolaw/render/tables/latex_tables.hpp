// Tables of a publication: LaTeX with booktabs (and longtable where one may be longer than a page), numbers in plain
// math with four significant digits (two of a standard deviation over runs), to be \input where they belong. Beside
// each stands a CSV of the same content (tables.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Text of a user: nothing of it is a command; control characters and what pdfLaTeX knows no letter for are spelled out.
std::string latex_text(std::string_view text);

// "$1.600$", "$-2.320\times10^{5}$"; "--" where there is none.
std::string latex_number(std::optional<double> const& number, int digits_shown = 4);

// "kN/mm", "N/m$^{3}$"; "" for none.
std::string latex_unit(std::string_view unit);

// The content of table_a5.csv.
std::string table_a5_tex(Summary const& summary);

// Per law: the objective, beta, the front; the content of robustness.csv.
std::string robustness_tex(Summary const& summary);

// The content of front.csv.
std::string front_tex(Summary const& summary);

}  // namespace isolaw::render
