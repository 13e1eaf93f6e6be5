#include "isolaw/data/files/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {

StampKind NumberColumn::kind() const {
  if (datenum) return StampKind::serial_number;
  if (stamps.empty() || stamps.size() != values.size()) return StampKind::none;
  auto const first = kind_of(stamps.front());
  return std::ranges::all_of(stamps, [&](auto const& stamp) { return kind_of(stamp) == first; }) ? first
                                                                                                 : StampKind::none;
}

NumberTable::NumberTable(std::string place, std::vector<NumberColumn> columns, std::string_view row,
                         std::string recognised, std::string title)
    : Table(std::move(place)), list_(std::move(columns)), recognised_(std::move(recognised)) {
  title_ = std::move(title);
  columns_ = list_.size();
  header_.row = row;
  bool const named = std::ranges::any_of(list_, [](auto const& column) { return !column.name.empty(); });
  bool const units = std::ranges::any_of(list_, [](auto const& column) { return !column.unit.empty(); });
  for (auto const& column : list_) {
    if (named) header_.names.push_back(column.name);
    if (units) header_.units.push_back(column.unit);
    header_.stamps.push_back(column.kind());
  }
}

void NumberTable::check_lengths(ChannelColumns const& columns, std::vector<Complaint>& complaints) const {
  std::vector<std::string> texts;
  bool equal = true;
  for (auto const& [channel, column] : columns) {
    equal = equal && list_[column.index].length == list_[columns.begin()->second.index].length;
    texts.push_back(fmt::format("{} has {} values", column_text(column.index, header_), list_[column.index].length));
  }
  if (!equal)
    complaints.push_back({place_, fmt::format("the channels differ in length: {}", fmt::join(texts, ", ")),
                          "columns of equal length",
                          "--columns time=...,disp=...,force=... with columns that belong together"});
}

void NumberTable::report_odd(std::size_t column, RawChannel const& raw, RowChoice const& choice,
                             std::vector<Complaint>& complaints) const {
  FirstComplaints findings(place_of(column), "values that are no number");
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < raw.values.size(); ++i)
    if (!std::isfinite(raw.values[i]) && choice.contains(i + 1)) rows.push_back(i + 1);
  if (rows.empty()) return;
  auto const leave_out = without_rows(choice.range, rows, raw.values.size());
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    if (std::isfinite(raw.values[i]) || !choice.contains(i + 1)) continue;
    auto const odd = list_[column].odd_cells.find(i);
    if (odd == list_[column].odd_cells.end() && choice.missing != MissingValues::refused) continue;
    if (odd != list_[column].odd_cells.end() && parse_stamp(odd->second))
      findings.add(i + 1, fmt::format("{} in {} is a time stamp", in_quotes(odd->second), raw.column),
                   "numbers, or time stamps of one kind in the whole column", "--columns time=none --dt SECONDS");
    else if (odd != list_[column].odd_cells.end())
      findings.add(i + 1, fmt::format("{} in {} is not a number", in_quotes(odd->second), raw.column), "a number",
                   leave_out);
    else
      findings.add(i + 1, fmt::format("'{}' in {} is not a finite number", raw.values[i], raw.column),
                   "a finite number", leave_out + std::string(or_missing));
  }
  findings.append_to(complaints);
}

std::vector<Stamp> NumberTable::stamps_of(Column const& column, std::vector<Complaint>& complaints) const {
  auto const& own = list_[column.index];
  if (own.datenum) {
    std::vector<Stamp> stamps;
    for (double const days : values(column.index)) {
      double const serial = days - datenum_of_serial;
      if (!may_be_serial(serial)) {
        complaints.push_back({place_of(column.index), fmt::format("{} is no day of a test", days),
                              "days of MATLAB's datenum, 1954 to 2119", "--columns time=none --dt SECONDS"});
        return {};
      }
      stamps.push_back(stamp_of_serial(serial));
    }
    return stamps;
  }
  auto stamps = own.stamps;
  if (!column.date_column) return stamps;
  auto const& dates = list_[*column.date_column].stamps;
  for (std::size_t i = 0; i < std::min(stamps.size(), dates.size()); ++i) stamps[i] = on_date(stamps[i], dates[i]);
  return stamps;
}

Rows NumberTable::read(ChannelColumns const& columns, RowChoice const& choice,
                       std::vector<Complaint>& complaints) const {
  Rows rows;
  auto const before = complaints.size();
  check_lengths(columns, complaints);
  for (auto const& [channel, column] : columns)
    if (list_[column.index].length > most_lines) {
      complaints.push_back({place_, fmt::format("{} values", list_[column.index].length),
                            fmt::format("{} or fewer", most_lines), "thin the record, every tenth value for example"});
      break;
    }
  if (complaints.size() > before) return rows;
  std::vector<Stamp> stamps;
  for (auto const& [channel, column] : columns) {
    bool const stamped = column.stamp != StampKind::none;
    if (stamped) stamps = stamps_of(column, complaints);
    rows.channels.push_back(
        {.channel = channel,
         .column = column_text(column.index, header_),
         .unit = column.unit ? std::string(column.unit->symbol) : std::string(),
         .values = stamped ? std::vector<double>(list_[column.index].length, 0.0) : values(column.index)});
    if (!stamped) report_odd(column.index, rows.channels.back(), choice, complaints);
  }
  auto const length = rows.channels.empty() ? 0 : rows.channels.front().values.size();
  rows.rows_in_file = length;
  for (std::size_t i = 0; i < length; ++i) {
    auto const is_finite = [&](auto const& raw) { return std::isfinite(raw.values[i]); };
    bool const may_be_missing = choice.missing != MissingValues::refused;
    if (!choice.contains(i + 1) || (!may_be_missing && !std::ranges::all_of(rows.channels, is_finite))) continue;
    for (auto& raw : rows.channels) raw.values[rows.numbers.size()] = raw.values[i];
    rows.numbers.push_back(i + 1);
  }
  for (auto& raw : rows.channels) raw.values.resize(rows.numbers.size());
  if (stamps.size() != length || complaints.size() > before) return rows;
  for (std::size_t i = 0; i < rows.numbers.size(); ++i) stamps[i] = stamps[rows.numbers[i] - 1];
  stamps.resize(rows.numbers.size());
  for (auto& raw : rows.channels) {
    if (columns.at(raw.channel).stamp == StampKind::none || stamps.empty()) continue;
    auto time = seconds_of(stamps, rows.numbers, place_, header_.row, choice.date_order, complaints);
    raw.values = std::move(time.time_s);
    rows.origin_s = time.origin_s;
    rows.dated = time.dated;
    for (auto const& sentence : time.sentences)
      rows.recognised.push_back(decision(FindingKind::time_scale, raw.column + ", " + sentence));
  }
  return rows;
}

}  // namespace isolaw::data
