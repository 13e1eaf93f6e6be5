#include "isolaw/data/signals/signal_pair.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/data/channels/time_gaps.hpp"
#include "isolaw/data/cycles/cycles.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

Signal signal_of(std::span<double const> values, std::vector<Spike> const& off) {
  Signal signal{.x = {values.begin(), values.end()}};
  for (auto const& spike : off) signal.x[spike.at] = spike.expected;
  signal.half_range = half_range(signal.x);
  signal.quantum = smallest_step(signal.x, 2.0 * signal.half_range);
  signal.noise = noise_deviation(signal.x);
  return signal;
}

std::size_t median_distance(std::vector<std::size_t> const& turns) {
  std::vector<double> distances;
  for (std::size_t k = 1; k < turns.size(); ++k) distances.push_back(static_cast<double>(turns[k] - turns[k - 1]));
  return std::max<std::size_t>(4, static_cast<std::size_t>(num::median(distances)));
}

}  // namespace

SignalPair::SignalPair(std::span<double const> disp_mm, std::span<double const> force_kN,
                       std::span<double const> time_s, std::vector<Spike> const& of_disp,
                       std::vector<Spike> const& of_force)
    : disp(signal_of(disp_mm, of_disp)), force(signal_of(force_kN, of_force)), time(time_s) {
  if (!moves()) return;
  turns = reversals(disp.x).at;
  half_cycle = turns.size() < 3 ? size() : median_distance(turns);
  if (!time.empty()) interval = usual_interval(time);
}

bool SignalPair::moves() const {
  return disp.half_range > 0.0 && force.half_range > 0.0 && std::isfinite(disp.half_range + force.half_range);
}

bool SignalPair::gap_after(std::size_t i) const {
  constexpr double longer = 3.0;
  return !time.empty() && i + 1 < time.size() && time[i + 1] - time[i] > longer * interval;
}

bool SignalPair::has_noise(Signal const& signal) const {
  double const smooth = 4.0 * std::pow(std::numbers::pi / static_cast<double>(half_cycle), 4.0) * signal.half_range;
  return signal.noise > std::max(3.0 * signal.quantum, smooth);
}

double mean_of(std::span<double const> x, std::size_t begin, std::size_t end) {
  double sum = 0.0;
  for (auto i = begin; i < end; ++i) sum += x[i];
  return sum / static_cast<double>(end - begin);
}

}  // namespace isolaw::data
