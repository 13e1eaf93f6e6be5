// Reads the lines above the rows of numbers: facts about the specimen, a row of names, a row of units, comments.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/files/dialect.hpp"

namespace isolaw::data {

// Line numbers count from 0 here, and from 1 in messages.
struct Header {
  std::size_t first_data = 0;  // line of the first row of numbers
  std::optional<std::size_t> name_line;
  std::optional<std::size_t> unit_line;
  std::vector<std::string> names;            // one for each column, with the units in it; empty without a row of names
  std::vector<std::string> units;            // one for each column; empty if the file states none outside the names
  std::vector<std::string> units_elsewhere;  // units that the file states without naming their column
  std::vector<StampKind> stamps;         // for each column: kind of its dates and times; empty if the format has none
  std::vector<std::size_t> passed_over;  // lines above the rows that were not used, except blank lines and comments

  struct Mismatch {
    std::size_t line;
    std::size_t names;
    bool commas = false;  // commas seem to be both delimiter and decimal separator
  };
  std::optional<Mismatch> mismatch;

  std::optional<double> interval_s;  // time between rows, if the header states it and no column holds the time

  bool own_axis = false;             // names refer to the actuator's axis, which may have any direction in the rig
  std::string_view row = "line";     // word for a row in messages: "line", "row", "element"
  bool lettered = false;             // columns have letters instead of numbers, as in a workbook
  bool by_name = false;              // columns are variables: messages call them by name, not by number
  std::vector<std::string> objects;  // variables that hold text, or objects that only MATLAB reads
  std::vector<std::string> complex;  // variables of complex numbers, which cannot be channels
  std::string listing;               // lists all contents of the file if not all are columns
};

// The text by which a lot file names a column: its name if --columns accepts it and it is unique, else its number.
std::string column_key(std::size_t index, Header const& header);

// The text that messages suggest for --columns: the letter in a workbook, a variable's name, else the number.
std::string option_key(std::size_t index, Header const& header);
// The letter of a workbook's column with this index, from 0: "A" to "Z", "AA", ...
std::string column_letters(std::size_t index);
std::optional<std::size_t> letters_column(std::string_view letters);

// How messages call a column: "column 2 'Force [kN]'", "column B 'Force [kN]'", "variable 'Force'".
std::string column_text(std::size_t index, Header const& header);

bool is_data_row(std::string_view line, Dialect const& dialect);

Header recognise_header(std::span<std::string_view const> lines, Dialect const& dialect);

// The lines at which the second and all later tests begin. A test begins with a row of names below rows of numbers.
std::vector<std::size_t> later_tests(std::span<std::string_view const> lines, Dialect const& dialect,
                                     Header const& first);

}  // namespace isolaw::data
