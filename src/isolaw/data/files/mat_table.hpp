// Reads MATLAB variables as columns: vectors, fields of structs, and columns of a matrix ("x_F:3"), or its rows if few.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

bool is_mat(std::string_view bytes);

// `owner` names a struct or matrix, whose columns alone are then read and named without the owner. Without `owner`, all
// variables are one test. If several structs seem to hold one test each, Tests::sheets lists them. Throws Error.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
