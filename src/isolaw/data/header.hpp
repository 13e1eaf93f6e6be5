// What stands above the rows of numbers: lines about the specimen, a row of names, a row of units, comments.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/dialect.hpp"

namespace isolaw::data {

// Lines are counted from 0 here; messages count from 1.
struct Header {
  std::size_t first_data = 0;  // first row of numbers
  std::optional<std::size_t> name_line;
  std::optional<std::size_t> unit_line;
  std::vector<std::string> names;        // per column, UTF-8, with units as written; empty without a name row
  std::vector<std::string> units;        // per column; empty without a unit row
  std::vector<std::size_t> passed_over;  // lines above the data that are neither, blank lines and comments left out

  // A row that names channels, but not as many as there are columns.
  struct Mismatch {
    std::size_t line;
    std::size_t names;
  };
  std::optional<Mismatch> mismatch;
};

Header recognise_header(std::span<std::string_view const> lines, Dialect const& dialect);

}  // namespace isolaw::data
