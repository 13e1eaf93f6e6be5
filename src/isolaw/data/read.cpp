// Joins the parts of reading: text, dialect, header, columns, then the rows, then what the values tell. Problems are
// collected as far as reading can go on; the first problem that hides the rest is thrown at once.
#include "isolaw/data/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/columns.hpp"
#include "isolaw/data/dialect.hpp"
#include "isolaw/data/header.hpp"
#include "isolaw/data/text.hpp"

namespace isolaw::data {
namespace {

constexpr std::size_t least_samples = 3;

// The rows of numbers, in the units of the file.
struct Rows {
  std::vector<RawChannel> channels;
  std::vector<std::size_t> lines;  // line number of each sample
  std::size_t comments = 0;        // comment lines among the rows
};

class RowReader {
 public:
  RowReader(std::string const& file, std::span<std::string_view const> lines, Dialect const& dialect,
            Header const& header, Columns const& columns)
      : lines_(lines),
        dialect_(dialect),
        header_(header),
        widths_(file, "rows with another number of columns"),
        numbers_(file, "cells that are no number") {
    for (auto const& [channel, column] : columns.channels) {
      rows_.channels.push_back({.channel = channel,
                                .column = column_text(column.index, header),
                                .unit = column.unit ? std::string(column.unit->symbol) : std::string(),
                                .values = {}});
      rows_.channels.back().values.reserve(lines.size() - header.first_data);
      indices_.push_back(column.index);
    }
    rows_.lines.reserve(lines.size() - header.first_data);
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
    split_cells(lines_[i], dialect_.delimiter, cells_);
    if (cells_.size() != dialect_.columns) {
      if (!is_blank(lines_[i], dialect_.delimiter)) report_width(i);
      return;
    }
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
    rows_.lines.push_back(i + 1);
  }

  bool repeats_header(std::size_t i) const { return header_.name_line && lines_[i] == lines_[*header_.name_line]; }

  void report_width(std::size_t i) {
    widths_.add(i + 1, fmt::format("{} columns: {}", cells_.size(), in_quotes(lines_[i])),
                fmt::format("{} columns, as in most rows", dialect_.columns), "remove the line, or put '#' before it");
  }

  void report_cell(std::size_t i, std::size_t k, std::string_view cell, CellKind kind) {
    auto const& column = rows_.channels[k].column;
    if (repeats_header(i))
      numbers_.add(i + 1, "the header is repeated: several tests in one file", "one test per file",
                   "split the file here");
    else if (kind == CellKind::grouped)
      numbers_.add(i + 1, fmt::format("{} in {} has thousands separators", in_quotes(cell), column),
                   fmt::format("a number with a decimal {} and no other separator", decimal_name(dialect_.decimal)),
                   "export without digit grouping");
    else if (kind == CellKind::not_finite)
      numbers_.add(i + 1, fmt::format("{} in {} is not a finite number", in_quotes(cell), column), "a finite number",
                   "cut the record before this line, or test again");
    else if (kind == CellKind::empty)
      numbers_.add(i + 1, column + " is empty", "a number", "remove the line, or put '#' before it");
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

// --- sentences ------------------------------------------------------------------------------------------------------

std::string line_list(std::vector<std::size_t> const& lines) {
  constexpr std::size_t shown = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, lines.size()); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", lines[i] + 1);
  return lines.size() > shown ? text + fmt::format(" and {} more", lines.size() - shown) : text;
}

void describe_text(Lines const& text, std::vector<std::string>& recognised) {
  if (text.byte_order_mark) recognised.push_back("a UTF-8 byte order mark is left out");
  if (text.windows_1252) recognised.push_back("bytes that are no UTF-8 are read as Windows-1252");
}

void describe_header(Header const& header, std::vector<std::string>& recognised) {
  if (header.name_line)
    recognised.push_back(
        fmt::format("line {} is the header{}", *header.name_line + 1,
                    header.unit_line ? fmt::format(", line {} gives the units", *header.unit_line + 1) : ""));
  else
    recognised.push_back(header.unit_line
                             ? fmt::format("line {} gives the units; no line names the columns", *header.unit_line + 1)
                             : "no line names the columns");
  if (!header.passed_over.empty())
    recognised.push_back(fmt::format("above the data, line {} {} passed over", line_list(header.passed_over),
                                     header.passed_over.size() == 1 ? "is" : "are"));
}

void describe_rows(Rows const& rows, TestRecord const& record, std::vector<std::string>& recognised) {
  recognised.push_back(
      fmt::format("{} samples, lines {} to {}", rows.lines.size(), rows.lines.front(), rows.lines.back()));
  if (rows.comments > 0)
    recognised.push_back(fmt::format("{} comment lines among the rows are passed over", rows.comments));
  if (!record.has_time()) {
    recognised.push_back("no time column: rate-dependent laws need --dt SECONDS, the sampling interval");
    return;
  }
  double const mean = (record.time_s.back() - record.time_s.front()) / static_cast<double>(record.size() - 1);
  recognised.push_back(fmt::format("sampling interval {:.6g} s ({:.6g} Hz){}", mean, 1.0 / mean,
                                   record.layout.dt_s ? ", as asked for" : ", on average over the time column"));
}

// --- assembly -------------------------------------------------------------------------------------------------------

void check_interval(std::string const& file, ReadOptions const& options, Header const& header, Columns const& columns,
                    std::vector<Complaint>& complaints) {
  if (!options.dt_s) return;
  if (!(*options.dt_s >= 1e-9 && *options.dt_s <= 1e6))
    complaints.push_back({"--dt", fmt::format("{}", *options.dt_s), "a positive number of seconds, 1e-9 to 1e6", {}});
  if (auto const time = columns.channels.find(Channel::time); time != columns.channels.end())
    complaints.push_back(
        {file,
         fmt::format("--dt {} is given, but {} is the time", *options.dt_s, column_text(time->second.index, header)),
         "--dt for a file without a time column", "leave --dt out, or leave the column out with --columns time=none"});
}

// The name where it says which column it is and an option can hold it, else the number.
std::string column_key(std::size_t index, Header const& header) {
  auto const number = std::to_string(index + 1);
  if (header.names.empty()) return number;
  auto const& text = header.names[index];
  bool const plain = is_printable(text) && !text.empty() && text.find_first_of(",=\"") == std::string::npos &&
                     text.find_first_not_of("0123456789") != std::string::npos && lower(text) != "none";
  return plain && std::ranges::count(header.names, text) == 1 ? text : number;
}

Layout resolved_layout(Columns const& columns, Header const& header, ReadOptions const& options) {
  Layout layout{.columns = {}, .units = {}, .dt_s = options.dt_s, .flip_force = options.flip_force};
  for (auto const& [channel, column] : columns.channels) {
    layout.columns[channel] = column_key(column.index, header);
    if (column.unit) layout.units[channel] = column.unit->symbol;
  }
  for (auto const& [channel, wanted] : options.columns)  // "none"
    if (!columns.channels.contains(channel)) layout.columns[channel] = wanted;
  return layout;
}

std::string exchange_advice(Columns const& columns) {
  auto const& disp = columns.channels.at(Channel::disp);
  auto const& force = columns.channels.at(Channel::force);
  return fmt::format("--columns disp={},force={} --units disp={},force={}, with the units these columns have",
                     force.index + 1, disp.index + 1, disp.unit->symbol, force.unit->symbol);
}

std::vector<double> in_record_units(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

void store_channels(Rows& rows, Columns const& columns, TestRecord& record) {
  for (auto& raw : rows.channels) {
    auto values = in_record_units(std::move(raw.values), columns.channels.at(raw.channel).unit->in_record_units);
    switch (raw.channel) {
      case Channel::time:
        record.time_s = std::move(values);
        break;
      case Channel::disp:
        record.disp_mm = std::move(values);
        break;
      case Channel::force:
        record.force_kN = std::move(values);
        break;
      case Channel::load:
        record.load_kN = std::move(values);
        break;
    }
  }
  if (record.layout.dt_s)
    for (std::size_t i = 0; i < record.size(); ++i)
      record.time_s.push_back(static_cast<double>(i) * *record.layout.dt_s);
  if (!record.layout.flip_force) return;
  for (double& value : record.force_kN) value = -value;
  record.recognised.push_back("the force is multiplied by -1, as asked for");
}

void append(std::vector<std::string>& sentences, std::vector<std::string> const& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
}

Dialect require_dialect(std::string const& file, std::span<std::string_view const> lines) {
  auto dialect = recognise_dialect(lines);
  if (!dialect)
    throw Error(Complaint{.where = file,
                          .found = fmt::format("no rows of numbers in {} lines", lines.size()),
                          .allowed = "two or more columns of numbers, separated by commas, semicolons, tabs or blanks",
                          .advice = "export displacement and force as CSV"});
  return *std::move(dialect);
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

// Whole numbers separated by commas without names may be decimals with a comma: "1,5,2,0".
void check_commas(std::string const& file, Dialect const& dialect, Header const& header,
                  std::vector<Complaint>& complaints) {
  if (dialect.delimiter != ',' || dialect.decimal_seen || !header.names.empty() || header.mismatch ||
      dialect.columns % 2 != 0 || dialect.columns < 4)
    return;
  complaints.push_back({fmt::format("{}:{}", file, header.first_data + 1),
                        fmt::format("{} columns of whole numbers, or {} of numbers with a decimal comma: nothing tells",
                                    dialect.columns, dialect.columns / 2),
                        "a delimiter that is not the decimal separator, or a line of names",
                        "export with semicolons or tabs between the columns"});
}

}  // namespace

TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options) {
  return read_record_text(load_text(file), file.generic_string(), options);
}

TestRecord read_record_text(std::string_view bytes, std::string const& name, ReadOptions const& options) {
  TestRecord record;
  record.file = name;
  check_text(name, bytes);
  record.sha256 = sha256(bytes);
  auto const text = split_lines(bytes);
  auto const dialect = require_dialect(record.file, text.lines);
  refuse_width(record.file, dialect);
  auto const header = recognise_header(text.lines, dialect);
  auto const columns = recognise_columns(record.file, header, dialect, options);

  auto complaints = columns.complaints;
  check_commas(record.file, dialect, header, complaints);
  check_interval(record.file, options, header, columns, complaints);
  auto rows = RowReader(record.file, text.lines, dialect, header, columns).read(complaints);
  if (rows.lines.size() < least_samples && complaints.empty())
    complaints.push_back(
        {record.file, fmt::format("{} samples", rows.lines.size()), fmt::format("{} or more", least_samples), {}});
  for (auto const& raw : rows.channels) check_channel(record.file, raw, rows.lines, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));

  record.layout = resolved_layout(columns, header, options);
  describe_text(text, record.recognised);
  record.recognised.push_back(dialect.why);
  describe_header(header, record.recognised);
  append(record.recognised, columns.recognised);
  append(record.warnings, columns.warnings);
  store_channels(rows, columns, record);
  describe_rows(rows, record, record.recognised);
  check_physics(record, exchange_advice(columns), complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));
  add_warnings(record);
  return record;
}

}  // namespace isolaw::data
