// Recognises delimiter and decimal separator together. A comma may be either ("1,5;2,0" against "1.5,2.0"), so every
// pair of the two is tried on lines from all over the file, and the pair that reads most of them as numbers wins.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/time_stamp.hpp"

namespace isolaw::data {

// A mark that groups digits. The blank is called "blank", since files write it as several characters.
struct DigitGroup {
  char mark;
  std::string_view word, typed, said;  // the value of --thousands; quoted for a shell; in a sentence
};
inline constexpr std::array digit_groups{DigitGroup{',', ",", ",", "','"}, DigitGroup{'.', ".", ".", "'.'"},
                                         DigitGroup{'\'', "'", "\"'\"", "'''"},
                                         DigitGroup{' ', "blank", "blank", "blanks"}};
DigitGroup const& digit_group(char mark);
std::optional<DigitGroup> group_in(std::string_view cell, char decimal);
struct NumberFormat {
  char decimal = '.';
  char thousands = '\0';  // the mark that groups digits; none unless the user says so
  NumberFormat(char decimal_sign, char group = '\0') : decimal(decimal_sign), thousands(group) {}
};

struct Dialect {
  char delimiter = ',';  // ' ' means runs of blanks and tabs
  char decimal = '.';
  std::size_t columns = 0;  // cells of a data row, a trailing empty one not counted
  char thousands = '\0';
  std::vector<bool> numeric;      // per column: mostly numbers
  std::vector<StampKind> stamps;  // per column: what its dates and times are
  bool decimal_seen = false;      // some number holds the decimal separator
  std::string why;                // one sentence
  bool sheet = false;  // a worksheet: short rows are filled up, and cells to the right of the table are ignored

  NumberFormat format() const { return {decimal, thousands}; }
};

enum class CellKind {
  number,
  empty,
  not_finite,
  grouped,
  text,
  stamp
};  // grouped: thousands separators, "1.234,56"; stamp: a date or time

struct Cell {
  CellKind kind = CellKind::empty;
  double value = 0.0;  // if it is a number
};

Cell parse_cell(std::string_view cell, NumberFormat format);
// Trims cells and removes their quotes; drops one trailing empty cell.
void split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);
void split_row(std::string_view line, Dialect const& dialect, std::vector<std::string_view>& cells);
bool is_comment(std::string_view line);
bool is_blank(std::string_view line, char delimiter);

// nullopt if no pair of delimiter and decimal sign gives rows with numbers or time stamps in at least two columns.
std::optional<Dialect> recognise_dialect(std::span<std::string_view const> lines,
                                         std::optional<char> thousands = std::nullopt);
std::optional<Dialect> one_column_dialect(std::span<std::string_view const> lines,
                                          std::optional<char> thousands = std::nullopt);
std::optional<Dialect> sheet_dialect(std::span<std::string_view const> rows);

std::string_view delimiter_name(char delimiter);
std::string_view decimal_name(char decimal);

}  // namespace isolaw::data
