#include "isolaw/data/channels/time_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {

double usual_interval(std::span<double const> time_s) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time_s.size(); ++i) intervals.push_back(time_s[i] - time_s[i - 1]);
  return num::median(intervals);
}

namespace {

std::vector<Gap> gaps_of_test(std::span<double const> x, std::span<double const> time_s) {
  constexpr std::size_t fewest = 16;
  if (time_s.size() < fewest) return {};
  std::vector<double> intervals;
  for (std::size_t i = 1; i < time_s.size(); ++i) intervals.push_back(time_s[i] - time_s[i - 1]);
  double const longest = std::ranges::max(intervals);
  double const interval = num::median(intervals);
  if (!(longest > most_intervals * interval)) return {};
  // Only a single long interval is a gap. Several in a row are a part of the test that was sampled more slowly.
  auto const is_long = [&](std::size_t i) { return intervals[i] > most_intervals * interval; };
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < time_s.size(); ++i) {
    double const length = intervals[i];
    if (!is_long(i) || (i > 0 && is_long(i - 1)) || (i + 1 < intervals.size() && is_long(i + 1))) continue;
    double const before = i > 0 ? std::abs(x[i] - x[i - 1]) : 0.0;
    double const after = i + 2 < x.size() ? std::abs(x[i + 2] - x[i + 1]) : 0.0;
    double const speed = std::max(before, after) / interval;
    double const way = std::abs(x[i + 1] - x[i]);
    // If the device stands still on both sides of the gap, it is assumed to have rested during the whole gap.
    double const taken = speed > 0.0 ? std::clamp(way / speed, interval, length) : length;
    gaps.push_back({.last_before = i, .length_s = length, .taken_s = taken});
  }
  return gaps;
}

}  // namespace

std::vector<Gap> time_gaps(std::span<double const> disp_mm, std::span<double const> time_s,
                           std::span<std::size_t const> starts) {
  std::vector<Gap> gaps;
  for (auto const& range : test_ranges(starts, disp_mm.size()))
    for (auto gap : gaps_of_test(range.slice(disp_mm), range.slice(time_s))) {
      gap.last_before += range.first;
      gaps.push_back(gap);
    }
  return gaps;
}

std::vector<double> without_gaps(std::span<double const> time_s, std::vector<Gap> const& gaps) {
  if (gaps.empty()) return {};
  std::vector<double> time(time_s.begin(), time_s.end());
  double cut = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    time[i] -= cut;
    if (next < gaps.size() && gaps[next].last_before == i) cut += gaps[next].length_s - gaps[next].taken_s, ++next;
  }
  return time;
}

}  // namespace isolaw::data
