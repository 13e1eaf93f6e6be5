#include "isolaw/data/cycles/swings.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/data/cycles/holds.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double least_way_back = 0.05;  // fraction of half the range by which a motion comes back from a turn
constexpr double rest_band = 0.01;       // fraction of the range within which a motion rests

std::vector<std::size_t> turning_points(std::span<double const> x, double back) {
  std::vector<std::size_t> turns;
  std::size_t low = 0, high = 0;
  int direction = 0;  // 1 upwards, -1 downwards, 0 until the motion has come back from its first extreme
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (direction >= 0 && x[i] > x[high]) high = i;
    if (direction <= 0 && x[i] < x[low]) low = i;
    if (direction >= 0 && x[high] - x[i] >= back) {
      turns.push_back(high);
      direction = -1;
      low = i;
    } else if (direction <= 0 && x[i] - x[low] >= back) {
      turns.push_back(low);
      direction = 1;
      high = i;
    }
  }
  std::erase_if(turns, [&](std::size_t turn) { return turn == 0 || turn + 1 == x.size(); });
  return turns;
}

double interval_after(std::span<double const> time_s, std::size_t sample) {
  return time_s.empty() ? 1.0 : time_s[sample + 1] - time_s[sample];
}

// For each interval between samples its length, or 0 while the motion rests.
std::vector<double> moving_intervals(std::span<double const> x, std::span<double const> time_s,
                                     std::span<std::size_t const> turns, double range) {
  std::vector<double> intervals, durations;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) intervals.push_back(interval_after(time_s, i));
  auto const between = [&](std::size_t first, std::size_t last) {
    return time_s.empty() ? static_cast<double>(last - first) : time_s[last] - time_s[first];
  };
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) durations.push_back(between(turns[k], turns[k + 1]));
  if (durations.empty()) return intervals;
  double const longest = num::median(durations);
  for (auto const& rest : stretches_within(x, 0, x.size(), rest_band * range, 1))
    if (between(rest.first, rest.last) > longest)
      std::fill(intervals.begin() + static_cast<std::ptrdiff_t>(rest.first),
                intervals.begin() + static_cast<std::ptrdiff_t>(rest.last), 0.0);
  return intervals;
}

struct SwingingMotion {
  std::vector<double> intervals;
  std::vector<Swing> swings;
};

SwingingMotion motion_in(std::span<double const> x, std::span<double const> time_s) {
  if (x.size() < 3) return {};
  auto const [least, most] = std::ranges::minmax(x);
  double const range = most - least;
  if (!(range > 0.0)) return {};
  auto const turns = turning_points(x, 0.5 * least_way_back * range);
  SwingingMotion motion{.intervals = moving_intervals(x, time_s, turns, range), .swings = {}};
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    Swing swing{
        .first = turns[k], .last = turns[k + 1], .half_range_mm = 0.5 * std::abs(x[turns[k + 1]] - x[turns[k]])};
    for (auto i = swing.first; i < swing.last; ++i) swing.duration += motion.intervals[i];
    motion.swings.push_back(swing);
  }
  return motion;
}

}  // namespace

std::vector<Swing> swings(std::span<double const> disp_mm, std::span<double const> time_s) {
  return motion_in(disp_mm, time_s).swings;
}

std::string_view name(Weighting weighting) {
  return weighting == Weighting::time ? "time" : weighting == Weighting::swing ? "swing" : "travel";
}

std::vector<double> sample_weights(std::span<double const> x, std::span<double const> time_s, Weighting weighting) {
  std::vector<double> weights(x.size(), 0.0);
  auto const add = [&](std::size_t interval, double weight) {  // half to the sample before, half to the sample after
    weights[interval] += 0.5 * weight;
    weights[interval + 1] += 0.5 * weight;
  };
  auto const motion = weighting == Weighting::swing ? motion_in(x, time_s) : SwingingMotion{};
  if (!motion.swings.empty()) {
    for (auto const& swing : motion.swings)
      for (auto i = swing.first; i < swing.last; ++i)
        if (swing.duration > 0.0) add(i, swing.half_range_mm / swing.duration * motion.intervals[i]);
    return weights;
  }
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    add(i, weighting == Weighting::travel ? std::abs(x[i + 1] - x[i]) : interval_after(time_s, i));
  return weights;
}

}  // namespace isolaw::data
