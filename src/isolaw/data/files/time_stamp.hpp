// Reads dates and times of day as loggers write them, and turns them into seconds from the first of them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"

namespace isolaw::data {

enum class DateOrder { day_first, month_first };

// `serial_number` means a plain number that may be a date, stored as a number of days as in spreadsheets.
enum class StampKind { none, date_time, date, clock, serial_number };

struct Stamp {
  bool dated = false, clocked = false;
  std::optional<long> days;             // from 1970-01-01; nullopt if the order of day and month is uncertain
  int first = 0, second = 0, year = 0;  // the date as written, if `days` is nullopt
  double clock_s = 0.0;                 // from midnight in the time zone of the stamp
  std::optional<double> zone_s;         // offset of the time zone, positive east of Greenwich
};

std::string_view date_order_word(DateOrder order);  // "dmy" or "mdy"
// nullopt if the cell is no time stamp. Also parses a date of a workbook, which is written as a number of days and the
// text date_cell_mark.
std::optional<Stamp> parse_stamp(std::string_view cell);
StampKind kind_of(Stamp const& stamp);
Stamp stamp_of_serial(double days);
// MATLAB's datenum counts days from the year 0. A datenum minus this constant is a spreadsheet's day number.
inline constexpr double datenum_of_serial = 693960.0;
Stamp on_date(Stamp clock, Stamp const& date);
// Whether the text may be a date. Also true for words with a year, such as "spring 2024".
bool may_be_date(std::string_view text);
// Whether a number may be a date as spreadsheets store it, in days. Accepts the dates from 1954 to 2119.
bool may_be_serial(double value);

inline constexpr std::string_view date_cell_mark = " (a date or time of day)";

struct StampedTime {
  std::vector<double> time_s;      // seconds from the first stamp
  std::optional<double> origin_s;  // the first stamp in s: from 1970 if dated, else from midnight
  bool dated = false;
  std::vector<std::string> sentences;  // how the stamps were read, in words
};

// `lines` are the line numbers of the stamps. If the time cannot be determined, returns nothing and adds a complaint.
StampedTime seconds_of(std::span<Stamp const> stamps, std::span<std::size_t const> lines, std::string const& where,
                       std::string_view row, std::optional<DateOrder> order, std::vector<Complaint>& complaints);

}  // namespace isolaw::data
