// Reads MATLAB variables as columns: a vector, each column of a matrix ("x_F:3"; rows if few), each field of a struct.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

bool is_mat(std::string_view bytes);

// `owner` names a struct or matrix. Only its columns are then read, and named without it. If it is empty, all variables
// are one test, and if several structs seem to hold a test each, Tests::sheets lists them. Throws Error.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
