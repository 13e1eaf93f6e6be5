// Reads tables that are lines of cells: delimited text, and worksheets after their rows were written as such lines.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

struct TextOptions {
  std::optional<char> thousands = {};  // the mark that groups digits
  bool one_column = false;             // also accept a file with one column of numbers
};

// `bytes` must outlive the result. Throws Error if there are no rows of numbers.
Tests text_tests(std::string_view bytes, std::string const& file, TextOptions const& options = {});

// `rows` has a line for each row, with tabs and decimal points. Tests::tables is empty without rows of numbers.
Tests sheet_tests(std::string rows, std::string const& place);

}  // namespace isolaw::data
