#include "isolaw/data/signals/spikes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "isolaw/data/cycles/cycles.hpp"

namespace isolaw::data {
namespace {

// A spike is farther from the cubic through its neighbours than each of these three limits: least_spike times the
// channel's half range (half the difference between its largest and smallest value), spike_deviations standard
// deviations of its noise, and spike_quanta steps of its digitiser. At kinks of true records, samples are off the cubic
// by 3 % of the half range.
constexpr double least_spike = 0.04;
constexpr double spike_deviations = 13.0;
constexpr double spike_quanta = 2.5;
// A spike is also farther from the cubic than this number times the rms distance of its neighbours from the cubic.
// Samples at corners of a signal reach 7.4 times this rms distance, and samples at steps 5.6 times.
constexpr double spike_contrast = 10.0;
// Near an end of the record, where most neighbours lie on one side, spike_contrast is multiplied by this number.
constexpr double edge_contrast = 2.0;
// A sample is no spike if it lies on the line through the two samples before it, or after it: its distance from that
// line is below this fraction of its distance from the cubic.
constexpr double on_one_side = 0.5;
// Many samples of a rough signal look like spikes. If they are more than 24 and more than 1/75 of all samples, the
// largest ones, as many as the larger of these two numbers, are set aside. A spike is then a fault only if it exceeds
// the largest of the others by a quarter.
constexpr double beyond_others = 1.25;
constexpr std::size_t fewest_others = 24;
constexpr std::size_t samples_an_other = 75;
// If more than 6 samples, and more than one in 150, are found to be spikes, they are taken as part of the signal, and
// none is reported.
constexpr std::size_t fewest_texture = 6;
constexpr std::size_t samples_a_spike = 150;

// `expected` is the value of the least-squares cubic through six neighbours, `left` their rms distance from the cubic.
struct Neighbours {
  double expected = 0.0;
  double left = 0.0;
};

Neighbours neighbours_of(std::span<double const> x, std::size_t i) {
  constexpr std::size_t count = 6, coefficients = 4;
  auto const begin = std::min(i >= 3 ? i - 3 : 0, x.size() - count - 1);
  std::array<std::array<double, coefficients>, count> rows{};
  std::array<double, count> values{};
  std::size_t row = 0;
  for (auto k = begin; row < count; ++k) {
    if (k == i) continue;
    double const at = static_cast<double>(k) - static_cast<double>(i);
    rows[row] = {1.0, at, at * at, at * at * at};
    values[row++] = x[k] - x[i];
  }
  // Solves for the cubic's constant by making each column orthogonal to the columns of higher power.
  std::array<double, count> ones{};
  ones.fill(1.0);
  std::array<std::size_t, 3> const powers{3, 2, 1};
  for (std::size_t p = 0; p < powers.size(); ++p) {
    double size = 0.0, with_ones = 0.0, with_values = 0.0;
    std::array<double, coefficients> with{};
    for (std::size_t r = 0; r < count; ++r) {
      double const column = rows[r][powers[p]];
      size += column * column;
      with_ones += column * ones[r];
      with_values += column * values[r];
      for (auto q = p + 1; q < powers.size(); ++q) with[powers[q]] += column * rows[r][powers[q]];
    }
    for (std::size_t r = 0; r < count; ++r) {
      double const column = rows[r][powers[p]];
      ones[r] -= with_ones / size * column;
      values[r] -= with_values / size * column;
      for (auto q = p + 1; q < powers.size(); ++q) rows[r][powers[q]] -= with[powers[q]] / size * column;
    }
  }
  double size = 0.0, with_values = 0.0;
  for (std::size_t r = 0; r < count; ++r) {
    size += ones[r] * ones[r];
    with_values += ones[r] * values[r];
  }
  Neighbours found{.expected = x[i] + with_values / size, .left = 0.0};
  for (std::size_t r = 0; r < count; ++r) found.left += std::pow(values[r] - with_values / size * ones[r], 2.0);
  found.left = std::sqrt(found.left / static_cast<double>(count));
  return found;
}

double ordinary_half_range(std::span<double const> x) {
  std::vector<double> sorted(x.begin(), x.end());
  std::ranges::sort(sorted);
  auto const cut = sorted.size() / 100;
  return (sorted[sorted.size() - 1 - cut] - sorted[cut]) / 2.0;
}

}  // namespace

double smallest_step(std::span<double const> x, double range) {
  std::vector<double> sorted(x.begin(), x.end());
  std::ranges::sort(sorted);
  // Values that differ by less than this fraction of `range` count as equal: such a difference is a rounding error.
  constexpr double no_step = 1e-9;
  double least = range;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (double const step = sorted[i] - sorted[i - 1]; step > no_step * range) least = std::min(least, step);
  return least;
}

std::vector<Spike> spikes(std::span<double const> values) {
  constexpr std::size_t fewest = 16;
  if (values.size() < fewest) return {};
  double const half_range = ordinary_half_range(values);
  if (!(half_range > 0.0) || !std::isfinite(half_range)) return {};
  double const least = std::max({least_spike * half_range, spike_deviations * noise_deviation(values),
                                 spike_quanta * smallest_step(values, 2.0 * half_range)});
  std::vector<Spike> found;
  // For each sample that looks like a spike, even a small one: its distance from the cubic through its neighbours.
  std::vector<double> others;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    // This cheap test avoids the fit for most samples, which are close to the mean of their two neighbours.
    if (std::abs(values[i] - (values[i - 1] + values[i + 1]) / 2.0) <= least / 4.0) continue;
    auto const neighbours = neighbours_of(values, i);
    double const off = std::abs(values[i] - neighbours.expected);
    // A sample beside a jump or a corner is no spike. Such a sample lies on the line through the two samples before it,
    // or the two after it.
    auto const on_line = [&](std::size_t near, std::size_t far) {
      return std::abs(values[i] - (2.0 * values[near] - values[far])) < on_one_side * off;
    };
    bool const at_an_end = i < 3 || i + 3 >= values.size();
    // Near an end, too few samples may follow a corner to show the line after it. There a spike must be higher or lower
    // than both neighbours.
    if (at_an_end && (values[i] - values[i - 1]) * (values[i + 1] - values[i]) >= 0.0) continue;
    double const contrast = spike_contrast * (at_an_end ? edge_contrast : 1.0) * neighbours.left;
    if ((i >= 2 && on_line(i - 1, i - 2)) || (i + 2 < values.size() && on_line(i + 1, i + 2))) continue;
    if (off > contrast / 3.0) others.push_back(off);
    if (off > least && off > contrast) found.push_back({.at = i, .value = values[i], .expected = neighbours.expected});
  }
  // A logger may write one fixed value, such as 0, where it has no measurement. If nine tenths of the spikes have one
  // value, all are faults, even if they are many.
  for (auto const& spike : found) {
    auto const alike = std::ranges::count(found, spike.value, &Spike::value);
    auto const all = static_cast<std::ptrdiff_t>(found.size());
    if (alike >= static_cast<std::ptrdiff_t>(fewest_texture) && alike >= all - all / 10) return found;
    // If there is a fixed value, at most a tenth of the spikes have another one. So trying one spike more than that
    // suffices.
    if (&spike - found.data() > all / 10) break;
  }
  auto const most = std::max(fewest_texture, values.size() / samples_a_spike);
  auto const rank = std::max(fewest_others, values.size() / samples_an_other);
  if (others.size() > rank) {
    auto const at = others.begin() + static_cast<std::ptrdiff_t>(rank);
    std::ranges::nth_element(others, at, std::greater<>());
    std::erase_if(found, [limit = beyond_others * *at](Spike const& spike) {
      return std::abs(spike.value - spike.expected) <= limit;
    });
  }
  if (found.size() > most) found.clear();
  return found;
}

bool is_of_every_turn(Spike const& spike, std::vector<Spike> const& all, std::span<double const> force,
                      std::span<std::size_t const> turns) {
  constexpr std::size_t reach = 2, least_turns = 2;
  constexpr double as_much = 0.35;
  auto const near = [](std::size_t a, std::size_t b) { return (a > b ? a - b : b - a) <= reach; };
  if (std::ranges::none_of(turns, [&](auto turn) { return near(turn, spike.at); })) return false;
  double const off = std::abs(spike.value - spike.expected);
  std::size_t others = 0;
  for (auto const turn : turns) {
    if (std::ranges::any_of(all, [&](Spike const& other) { return near(turn, other.at); })) continue;
    double most = 0.0;
    for (auto i = std::max(turn, reach + 1) - reach; i <= turn + reach && i + 1 < force.size(); ++i)
      most = std::max(most, std::abs(force[i] - neighbours_of(force, i).expected));
    if (most > as_much * off) ++others;
  }
  return others >= least_turns;
}

}  // namespace isolaw::data
