// Reads the lines above the rows of numbers: lines about the specimen, a row of names, a row of units, comments.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/dialect.hpp"

namespace isolaw::data {

// Lines count from 0; messages count from 1.
struct Header {
  std::size_t first_data = 0;  // first row of numbers
  std::optional<std::size_t> name_line;
  std::optional<std::size_t> unit_line;
  std::vector<std::string> names;        // per column, UTF-8, with units as written; empty without a name row
  std::vector<std::string> units;        // per column; empty if neither a row nor a key gives them
  std::vector<StampKind> stamps;         // per column: what its dates and times are; empty if it can have none
  std::vector<std::size_t> passed_over;  // other lines above the data, without blank lines and comments

  struct Mismatch {
    std::size_t line;
    std::size_t names;
    bool commas = false;  // as if the comma were both delimiter and decimal separator
  };
  std::optional<Mismatch> mismatch;

  std::optional<double> interval_s;  // between rows, if the header gives it and no column has the time

  bool own_axis = false;             // channels are named after the machine's axis, which may have any direction
  std::string_view row = "line";     // the word for a row: "line", "row", "element"
  bool lettered = false;             // columns have letters, as in a workbook
  bool by_name = false;              // columns are variables, so that advice calls them by name, not by number
  std::vector<std::string> objects;  // variables that hold text, or objects that only MATLAB can read
  std::vector<std::string> complex;  // variables of complex numbers, from which no channel is read
  std::string listing;               // everything in the file, if that is more than its columns
};

bool is_data_row(std::string_view line, Dialect const& dialect);

Header recognise_header(std::span<std::string_view const> lines, Dialect const& dialect);

// Lines (from 0) at which another test begins: a row of names below rows of numbers. The first test is not included.
std::vector<std::size_t> later_tests(std::span<std::string_view const> lines, Dialect const& dialect,
                                     Header const& first);

}  // namespace isolaw::data
