// Variables of a MATLAB file as the columns of a table: vectors by their name, columns of a matrix as "x_F:3" (rows,
// where a matrix has a few long rows), fields of a struct as "test.disp".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Whether the bytes begin as a MATLAB file of version 5, 7 or 7.3 does.
bool is_mat(std::string_view bytes);

// The test in the struct or matrix named, whose fields then go by their own names; without one, all variables together,
// and in Tests::sheets the structs that each seem to hold a test where there are several. Throws Error: damaged, no
// arrays long enough, no such struct.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
