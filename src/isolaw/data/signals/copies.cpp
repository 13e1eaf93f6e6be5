#include "isolaw/data/signals/copies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

// The outline of a record (see Trace) has this many values of force from one pass to the next.
constexpr std::size_t outline_points = 16;
// A record with fewer than fewest_passes is not compared. Only the first most_passes of a record are used.
constexpr std::size_t fewest_passes = 4, most_passes = 64;
// The noises of two records are compared at this many samples: at least the first number, at most the second.
constexpr std::size_t fewest_compared_samples = 64, most_compared_samples = 4096;
// One outline is fitted as a factor times the other plus an offset. The two are alike if the rms error of this fit is
// below this fraction of the standard deviation of force along the outline.
constexpr double outlines_alike = 0.03;
// In the same way, all forces of one record are fitted to the forces of the other. If the rms error of this fit is
// below this fraction of the standard deviation of force, the records differ by rounding only.
constexpr double rounding_apart = 1e-4;
// Two records have the same noise if their noises correlate in step more than this many times as strongly as out of
// step.
constexpr double noise_stands_out = 5.0;

// The value at a fractional position, by a cubic through four samples (Catmull, Rom 1974).
double cubic_at(std::span<double const> values, double position) {
  auto const last = static_cast<std::ptrdiff_t>(values.size()) - 1;
  auto const i = std::clamp(static_cast<std::ptrdiff_t>(position), std::ptrdiff_t{0}, last - 1);
  auto const at = [&](std::ptrdiff_t k) {
    return values[static_cast<std::size_t>(std::clamp(k, std::ptrdiff_t{0}, last))];
  };
  double const u = position - static_cast<double>(i), a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
  return b + 0.5 * u * (c - a + u * (2.0 * a - 5.0 * b + 4.0 * c - d + u * (3.0 * (b - c) + d - a)));
}

// The fractional index of `instant` in rising times; `hint` is an index at or before it.
double position_of(std::span<double const> time, double instant, std::size_t& hint) {
  while (hint + 2 < time.size() && time[hint + 1] <= instant) ++hint;
  return static_cast<double>(hint) + (instant - time[hint]) / (time[hint + 1] - time[hint]);
}

void find_passes(Trace& trace) {
  auto const [least, largest] = std::ranges::minmax(trace.disp);
  double const middle = 0.5 * (least + largest), beyond = 0.05 * (largest - least);
  int side = 0;
  std::size_t crossed = 0;
  for (std::size_t i = 0; i < trace.disp.size() && trace.passes.size() < most_passes; ++i) {
    double const x = trace.disp[i] - middle;
    if (i > 0 && (x > 0.0) != (trace.disp[i - 1] - middle > 0.0)) crossed = i;
    int const now = x > beyond ? 1 : x < -beyond ? -1 : 0;
    if (now == 0 || now == side) continue;
    if (side != 0) {
      double const before = trace.disp[crossed - 1] - middle, after = trace.disp[crossed] - middle;
      if (trace.passes.empty()) trace.rises_first = now > 0;
      trace.passes.push_back(std::lerp(trace.time[crossed - 1], trace.time[crossed], before / (before - after)));
    }
    side = now;
  }
}

// y = factor x + offset. `error` is the rms distance of the points from this line / standard deviation of y.
struct Line {
  double factor = 1.0, offset = 0.0, error = 0.0;
};

Line fit_line(std::span<double const> x, std::span<double const> y) {
  auto const n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double const dx = x[i] - mean_x, dy = y[i] - mean_y;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
  }
  if (!(xx > 0.0) || !(yy > 0.0)) return {.factor = 0.0, .error = 1.0};
  double const factor = xy / xx;
  return {factor, mean_y - factor * mean_x, std::sqrt(std::max(0.0, 1.0 - factor * xy / yy))};
}

// Returns by how many passes `other` must be moved along `one` for the best agreement of their outlines; nullopt if the
// outlines agree nowhere.
std::optional<std::ptrdiff_t> best_step(Trace const& one, Trace const& other) {
  auto const n = static_cast<std::ptrdiff_t>(one.passes.size()), m = static_cast<std::ptrdiff_t>(other.passes.size());
  std::optional<std::ptrdiff_t> best;
  // The outlines of a copy and its original differ because noise was added to the force, and because noise of the
  // displacement moves the passes. So noisier records may differ more.
  double least = std::min(outlines_alike, 0.001 + 3.0 * std::max(one.noise_share, other.noise_share));
  for (std::ptrdiff_t step = -m; step <= n; ++step) {
    if ((step % 2 == 0) != (one.rises_first == other.rises_first)) continue;
    auto const first = std::max<std::ptrdiff_t>(0, -step), count = std::min(m, n - step) - first;
    if (count < static_cast<std::ptrdiff_t>(fewest_passes) || 4 * count < 3 * std::max(n, m)) continue;
    auto const size = static_cast<std::size_t>(count - 1) * outline_points;
    auto const line =
        fit_line(std::span(one.outline).subspan(static_cast<std::size_t>(first + step) * outline_points, size),
                 std::span(other.outline).subspan(static_cast<std::size_t>(first) * outline_points, size));
    if (line.factor > 0.0 && line.error < least) least = line.error, best = step;
  }
  return best;
}

// The noise of a signal: each sample less the least-squares cubic through seven samples, each `stride` from the next
// (Savitzky, Golay 1964). Zero where it is far larger than usual, as at the corners of a loop.
std::vector<double> noise_of(std::span<double const> y, std::size_t stride) {
  std::vector<double> noise(y.size());
  for (std::size_t i = 3 * stride; i + 3 * stride < y.size(); ++i) {
    auto const both = [&](std::size_t k) { return y[i - k * stride] + y[i + k * stride]; };
    noise[i] = y[i] - (7.0 * y[i] + 6.0 * both(1) + 3.0 * both(2) - 2.0 * both(3)) / 21.0;
  }
  std::vector<double> sizes;
  for (double const value : noise) sizes.push_back(std::abs(value));
  auto const middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  for (double& value : noise)
    if (std::abs(value) > 5.0 * *middle) value = 0.0;
  return noise;
}

// Subtracts the part of the force's noise that follows from the noise of the displacement, because different tests with
// the same motion may share this part.
void take_off(std::vector<double>& noise, std::span<double const> of_disp) {
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < noise.size(); ++i) xx += of_disp[i] * of_disp[i], xy += noise[i] * of_disp[i];
  if (xx > 0.0)
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= xy / xx * of_disp[i];
}

double correlation_at(std::span<double const> one, std::span<double const> other, std::ptrdiff_t lag) {
  double sum = 0.0, a = 0.0, b = 0.0;
  auto const n = static_cast<std::ptrdiff_t>(one.size());
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -lag); i < std::min(n, n - lag); ++i) {
    double const x = one[static_cast<std::size_t>(i + lag)], y = other[static_cast<std::size_t>(i)];
    sum += x * y, a += x * x, b += y * y;
  }
  return a > 0.0 && b > 0.0 ? sum / std::sqrt(a * b) : 0.0;
}

// Whether two noises correlate in step and far less out of step. Out of step means shifted by some samples, or by half
// a cycle to two cycles: a disturbance that the rig repeats in every cycle would correlate there too.
bool is_same_noise(std::span<double const> one, std::span<double const> other, double cycle) {
  double const in_step = correlation_at(one, other, 0);
  if (in_step * std::sqrt(static_cast<double>(one.size())) < 0.7 * noise_stands_out) return false;
  double squares = 0.0, largest = 0.0;
  int count = 0;
  auto const try_lag = [&](std::ptrdiff_t lag) {
    // With a lag of more than half the samples, the two noises overlap in too few samples to be correlated.
    if (2 * std::abs(lag) > static_cast<std::ptrdiff_t>(one.size())) return;
    double const found = correlation_at(one, other, lag);
    squares += found * found, largest = std::max(largest, std::abs(found)), ++count;
  };
  for (std::ptrdiff_t lag = 4; lag <= 40; ++lag) try_lag(lag), try_lag(-lag);
  for (double const cycles : {0.5, 1.0, 2.0})
    for (std::ptrdiff_t near = -3; near <= 3; ++near)
      for (double const sign : {-1.0, 1.0}) try_lag(std::lround(sign * cycles * cycle) + near);
  return in_step > noise_stands_out * std::sqrt(squares / count) && in_step > 1.5 * largest;
}

double root_mean_square(std::span<double const> values) {
  double squares = 0.0;
  for (double const value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

std::vector<double> left_of(std::span<double const> y, std::span<double const> x, Line const& line) {
  std::vector<double> left(y.begin(), y.end());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] -= line.factor * x[i] + line.offset;
  return left;
}

// Estimates, by one Gauss-Newton step, by how many samples `one` must be moved on to agree best with `other`.
double shift_between(std::span<double const> one, std::span<double const> other) {
  std::vector<double> slope(one.size());
  for (std::size_t i = 1; i + 1 < one.size(); ++i) slope[i] = 0.5 * (one[i + 1] - one[i - 1]);
  auto const line = fit_line(one, other);
  auto const step = fit_line(left_of(slope, one, fit_line(one, slope)), left_of(other, one, line));
  return std::clamp(step.factor / line.factor, -1.0, 1.0);
}

// Whether the values are white noise: values that are 1 to 10 samples apart do not correlate.
bool is_white(std::span<double const> values) {
  constexpr int lags = 10;
  double sum = 0.0;
  for (int lag = 1; lag <= lags; ++lag) sum += correlation_at(values, values, lag);
  return sum < 3.0 * std::sqrt(lags / static_cast<double>(values.size()));
}

}  // namespace

Trace trace_of(TestRecord const& record) {
  Trace trace;
  trace.time = record.time_s, trace.disp = record.disp_mm, trace.force = record.force_kN;
  if (trace.time.size() != record.size() ||
      std::ranges::adjacent_find(trace.time, std::greater_equal()) != trace.time.end()) {
    trace.time.resize(record.size());
    for (std::size_t i = 0; i < trace.time.size(); ++i) trace.time[i] = static_cast<double>(i);
  }
  if (record.size() < fewest_compared_samples) return trace;
  find_passes(trace);
  if (trace.passes.empty()) return trace;
  // A test usually has this many samples from one pass to the next. In a record with more samples, neighbouring samples
  // share noise, so only every `stride`th sample is compared.
  constexpr double usual_samples = 64.0;
  trace.stride = std::max<std::size_t>(1, static_cast<std::size_t>(trace.samples_per_pass() / usual_samples));
  trace.noise = noise_of(trace.force, trace.stride);
  trace.disp_noise = noise_of(trace.disp, trace.stride);
  take_off(trace.noise, trace.disp_noise);
  trace.noise_share = root_mean_square(trace.noise) / num::population_std(trace.force);
  std::size_t hint = 0;
  for (std::size_t pass = 0; pass + 1 < trace.passes.size(); ++pass)
    for (std::size_t k = 0; k < outline_points; ++k) {
      double const instant = std::lerp(trace.passes[pass], trace.passes[pass + 1],
                                       static_cast<double>(k) / static_cast<double>(outline_points));
      trace.outline.push_back(cubic_at(trace.force, position_of(trace.time, instant, hint)));
    }
  return trace;
}

bool is_altered_copy(Trace const& one, Trace const& other) {
  if (one.passes.size() < fewest_passes || other.passes.size() < fewest_passes) return false;
  double const finer = one.samples_per_pass() / other.samples_per_pass();
  if (finer < 1.0) return is_altered_copy(other, one);  // from here on, `other` has fewer samples per pass than `one`
  auto const step = best_step(one, other);
  if (!step) return false;
  auto const first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -*step));
  auto const from = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(first) + *step);
  auto const count = std::min(other.passes.size() - first, one.passes.size() - from);
  auto const passes = std::span(other.passes).subspan(first, count);
  auto const own_passes = std::span(one.passes).subspan(from, count);
  auto scale = fit_line(passes, own_passes);
  // A factor this close to 1 differs from 1 only because noise moves the passes: both records have the same time scale.
  if (std::abs(scale.factor - 1.0) < 0.005)
    scale = {.offset = num::moments(own_passes).mean - num::moments(passes).mean};
  auto const index = [&](double instant) { return std::ranges::lower_bound(other.time, instant) - other.time.begin(); };
  auto const picked = [&, begin = index(passes.front()), end = index(passes.back())](std::vector<double> const& all) {
    std::vector<double> some;
    for (auto i = begin; i < end && some.size() < most_compared_samples; i += static_cast<std::ptrdiff_t>(other.stride))
      some.push_back(all[static_cast<std::size_t>(i)]);
    return some;
  };
  auto const time = picked(other.time), force = picked(other.force), noise = picked(other.noise);
  if (time.size() < fewest_compared_samples) return false;
  double const interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  // Returns the values of a signal of `one` at the times of `other` plus `shift` sampling intervals.
  auto const laid = [&](std::vector<double> const& signal, double shift) {
    std::vector<double> values;
    std::size_t hint = 0;
    for (double const instant : time)
      values.push_back(
          cubic_at(signal, position_of(one.time, scale.offset + scale.factor * (instant + shift * interval), hint)));
    return values;
  };
  // The passes bring the records together to within a sample. The shift that remains follows from the forces.
  double shift = 0.0;
  for (int i = 0; i < 3; ++i) shift += shift_between(laid(one.force, shift), force);
  if (!(std::abs(shift) < 2.0)) return false;
  auto const own_force = laid(one.force, shift);
  auto const line = fit_line(own_force, force);
  // The forces of two devices may differ by a mere factor. In records without noise, such as computed ones, only equal
  // forces therefore show a copy.
  if (line.error < rounding_apart && std::abs(line.factor - 1.0) < rounding_apart) return true;
  auto const left = left_of(force, own_force, line);
  if (root_mean_square(left) > root_mean_square(noise) && !is_white(left)) return false;
  // If the records have different sampling, the noise of `one` is computed from its values at the instants of `other`.
  bool const same_sampling = finer < 1.1;
  double const cycle = 2.0 * (passes.back() - passes.front()) / static_cast<double>(count - 1) / interval;
  auto const own = same_sampling ? laid(one.noise, shift) : noise_of(own_force, 1);
  if (is_same_noise(own, noise, cycle)) return true;
  // If one force is so noisy that the noise of the other cannot be seen in it, the noise of the displacements decides.
  double const quieter = line.factor * root_mean_square(own) / root_mean_square(noise);
  if (std::min(quieter, 1.0 / quieter) * std::sqrt(static_cast<double>(noise.size())) > 2.0 * noise_stands_out)
    return false;
  auto const own_disp = same_sampling ? laid(one.disp_noise, shift) : noise_of(laid(one.disp, shift), 1);
  return is_same_noise(own_disp, picked(other.disp_noise), cycle);
}

bool is_same_record(TestRecord const& one, TestRecord const& other) {
  if (one.size() == 0 && other.size() == 0) return one.sha256 == other.sha256;
  return one.disp_mm == other.disp_mm && one.force_kN == other.force_kN;
}

std::vector<std::vector<std::size_t>> groups_of_copies(std::span<TestRecord const* const> records) {
  std::vector<Trace> traces;
  if (records.size() <= most_compared)
    for (auto const* record : records) traces.push_back(trace_of(*record));
  auto const is_copy = [&](std::size_t first, std::size_t other) {
    return is_same_record(*records[first], *records[other]) ||
           (!traces.empty() && is_altered_copy(traces[first], traces[other]));
  };
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (records[i]->size() == 0 && records[i]->sha256.empty()) continue;
    auto found = std::ranges::find_if(groups, [&](auto const& group) { return is_copy(group.front(), i); });
    if (found == groups.end()) found = groups.insert(groups.end(), {{}});
    found->push_back(i);
  }
  std::erase_if(groups, [](auto const& group) { return group.size() < 2; });
  return groups;
}

}  // namespace isolaw::data
