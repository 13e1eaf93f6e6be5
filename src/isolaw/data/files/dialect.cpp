#include "isolaw/data/files/dialect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <system_error>

#include "isolaw/base/words.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

bool is_not_finite(std::string_view cell) {
  constexpr std::array<std::string_view, 16> marks{"nan",     "inf",    "infinity", "n/a",  "na",      "#n/a",
                                                   "#nv",     "#num!",  "null",     "none", "#div/0!", "1.#inf",
                                                   "1.#qnan", "1.#ind", "--",       "---"};
  if (cell.size() > 10) return false;
  auto text = lower(cell);
  std::ranges::replace(text, ',', '.');
  std::string_view view = text;
  if (view.size() > 1 && (view.front() == '+' || (view.front() == '-' && view[1] != '-'))) view.remove_prefix(1);
  return std::ranges::find(marks, view) != marks.end() || view.starts_with("nan(");
}

struct GroupMark {
  char meant;
  std::string_view written;
};
constexpr std::array group_marks{GroupMark{'.', "."},
                                 GroupMark{',', ","},
                                 GroupMark{' ', " "},
                                 GroupMark{'\'', "'"},
                                 GroupMark{' ', "\xA0"},
                                 GroupMark{' ', "\xC2\xA0"},
                                 GroupMark{' ', "\xE2\x80\xAF"},
                                 GroupMark{'\'', "\xE2\x80\x99"}};

// Accepts "1.234,56", "1.234.567", "1 234,56", "1'234.56". Accepts "1.234" only if the user names the grouping mark.
bool is_grouped(std::string_view cell, NumberFormat format, std::string* digits = nullptr) {
  auto const whole = cell;
  char const decimal = format.decimal;
  auto const take_digits = [&cell] {
    std::size_t count = 0;
    while (count < cell.size() && is_digit(cell[count])) ++count;
    cell.remove_prefix(count);
    return count;
  };
  if (!cell.empty() && (cell.front() == '+' || cell.front() == '-')) cell.remove_prefix(1);
  bool const leading_zero = cell.starts_with('0');
  auto const lead = take_digits();
  if (lead < 1 || lead > 3 || leading_zero || cell.empty()) return false;
  std::string_view separator;
  for (auto const& [meant, written] : group_marks)
    if (cell.starts_with(written) && (format.thousands == '\0' || meant == format.thousands)) separator = written;
  if (separator.empty() || separator.front() == decimal) return false;
  int groups = 0;
  for (; cell.starts_with(separator); ++groups) {
    cell.remove_prefix(separator.size());
    if (take_digits() != 3) return false;
  }
  if (digits != nullptr) {
    digits->assign(whole.substr(0, whole.size() - cell.size()));
    for (auto at = digits->find(separator); at != std::string::npos; at = digits->find(separator, at))
      digits->erase(at, separator.size());
    digits->append(cell);
  }
  if (cell.empty()) return groups > 1 || (separator != "." && separator != ",") || format.thousands != '\0';
  if (cell.front() != decimal) return false;
  cell.remove_prefix(1);
  take_digits();
  return cell.empty();
}

Cell parse_point(char const* first, char const* last) {
  double value = 0.0;
  auto const [end, failure] = std::from_chars(first, last, value);
  if (end != last) return {.kind = CellKind::text};
  if (failure == std::errc::result_out_of_range) {
    bool const tiny = std::find(std::next(first), last, '-') != last;  // a minus sign in the exponent
    if (tiny) return {.kind = CellKind::number, .value = 0.0};
    return {.kind = CellKind::not_finite};
  }
  if (failure != std::errc{}) return {.kind = CellKind::text};
  return {.kind = CellKind::number, .value = value};
}

// std::from_chars accepts only a decimal point, so the comma is replaced in a copy on the stack.
Cell parse_comma(std::string_view cell) {
  std::array<char, 64> buffer;
  if (cell.size() > buffer.size()) return {.kind = CellKind::text};
  for (std::size_t i = 0; i < cell.size(); ++i) {
    char const c = cell[i];
    if (c == '.') return {.kind = CellKind::text};
    if (c == ',' && (i + 1 == cell.size() || !is_digit(cell[i + 1]))) return {.kind = CellKind::text};
    buffer[i] = c == ',' ? '.' : c;
  }
  return parse_point(buffer.data(), buffer.data() + cell.size());
}

struct Pair {
  char delimiter;
  char decimal;
};

struct Score {
  Pair pair{',', '.'};
  std::size_t columns = 0;
  std::size_t rows = 0;  // lines that have `columns` cells and enough numbers
  double points = 0.0;   // sum, over these lines, of numbers / cells that are not empty
};

bool number_like(CellKind kind) {
  return kind == CellKind::number || kind == CellKind::not_finite || kind == CellKind::grouped;
}

Score score_pair(std::span<std::string_view const> lines, Pair pair, char thousands = '\0', std::size_t fewest = 2) {
  struct Group {
    std::size_t rows = 0;
    double points = 0.0;
  };
  std::map<std::size_t, Group> groups;
  std::vector<std::string_view> cells;
  for (auto const line : lines) {
    split_cells(line, pair.delimiter, cells);
    std::size_t numbers = 0;
    std::size_t filled = 0;
    for (auto const cell : cells) {
      auto const kind = parse_cell(cell, {pair.decimal, thousands}).kind;
      numbers += number_like(kind) || kind == CellKind::stamp ? 1u : 0u;
      filled += kind != CellKind::empty ? 1u : 0u;
    }
    if (numbers < fewest) continue;
    auto& group = groups[cells.size()];
    ++group.rows;
    group.points += static_cast<double>(numbers) / static_cast<double>(filled);
  }
  Score best{.pair = pair};
  for (auto const& [columns, group] : groups)
    if (group.points > best.points)
      best = {.pair = pair, .columns = columns, .rows = group.rows, .points = group.points};
  return best;
}

// Whether only blanks follow the last delimiter of the line.
bool ends_with_delimiter(std::string_view line, char delimiter) {
  auto const last = line.find_last_of(delimiter);
  return last != line.npos && trimmed(line.substr(last + 1)).empty();
}

// Whether the last column is empty in most rows. Most rows then end with the delimiter, and a few have a number after
// it.
bool has_sparse_last_column(std::span<std::string_view const> lines, Score const& score, char thousands) {
  std::vector<std::string_view> cells;
  std::size_t longer = 0;
  for (auto const line : lines) {
    split_cells(line, score.pair.delimiter, cells);
    auto const is_number = [&](auto cell) {
      return number_like(parse_cell(cell, {score.pair.decimal, thousands}).kind);
    };
    if (!std::ranges::all_of(cells, is_number)) continue;
    if (cells.size() == score.columns && !ends_with_delimiter(line, score.pair.delimiter)) return false;
    longer += cells.size() == score.columns + 1 ? 1u : 0u;
  }
  return longer > 0;
}

// Returns the first 200 lines and about 800 lines spread over the file. All lines of a long file would take too long.
std::vector<std::string_view> sample_lines(std::span<std::string_view const> lines) {
  constexpr std::size_t first = 200;
  constexpr std::size_t spread = 800;
  std::vector<std::string_view> sample;
  auto const stride = std::max<std::size_t>(1, lines.size() / spread);
  for (std::size_t i = 0; i < lines.size(); i += i < first ? 1 : stride)
    if (!is_comment(lines[i]) && !trimmed(lines[i]).empty()) sample.push_back(lines[i]);
  return sample;
}

struct ColumnStudy {
  std::size_t numbers = 0;
  std::array<std::size_t, 4> stamps{};  // number of cells of each StampKind, in the order of StampKind
  bool serial = true;                   // all numbers may be dates, which a spreadsheet stores as days
  double least = 0.0, largest = 0.0;

  void take(std::string_view text, Cell const& cell) {
    if (number_like(cell.kind)) {
      ++numbers;
      serial = serial && cell.kind == CellKind::number && may_be_serial(cell.value);
      least = numbers == 1 ? cell.value : std::min(least, cell.value);
      largest = numbers == 1 ? cell.value : std::max(largest, cell.value);
    } else if (cell.kind == CellKind::stamp) {
      ++stamps[static_cast<std::size_t>(kind_of(*parse_stamp(text)))];
    }
  }
  StampKind kind(std::size_t rows) const {
    constexpr double longest_test_days = 2.0;
    auto const most = std::ranges::max_element(stamps);
    auto const all = stamps[1] + stamps[2] + stamps[3];
    if (2 * all > rows) return static_cast<StampKind>(most - stamps.begin());
    bool const moves = largest > least && largest - least < longest_test_days;
    return 2 * numbers > rows && serial && moves ? StampKind::serial_number : StampKind::none;
  }
};

void study_columns(Dialect& dialect, std::span<std::string_view const> sample, std::size_t fewest = 2) {
  std::vector<ColumnStudy> columns(dialect.columns);
  std::size_t rows = 0;
  std::vector<std::string_view> cells;
  std::vector<Cell> parsed;
  for (auto const line : sample) {
    split_row(line, dialect, cells);
    if (cells.size() != dialect.columns) continue;
    parsed.clear();
    std::size_t count = 0;
    for (auto const cell : cells) {
      parsed.push_back(parse_cell(cell, dialect.format()));
      count += number_like(parsed.back().kind) || parsed.back().kind == CellKind::stamp ? 1u : 0u;
    }
    if (count < fewest) continue;
    ++rows;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      columns[i].take(cells[i], parsed[i]);
      if (parsed[i].kind == CellKind::number && cells[i].find(dialect.decimal) != std::string_view::npos)
        dialect.decimal_seen = true;
    }
  }
  for (auto const& column : columns) {
    dialect.numeric.push_back(2 * column.numbers > rows);
    dialect.stamps.push_back(column.kind(rows));
  }
}

}  // namespace

DigitGroup const& digit_group(char mark) {
  return *std::ranges::find(digit_groups, mark, &DigitGroup::mark);
}

std::optional<DigitGroup> group_in(std::string_view cell, char decimal) {
  for (auto const& [meant, written] : group_marks)
    if (written.front() != decimal && cell.find(written) != std::string_view::npos) return digit_group(meant);
  return std::nullopt;
}

Cell parse_cell(std::string_view cell, NumberFormat format) {
  if (cell.empty()) return {};
  char const decimal = format.decimal;
  auto digits = cell;
  if (digits.front() == '+') digits.remove_prefix(1);
  Cell parsed{.kind = CellKind::text};
  if (!digits.empty() && (is_digit(digits.back()) || digits.back() == '.') && digits.front() != '+')
    parsed = decimal == '.' ? parse_point(digits.data(), digits.data() + digits.size()) : parse_comma(digits);
  if (parsed.kind != CellKind::text) return parsed;
  if (is_not_finite(cell)) return {.kind = CellKind::not_finite};
  if (std::string plain; is_grouped(cell, format, format.thousands == '\0' ? nullptr : &plain))
    return format.thousands == '\0' ? Cell{.kind = CellKind::grouped} : parse_cell(plain, decimal);
  if (parse_stamp(cell)) return {.kind = CellKind::stamp};
  return parsed;
}

void split_cells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  cells.clear();
  bool const blanks = delimiter == ' ';
  auto const is_delimiter = [&](char c) { return blanks ? c == ' ' || c == '\t' : c == delimiter; };
  std::size_t i = 0;
  auto const size = line.size();
  while (true) {
    while (i < size && (line[i] == ' ' || (line[i] == '\t' && delimiter != '\t'))) ++i;
    if (blanks && i == size) break;
    std::string_view cell;
    if (i < size && line[i] == '"') {
      auto const close = line.find('"', i + 1);
      cell = trimmed(line.substr(i + 1, close == std::string_view::npos ? close : close - i - 1));
      i = close == std::string_view::npos ? size : close + 1;
      while (i < size && !is_delimiter(line[i])) ++i;
    } else {
      auto const start = i;
      while (i < size && !is_delimiter(line[i])) ++i;
      auto end = i;
      while (end > start && (line[end - 1] == ' ' || line[end - 1] == '\t')) --end;
      cell = line.substr(start, end - start);
    }
    cells.push_back(cell);
    if (i >= size) break;
    ++i;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
}

void split_row(std::string_view line, Dialect const& dialect, std::vector<std::string_view>& cells) {
  split_cells(line, dialect.delimiter, cells);
  if (dialect.sheet) cells.resize(dialect.columns);
  if (cells.size() + 1 == dialect.columns && ends_with_delimiter(line, dialect.delimiter)) cells.emplace_back();
}

bool is_comment(std::string_view line) {
  auto const text = trimmed(line);
  return !text.empty() && (text.front() == '#' || text.front() == '%');
}

bool is_blank(std::string_view line, char delimiter) {
  return std::ranges::all_of(line, [&](char c) { return c == ' ' || c == '\t' || c == delimiter; });
}

std::string_view delimiter_name(char delimiter) {
  return delimiter == ',' ? "commas" : delimiter == ';' ? "semicolons" : delimiter == '\t' ? "tabs" : "blanks";
}

std::string_view decimal_name(char decimal) {
  return decimal == ',' ? "comma" : "point";
}

std::optional<Dialect> sheet_dialect(std::span<std::string_view const> rows) {
  auto const sample = sample_lines(rows);
  auto const score = score_pair(sample, {'\t', '.'});
  if (score.columns < 2) return std::nullopt;
  Dialect dialect;
  dialect.delimiter = '\t';
  dialect.columns = score.columns;
  dialect.sheet = true;
  study_columns(dialect, sample);
  dialect.decimal_seen = true;
  return dialect;
}

std::optional<Dialect> recognise_dialect(std::span<std::string_view const> lines, std::optional<char> thousands) {
  char const group = thousands.value_or('\0');
  auto const sample = sample_lines(lines);
  // If two pairs of delimiter and decimal sign read the file equally well, as with whole numbers, the first one wins.
  std::vector<Pair> pairs{{'\t', '.'}, {'\t', ','}, {';', '.'}, {';', ','}, {',', '.'}, {' ', '.'}, {' ', ','}};
  bool const quotes = std::ranges::any_of(sample, [](auto line) { return line.find('"') != std::string_view::npos; });
  if (quotes) pairs.push_back({',', ','});  // in "1,5","2,0" the quotes keep the two kinds of commas apart
  std::erase_if(pairs, [&](auto pair) { return pair.decimal == group || (pair.delimiter == group && !quotes); });
  Score best;
  Score second;
  for (auto const pair : pairs) {
    auto const score = score_pair(sample, pair, group);
    if (score.columns < 2) continue;
    if (score.points > best.points + 1e-9) {
      second = best;
      best = score;
    } else if (score.points > second.points) {
      second = score;
    }
  }
  if (best.columns < 2) return std::nullopt;
  Dialect dialect;
  dialect.delimiter = best.pair.delimiter;
  dialect.decimal = best.pair.decimal;
  dialect.thousands = group;
  dialect.columns = best.columns + (has_sparse_last_column(sample, best, group) ? 1 : 0);
  study_columns(dialect, sample);
  dialect.explanation = fmt::format(
      "columns are separated by {}, decimals by a {}: {} of {} lines looked at read as rows of {}",
      delimiter_name(dialect.delimiter), decimal_name(dialect.decimal), best.rows, sample.size(), dialect.columns);
  if (!dialect.decimal_seen)
    dialect.explanation += " whole numbers (no decimal separator occurs)";
  else if (second.points > 0.1 * best.points)
    dialect.explanation += fmt::format(" (next best: {} with decimal {})", delimiter_name(second.pair.delimiter),
                                       decimal_name(second.pair.decimal));
  return dialect;
}

std::optional<Dialect> one_column_dialect(std::span<std::string_view const> lines, std::optional<char> thousands) {
  char const group = thousands.value_or('\0');
  auto const sample = sample_lines(lines);
  Score best;
  for (auto const pair : {Pair{'\t', '.'}, Pair{'\t', ','}})
    if (auto const score = score_pair(sample, pair, group, 1);
        pair.decimal != group && score.columns == 1 && score.points > best.points)
      best = score;
  if (best.columns != 1) return std::nullopt;
  Dialect dialect;
  dialect.delimiter = best.pair.delimiter;
  dialect.decimal = best.pair.decimal;
  dialect.thousands = group;
  dialect.columns = 1;
  study_columns(dialect, sample, 1);
  dialect.explanation = fmt::format("one column, decimals by a {}: {} of {} lines looked at are numbers",
                                    decimal_name(dialect.decimal), best.rows, sample.size());
  return dialect;
}

}  // namespace isolaw::data
