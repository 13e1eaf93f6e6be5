// Excel workbooks, .xlsx (ECMA-376 part 1, chapter 18): the cells of a sheet as rows of text, which are then read as
// delimited text is. Formulas count with the value that was saved with them. Dates and times of day, which a workbook
// keeps as numbers of days, are text here, since a number of days taken for seconds would go unnoticed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Whether these are the bytes of a zip archive, of which .xlsx is one.
bool is_zip(std::string_view bytes);

// The tests of the sheet named, or of that number from 1; without one, of the first sheet that holds rows of numbers,
// and in Tests::sheets all that do. Throws Error: no workbook, damaged, a bomb, no such sheet, no rows of numbers.
Tests workbook_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& sheet);

}  // namespace isolaw::data
