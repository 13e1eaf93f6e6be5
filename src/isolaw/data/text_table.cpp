#include "isolaw/data/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <span>

#include "isolaw/base/words.hpp"
#include "isolaw/data/dialect.hpp"
#include "isolaw/data/text.hpp"

namespace isolaw::data {
namespace {

constexpr std::size_t most_tests = 1000;

// Lines of a file, which its tests share.
struct Page {
  std::string owned;  // of a worksheet
  Lines text;
  Dialect dialect;
};

class RowReader {
 public:
  RowReader(std::string const& place, Page const& page, std::size_t end, Header const& header, Columns const& columns)
      : lines_(std::span(page.text.lines).first(end)),
        dialect_(page.dialect),
        header_(header),
        widths_(place, "rows with another number of columns"),
        numbers_(place, "cells that are no number") {
    for (auto const& [channel, column] : columns.channels) {
      rows_.channels.push_back({.channel = channel,
                                .column = column_text(column.index, header),
                                .unit = column.unit ? std::string(column.unit->symbol) : std::string(),
                                .values = {}});
      rows_.channels.back().values.reserve(lines_.size() - header.first_data);
      indices_.push_back(column.index);
    }
    rows_.numbers.reserve(lines_.size() - header.first_data);
    row_.resize(indices_.size());
  }

  Rows read(std::vector<Complaint>& complaints) {
    for (auto i = header_.first_data; i < lines_.size(); ++i) {
      if (is_comment(lines_[i]))
        ++rows_.comments;
      else
        read_line(i);
    }
    widths_.append_to(complaints);
    numbers_.append_to(complaints);
    return std::move(rows_);
  }

 private:
  void read_line(std::size_t i) {
    split_row(lines_[i], dialect_, cells_);
    if (cells_.size() != dialect_.columns) {
      if (!is_blank(lines_[i], dialect_.delimiter)) report_width(i);
      return;
    }
    if (dialect_.sheet && is_blank(lines_[i], dialect_.delimiter)) return;
    bool good = true;
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      auto const cell = cells_[indices_[k]];
      auto const parsed = parse_cell(cell, dialect_.decimal);
      row_[k] = parsed.value;
      if (parsed.kind == CellKind::number) continue;
      if (good) report_cell(i, k, cell, parsed.kind);  // one complaint per row
      good = false;
    }
    if (!good) return;
    for (std::size_t k = 0; k < row_.size(); ++k) rows_.channels[k].values.push_back(row_[k]);
    rows_.numbers.push_back(i + 1);
  }

  std::string leave_out() const { return dialect_.sheet ? "remove the row" : "remove the line, or put '#' before it"; }

  void report_width(std::size_t i) {
    widths_.add(i + 1, fmt::format("{} columns: {}", cells_.size(), in_quotes(lines_[i])),
                fmt::format("{} columns, as in most rows", dialect_.columns), leave_out());
  }

  void report_cell(std::size_t i, std::size_t k, std::string_view cell, CellKind kind) {
    auto const& column = rows_.channels[k].column;
    if (kind == CellKind::grouped)
      numbers_.add(i + 1, fmt::format("{} in {} has thousands separators", in_quotes(cell), column),
                   fmt::format("a number with a decimal {} and no other separator", decimal_name(dialect_.decimal)),
                   "export without digit grouping");
    else if (kind == CellKind::not_finite)
      numbers_.add(i + 1, fmt::format("{} in {} is not a finite number", in_quotes(cell), column), "a finite number",
                   fmt::format("cut the record before this {}, or test again", header_.row));
    else if (kind == CellKind::empty)
      numbers_.add(i + 1, column + " is empty", "a number", leave_out());
    else if (dialect_.sheet)
      numbers_.add(i + 1, fmt::format("{} in {} is text, not a number", in_quotes(cell), column), "a number",
                   "let the cell hold a number, or remove the row");
    else
      numbers_.add(i + 1, fmt::format("{} in {} is not a number", in_quotes(cell), column),
                   fmt::format("a number with a decimal {}", decimal_name(dialect_.decimal)),
                   "correct the cell, or put '#' before the line");
  }

  std::span<std::string_view const> lines_;
  Dialect const& dialect_;
  Header const& header_;
  std::vector<std::size_t> indices_;  // columns wanted
  std::vector<std::string_view> cells_;
  std::vector<double> row_;
  Rows rows_;
  Findings widths_;
  Findings numbers_;
};

std::string line_list(std::vector<std::size_t> const& lines) {
  constexpr std::size_t shown = 6;
  auto const number = [](std::size_t line) { return std::to_string(line + 1); };
  auto const text = joined(lines | std::views::take(shown) | std::views::transform(number));
  return lines.size() > shown ? text + fmt::format(" and {} more", lines.size() - shown) : text;
}

// Lines from `begin` to `end` of the page.
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
    columns_ = page_->dialect.columns;
    start_ = (header_.name_line ? *header_.name_line : header_.first_data) + 1;
  }

  std::vector<std::string> recognised() const override {
    std::vector<std::string> sentences;
    auto const row = header_.row;
    if (header_.name_line)
      sentences.push_back(
          fmt::format("{} {} is the header{}", row, *header_.name_line + 1,
                      header_.unit_line ? fmt::format(", {} {} gives the units", row, *header_.unit_line + 1) : ""));
    else
      sentences.push_back(header_.unit_line ? fmt::format("{} {} gives the units; no {} names the columns", row,
                                                          *header_.unit_line + 1, row)
                                            : fmt::format("no {} names the columns", row));
    if (!header_.passed_over.empty())
      sentences.push_back(fmt::format("above the data, {} {} {} passed over", row, line_list(header_.passed_over),
                                      header_.passed_over.size() == 1 ? "is" : "are"));
    return sentences;
  }

  // Whole numbers separated by commas without names may be decimals with a comma: "1,5,2,0".
  void check(std::vector<Complaint>& complaints) const override {
    auto const& dialect = page_->dialect;
    if (dialect.delimiter != ',' || dialect.decimal_seen || !header_.names.empty() || header_.mismatch ||
        dialect.columns % 2 != 0 || dialect.columns < 4)
      return;
    complaints.push_back(
        {fmt::format("{}:{}", place_, header_.first_data + 1),
         fmt::format("{} columns of whole numbers, or {} of numbers with a decimal comma: nothing tells",
                     dialect.columns, dialect.columns / 2),
         "a delimiter that is not the decimal separator, or a line of names",
         "export with semicolons or tabs between the columns"});
  }

  Rows read(Columns const& columns, std::vector<Complaint>& complaints) const override {
    return RowReader(place_, *page_, end_, header_, columns).read(complaints);
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

bool is_one_column(std::span<std::string_view const> lines) {
  auto const is_number = [](std::string_view line) {
    auto const cell = std::string(trimmed(line));
    return parse_cell(cell, '.').kind == CellKind::number || parse_cell(cell, ',').kind == CellKind::number;
  };
  return 2 * std::ranges::count_if(lines, is_number) > static_cast<std::ptrdiff_t>(lines.size());
}

Dialect require_dialect(std::string const& file, std::span<std::string_view const> lines) {
  if (auto dialect = recognise_dialect(lines)) return *std::move(dialect);
  bool const one_column = is_one_column(lines);
  throw Error(Complaint{
      .where = file,
      .found = one_column ? "one column of numbers" : fmt::format("no rows of numbers in {} lines", lines.size()),
      .allowed = "two or more columns of numbers, separated by commas, semicolons, tabs or blanks",
      .advice = one_column ? "write time beside displacement for a motion, displacement beside force for a test"
                           : "export displacement and force as CSV"});
}

void refuse_width(std::string const& file, Dialect const& dialect) {
  constexpr std::size_t most_columns = 1000;
  if (dialect.columns > most_columns)
    throw Error(Complaint{
        .where = file,
        .found = fmt::format("{} columns separated by {}", dialect.columns, delimiter_name(dialect.delimiter)),
        .allowed = fmt::format("{} or fewer", most_columns),
        .advice = "export time, displacement and force alone, one sample a line"});
}

}  // namespace

Tests text_tests(std::string_view bytes, std::string const& file) {
  check_text(file, bytes);
  auto page = std::make_shared<Page>();
  page->text = split_lines(bytes);
  page->dialect = require_dialect(file, page->text.lines);
  refuse_width(file, page->dialect);
  auto tests = tests_of(page, file);
  if (page->text.byte_order_mark) tests.recognised.push_back("a UTF-8 byte order mark is left out");
  if (page->text.windows_1252) tests.recognised.push_back("bytes that are no UTF-8 are read as Windows-1252");
  tests.recognised.push_back(page->dialect.why);
  return tests;
}

Tests sheet_tests(std::string rows, std::string const& place) {
  auto page = std::make_shared<Page>();
  page->owned = std::move(rows);
  page->text = split_lines(page->owned);
  auto dialect = sheet_dialect(page->text.lines);
  if (!dialect) return {};
  page->dialect = *std::move(dialect);
  return tests_of(page, place);
}

}  // namespace isolaw::data
