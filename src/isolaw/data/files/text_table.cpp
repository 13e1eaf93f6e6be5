#include "isolaw/data/files/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <ranges>
#include <span>

#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/device_facts.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/exporter.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

struct Page {
  // The text that `text.lines` points into, if it is not the file's own bytes: rows of a worksheet, or a text that was
  // converted to UTF-8.
  std::string owned;
  Lines text;
  Dialect dialect;
  std::optional<Exporter> exporter = {};
};

class RowReader {
 public:
  RowReader(std::string const& place, Page const& page, std::size_t end, Header const& header,
            ChannelColumns const& columns, RowChoice const& choice)
      : place_(place),
        lines_(std::span(page.text.lines).first(end)),
        dialect_(page.dialect),
        header_(header),
        choice_(choice),
        widths_(place, "rows with another number of columns"),
        numbers_(place, "cells that are no number") {
    for (auto const& [channel, column] : columns) {
      rows_.channels.push_back({.channel = channel,
                                .column = column_text(column.index, header),
                                .unit = column.unit ? std::string(column.unit->symbol) : std::string(),
                                .values = {}});
      rows_.channels.back().values.reserve(lines_.size() - header.first_data);
      if (column.stamp != StampKind::none) {
        stamped_ = indices_.size();
        serial_ = column.stamp == StampKind::serial_number;
        date_column_ = column.date_column;
      }
      indices_.push_back(column.index);
    }
    rows_.numbers.reserve(lines_.size() - header.first_data);
    row_.resize(indices_.size());
  }

  Rows read(std::vector<Complaint>& complaints) {
    take_footer_off(complaints);
    for (auto i = header_.first_data; i < lines_.size(); ++i) {
      if (is_comment(lines_[i])) {
        ++rows_.comments;
        continue;
      }
      if (is_blank(lines_[i], dialect_.delimiter)) continue;
      ++rows_.rows_in_file;
      if (choice_.contains(rows_.rows_in_file)) read_line(i);
    }
    widths_.append_to(complaints);
    numbers_.append_to(complaints);
    read_stamps(complaints);
    return std::move(rows_);
  }

 private:
  // Removes text below the rows, such as statistics or a signature. Complains of this text unless the user gave the
  // option --footer skip or the last row to read (--rows).
  void take_footer_off(std::vector<Complaint>& complaints) {
    auto const is_open = [&](std::size_t i) {
      return is_comment(lines_[i]) || is_blank(lines_[i], dialect_.delimiter);
    };
    auto first = lines_.size(), end = lines_.size();
    std::size_t count = 0;
    for (auto i = lines_.size(); i > header_.first_data && count <= longest_footer; --i) {
      if (is_open(i - 1)) continue;
      if (!is_footer_line(lines_[i - 1])) break;
      first = i - 1;
      ++count;
    }
    if (count == 0 || count > longest_footer || 2 * count > end - header_.first_data) {
      if (choice_.skip_footer)
        rows_.recognised.push_back(
            decision(FindingKind::rows_read, "there is no text below the rows to skip (--footer skip)", "--footer"));
      return;
    }
    while (end > first && is_open(end - 1)) --end;
    lines_ = lines_.first(first);
    auto const where = count == 1 ? fmt::format("{} {}", header_.row, first + 1)
                                  : fmt::format("{}s {} to {}", header_.row, first + 1, end);
    auto const text = in_quotes(lines_.data()[first]);
    if (choice_.skip_footer)
      rows_.recognised.push_back(
          decision(FindingKind::rows_read,
                   fmt::format("below the rows, {} {} text, {}{}, and left out (--footer skip)", where,
                               count == 1 ? "is" : "are", text, count == 1 ? "" : " and so on"),
                   "--footer"));
    else if (!choice_.range.last)  // if --rows states a last row, the text below it is left out anyway
      complaints.push_back(
          {fmt::format("{}:{}", place_, first + 1), fmt::format("text below the rows of numbers, {}: {}", where, text),
           "rows of numbers to the end of the file", "--footer skip, which leaves it out and the file as it is"});
  }

  bool is_footer_line(std::string_view line) {
    split_row(line, dialect_, cells_);
    bool const as_wide = cells_.size() == dialect_.columns;
    bool words = false, digits = false, statistics = false;
    bool first_is_word = false;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      auto const kind = parse_cell(cells_[i], dialect_.format()).kind;
      bool const word = kind == CellKind::text && names_something(cells_[i]);
      if (i == 0) first_is_word = word || kind == CellKind::empty;
      words = words || word;
      digits = digits || cells_[i].find_first_of("0123456789") != std::string_view::npos;
      statistics = statistics || (word && is_statistic(cells_[i]));
    }
    // A line with one number may be a count of rows, which is text, or a broken row of the table. It is taken as text
    // only with --footer skip.
    if (!as_wide) return words || !digits || (choice_.skip_footer && cells_.size() == 1);
    if (statistics) return true;
    auto const reads = std::ranges::count_if(indices_, [&](auto k) { return is_value(cells_[k]); });
    if (static_cast<std::size_t>(reads) == indices_.size()) return false;
    // In a worksheet, a cell without a value may hold an error such as #DIV/0!, so this row may be a sample.
    if (dialect_.sheet && reads > 0) return false;
    return (first_is_word && words) || !digits;
  }

  bool is_value(std::string_view cell) const {
    auto const kind = parse_cell(cell, dialect_.format()).kind;
    return kind == CellKind::number || kind == CellKind::not_finite || kind == CellKind::grouped ||
           kind == CellKind::stamp;
  }

  static bool names_something(std::string_view cell) {
    auto const letter = [](char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80; };
    for (std::size_t i = 1; i < cell.size(); ++i)
      if (letter(cell[i - 1]) && letter(cell[i])) return true;
    return false;
  }

  static bool is_statistic(std::string_view cell) {
    constexpr std::string_view names[]{"max",      "min",     "mean",     "average", "avg",        "std",
                                       "stdev",    "sum",     "total",    "maximum", "minimum",    "rms",
                                       "media",    "massimo", "minimo",   "mittel",  "mittelwert", "moyenne",
                                       "ortalama", "count",   "std. dev", "range",   "end of data"};
    auto text = lower(without_accents(trimmed(cell)));
    while (!text.empty() && (text.back() == ':' || text.back() == '.' || text.back() == ' ')) text.pop_back();
    return std::ranges::find(names, text) != std::ranges::end(names);
  }

  void read_stamps(std::vector<Complaint>& complaints) {
    if (!stamped_ || !complaints.empty()) return;
    auto const& column = rows_.channels[*stamped_].column;
    auto time = seconds_of(stamps_, rows_.numbers, place_, header_.row, choice_.date_order, complaints);
    rows_.channels[*stamped_].values = std::move(time.time_s);
    rows_.origin_s = time.origin_s;
    rows_.dated = time.dated;
    for (auto& sentence : time.sentences)
      rows_.recognised.push_back(decision(FindingKind::time_scale, column + ", " + std::move(sentence)));
  }

  std::optional<Stamp> stamp_of(std::size_t k) const {
    auto const cell = cells_[indices_[k]];
    if (serial_) {
      auto const parsed = parse_cell(cell, dialect_.format());
      if (parsed.kind != CellKind::number) return std::nullopt;
      return stamp_of_serial(parsed.value);
    }
    auto stamp = parse_stamp(cell);
    if (!stamp) return std::nullopt;
    if (date_column_) {
      auto const date = parse_stamp(cells_[*date_column_]);
      if (!date || !date->dated || !stamp->clocked) return std::nullopt;
      stamp = on_date(*stamp, *date);
    }
    if (!stamps_.empty() && stamp->dated != stamps_.front().dated) return std::nullopt;
    return stamp;
  }

  void read_line(std::size_t i) {
    split_row(lines_[i], dialect_, cells_);
    if (cells_.size() != dialect_.columns) {
      report_width(i);
      return;
    }
    bool good = true;
    std::optional<Stamp> stamp;
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      auto const cell = cells_[indices_[k]];
      if (k == stamped_) {
        stamp = stamp_of(k);
        if (stamp) continue;
        if (good)
          numbers_.add(
              i + 1,
              fmt::format("{} in {} is no date and time like the others", in_quotes(cell), rows_.channels[k].column),
              "time stamps of one kind", leave_out());
        good = false;
        continue;
      }
      auto const parsed = parse_cell(cell, dialect_.format());
      row_[k] = parsed.value;
      if (parsed.kind == CellKind::number) continue;
      if (may_be_missing(parsed.kind)) {
        row_[k] = std::numeric_limits<double>::quiet_NaN();
        continue;
      }
      if (good) report_cell(i, k, cell, parsed.kind);  // reports only the first bad cell of a row
      good = false;
    }
    if (!good) return;
    for (std::size_t k = 0; k < row_.size(); ++k)
      if (k != stamped_) rows_.channels[k].values.push_back(row_[k]);
    if (stamp) stamps_.push_back(*stamp);
    rows_.numbers.push_back(i + 1);
  }

  bool may_be_missing(CellKind kind) const {
    return choice_.missing != MissingValues::refused && (kind == CellKind::empty || kind == CellKind::not_finite);
  }

  // Advises what to do about rows that cannot be read. The first call looks for such rows in the whole table, and later
  // calls return the same advice.
  std::string const& leave_out() {
    if (!advice_.empty()) return advice_;
    std::size_t count = 0;
    std::vector<std::size_t> bad;
    std::vector<std::string_view> cells;
    for (auto i = header_.first_data; i < lines_.size(); ++i)
      if (is_row(i) && choice_.contains(++count) && !is_good(i, cells)) bad.push_back(count);
    return advice_ = bad.empty() ? without_row(choice_.range, rows_.rows_in_file, count)
                                 : without_rows(choice_.range, bad, count);
  }
  bool is_good(std::size_t i, std::vector<std::string_view>& cells) const {
    split_row(lines_[i], dialect_, cells);
    if (cells.size() != dialect_.columns) return false;
    for (std::size_t k = 0; k < indices_.size(); ++k)
      if (k != stamped_) {
        auto const kind = parse_cell(cells[indices_[k]], dialect_.format()).kind;
        if (kind != CellKind::number && !may_be_missing(kind)) return false;
      }
    return true;
  }
  bool is_row(std::size_t i) const { return !is_comment(lines_[i]) && !is_blank(lines_[i], dialect_.delimiter); }

  void report_width(std::size_t i) {
    widths_.add(i + 1, fmt::format("{}: {}", counted(cells_.size(), "column"), in_quotes(lines_[i])),
                fmt::format("{} columns, as in most rows", dialect_.columns), leave_out());
  }

  void report_cell(std::size_t i, std::size_t k, std::string_view cell, CellKind kind) {
    auto const& column = rows_.channels[k].column;
    if (kind == CellKind::grouped && !dialect_.sheet)
      numbers_.add(i + 1, fmt::format("{} in {} has thousands separators", in_quotes(cell), column),
                   fmt::format("a number with a decimal {} and no other separator", decimal_name(dialect_.decimal)),
                   fmt::format("--thousands {}", group_in(cell, dialect_.decimal)->shell_text));
    else if (kind == CellKind::not_finite)
      numbers_.add(i + 1, fmt::format("{} in {} is not a finite number", in_quotes(cell), column), "a finite number",
                   leave_out() + std::string(or_missing));
    else if (kind == CellKind::empty)
      numbers_.add(i + 1, column + " is empty", "a number", leave_out() + std::string(or_missing));
    else if (dialect_.sheet)
      numbers_.add(i + 1,
                   fmt::format("{} in {} is {}, not a number", in_quotes(cell), column,
                               kind == CellKind::stamp ? "a date or time of day" : "text"),
                   "a number", leave_out());
    else if (auto const other = grouped_otherwise(cell))
      numbers_.add(i + 1,
                   fmt::format("{} in {} is no number with a decimal {}", in_quotes(cell), column,
                               decimal_name(dialect_.decimal)),
                   "one decimal sign in the whole file",
                   fmt::format("--thousands {}, if that mark groups the digits", *other));
    else
      numbers_.add(i + 1, fmt::format("{} in {} is not a number", in_quotes(cell), column),
                   fmt::format("a number with a decimal {}", decimal_name(dialect_.decimal)), leave_out());
  }

  std::optional<std::string_view> grouped_otherwise(std::string_view cell) {
    char const other = dialect_.decimal == ',' ? '.' : ',';
    if (dialect_.thousands != '\0') return std::nullopt;
    bool const in_groups = parse_cell(cell, {dialect_.decimal, other}).kind == CellKind::number;
    if (in_groups) return digit_group(other).shell_text;
    auto const kind = parse_cell(cell, {other, dialect_.decimal}).kind;
    if (kind != CellKind::number || !all_in_threes()) return std::nullopt;
    return digit_group(dialect_.decimal).shell_text;
  }
  bool all_in_threes() {
    if (!in_threes_) in_threes_ = look_for_threes();
    return *in_threes_;
  }
  bool look_for_threes() const {
    constexpr std::size_t looked_at = 500;
    std::vector<std::string_view> cells;
    std::size_t seen = 0;
    auto const end = std::min(lines_.size(), header_.first_data + looked_at);
    for (auto i = header_.first_data; i < end; ++i) {
      split_row(lines_[i], dialect_, cells);
      if (cells.size() != dialect_.columns) continue;
      for (auto const k : indices_) {
        auto const at = cells[k].find(dialect_.decimal);
        if (at == std::string_view::npos || parse_cell(cells[k], dialect_.decimal).kind != CellKind::number) continue;
        if (cells[k].size() - at != 4) return false;
        ++seen;
      }
    }
    return seen > 0;
  }

  static constexpr std::size_t longest_footer = 200;
  std::string const& place_;
  std::span<std::string_view const> lines_;
  Dialect const& dialect_;
  Header const& header_;
  RowChoice const& choice_;
  std::optional<std::size_t> stamped_;      // position in `indices_` of the channel that is read from time stamps
  bool serial_ = false;                     // the stamps are numbers of days, as spreadsheets store dates
  std::optional<std::size_t> date_column_;  // the column that holds the dates if the stamps are times of day
  std::vector<Stamp> stamps_;
  std::optional<bool> in_threes_;
  std::vector<std::size_t> indices_;  // columns of the wanted channels
  std::string advice_;                // the text that leave_out() returns
  std::vector<std::string_view> cells_;
  std::vector<double> row_;
  Rows rows_;
  FirstComplaints widths_;
  FirstComplaints numbers_;
};

std::string line_list(std::vector<std::size_t> const& lines) {
  constexpr std::size_t shown = 6;
  auto const number = [](std::size_t line) { return std::to_string(line + 1); };
  auto const text = joined(lines | std::views::take(shown) | std::views::transform(number));
  return lines.size() > shown ? text + fmt::format(" and {} more", lines.size() - shown) : text;
}

class TextTable : public Table {
 public:
  TextTable(std::string place, std::shared_ptr<Page const> page, std::size_t begin, std::size_t end)
      : Table(std::move(place)), page_(std::move(page)), end_(end) {
    header_ = recognise_header(std::span(page_->text.lines).subspan(begin, end - begin), page_->dialect);
    header_.first_data += begin;
    for (auto* line : {&header_.name_line, &header_.unit_line})
      if (*line) **line += begin;
    for (auto& line : header_.passed_over) line += begin;
    if (header_.mismatch) header_.mismatch->line += begin;
    header_.row = page_->dialect.sheet ? "row" : "line";
    header_.lettered = page_->dialect.sheet;
    header_.own_axis = page_->exporter && page_->exporter->own_axis;
    columns_ = page_->dialect.columns;
    constexpr std::size_t most_lines_above = 1000;
    for (auto i = begin; i < std::min(header_.first_data, begin + most_lines_above); ++i)
      if (i != header_.name_line && i != header_.unit_line)
        take_device_facts(page_->text.lines[i], page_->dialect.delimiter, device_facts_);
    start_ = (header_.name_line ? *header_.name_line : header_.first_data) + 1;
  }

  std::vector<Finding> recognised() const override {
    std::vector<Finding> decisions;
    auto const decide = [&](std::string text) {
      decisions.push_back(decision(FindingKind::header_found, std::move(text)));
    };
    auto const row = header_.row;
    if (header_.name_line)
      decide(fmt::format("{} {} is the header{}", row, *header_.name_line + 1,
                         header_.unit_line ? fmt::format(", {} {} gives the units", row, *header_.unit_line + 1) : ""));
    else
      decide(header_.unit_line
                 ? fmt::format("{} {} gives the units; no {} names the columns", row, *header_.unit_line + 1, row)
                 : fmt::format("no {} names the columns", row));
    if (!header_.passed_over.empty())
      decide(fmt::format("above the data, {} {} {} passed over", row, line_list(header_.passed_over),
                         header_.passed_over.size() == 1 ? "is" : "are"));
    return decisions;
  }

  // Complains of unnamed columns of whole numbers between commas: "1,5,2,0" may be two numbers with decimal commas.
  void check(std::vector<Complaint>& complaints) const override {
    auto const& dialect = page_->dialect;
    if (dialect.delimiter != ',' || dialect.decimal_seen || !header_.names.empty() || header_.mismatch ||
        dialect.columns % 2 != 0 || dialect.columns < 4)
      return;
    complaints.push_back(
        {fmt::format("{}:{}", place_, header_.first_data + 1),
         fmt::format("{} columns of whole numbers, or {} of numbers with a decimal comma: nothing shows which",
                     dialect.columns, dialect.columns / 2),
         "a delimiter that is not the decimal separator, or a line of names",
         "export with semicolons or tabs between the columns"});
  }

  Rows read(ChannelColumns const& columns, RowChoice const& choice, std::vector<Complaint>& complaints) const override {
    return RowReader(place_, *page_, end_, header_, columns, choice).read(complaints);
  }

 private:
  std::shared_ptr<Page const> page_;
  std::size_t end_;
};

Tests tests_of(std::shared_ptr<Page const> const& page, std::string const& place) {
  std::span<std::string_view const> const lines = page->text.lines;
  auto ends = later_tests(lines, page->dialect, recognise_header(lines, page->dialect));
  ends.push_back(lines.size());
  if (ends.size() > most_tests)
    throw Error(Complaint{.where = place,
                          .found = fmt::format("{} tests, each with a row of names", ends.size()),
                          .allowed = fmt::format("{} or fewer", most_tests),
                          .advice = "split the file"});
  Tests tests;
  std::size_t begin = 0;
  for (auto const end : ends) {
    tests.tables.push_back(std::make_unique<TextTable>(place, page, begin, end));
    begin = end;
  }
  return tests;
}

bool is_one_column(std::span<std::string_view const> lines, char thousands) {
  auto const is_number = [&](std::string_view line) {
    auto const cell = std::string(trimmed(line));
    return parse_cell(cell, {'.', thousands}).kind == CellKind::number ||
           parse_cell(cell, {',', thousands}).kind == CellKind::number;
  };
  return 2 * std::ranges::count_if(lines, is_number) > static_cast<std::ptrdiff_t>(lines.size());
}

Dialect require_dialect(std::string const& file, std::span<std::string_view const> lines, TextOptions const& options) {
  if (auto dialect = recognise_dialect(lines, options.thousands)) return *std::move(dialect);
  bool const one_column = is_one_column(lines, options.thousands.value_or('\0'));
  if (one_column && options.one_column)
    if (auto dialect = one_column_dialect(lines, options.thousands)) return *std::move(dialect);
  throw Error(Complaint{
      .where = file,
      .found = one_column ? "one column of numbers" : "no rows of numbers in " + counted(lines.size(), "line"),
      .allowed = "two or more columns of numbers, separated by commas, semicolons, tabs or blanks",
      .advice =
          one_column
              ? "displacement beside force; --columns force=FILE:COLUMN where each is in a file of its own; --dt SECONDS for a motion"
              : "export displacement and force as CSV"});
}

// Whether a cell names a channel in Turkish or in a language without Latin letters. If so, the text was decoded
// correctly.
bool has_foreign_names(std::string_view utf8) {
  std::string word;
  auto const ends = [](char c) { return c == ';' || c == ',' || c == '\t' || c == '\n' || c == '\r' || c == '"'; };
  for (std::size_t i = 0; i <= utf8.size(); ++i) {
    if (i < utf8.size() && !ends(utf8[i])) {
      word += utf8[i];
      continue;
    }
    if (names_a_channel(word) && (has_turkish_letters(word) || is_translated(word))) return true;
    word.clear();
  }
  return false;
}

void refuse_width(std::string const& file, Dialect const& dialect) {
  if (dialect.columns > most_columns)
    throw Error(Complaint{
        .where = file,
        .found = fmt::format("{} columns separated by {}", dialect.columns, delimiter_name(dialect.delimiter)),
        .allowed = fmt::format("{} or fewer", most_columns),
        .advice = "export time, displacement and force alone, one sample a line"});
}

}  // namespace

Tests text_tests(std::string_view bytes, std::string const& file, TextOptions const& options) {
  auto page = std::make_shared<Page>();
  auto legacy = decode_wide(bytes);
  if (legacy) bytes = legacy->utf8;
  check_text(file, bytes);
  if (!legacy) legacy = decode_legacy(bytes, has_foreign_names);
  if (legacy) {
    page->owned = std::move(legacy->utf8);
    bytes = page->owned;
  }
  page->text = split_lines(bytes);
  page->exporter = exporter_of(page->text.lines);
  page->dialect = require_dialect(file, page->text.lines, options);
  refuse_width(file, page->dialect);
  auto tests = tests_of(page, file);
  auto const decide = [&](std::string text, std::string option = {}) {
    tests.recognised.push_back(decision(FindingKind::file_format, std::move(text), std::move(option)));
  };
  if (page->exporter) decide(fmt::format("read as: {}", page->exporter->name));
  if (page->text.byte_order_mark) decide("a UTF-8 byte order mark is left out");
  if (legacy) decide(fmt::format("the text is read as {}", legacy->encoding));
  if (page->text.windows_1252) decide("bytes that are no UTF-8 are read as Windows-1252");
  decide(page->dialect.explanation);
  if (options.thousands) {
    auto const& group = digit_group(*options.thousands);
    decide(fmt::format("digits are grouped by {} (--thousands {})", group.sentence_text, group.word), "--thousands");
  }
  return tests;
}

Tests sheet_tests(std::string rows, std::string const& place) {
  auto page = std::make_shared<Page>();
  page->owned = std::move(rows);
  page->text = split_lines(page->owned);
  auto dialect = sheet_dialect(page->text.lines);
  if (!dialect) {
    Tests none;
    constexpr std::size_t lines_read = 1000;
    for (auto const line : page->text.lines | std::views::take(lines_read))
      take_device_facts(line, '\t', none.device_facts);
    return none;
  }
  page->dialect = *std::move(dialect);
  return tests_of(page, place);
}

}  // namespace isolaw::data
