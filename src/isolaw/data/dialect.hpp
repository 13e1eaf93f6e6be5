// Delimiter and decimal separator, decided together. A comma alone says nothing ("1,5;2,0" against "1.5,2.0"), so every
// pair of the two is tried on lines from all over the file, and the pair that reads most of them as numbers wins.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::data {

struct Dialect {
  char delimiter = ',';  // ' ' stands for runs of blanks and tabs
  char decimal = '.';
  std::size_t columns = 0;    // cells of a data row, a trailing empty one not counted
  std::vector<bool> numeric;  // per column: mostly numbers
  bool decimal_seen = false;  // some number holds the decimal separator
  std::string why;            // one sentence
  bool sheet = false;         // a worksheet: short rows are filled up, what stands right of the table is left alone
};

enum class CellKind { number, empty, not_finite, grouped, text };  // grouped: thousands separators, "1.234,56"

struct Cell {
  CellKind kind = CellKind::empty;
  double value = 0.0;  // of a number
};

Cell parse_cell(std::string_view cell, char decimal);

// Cells of one line, trimmed and without their quotes; one trailing empty cell is dropped.
void split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

// The cells of a row as the dialect has them.
void split_row(std::string_view line, Dialect const& dialect, std::vector<std::string_view>& cells);

// A line that starts with '#' or '%'.
bool is_comment(std::string_view line);
// Nothing but blanks and delimiters.
bool is_blank(std::string_view line, char delimiter);

// nullopt when no pair finds rows with numbers in at least two columns.
std::optional<Dialect> recognise_dialect(std::span<std::string_view const> lines);
// The same of the rows of a worksheet, cells separated by tabs.
std::optional<Dialect> sheet_dialect(std::span<std::string_view const> rows);

std::string_view delimiter_name(char delimiter);
std::string_view decimal_name(char decimal);

}  // namespace isolaw::data
