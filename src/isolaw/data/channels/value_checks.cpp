#include "isolaw/data/channels/value_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include "isolaw/base/words.hpp"

namespace isolaw::data {
namespace {

// Larger than any value that a sensor reports, in any unit. Instruments write 1e10, 9.9e37 or 1e30 for "overload".
constexpr double beyond_any_sensor = 1e10;
constexpr std::array sentinels{999.0,  9999.0,  99999.0, 999999.0, 9999999.0, 999.9,
                               9999.9, 99999.9, 999.99,  9999.99,  99999.99};
constexpr double far_beyond = 50.0;      // a value above this many times ordinary_size() is an overload
constexpr double sentinel_beyond = 3.0;  // a value such as 9999 below this many times ordinary_size() may be measured
constexpr std::size_t least_values = 20;

bool is_sentinel(double size) {
  return std::ranges::find(sentinels, size) != sentinels.end();
}

// The size of ordinary values: the 99.9th percentile of |value| without markers such as 9999 or 1e30. It is at most the
// fourth largest, because up to three values may be overloads.
std::optional<double> ordinary_size(std::span<double const> values) {
  std::vector<double> sizes;
  sizes.reserve(values.size());
  for (double const value : values)
    if (double const size = std::abs(value); size < beyond_any_sensor && !is_sentinel(size)) sizes.push_back(size);
  if (sizes.size() < least_values) return std::nullopt;
  auto const above = std::max<std::size_t>(3, sizes.size() / 1000);
  auto const at = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() - 1 - above);
  std::ranges::nth_element(sizes, at);
  return *at > 0.0 ? std::optional(*at) : std::nullopt;
}

bool is_overload(double value, std::optional<double> ordinary) {
  double const size = std::abs(value);
  if (size >= beyond_any_sensor) return true;
  if (!ordinary) return false;
  return size > far_beyond * *ordinary || (is_sentinel(size) && size > sentinel_beyond * *ordinary);
}

void check_overload(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                    std::vector<Complaint>& complaints) {
  auto const ordinary = ordinary_size(raw.values);
  FirstComplaints findings(file, "values beyond the sensor's range");
  for (std::size_t i = 0; i < raw.values.size(); ++i) {
    if (!is_overload(raw.values[i], ordinary)) continue;
    std::string found =
        fmt::format("{} {} in {} looks like an overload of the sensor", raw.values[i], raw.unit, raw.column);
    if (ordinary) found += fmt::format(" (all but a few values stay within {:.4g} {})", *ordinary, raw.unit);
    findings.add(lines[i], std::move(found), "measured values",
                 "--rows A:B or --to SECONDS, which end before the overload, or test again");
  }
  findings.append_to(complaints);
}

void check_constant(std::string const& file, RawChannel const& raw, std::vector<Complaint>& complaints) {
  auto const [least, largest] = std::ranges::minmax(raw.values);
  if (largest - least > 1e-12 * std::max(std::abs(least), std::abs(largest))) return;
  complaints.push_back(
      {file,
       fmt::format("{} is constant: {} holds {} {} in {}{}", name(raw.channel), raw.column, least, raw.unit,
                   raw.values.size() == 1 ? "" : "all ", counted(raw.values.size(), "sample")),
       "a channel that moves",
       fmt::format("--columns {}=NUMBER with the column that was measured", name(raw.channel))});
}

void check_time(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                std::vector<Complaint>& complaints) {
  FirstComplaints findings(file, "times that do not increase");
  for (std::size_t i = 1; i < raw.values.size(); ++i) {
    double const before = raw.values[i - 1];
    double const now = raw.values[i];
    if (now > before) continue;
    auto found = now == before ? fmt::format("time {} {} is repeated", now, raw.unit)
                               : fmt::format("time goes back from {} to {} {}", before, now, raw.unit);
    findings.add(lines[i], std::move(found), "time that increases from row to row",
                 "--rows A:B for one test of several, or leave time out with --columns time=none and give --dt");
  }
  findings.append_to(complaints);
}

void check_cycle(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                 std::vector<Complaint>& complaints) {
  constexpr double most = 1e9;
  FirstComplaints findings(file, "values that are no number of a cycle");
  for (std::size_t i = 0; i < raw.values.size(); ++i)
    if (!(std::abs(raw.values[i]) <= most))
      findings.add(lines[i], fmt::format("{} in {} is no number of a cycle", raw.values[i], raw.column),
                   fmt::format("numbers up to {:.0f}", most),
                   "--columns cycle=none leaves the numbers of the cycles out");
  findings.append_to(complaints);
}

}  // namespace

void check_channel(std::string const& file, RawChannel const& raw, std::span<std::size_t const> lines,
                   std::vector<Complaint>& complaints) {
  if (raw.values.empty()) return;
  if (raw.channel == Channel::time) {
    check_time(file, raw, lines, complaints);
    return;
  }
  if (raw.channel == Channel::cycle) return check_cycle(file, raw, lines, complaints);
  check_overload(file, raw, lines, complaints);
  // These two may be constant: a press may hold the vertical load, and nothing may move in the second direction.
  if (raw.channel != Channel::load && raw.channel != Channel::second_disp) check_constant(file, raw, complaints);
}

}  // namespace isolaw::data
