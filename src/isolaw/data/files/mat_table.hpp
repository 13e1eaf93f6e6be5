// Reads MATLAB variables as columns: vectors, fields of structs, columns of a matrix ("x_F:3") or rows of a wide one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

bool is_mat(std::string_view bytes);

// Reads only the columns of the struct or matrix `owner`, fields without the struct's name. Without `owner`, reads all
// variables as one table; if several owners name two channels each, Tests::sheets lists these owners. Throws Error.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
