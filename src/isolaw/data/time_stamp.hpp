// Reads dates and times of day as loggers write them, as seconds from the first of them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/record.hpp"

namespace isolaw::data {

// serial_number: unmarked numbers that may be days of a spreadsheet's calendar.
enum class StampKind { none, date_time, date, clock, serial_number };

struct Stamp {
  bool dated = false, clocked = false;
  std::optional<long> days;             // since 1970-01-01, if the order of the date is certain
  int first = 0, second = 0, year = 0;  // else day and month as they are written
  double clock_s = 0.0;                 // from midnight, in the time zone written
  std::optional<double> zone_s;         // east of Greenwich
};

std::string_view date_order_word(DateOrder order);  // "dmy"
// nullopt if the cell is no time stamp. A cell that a workbook shows as a date carries `date_cell_mark`.
std::optional<Stamp> parse_stamp(std::string_view cell);
StampKind kind_of(Stamp const& stamp);
Stamp stamp_of_serial(double days);
// MATLAB counts days from the year 0: its datenum minus this number is a spreadsheet's day.
inline constexpr double datenum_of_serial = 693960.0;
Stamp on_date(Stamp clock, Stamp const& date);
// True also for words with a year ("spring 2024").
bool may_be_date(std::string_view text);
// Whether a number may be a spreadsheet's day, from 1954 to 2119.
bool may_be_serial(double value);

inline constexpr std::string_view date_cell_mark = " (a date or time of day)";

struct StampedTime {
  std::vector<double> time_s;      // from the first stamp
  std::optional<double> origin_s;  // the first stamp: since 1970 if dated, else since midnight
  bool dated = false;
  std::vector<std::string> sentences;  // the decisions, in words
};

// `lines` are the places of the stamps in messages. The time is empty, with a complaint, if it cannot be determined.
StampedTime seconds_of(std::span<Stamp const> stamps, std::span<std::size_t const> lines, std::string const& where,
                       std::string_view row, std::optional<DateOrder> order, std::vector<Complaint>& complaints);

}  // namespace isolaw::data
