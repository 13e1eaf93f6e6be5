// Reads tables written as lines of cells: delimited text, and the rows of a worksheet brought into the same form.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

struct TextOptions {
  std::optional<char> thousands = {};  // the mark that groups digits
  bool one_column = false;             // a single column of numbers will do
};

// Throws Error when there are no rows of numbers. `bytes` must outlive the tests.
Tests text_tests(std::string_view bytes, std::string const& file, TextOptions const& options = {});

// One row a line, cells separated by tabs, decimal points. Empty `tables` if the sheet holds no rows of numbers.
Tests sheet_tests(std::string rows, std::string const& place);

}  // namespace isolaw::data
