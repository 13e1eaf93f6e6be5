// Reads Excel workbooks, .xlsx (ECMA-376 part 1, chapter 18): turns the cells of a sheet into rows of text, which are
// then read like delimited text. A formula counts with its saved value. Dates and times of day, which a workbook keeps
// as numbers of days, become text, since nobody would notice if days were taken for seconds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Whether these are the bytes of a zip archive, of which .xlsx is one.
bool is_zip(std::string_view bytes);

// The tests in `sheet`, a name or a number from 1; without it those of the first sheet that holds rows of numbers, and
// Tests::sheets names all that do. Throws Error: no workbook, damaged, a bomb, no such sheet, no rows of numbers.
Tests workbook_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& sheet);

}  // namespace isolaw::data
