#include "isolaw/data/properties/channel_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <ranges>
#include <vector>

namespace isolaw::data {
namespace {

constexpr double least_rise = 0.03;      // at one amplitude, a sound device's force rises by less than this fraction
constexpr double rise_deviations = 5.0;  // a real rise exceeds this many standard deviations of a rise by noise
// A fault begins suddenly if the channel changes in the other cycles by at most this fraction of its change in the
// cycle that changes most. Otherwise the channel drifts.
constexpr double most_outside = 0.35;
constexpr double least_step = 0.02;   // times the amplitude; a smaller step of a channel's zero is not reported
constexpr double least_ratio = 0.05;  // the forces of the two directions must differ by at least this fraction
constexpr double better_by = 3.0;     // a gain is the cause if its rms residual is below 1/3 of an offset's residual
constexpr double same_at_peaks = 0.3;
constexpr double same_in_disp = 0.3;      // times the force's asymmetry; if displacement has more, it is the cause
constexpr double line_contrast = 4.0;     // a line of the spectrum must be this many times higher than its neighbours
constexpr double lowest_line = 10.0;      // lines are sought above this many times the test's frequency
constexpr double line_neighbours = 9.0;   // lines closer than this many times the test's frequency are neighbours
constexpr double least_line = 0.001;      // times the amplitude; a smaller line is not reported
constexpr double most_uneven_step = 0.1;  // each interval may differ by at most this fraction from the mean interval
constexpr std::size_t most_transformed = 65536;

// The counted cycles of a block, if they follow one another. Empty if there are fewer than `fewest`, or if a rest, a
// gap in time or another cycle separates two of them. A rest may precede the first.
std::vector<Cycle const*> unbroken(Block const& block, std::size_t fewest) {
  auto cycles = block.counted();
  bool broken = cycles.size() < fewest;
  for (std::size_t k = 1; k < cycles.size(); ++k)
    broken = broken || cycles[k]->still_samples > 0.0 || cycles[k]->first != cycles[k - 1]->last;
  if (broken) cycles.clear();
  return cycles;
}

// Standard deviation of the force in a cycle, divided by the standard deviation of displacement. A change of the force
// channel's gain changes this ratio in the same proportion as the stiffness. Noise and friction at the peaks disturb
// the stiffness, but hardly this ratio.
struct ForceRatio {
  double kN_per_mm = 0.0, deviation = 0.0;  // deviation: caused by noise; relative to kN_per_mm
};
ForceRatio force_ratio_of(Cycle const& cycle, CycleView const& view, double noise_kN) {
  auto const begin = static_cast<std::size_t>(std::ceil(cycle.first));
  auto const end = static_cast<std::size_t>(std::ceil(cycle.last));
  auto const squares = [&](std::span<double const> values) {
    double mean = 0.0, sum = 0.0;
    for (auto i = begin; i < end; ++i) mean += values[i] / static_cast<double>(end - begin);
    for (auto i = begin; i < end; ++i) sum += (values[i] - mean) * (values[i] - mean);
    return sum;
  };
  double const xx = squares(view.disp_mm), FF = squares(view.force_kN);
  return {.kN_per_mm = std::sqrt(FF / xx), .deviation = noise_kN / std::sqrt(FF)};
}

// The values of a channel in a block (`now`), each with the value one cycle before (`before`).
struct Repeats {
  std::size_t begin = 0;   // first sample
  std::size_t period = 0;  // samples in a cycle
  std::vector<double> now = {}, before = {};
};

// Pairs each value with the value one cycle before. Leaves out the first counted cycle, in which rubber softens
// unevenly. Values of force are paired by their phase, which counts from the start of a cycle. A jump of displacement
// moves these starts, so values of displacement are paired one mean period apart.
Repeats repeats_of(std::span<double const> values, std::vector<Cycle const*> const& cycles, LoopChannel channel) {
  double const period = (cycles.back()->last - cycles[1]->first) / static_cast<double>(cycles.size() - 1);
  Repeats repeats{.begin = static_cast<std::size_t>(std::ceil(cycles[2]->first)),
                  .period = static_cast<std::size_t>(std::lround(period))};
  std::size_t k = 2;
  for (auto i = repeats.begin; static_cast<double>(i) < cycles.back()->last; ++i) {
    auto const at = static_cast<double>(i);
    while (at >= cycles[k]->last) ++k;
    auto const &now = *cycles[k], &before = *cycles[k - 1];
    double const then = channel == LoopChannel::force
                            ? before.first + (at - now.first) / (now.last - now.first) * (before.last - before.first)
                            : at - period;
    repeats.now.push_back(values[i]);
    repeats.before.push_back(value_at(values, then));
  }
  return repeats;
}

// Least-squares fit of the change since the cycle before: change = offset + gain * (value before).
struct Change {
  double offset = 0.0, gain = 0.0, left = 0.0;  // left: rms residual
};
struct Sums {
  double n = 0.0, b = 0.0, bb = 0.0, d = 0.0, bd = 0.0, dd = 0.0;

  Sums& add(double before, double change) {
    n += 1.0, b += before, bb += before * before;
    d += change, bd += before * change, dd += change * change;
    return *this;
  }
  Sums operator-(Sums const& other) const {
    return {n - other.n, b - other.b, bb - other.bb, d - other.d, bd - other.bd, dd - other.dd};
  }
  Change fitted() const {
    double const size = n * bb - b * b;
    if (!(size > 0.0)) return {};
    Change found{.offset = (bb * d - b * bd) / size, .gain = (n * bd - b * d) / size};
    found.left = std::sqrt(std::max(0.0, (dd - found.offset * d - found.gain * bd) / n));
    return found;
  }
};

// Finds the cycle in which a channel differs most from the cycle before. If a fault begins suddenly, only the cycle in
// which it begins differs from the cycle before, because all later cycles have the fault. Returns nullopt if the
// channel changes in other cycles too.
struct SuddenChange {
  Change change;
  double at = 0.0;
};
std::optional<SuddenChange> sudden_change(Repeats const& repeats, double Change::*what) {
  std::vector<Sums> sums(1);
  for (std::size_t i = 0; i < repeats.now.size(); ++i) {
    auto next = sums.back();
    sums.push_back(next.add(repeats.before[i], repeats.now[i] - repeats.before[i]));
  }
  auto const size = static_cast<std::ptrdiff_t>(repeats.now.size());
  auto const period = static_cast<std::ptrdiff_t>(repeats.period), half = period / 2;
  SuddenChange found;
  std::ptrdiff_t from = 0, to = 0;
  double best = 0.0;
  for (auto start = -half; start <= size - half; ++start) {
    auto const a = std::max<std::ptrdiff_t>(0, start), b = std::min(size, start + period);
    if (b - a < half || size - (b - a) < half) continue;
    auto const change = (sums[static_cast<std::size_t>(b)] - sums[static_cast<std::size_t>(a)]).fitted();
    double const strength = std::abs(change.*what) * std::sqrt(static_cast<double>(b - a));
    if (strength <= best) continue;
    best = strength;
    found = {.change = change, .at = static_cast<double>(start) + static_cast<double>(repeats.begin)};
    from = a, to = b;
  }
  if (best == 0.0) return std::nullopt;
  auto const outside =
      (sums.back() - (sums[static_cast<std::size_t>(to)] - sums[static_cast<std::size_t>(from)])).fitted();
  if (std::abs(outside.*what) > most_outside * std::abs(found.change.*what)) return std::nullopt;
  return found;
}

// Replaces the values by their fast Fourier transform. Their number must be a power of two.
void transform(std::vector<std::complex<double>>& x) {
  auto const n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    auto bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  for (std::size_t length = 2; length <= n; length <<= 1)
    for (std::size_t k = 0; k < length / 2; ++k) {
      auto const turn = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
      for (std::size_t i = k; i < n; i += length) {
        auto const even = x[i], odd = turn * x[i + length / 2];
        x[i] = even + odd;
        x[i + length / 2] = even - odd;
      }
    }
}

bool is_uniform(std::span<double const> time, std::size_t begin, std::size_t end) {
  double const interval = (time[end - 1] - time[begin]) / static_cast<double>(end - 1 - begin);
  for (auto i = begin + 1; i < end; ++i)
    if (std::abs(time[i] - time[i - 1] - interval) > most_uneven_step * interval) return false;
  return true;
}

// The frequency of the mains, or twice this frequency, if sampling at `rate_Hz` shows it at `seen_Hz` (aliasing).
std::optional<double> mains_seen_at(double seen_Hz, double rate_Hz, double tolerance_Hz) {
  for (double const mains : {50.0, 60.0, 100.0, 120.0})
    if (std::abs(std::abs(mains - rate_Hz * std::round(mains / rate_Hz)) - seen_Hz) <= tolerance_Hz) return mains;
  return std::nullopt;
}

}  // namespace

std::optional<StiffnessRise> stiffness_rise(CycleView const& view, Block const& block) {
  auto const cycles = block.counted();
  double const noise = noise_deviation(view.force_kN);
  std::vector<ForceRatio> ratios;
  for (auto const* cycle : cycles) ratios.push_back(force_ratio_of(*cycle, view, noise));
  std::optional<StiffnessRise> found;
  std::size_t least = 1;  // the first cycle starts from rest, so its loop differs from the later ones
  for (std::size_t k = 2; k < cycles.size(); ++k) {
    if (cycles[k]->still_samples > 0.0 || cycles[k]->first != cycles[k - 1]->last) {
      least = k;  // a device recovers in a rest, so only later cycles are compared
      continue;
    }
    auto const share_from = [&](std::size_t from) { return ratios[k].kN_per_mm / ratios[from].kN_per_mm - 1.0; };
    // Besides noise, the allowed rise covers two effects. First, a device that softens with its displacement is stiffer
    // in a smaller cycle. Second, one sample more or less at a steep reversal changes kN_per_mm by a share of about 1 /
    // (number of samples in the cycle).
    double const allowed = least_rise + std::abs(cycles[k]->amplitude_mm / cycles[least]->amplitude_mm - 1.0) +
                           1.0 / (cycles[k]->last - cycles[k]->first) +
                           rise_deviations * std::hypot(ratios[k].deviation, ratios[least].deviation);
    constexpr double most_of_it = 0.8, clearly_more = 1.1;
    auto const from = share_from(k - 1) > most_of_it * share_from(least) ? k - 1 : least;
    if (share_from(least) > allowed && (!found || share_from(from) > clearly_more * found->share))
      found = {.from_cycle = cycles[from]->number, .cycle = cycles[k]->number, .share = share_from(from), .sample = {}};
    if (ratios[k].kN_per_mm < ratios[least].kN_per_mm) least = k;
  }
  if (!found) return found;
  auto const whole = unbroken(block, 4);
  if (whole.empty()) return found;
  auto const jump = sudden_change(repeats_of(view.force_kN, whole, LoopChannel::force), &Change::gain);
  if (jump && jump->change.gain > 0.5 * found->share) found->share = jump->change.gain, found->sample = jump->at;
  return found;
}

std::optional<Asymmetry> asymmetry(CycleView const& view, Block const& block) {
  auto const cycles = unbroken(block, 3);
  if (cycles.empty() || !cycles.back()->K_plus() || !cycles.back()->K_minus()) return std::nullopt;
  // In a symmetric loop, each value is the negative of the value half a cycle away (`opposite`, the mean of the values
  // half a cycle before and after). Half the sum of the two values is the asymmetry of the loop, and half their
  // difference is its size. The sums serve to fit asymmetry = gain * size.
  auto const sums_of = [&](std::span<double const> values) {
    Sums sums;
    for (std::size_t k = 1; k < cycles.size(); ++k) {
      double const half = (cycles[k]->last - cycles[k]->first) / 2.0;
      for (auto i = static_cast<std::size_t>(std::ceil(cycles[k]->first)); static_cast<double>(i) < cycles[k]->last;
           ++i) {
        auto const at = static_cast<double>(i);
        if (at + half > cycles.back()->last) break;
        double const opposite = (value_at(values, at - half) + value_at(values, at + half)) / 2.0;
        sums.add(std::abs(values[i] - opposite) / 2.0, (values[i] + opposite) / 2.0);
      }
    }
    return sums;
  };
  auto const force = sums_of(view.force_kN), disp = sums_of(view.disp_mm);
  double const gain = force.bd / force.bb, disp_gain = disp.bd / disp.bb;
  // Mean squared residuals of two fits to the asymmetry. by_gain: the asymmetry is proportional to the size, because
  // the gains of the directions differ. by_offset: the asymmetry is constant, because the zero is off.
  double const by_gain = (force.dd - gain * force.bd) / force.n,
               by_offset = (force.dd - force.d * force.d / force.n) / force.n;
  double peaks = 0.0, difference_of_peaks = 0.0;
  for (auto const* cycle : cycles | std::views::drop(1)) {
    peaks += cycle->F_plus_kN - cycle->F_minus_kN;
    difference_of_peaks += cycle->F_plus_kN + cycle->F_minus_kN;
  }
  Asymmetry found{.ratio = (1.0 + gain) / (1.0 - gain)};
  found.is_of_gain = std::abs(found.ratio - 1.0) > least_ratio && better_by * better_by * by_gain < by_offset &&
                     std::abs(difference_of_peaks / peaks / gain - 1.0) < same_at_peaks &&
                     std::abs(disp_gain) < same_in_disp * std::abs(gain);
  return found;
}

std::optional<OffsetStep> offset_step(CycleView const& view, Block const& block, LoopChannel channel) {
  auto const cycles = unbroken(block, 4);
  if (cycles.empty()) return std::nullopt;
  auto const values = channel == LoopChannel::force ? view.force_kN : view.disp_mm;
  auto const repeats = repeats_of(values, cycles, channel);
  auto const jump = sudden_change(repeats, &Change::offset);
  double const least = least_step * half_range(repeats.before);
  if (!jump || std::abs(jump->change.offset) < std::max(least, jump->change.left)) return std::nullopt;
  return OffsetStep{.jump = jump->change.offset, .sample = std::max(jump->at, cycles[1]->first)};
}

std::optional<Hum> hum(std::span<double const> values, CycleView const& view, Block const& block) {
  auto const cycles = block.counted();
  if (cycles.empty() || view.time_s.empty() || !block.frequency_Hz) return std::nullopt;
  auto const begin = static_cast<std::size_t>(std::ceil(cycles.front()->first));
  auto const end =
      std::min({static_cast<std::size_t>(cycles.back()->last) + 1, values.size(), begin + most_transformed});
  constexpr std::size_t fewest = 64;
  if (end < begin + fewest || !is_uniform(view.time_s, begin, end)) return std::nullopt;
  auto const count = end - begin;
  double const length_s = view.time_s[end - 1] - view.time_s[begin], rate = static_cast<double>(count - 1) / length_s;
  std::size_t padded = 1;
  while (padded < 2 * count) padded *= 2;
  double mean = 0.0;
  for (auto i = begin; i < end; ++i) mean += values[i] / static_cast<double>(count);
  std::vector<std::complex<double>> x(padded);
  for (std::size_t i = 0; i < count; ++i) {
    double const window =
        1.0 - std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
    x[i] = window * (values[begin + i] - mean);
  }
  transform(x);
  std::vector<double> lines(padded / 2 + 1);
  for (std::size_t k = 0; k < lines.size(); ++k)
    lines[k] = (k == padded / 2 ? 1.0 : 2.0) * std::abs(x[k]) / static_cast<double>(count);
  double const step = rate / static_cast<double>(padded);
  auto const in_steps = [&](double frequency) { return static_cast<std::size_t>(std::ceil(frequency / step)); };
  double const amplitude = half_range(values.subspan(begin, count));
  auto const lobe = in_steps(2.5 / length_s),
             reach = std::max(2 * lobe, in_steps(line_neighbours * *block.frequency_Hz));
  std::size_t largest = 0;
  for (auto k = in_steps(lowest_line * *block.frequency_Hz); k < lines.size(); ++k) {
    if (lines[k] < std::max(least_line * amplitude, largest == 0 ? 0.0 : lines[largest])) continue;
    auto const is_below = [&](std::size_t other) {
      double const nearer = std::min(1.0, static_cast<double>(other) / static_cast<double>(k));
      return line_contrast * lines[other] * nearer * nearer < lines[k];
    };
    bool stands_out = true;
    for (auto other = k > reach ? k - reach : 0; stands_out && other < std::min(lines.size(), k + reach + 1); ++other)
      if (other + lobe < k || other > k + lobe) stands_out = is_below(other);
    if (stands_out) largest = k;
  }
  if (largest == 0) return std::nullopt;
  double const frequency = step * static_cast<double>(largest);
  return Hum{.amplitude = lines[largest],
             .frequency_Hz = frequency,
             .rate_Hz = rate,
             .mains_Hz = mains_seen_at(frequency, rate, 1.0 / length_s)};
}

}  // namespace isolaw::data
