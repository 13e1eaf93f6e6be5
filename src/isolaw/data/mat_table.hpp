// Reads MATLAB variables as columns: vectors by name, matrix columns as "x_F:3" (rows if few), fields as "test.disp".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/table.hpp"

namespace isolaw::data {

bool is_mat(std::string_view bytes);

// `owner` is a struct or matrix whose fields are then named without it. Without it all variables are one test, and if
// several structs seem to hold a test each, Tests::sheets names them. Throws Error.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
