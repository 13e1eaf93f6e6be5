// Reads MATLAB variables as columns: vectors, fields of structs, columns of a matrix ("x_F:3"), rows of a wide matrix.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

bool is_mat(std::string_view bytes);

// With `owner`, reads only the columns of this struct or matrix. The field "test.disp" is then called "disp". Without
// it, reads all variables as one table. Tests::sheets then lists the structs and matrices in which two or more columns
// name a channel, if there are several of them. Throws Error.
Tests mat_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& owner);

}  // namespace isolaw::data
