#include "isolaw/data/files/header.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/unit_text.hpp"

namespace isolaw::data {
namespace {

using Names = std::vector<std::string>;

Names to_names(std::vector<std::string_view> const& cells) {
  Names names;
  for (auto const cell : cells) names.push_back(to_utf8(cell));
  return names;
}

Names split_names(std::string_view line, char delimiter) {
  std::vector<std::string_view> cells;
  split_cells(line, delimiter, cells);
  return to_names(cells);
}

Names split_wide(std::string_view line) {
  Names names;
  line = trimmed(line);
  while (!line.empty()) {
    auto const gap = std::min(line.find("  "), line.find('\t'));
    names.push_back(to_utf8(trimmed(line.substr(0, gap))));
    line = gap == std::string_view::npos ? std::string_view{} : trimmed(line.substr(gap));
  }
  return names;
}

// Splits a row of names at blanks, but keeps "Force [kN]" as one name.
Names split_bracketed(std::string_view line) {
  Names names;
  for (auto& name : split_names(line, ' ')) {
    bool const unit = name.starts_with('[') || name.starts_with('(');
    if (unit && !names.empty())
      names.back() += ' ' + name;
    else
      names.push_back(std::move(name));
  }
  return names;
}

// If blanks separate cells, a date and a time are two columns, which often share one name. The date then gets no name.
void name_date_and_clock(Names& names, Dialect const& dialect) {
  if (dialect.delimiter != ' ' || names.size() + 1 != dialect.columns) return;
  for (std::size_t i = 0; i + 1 < dialect.columns; ++i)
    if (dialect.stamps[i] == StampKind::date && dialect.stamps[i + 1] == StampKind::clock) {
      names.insert(names.begin() + static_cast<std::ptrdiff_t>(i), std::string());
      return;
    }
}

// Splits a row of names into cells. If blanks separate cells, tries several ways until the number of cells is right.
Names header_cells(std::string_view line, Dialect const& dialect) {
  if (dialect.sheet) {
    std::vector<std::string_view> cells;
    split_row(line, dialect, cells);
    return to_names(cells);
  }
  auto names = split_names(line, dialect.delimiter);
  while (names.size() > dialect.columns && names.back().empty()) names.pop_back();
  if (names.size() + 1 == dialect.columns && line.ends_with(dialect.delimiter))
    names.emplace_back();  // the last name is empty
  if (dialect.delimiter != ' ' || names.size() == dialect.columns) return names;
  for (auto other : {names, split_bracketed(line), split_wide(line), split_names(line, '\t')}) {
    name_date_and_clock(other, dialect);
    if (other.size() == dialect.columns) return other;
  }
  return names;
}

bool is_lvm_key(std::string_view cell) {
  constexpr std::string_view keys[]{"Channels", "Samples", "X0", "Delta_X"};
  return std::ranges::find(keys, cell) != std::ranges::end(keys);
}

bool has_number(Names const& cells, Dialect const& dialect) {
  return std::ranges::any_of(
      cells, [&](auto const& cell) { return parse_cell(cell, dialect.format()).kind == CellKind::number; });
}

bool has_stamp(Names const& cells) {
  return std::ranges::any_of(cells, [](auto const& cell) { return parse_stamp(cell).has_value(); });
}

struct UnitShare {
  std::size_t units = 0;
  std::size_t filled = 0;
  bool all() const { return units > 0 && units == filled; }
  bool most() const { return units > 0 && 2 * units >= filled; }
};

UnitShare count_units(Names const& cells) {
  UnitShare share;
  for (auto const& cell : cells) {
    if (trimmed(cell).empty() || cell == "-") continue;
    ++share.filled;
    share.units += parse_unit_text(cell) ? 1u : 0u;
  }
  return share;
}

std::size_t count_filled(Names const& cells) {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells, [](auto const& cell) { return !trimmed(cell).empty(); }));
}

std::size_t count_channels(Names const& cells) {
  return static_cast<std::size_t>(std::ranges::count_if(cells, [](auto const& cell) { return names_a_channel(cell); }));
}

std::string_view without_mark(std::string_view comment) {
  comment = trimmed(comment);
  comment.remove_prefix(std::min(comment.find_first_not_of("#%"), comment.size()));
  return comment;
}

struct Candidate {
  std::size_t line;
  Names cells;
  std::size_t channels;
};

// Finds the row of names: the line that has the right number of cells and names the most channels, or the last of
// several such lines. A comment is taken only if no other line names a channel.
std::optional<Candidate> find_names(std::span<std::string_view const> above, Dialect const& dialect, Header& header) {
  std::optional<Candidate> best;
  std::optional<Candidate> comment;
  for (std::size_t i = 0; i < above.size(); ++i) {
    bool const commented = is_comment(above[i]);
    auto cells = header_cells(commented ? without_mark(above[i]) : above[i], dialect);
    auto const channels = count_channels(cells);
    if (cells.size() != dialect.columns) {
      if (channels >= 2 && cells.size() >= 2 && !commented)
        header.mismatch =
            Header::Mismatch{i, cells.size(), dialect.delimiter == ',' && dialect.columns == 2 * cells.size()};
      continue;
    }
    if (dialect.sheet && count_filled(cells) < 2) continue;  // the row holds only a title
    if (has_number(cells, dialect) || has_stamp(cells) || (best && count_units(cells).most()) ||
        count_units(cells).all())
      continue;
    auto& slot = commented ? comment : best;
    if (!slot || channels >= slot->channels) slot = Candidate{i, std::move(cells), channels};
  }
  if ((!best || best->channels == 0) && comment && comment->channels > 0) return comment;
  return best;
}

// A quick test that skips most rows of numbers, which have letters only in exponents and time stamps.
bool may_hold_names(std::string_view line) {
  char previous = ' ';
  for (char const c : line) {
    bool const letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
    bool const of_number = is_digit(previous);  // a letter after a digit, as in 2024-05-02T10:00:00Z
    if (letter && c != 'e' && c != 'E' && !of_number) return true;
    previous = c;
  }
  return false;
}

bool begins_test(std::string_view line, Dialect const& dialect, std::string_view first_names) {
  if (!may_hold_names(line)) return false;
  if (!first_names.empty() && trimmed(line) == first_names) return true;
  if (is_comment(line)) return false;
  auto const cells = header_cells(line, dialect);
  return cells.size() == dialect.columns && !has_number(cells, dialect) && count_channels(cells) >= 2;
}

std::optional<double> lvm_interval(Names const& given, Dialect const& dialect) {
  std::optional<double> interval;
  for (std::size_t k = 1; k < given.size(); ++k) {
    if (given[k].empty()) continue;
    auto const cell = parse_cell(given[k], dialect.format());
    if (cell.kind != CellKind::number || !(cell.value > 0.0) || interval.value_or(cell.value) != cell.value)
      return std::nullopt;
    interval = cell.value;
  }
  return interval;
}

// Reads the header of a LabVIEW file (.lvm). Units stand above the last end-of-header mark, names in the row below it.
bool read_lvm_header(std::span<std::string_view const> above, Dialect const& dialect, Header& header) {
  auto const opens = [](std::string_view line, std::string_view key) { return trimmed(line).starts_with(key); };
  std::optional<std::size_t> end;
  for (std::size_t i = 0; i < above.size(); ++i)
    if (opens(above[i], "***End_of_Header***")) end = i;
  if (!end) return false;
  auto names = *end + 1;
  while (names < above.size() && is_blank(above[names], dialect.delimiter)) ++names;
  if (names >= above.size()) return false;
  auto cells = split_names(above[names], dialect.delimiter);
  while (cells.size() > dialect.columns && (cells.back().empty() || lower(cells.back()) == "comment")) cells.pop_back();
  if (cells.size() != dialect.columns || lower(cells.front()) != "x_value") return false;
  bool const timed = dialect.numeric.front();
  if (!timed) cells.front().clear();  // the file says "X_Columns No": no column holds the time
  bool of_times = true;
  Names units(dialect.columns);
  for (std::size_t i = 0; i < *end; ++i) {
    auto const given = split_names(above[i], dialect.delimiter);
    bool const of_x = opens(above[i], "X_Unit_Label"), of_time = opens(above[i], "X_Dimension");
    bool const of_y = opens(above[i], "Y_Unit_Label") && given.size() == dialect.columns;
    for (std::size_t k = 1; of_y && k < given.size(); ++k) units[k] = given[k];
    if (given.size() > 1 && of_x) units[0] = given[1];
    if (given.size() > 1 && of_time && lower(given[1]) == "time" && units[0].empty()) units[0] = "s";
    if (given.size() > 1 && of_time) of_times = lower(given[1]) == "time";
    if (!timed && opens(above[i], "Delta_X")) header.interval_s = lvm_interval(given, dialect);
    if (!of_x && !of_time && !of_y && !is_blank(above[i], dialect.delimiter)) header.passed_over.push_back(i);
  }
  if (std::ranges::any_of(units, [](auto const& unit) { return !unit.empty(); })) header.units = std::move(units);
  if (!of_times) header.interval_s.reset();
  header.passed_over.push_back(*end);
  header.name_line = names;
  header.names = std::move(cells);
  return true;
}

}  // namespace

bool is_data_row(std::string_view line, Dialect const& dialect) {
  std::vector<std::string_view> cells;
  split_row(line, dialect, cells);
  if (cells.size() != dialect.columns || is_lvm_key(cells.front())) return false;
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    auto const kind = parse_cell(cells[i], dialect.format()).kind;
    bool const stamped = dialect.stamps[i] != StampKind::none && dialect.stamps[i] != StampKind::serial_number;
    bool const word = kind == CellKind::text || (kind == CellKind::stamp && !stamped);
    if (dialect.numeric[i] && word) return false;
    numbers += !word && kind != CellKind::empty ? 1u : 0u;
  }
  return numbers >= 1;
}

std::vector<std::size_t> later_tests(std::span<std::string_view const> lines, Dialect const& dialect,
                                     Header const& first) {
  std::vector<std::size_t> starts;
  auto const names = first.name_line ? trimmed(lines[*first.name_line]) : std::string_view{};
  auto last_seen = first.first_data;  // rows of numbers above this line belong to earlier tests
  for (auto i = first.first_data; i < lines.size(); ++i) {
    if (!begins_test(lines[i], dialect, names)) continue;
    auto row = i;
    while (row > last_seen && !is_data_row(lines[row - 1], dialect)) --row;
    if (row > last_seen) starts.push_back(row);  // the lines above the names belong to the new test
    last_seen = i + 1;
  }
  return starts;
}

Header recognise_header(std::span<std::string_view const> lines, Dialect const& dialect) {
  Header header;
  header.stamps = dialect.stamps;
  while (header.first_data < lines.size() &&
         (is_comment(lines[header.first_data]) || !is_data_row(lines[header.first_data], dialect)))
    ++header.first_data;
  if (read_lvm_header(lines.first(header.first_data), dialect, header)) return header;
  auto const names = find_names(lines.first(header.first_data), dialect, header);
  if (names) {
    header.name_line = names->line;
    header.names = names->cells;
    header.mismatch.reset();
  }
  for (std::size_t i = 0; i < header.first_data; ++i) {
    if (i == header.name_line || is_blank(lines[i], dialect.delimiter)) continue;
    auto const cells = header_cells(is_comment(lines[i]) ? without_mark(lines[i]) : lines[i], dialect);
    bool const right_size = cells.size() == dialect.columns;
    if (right_size && !header.unit_line &&
        (names ? i > names->line && count_units(cells).most() : count_units(cells).all())) {
      header.unit_line = i;
      header.units = cells;
    } else if (right_size && names && i > names->line && has_number(cells, dialect) && !is_comment(lines[i])) {
      header.first_data = i;  // a damaged row of numbers: Table::read() complains about it
    } else if (!is_comment(lines[i])) {
      header.passed_over.push_back(i);
    }
  }
  return header;
}

std::string column_text(std::size_t index, Header const& header) {
  // header.names is empty if all variables have empty names.
  if (header.by_name && !header.names.empty()) return "variable " + in_quotes(header.names[index]);
  auto const label = header.lettered ? column_letters(index) : std::to_string(index + 1);
  if (header.names.empty() || header.names[index].empty()) return "column " + label;
  return fmt::format("column {} {}", label, in_quotes(header.names[index]));
}

std::string column_key(std::size_t index, Header const& header) {
  auto const number = std::to_string(index + 1);
  if (header.names.empty()) return number;
  auto const& text = header.names[index];
  bool const plain = is_printable(text) && !text.empty() && text.find_first_of(",=\"") == std::string::npos &&
                     text.find_first_not_of("0123456789") != std::string::npos && lower(text) != "none";
  return plain && std::ranges::count(header.names, text) == 1 ? text : number;
}

std::string option_key(std::size_t index, Header const& header) {
  if (header.by_name) return column_key(index, header);
  auto const number = std::to_string(index + 1);
  auto const letters = column_letters(index);
  bool const is_name = std::ranges::find(header.names, letters) != header.names.end();
  return header.lettered && !is_name ? letters : number;
}

std::string column_letters(std::size_t index) {
  std::string letters;
  for (++index; index > 0; index = (index - 1) / 26)
    letters.insert(letters.begin(), static_cast<char>('A' + (index - 1) % 26));
  return letters;
}

std::optional<std::size_t> letters_column(std::string_view letters) {
  constexpr std::size_t longest = 3;
  if (letters.empty() || letters.size() > longest) return std::nullopt;
  std::size_t number = 0;
  for (char const c : letters) {
    char const capital = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (capital < 'A' || capital > 'Z') return std::nullopt;
    number = 26 * number + static_cast<std::size_t>(capital - 'A' + 1);
  }
  return number - 1;
}

}  // namespace isolaw::data
