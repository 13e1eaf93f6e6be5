// Turns the variables of a MATLAB file into the columns of a table: vectors go by their name, columns of a matrix as
// "x_F:3" (its rows if they are few and long), fields of a struct as "test.disp".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

// Whether the bytes begin as a MATLAB file of version 5, 7 or 7.3 does.
bool is_mat(std::string_view bytes);

// The test in the struct or matrix `owner`, whose fields then go by their own names. Without `owner` all variables are
// one test, and if several structs seem to hold a test each, Tests::sheets names them. Throws Error: damaged, no arrays
// long enough, no such struct.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
