// Recognises delimiter and decimal separator together, since a comma may be either ("1,5;2,0" or "1.5,2.0"). Tries
// every pair of delimiter and separator on lines from all over the file. The pair that makes most cells numbers wins.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {

// A mark that groups digits. The user types a blank as "blank", because files write it as several different characters.
struct DigitGroup {
  char mark;
  // `word`: value of the option; `shell_text`: as typed in a shell; `sentence_text`: in a sentence
  std::string_view word, shell_text, sentence_text;
};
inline constexpr std::array digit_groups{DigitGroup{',', ",", ",", "','"}, DigitGroup{'.', ".", ".", "'.'"},
                                         DigitGroup{'\'', "'", "\"'\"", "'''"},
                                         DigitGroup{' ', "blank", "blank", "blanks"}};
DigitGroup const& digit_group(char mark);
std::optional<DigitGroup> group_in(std::string_view cell, char decimal);
struct NumberFormat {
  char decimal = '.';
  char thousands = '\0';  // the mark that groups digits; '\0': digits are not grouped
  NumberFormat(char decimal_sign, char group = '\0') : decimal(decimal_sign), thousands(group) {}
};

struct Dialect {
  char delimiter = ',';  // ' ' stands for runs of blanks and tabs
  char decimal = '.';
  std::size_t columns = 0;  // number of cells in a row of numbers, without an empty last cell
  char thousands = '\0';
  std::vector<bool> numeric;      // for each column: whether most cells are numbers
  std::vector<StampKind> stamps;  // for each column: the kind of its dates and times
  bool decimal_seen = false;      // at least one number holds the decimal separator
  std::string explanation;        // one sentence that explains the choice
  bool sheet = false;             // the rows of a worksheet: split_row() cuts or fills them to `columns` cells

  NumberFormat format() const { return {decimal, thousands}; }
};

enum class CellKind {
  number,
  empty,
  not_finite,
  grouped,
  text,
  stamp
};  // grouped: a number with thousands separators ("1.234,56") that the format does not have; stamp: a date or time

struct Cell {
  CellKind kind = CellKind::empty;
  double value = 0.0;  // only for a number
};

Cell parse_cell(std::string_view cell, NumberFormat format);
// Trims cells, removes their quotes, and drops one empty cell at the end.
void split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells);
void split_row(std::string_view line, Dialect const& dialect, std::vector<std::string_view>& cells);
bool is_comment(std::string_view line);
bool is_blank(std::string_view line, char delimiter);

// nullopt if no pair of delimiter and decimal sign gives rows with numbers or time stamps in two or more columns.
std::optional<Dialect> recognise_dialect(std::span<std::string_view const> lines,
                                         std::optional<char> thousands = std::nullopt);
std::optional<Dialect> one_column_dialect(std::span<std::string_view const> lines,
                                          std::optional<char> thousands = std::nullopt);
std::optional<Dialect> sheet_dialect(std::span<std::string_view const> rows);

std::string_view delimiter_name(char delimiter);
std::string_view decimal_name(char decimal);

}  // namespace isolaw::data
