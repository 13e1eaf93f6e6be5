#include "isolaw/data/cycles/swings.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/data/cycles/holds.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double least_way_back = 0.05;  // from a turn, a motion comes back by at least this fraction of half its range
constexpr double rest_band = 0.01;       // a motion rests while it stays within this fraction of its range

std::vector<std::size_t> turning_points(std::span<double const> x, double back) {
  std::vector<std::size_t> turns;
  std::size_t lowest = 0, highest = 0;
  int direction = 0;  // 1 upwards, -1 downwards, 0 until the motion has come back from its first extreme
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (direction >= 0 && x[i] > x[highest]) highest = i;
    if (direction <= 0 && x[i] < x[lowest]) lowest = i;
    if (direction >= 0 && x[highest] - x[i] >= back) {
      turns.push_back(highest);
      direction = -1;
      lowest = i;
    } else if (direction <= 0 && x[i] - x[lowest] >= back) {
      turns.push_back(lowest);
      direction = 1;
      highest = i;
    }
  }
  std::erase(turns, 0u);  // the first sample is no turn; the last one cannot be, because nothing comes back from it
  return turns;
}

double interval_after(std::span<double const> time_s, std::size_t sample) {
  return time_s.empty() ? 1.0 : time_s[sample + 1] - time_s[sample];
}

double duration(std::span<double const> time_s, std::size_t first, std::size_t last) {
  return time_s.empty() ? static_cast<double>(last - first) : time_s[last] - time_s[first];
}

// Returns the duration of each interval between samples, or 0 while the motion rests (see swings.hpp). Around its
// turns, a slow swing also changes little for a while. A rest must therefore take more than a quarter of its swing.
std::vector<double> moving_intervals(std::span<double const> x, std::span<double const> time_s,
                                     std::span<std::size_t const> turns, double range) {
  constexpr double least_part = 0.25;
  std::vector<double> intervals, durations;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) intervals.push_back(interval_after(time_s, i));
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) durations.push_back(duration(time_s, turns[k], turns[k + 1]));
  if (durations.empty()) return intervals;
  double const usual = num::median(durations);
  for (auto const& rest : stretches_within(x, 0, x.size(), rest_band * range, 1)) {
    if (duration(time_s, rest.first, rest.last) <= usual) continue;
    for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
      auto const first = std::max(rest.first, turns[k]), last = std::min(rest.last, turns[k + 1]);
      if (first < last && duration(time_s, first, last) > least_part * durations[k])
        std::fill(intervals.begin() + static_cast<std::ptrdiff_t>(first),
                  intervals.begin() + static_cast<std::ptrdiff_t>(last), 0.0);
    }
  }
  return intervals;
}

// The weight of the interval after a sample: the distance moved for Weighting::travel, else the time.
double weight_of(std::span<double const> x, std::span<double const> time_s, Weighting weighting, std::size_t sample) {
  return weighting == Weighting::travel ? std::abs(x[sample + 1] - x[sample]) : interval_after(time_s, sample);
}

// Adds half of the interval's weight to the sample before it and half to the sample after it.
void add_interval(std::vector<double>& weights, std::size_t interval, double weight) {
  weights[interval] += 0.5 * weight;
  weights[interval + 1] += 0.5 * weight;
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

bool are_alike(std::span<Swing const> swings) {
  constexpr double most_ratio = 1.1;
  auto const alike = [&](double Swing::*member) {
    auto const [least, most] = std::ranges::minmax(swings, {}, member);
    return most.*member <= most_ratio * (least.*member);
  };
  return swings.empty() || (alike(&Swing::half_range_mm) && alike(&Swing::duration));
}

std::string_view name(Weighting weighting) {
  return weighting == Weighting::time ? "time" : weighting == Weighting::swing ? "swing" : "travel";
}

std::vector<double> sample_weights(std::span<double const> x, std::span<double const> time_s, Weighting weighting) {
  if (weighting == Weighting::swing)
    if (auto const all = swings(x, time_s); !all.empty()) return weights_within(all, x, time_s, weighting);
  std::vector<double> weights(x.size(), 0.0);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) add_interval(weights, i, weight_of(x, time_s, weighting, i));
  return weights;
}

std::vector<double> weights_within(std::span<Swing const> some, std::span<double const> x,
                                   std::span<double const> time_s, Weighting weighting) {
  std::vector<double> weights(x.size(), 0.0);
  auto const motion = motion_in(x, time_s);
  for (auto const& swing : some)
    for (auto i = swing.first; i < swing.last; ++i) {
      if (weighting != Weighting::swing)
        add_interval(weights, i, weight_of(x, time_s, weighting, i));
      else if (swing.duration > 0.0)
        add_interval(weights, i, swing.half_range_mm / swing.duration * motion.intervals[i]);
    }
  return weights;
}

}  // namespace isolaw::data
