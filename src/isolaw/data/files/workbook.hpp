// Reads Excel workbooks, .xlsx (ECMA-376 part 1, chapter 18). For a formula, reads the value that was saved. Dates and
// times of day, which are stored as days, become text, because nobody would notice if days were read as seconds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {
bool is_zip(std::string_view bytes);

// `sheet` is a name or a number from 1. Without it, reads the first sheet with rows of numbers. If that sheet names no
// channel, but another names two or more, reads the first sheet that names a channel. Throws Error.
Tests workbook_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& sheet);

}  // namespace isolaw::data
