#include "isolaw/data/files/time_stamp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "isolaw/base/words.hpp"

namespace isolaw::data {
namespace {

constexpr double day_s = 86400.0;
constexpr long spreadsheet_epoch = -25569;  // 1899-12-30 as days from 1970-01-01; spreadsheets count days from it

std::optional<long> days_of(int year, int month, int day) {
  std::chrono::year_month_day const date{std::chrono::year{year}, std::chrono::month{static_cast<unsigned>(month)},
                                         std::chrono::day{static_cast<unsigned>(day)}};
  if (month < 1 || day < 1 || !date.ok()) return std::nullopt;
  return std::chrono::sys_days{date}.time_since_epoch().count();
}
class StampText {
 public:
  explicit StampText(std::string_view text) : left_(text) {}

  bool done() const { return left_.empty(); }
  bool take(char c) {
    if (left_.empty() || left_.front() != c) return false;
    left_.remove_prefix(1);
    return true;
  }
  char next() const { return left_.empty() ? '\0' : left_.front(); }
  void skip_blanks() { left_ = trimmed(left_); }
  std::optional<int> digits(std::size_t least, std::size_t most) {
    std::size_t count = 0;
    while (count < left_.size() && is_digit(left_[count])) ++count;
    if (count < least || count > most) return std::nullopt;
    auto const value = number_in<int>(left_.substr(0, count));
    left_.remove_prefix(count);
    last_count_ = count;
    return value;
  }
  std::size_t last_count() const { return last_count_; }
  std::string word() {
    std::size_t count = 0;
    while (count < left_.size() && ((left_[count] | 0x20) >= 'a' && (left_[count] | 0x20) <= 'z')) ++count;
    auto const text = lower(left_.substr(0, count));
    left_.remove_prefix(count);
    return text;
  }
  double fraction() {
    double value = 0.0, place = 0.1;
    for (; !left_.empty() && is_digit(left_.front()); left_.remove_prefix(1), place /= 10.0)
      value += place * (left_.front() - '0');
    return value;
  }

 private:
  std::string_view left_;
  std::size_t last_count_ = 0;
};

std::optional<int> month_of(std::string const& word) {
  constexpr std::array<std::string_view, 12> names{"jan", "feb", "mar", "apr", "may", "jun",
                                                   "jul", "aug", "sep", "oct", "nov", "dec"};
  if (word.size() < 3) return std::nullopt;
  auto const found = std::ranges::find(names, std::string_view(word).substr(0, 3));
  return found == names.end() ? std::nullopt : std::optional(static_cast<int>(found - names.begin()) + 1);
}

// Reads a date, such as 2024-05-02, 2024/05/02, 20240502, 02.05.2024, 05/02/24 or 02-May-2024.
bool take_date(StampText& text, Stamp& stamp) {
  auto const lead = text.digits(1, 8);
  if (!lead) return false;
  auto const width = text.last_count();
  if (width == 8) {
    stamp.days = days_of(*lead / 10000, *lead / 100 % 100, *lead % 100);
    stamp.dated = true;
    return stamp.days && (text.next() == 'T' || text.next() == ' ' || text.next() == '_');
  }
  char const separator = text.next();
  if (separator != '-' && separator != '/' && separator != '.') return false;
  text.take(separator);
  stamp.dated = true;
  if (width == 4) {
    auto const month = text.digits(1, 2);
    if (!month || !text.take(separator)) return false;
    auto const day = text.digits(1, 2);
    stamp.days = day ? days_of(*lead, *month, *day) : std::nullopt;
    return stamp.days.has_value();
  }
  if (width > 2) return false;
  auto const month_name = month_of(text.word());
  stamp.first = *lead;
  auto const second = month_name ? month_name : text.digits(1, 2);
  if (!second || !text.take(separator)) return false;
  stamp.second = *second;
  auto const year = text.digits(2, 4);
  if (!year || text.last_count() == 3) return false;
  stamp.year = text.last_count() == 2 ? 2000 + *year : *year;
  if (month_name) stamp.days = days_of(stamp.year, *second, *lead);
  return month_name ? stamp.days.has_value()
                    : stamp.first >= 1 && stamp.second >= 1 && stamp.first <= 31 && stamp.second <= 31;
}

bool take_zone(StampText& text, Stamp& stamp) {
  text.skip_blanks();
  if (text.done()) return true;
  char const sign = text.next();
  if (sign == '+' || sign == '-') {
    text.take(sign);
    auto const digits = text.digits(1, 4);
    if (!digits) return false;
    int minutes = 0, hours = *digits;
    if (text.last_count() > 2) {
      minutes = *digits % 100;
      hours = *digits / 100;
    } else if (text.take(':')) {
      auto const rest = text.digits(2, 2);
      if (!rest) return false;
      minutes = *rest;
    }
    if (hours > 15 || minutes > 59) return false;
    stamp.zone_s = (sign == '-' ? -1.0 : 1.0) * (hours * 3600.0 + minutes * 60.0);
    return text.done();
  }
  auto const word = text.word();
  if (word != "z" && word != "utc" && word != "gmt") return false;
  stamp.zone_s = 0.0;
  return text.done();
}

// Reads a time of day, such as 10:00:00.250, 10:00:00:250, 10:00:00 PM or 59:59.5 (no hours); after a date also 10:00
// or 100000.25.
bool take_clock(StampText& text, Stamp& stamp) {
  auto const lead = text.digits(1, 6);
  if (!lead) return false;
  double hours = *lead, minutes = 0.0, seconds = 0.0;
  if (text.last_count() == 6 && stamp.dated) {
    hours = *lead / 10000;
    minutes = *lead / 100 % 100;
    seconds = *lead % 100;
    if (text.take('.') || text.take(',')) seconds += text.fraction();
  } else {
    if (text.last_count() > 2 || !text.take(':')) return false;
    auto const second = text.digits(2, 2);
    if (!second) return false;
    minutes = *second;
    if (text.take(':')) {
      auto const third = text.digits(2, 2);
      if (!third) return false;
      seconds = *third;
      if (text.take('.') || text.take(',')) {
        seconds += text.fraction();
      } else if (text.take(':')) {
        auto const thousandths = text.digits(3, 3);
        if (!thousandths) return false;
        seconds += *thousandths / 1000.0;
      }
    } else if (text.take('.') || text.take(',')) {  // 59:59.5 has minutes and seconds only
      seconds = minutes + text.fraction();
      minutes = hours;
      hours = 0.0;
    } else if (!stamp.dated) {
      return false;  // without a date, 10:30 may also be minutes and seconds
    }
  }
  text.skip_blanks();
  if (char const c = text.next(); c == 'A' || c == 'a' || c == 'P' || c == 'p') {
    auto const half = text.word();
    if ((half != "am" && half != "pm") || hours < 1.0 || hours > 12.0) return false;
    hours = std::fmod(hours, 12.0) + (half == "pm" ? 12.0 : 0.0);
  }
  bool const past_midnight = hours == 24.0 && (minutes > 0.0 || seconds > 0.0);
  if (hours > 24.0 || past_midnight || minutes > 59.0 || seconds >= 61.0) return false;
  stamp.clocked = true;
  stamp.clock_s = 3600.0 * hours + 60.0 * minutes + seconds;
  return take_zone(text, stamp);
}

// Replaces the Japanese characters for year, month, day, hour, minute and second by the usual separators.
std::string without_japanese(std::string_view cell) {
  constexpr std::pair<std::string_view, std::string_view> signs[]{{"\xE5\xB9\xB4", "-"}, {"\xE6\x9C\x88", "-"},
                                                                  {"\xE6\x97\xA5", " "}, {"\xE6\x99\x82", ":"},
                                                                  {"\xE5\x88\x86", ":"}, {"\xE7\xA7\x92", ""}};
  std::string text(cell);
  for (auto const& [sign, ordinary] : signs)
    if (auto const at = text.find(sign); at != std::string::npos) text.replace(at, sign.size(), ordinary);
  return std::string(trimmed(text));
}

std::string date_text(long days) {
  std::chrono::year_month_day const date{std::chrono::sys_days{std::chrono::days{days}}};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

std::string clock_text(double clock_s) {
  auto const thousandths = std::llround(1000.0 * clock_s);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", thousandths / 3'600'000, thousandths / 60'000 % 60,
                     thousandths / 1000 % 60, thousandths % 1000);
}

std::optional<long> days_in(Stamp const& stamp, DateOrder order) {
  if (stamp.days) return stamp.days;
  return order == DateOrder::day_first ? days_of(stamp.year, stamp.second, stamp.first)
                                       : days_of(stamp.year, stamp.first, stamp.second);
}

std::string_view name_of(DateOrder order) {
  return order == DateOrder::day_first ? "day first" : "month first";
}

std::optional<std::vector<double>> times_in(std::span<Stamp const> stamps, DateOrder order) {
  std::vector<double> times;
  times.reserve(stamps.size());
  std::optional<double> origin_days;
  auto const& start = stamps.front();
  for (auto const& stamp : stamps) {
    auto const days = days_in(stamp, order);
    if (!days) return std::nullopt;
    if (!origin_days) origin_days = static_cast<double>(*days);
    double const zone = stamp.zone_s.value_or(0.0) - start.zone_s.value_or(0.0);
    times.push_back((static_cast<double>(*days) - *origin_days) * day_s + (stamp.clock_s - start.clock_s) - zone);
  }
  return times;
}

double largest_step(std::vector<double> const& times) {
  double largest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) largest = std::max(largest, times[i] - times[i - 1]);
  return largest;
}

struct DatesRead {
  std::vector<double> times;
  DateOrder order = DateOrder::day_first;
  std::string why;
  bool in_either_order = false;  // both orders of day and month give these times, but not the same first date
};

class DateReader {
 public:
  DateReader(std::span<Stamp const> stamps, std::span<std::size_t const> lines, std::string const& where,
             std::string_view row, std::vector<Complaint>& complaints)
      : stamps_(stamps), lines_(lines), where_(where), row_(row), complaints_(complaints) {}

  std::optional<DatesRead> read(std::optional<DateOrder> asked) {
    if (std::ranges::all_of(stamps_, [](auto const& stamp) { return stamp.days.has_value(); }))
      return DatesRead{.times = *times_in(stamps_, DateOrder::day_first), .order = {}, .why = {}};
    auto day_first = times_in(stamps_, DateOrder::day_first), month_first = times_in(stamps_, DateOrder::month_first);
    if (asked) {
      auto& chosen = *asked == DateOrder::day_first ? day_first : month_first;
      if (!chosen) return refuse_date(*asked);
      return DatesRead{std::move(*chosen), *asked,
                       fmt::format("{} (--date-order {})", name_of(*asked), date_order_word(*asked))};
    }
    if (!day_first && !month_first) return refuse_date(DateOrder::day_first);
    if (!day_first || !month_first) {
      auto const order = day_first ? DateOrder::day_first : DateOrder::month_first;
      return DatesRead{std::move(day_first ? *day_first : *month_first), order,
                       fmt::format("{}, {}", name_of(order), large(order))};
    }
    if (*day_first == *month_first) {
      auto const& s = stamps_.front();
      return DatesRead{
          std::move(*day_first), DateOrder::day_first,
          fmt::format("{} is {} or {}: the times are the same either way", written(s),
                      date_text(*days_in(s, DateOrder::day_first)), date_text(*days_in(s, DateOrder::month_first))),
          true};
    }
    return by_sequence(std::move(*day_first), std::move(*month_first));
  }

 private:
  static std::string written(Stamp const& s) { return fmt::format("{:02}/{:02}/{}", s.first, s.second, s.year); }

  std::string large(DateOrder order) const {
    for (std::size_t i = 0; i < stamps_.size(); ++i)
      if (auto const& s = stamps_[i]; !s.days && (order == DateOrder::day_first ? s.first : s.second) > 12)
        return fmt::format("as {} {} shows ({})", row_, lines_[i], written(s));
    return "which alone makes dates of all of them";
  }

  // Chooses the order of day and month in which the times rise in steps of at most 12 hours. Complains if they do so in
  // both orders or in neither.
  std::optional<DatesRead> by_sequence(std::vector<double> day_first, std::vector<double> month_first) {
    constexpr double step_of_a_record_s = 12.0 * 3600.0;
    auto const fits = [&](std::vector<double> const& times) {
      return std::ranges::is_sorted(times) && largest_step(times) <= step_of_a_record_s;
    };
    bool const day = fits(day_first), month = fits(month_first);
    if (day != month)
      return DatesRead{std::move(day ? day_first : month_first), day ? DateOrder::day_first : DateOrder::month_first,
                       fmt::format("{}, the only order in which they follow one another without a leap",
                                   name_of(day ? DateOrder::day_first : DateOrder::month_first))};
    auto const at = static_cast<std::size_t>(
        std::ranges::find_if(stamps_, [](auto const& s) { return !s.days && s.first != s.second; }) - stamps_.begin());
    auto const& s = stamps_[std::min(at, stamps_.size() - 1)];
    complaints_.push_back(
        {fmt::format("{}:{}", where_, lines_[std::min(at, lines_.size() - 1)]),
         fmt::format("date {} may be {} (day first) or {} (month first)", written(s),
                     date_text(*days_in(s, DateOrder::day_first)), date_text(*days_in(s, DateOrder::month_first))),
         "dates of which one has a day above 12, which shows the order",
         fmt::format("--date-order {}, or --date-order {}", date_order_word(DateOrder::day_first),
                     date_order_word(DateOrder::month_first))});
    return std::nullopt;
  }

  std::nullopt_t refuse_date(DateOrder order) {
    for (std::size_t i = 0; i < stamps_.size(); ++i)
      if (!days_in(stamps_[i], order)) {
        complaints_.push_back(
            {fmt::format("{}:{}", where_, lines_[i]),
             fmt::format("{} is no date, {}", written(stamps_[i]), name_of(order)),
             "dates in one order, day first or month first",
             fmt::format("--date-order {} or {}; or --columns time=none and --dt SECONDS",
                         date_order_word(DateOrder::day_first), date_order_word(DateOrder::month_first))});
        break;
      }
    return std::nullopt;
  }

  std::span<Stamp const> stamps_;
  std::span<std::size_t const> lines_;
  std::string const& where_;
  std::string_view row_;
  std::vector<Complaint>& complaints_;
};

// Fills `times` and counts midnights: midnight has passed when the time of day goes back by more than half a day.
std::size_t count_midnights(std::span<Stamp const> stamps, std::vector<double>& times) {
  std::size_t midnights = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (i > 0 && stamps[i].clock_s < stamps[i - 1].clock_s - day_s / 2.0) ++midnights;
    times.push_back(stamps[i].clock_s - stamps.front().clock_s + static_cast<double>(midnights) * day_s);
  }
  return midnights;
}

// Refuses time stamps if a fifth or more of them repeat the one before. A logger that writes whole seconds makes such
// stamps.
bool refuse_coarse(std::vector<double> const& times, std::string const& where, std::vector<Complaint>& complaints) {
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < times.size(); ++i) repeated += times[i] == times[i - 1] ? 1u : 0u;
  if (times.size() < 10 || 5 * repeated < times.size()) return false;
  double const interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  complaints.push_back({where,
                        fmt::format("{} of {} time stamps repeat the one before: they are coarser than the sampling",
                                    repeated, times.size()),
                        "a time that increases from row to row",
                        fmt::format("--columns time=none --dt SECONDS, the sampling interval{}",
                                    interval > 0.0 ? fmt::format(" (about {:.3g} s on average)", interval) : "")});
  return true;
}

}  // namespace

std::string_view date_order_word(DateOrder order) {
  return order == DateOrder::day_first ? "dmy" : "mdy";
}

std::optional<Stamp> parse_stamp(std::string_view cell) {
  constexpr std::size_t longest = 48;
  if (cell.size() < 5 || cell.size() > longest || !is_digit(cell.front())) return std::nullopt;
  constexpr std::string_view japanese_year = "\xE5\xB9\xB4";
  if (cell.find(japanese_year) != std::string_view::npos) return parse_stamp(without_japanese(cell));
  if (cell.ends_with(date_cell_mark)) {
    auto const days = number_in<double>(cell.substr(0, cell.size() - date_cell_mark.size()));
    if (!days || *days < 0.0 || *days > 3e6) return std::nullopt;
    return stamp_of_serial(*days);
  }
  Stamp stamp;
  StampText text(cell);
  if (take_date(text, stamp)) {
    if (text.done()) return stamp;
    if (!text.take('T') && !text.take('t') && !text.take('_') && text.next() != ' ') return std::nullopt;
    text.skip_blanks();
    return take_clock(text, stamp) ? std::optional(stamp) : std::nullopt;
  }
  stamp = {};
  StampText again(cell);
  return take_clock(again, stamp) ? std::optional(stamp) : std::nullopt;
}

StampKind kind_of(Stamp const& stamp) {
  return stamp.dated ? stamp.clocked ? StampKind::date_time : StampKind::date : StampKind::clock;
}

Stamp stamp_of_serial(double days) {
  double const whole = std::floor(days);
  Stamp stamp;
  stamp.dated = whole >= 1.0;
  stamp.clocked = !stamp.dated || days != whole;
  if (stamp.dated) stamp.days = static_cast<long>(whole) + spreadsheet_epoch;
  stamp.clock_s = (days - whole) * day_s;
  return stamp;
}

Stamp on_date(Stamp clock, Stamp const& date) {
  clock.dated = true;
  clock.days = date.days;
  clock.first = date.first;
  clock.second = date.second;
  clock.year = date.year;
  return clock;
}

bool may_be_date(std::string_view text) {
  std::string plain(trimmed(text));
  std::erase(plain, ' ');
  bool const words = plain.find_first_not_of("0123456789-/.") != std::string::npos;
  if (plain.find_first_of("-/.") != std::string::npos || words) {
    auto const stamp = parse_stamp(plain);
    if (stamp && stamp->dated && (days_in(*stamp, DateOrder::day_first) || days_in(*stamp, DateOrder::month_first)))
      return true;
    if (!words) return false;
  }
  for (std::size_t begin = plain.find_first_of("0123456789"); begin < plain.size();) {
    auto const end = std::min(plain.find_first_not_of("0123456789", begin), plain.size());
    auto const digits = plain.substr(begin, end - begin);
    bool const century = digits.starts_with("19") || digits.starts_with("20");
    if (century && digits.size() == 4) return true;
    if (century && digits.size() == 8 &&
        days_of(std::stoi(digits.substr(0, 4)), std::stoi(digits.substr(4, 2)), std::stoi(digits.substr(6, 2))))
      return true;
    begin = plain.find_first_of("0123456789", end);
  }
  return false;
}

bool may_be_serial(double value) {
  return value >= 20000.0 && value < 80000.0;
}

StampedTime seconds_of(std::span<Stamp const> stamps, std::span<std::size_t const> lines, std::string const& where,
                       std::string_view row, std::optional<DateOrder> order, std::vector<Complaint>& complaints) {
  StampedTime result;
  if (stamps.empty()) return result;
  auto const& start = stamps.front();
  result.dated = start.dated;
  double const of_day = start.clock_s - start.zone_s.value_or(0.0);
  std::vector<double> times;
  if (result.dated) {
    auto read = DateReader(stamps, lines, where, row, complaints).read(order);
    if (!read) return result;
    auto const days = *days_in(start, read->order);
    result.origin_s = static_cast<double>(days) * day_s + of_day;
    result.sentences.push_back(
        fmt::format("time stamps: {}seconds from the first, {} {}", read->why.empty() ? "" : read->why + "; ",
                    read->in_either_order ? "at" : date_text(days) + " at", clock_text(start.clock_s)));
    times = std::move(read->times);
  } else {
    result.origin_s = of_day;
    auto const midnights = count_midnights(stamps, times);
    result.sentences.push_back(fmt::format("times of day: seconds from the first, {}{}", clock_text(start.clock_s),
                                           midnights > 0 ? ", past midnight" : ""));
  }
  if (refuse_coarse(times, where, complaints)) return result;
  result.time_s = std::move(times);
  return result;
}

}  // namespace isolaw::data
