#include "isolaw/data/properties/skew.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "isolaw/base/runs.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::data {
namespace {

constexpr double wide = 0.08;    // length of the wide window on each side of a reversal, in cycles: half a radian
constexpr double narrow = 0.04;  // length of the narrow window, in cycles; even a sharp loop is smooth in it
constexpr double farthest_shift = 0.04;  // fraction of a cycle: a quarter of a radian; larger shifts are not tried
constexpr int shifts = 41;
constexpr std::size_t least_in_window = 12;  // fewest samples in a window: twice the number of unknowns
constexpr std::size_t most_samples = 400;    // most samples in a window; a window with more is thinned
constexpr std::size_t most_cycles = 12;
constexpr int least_reversals = 4;
constexpr double poor_fit = 0.012;    // rms residual over the force's amplitude; a worse fit gives no skew
constexpr double good_fit = 0.0012;   // as poor_fit, less noise; in a worse fit a loop's shape may look like a delay
constexpr double least_late = 0.015;  // rad; a smaller delay is no skew
constexpr double least_late_by_shape = 0.045;  // rad; as least_late, for a loop that is too sharp to be fitted
constexpr double least_early = 0.04;
constexpr double standard_errors = 4.0;  // a skew must exceed this many standard errors
constexpr double by_chance = 0.001;      // at most this fraction of records without skew may seem late by chance
constexpr double most_agree = 0.75;      // least fraction of the reversals that must show the skew
constexpr double least_growth = 0.03;    // rad; a delay that changes by less within the test does not grow
constexpr double most_apart = 0.004;     // rad; the wide and the narrow window agree if their skews differ by less
constexpr double quiet = 0.0005;         // fraction of the amplitude; less noise needs no smoothing
constexpr double too_noisy = 0.01;       // fraction of the amplitude; noisier records give no skew
constexpr double smoothed_over = 0.06;   // fraction of a cycle on each side; smoothing over it takes 0.02 % off a sine
constexpr double hold_band = 0.005;      // fraction of the amplitude; a hold stays within it
constexpr double noise_band = 8.0;  // the extremes of a hold may be this many standard deviations of the noise apart
constexpr std::size_t most_smoothed = 100;  // samples on each side; more bring little and cost time

struct Reversal {
  double at = 0.0;      // fractional sample index
  double cycle = 0.0;   // samples in a cycle
  double tip_mm = 0.0;  // displacement at the reversal
  double reach_mm = 0.0;
  double friction_kN = 0.0;  // at the reversal, friction changes from plus this value to minus this value
};

// The fit has six unknowns: force at the tip, two coefficients of a parabola before it and three of a cubic after it.
constexpr std::size_t unknowns = 6;
using Row = std::array<double, unknowns>;

Row row_of(double distance, bool before) {
  double const s = distance;
  return before ? Row{1.0, s, s * s, 0.0, 0.0, 0.0} : Row{1.0, 0.0, 0.0, s, s * s, s * s * s};
}

// The sum of squared residuals of a least-squares fit (modified Gram-Schmidt, column by column).
double residual(std::vector<Row>& rows, std::vector<double>& values) {
  for (std::size_t k = 0; k < unknowns; ++k) {
    double size = 0.0;
    for (auto const& row : rows) size += row[k] * row[k];
    if (!(size > 0.0)) continue;
    std::array<double, unknowns> with{};
    double with_values = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = k + 1; j < unknowns; ++j) with[j] += rows[i][k] * rows[i][j];
      with_values += rows[i][k] * values[i];
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = k + 1; j < unknowns; ++j) rows[i][j] -= with[j] / size * rows[i][k];
      values[i] -= with_values / size * rows[i][k];
    }
  }
  double sum = 0.0;
  for (double const value : values) sum += value * value;
  return sum;
}

// Returns the mean squared residual of the fit for one shift. Shifts displacement and not force, because interpolation
// would lower the noise of the force and so favour some shifts.
double left_at(double shift, double window, Reversal const& reversal, CycleView const& view) {
  double const half = window * reversal.cycle;
  auto const begin = static_cast<std::size_t>(std::ceil(reversal.at - half));
  auto const end = static_cast<std::size_t>(std::floor(reversal.at + half));
  std::vector<Row> rows;
  std::vector<double> values;
  auto const stride = std::max<std::size_t>(1, (end - begin) / most_samples);
  for (auto i = begin; i <= end; i += stride) {
    double const then = static_cast<double>(i) - shift;
    double const distance = (value_at(view.disp_mm, then) - reversal.tip_mm) / reversal.reach_mm;
    bool const before = then < reversal.at;
    rows.push_back(row_of(distance, before));
    values.push_back(view.force_kN[i] - (before ? reversal.friction_kN : -reversal.friction_kN));
  }
  return residual(rows, values) / static_cast<double>(values.size());
}

struct Shift {
  double samples = 0.0;
  double left = 0.0;  // rms residual over the force's amplitude
};

// The shift with the smallest residual. nullopt if this shift is at the edge of the search, or if the fit is poor.
std::optional<Shift> best_shift(double window, Reversal const& reversal, CycleView const& view,
                                double force_amplitude) {
  double const farthest = farthest_shift * reversal.cycle;
  double const step = 2.0 * farthest / (shifts - 1);
  double const room = window * reversal.cycle + farthest + 2.0;
  if (reversal.at < room || reversal.at + room > static_cast<double>(view.disp_mm.size() - 1)) return std::nullopt;
  if (2.0 * window * reversal.cycle < static_cast<double>(least_in_window)) return std::nullopt;
  std::array<double, shifts> left{};
  for (int k = 0; k < shifts; ++k)
    left[static_cast<std::size_t>(k)] = left_at(-farthest + k * step, window, reversal, view);
  auto const best = static_cast<std::size_t>(std::ranges::min_element(left) - left.begin());
  if (best == 0 || best + 1 == shifts) return std::nullopt;
  double const least = std::sqrt(left[best]) / force_amplitude;
  if (!(least <= poor_fit)) return std::nullopt;
  double const curvature = left[best - 1] - 2.0 * left[best] + left[best + 1];
  double const offset = curvature > 0.0 ? (left[best - 1] - left[best + 1]) / (2.0 * curvature) : 0.0;
  return Shift{.samples = -farthest + (static_cast<double>(best) + offset) * step, .left = least};
}

bool is_held(std::span<double const> x, double at, double tip, Cycle const& cycle, double noise) {
  constexpr double longer = 1.5;
  double const width = std::max(hold_band * cycle.amplitude_mm, noise_band * noise);
  auto const below = [&](std::ptrdiff_t i) { return std::abs(x[static_cast<std::size_t>(i)] - tip); };
  auto const stays = [&](std::ptrdiff_t step) {
    auto const size = static_cast<std::ptrdiff_t>(x.size());
    auto const start = static_cast<std::ptrdiff_t>(std::lround(at));
    auto i = start;
    while (i >= 0 && i < size && below(i) <= width) i += step;
    if (i < 0 || i >= size || i == start) return static_cast<double>(std::abs(i - start));
    double const inner = below(i - step), outer = below(i);
    return static_cast<double>(std::abs(i - start)) - (outer - width) / (outer - inner);
  };
  double const share = std::acos(std::max(-1.0, 1.0 - width / cycle.amplitude_mm)) / std::numbers::pi;
  double const lingers = share * (cycle.last - cycle.first);
  return stays(-1) + stays(1) > longer * lingers + 1.0;  // one sample more, because the tip rarely lies on a sample
}

std::vector<Cycle const*> chosen_cycles(Properties const& properties) {
  std::vector<Cycle const*> all;  // only cycles without holds, because force relaxes in a hold
  for (auto const* cycle : properties.counted())
    if (cycle->still_samples == 0.0) all.push_back(cycle);
  std::vector<Cycle const*> chosen;
  auto const step = (all.size() + most_cycles - 1) / most_cycles;
  for (std::size_t k = 0; k < all.size(); k += std::max<std::size_t>(1, step)) chosen.push_back(all[k]);
  return chosen;
}

double samples_of(Cycle const* cycle) {
  return cycle->last - cycle->first;
}

// Replaces each sample by the value of a least-squares parabola through its neighbourhood. Leaves both ends as they
// are.
std::vector<double> smoothed(std::span<double const> x, std::size_t half) {
  std::vector<double> smooth(x.begin(), x.end());
  auto const h = static_cast<double>(half);
  double const count = 2.0 * h + 1.0;
  double const second = h * (h + 1.0) * count / 3.0;                   // sum of k^2
  double const fourth = second * (3.0 * h * h + 3.0 * h - 1.0) / 5.0;  // sum of k^4
  double const scale = count * fourth - second * second;
  for (std::size_t i = half; i + half < x.size(); ++i) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t j = 0; j <= 2 * half; ++j) {
      double const k = static_cast<double>(j) - h;
      sum += x[i - half + j];
      squares += k * k * x[i - half + j];
    }
    smooth[i] = (fourth * sum - second * squares) / scale;
  }
  return smooth;
}
struct Sample {
  double at = 0.0;  // fractional sample index
  int block = 0, cycle = 0;
  double phase = 0.0;              // rad
  double late = 0.0;               // in s, or in samples without time
  double left = 0.0, noise = 0.0;  // rms residual of the fit and rms noise, both over the force's amplitude
  double samples = 0.0;            // number of samples in the window
};

// Fits a line to the delays of the reversals in one block. Its rise over the block is the growth of the delay.
void add_growth(Skew& skew, std::vector<Sample> samples, int block) {
  std::erase_if(samples, [&](Sample const& each) { return each.block != block; });
  each_run(std::span(std::as_const(samples)), &Sample::cycle, [&](std::span<Sample const> of_cycle) {
    skew.cycle_delays.push_back({of_cycle.front().cycle, num::median_over(of_cycle, &Sample::late)});
  });
  if (samples.size() < 3) return;
  auto const count = static_cast<double>(samples.size());
  double at = 0.0, late = 0.0, squares = 0.0, product = 0.0, left = 0.0;
  for (auto const& each : samples) at += each.at / count, late += each.late / count;
  for (auto const& each : samples) {
    squares += (each.at - at) * (each.at - at);
    product += (each.at - at) * (each.late - late);
  }
  auto const [first, last] = std::ranges::minmax(samples, {}, &Sample::at);
  if (!(squares > 0.0)) return;
  skew.growth_reversals = static_cast<int>(samples.size());
  double const slope = product / squares, length = last.at - first.at;
  for (auto const& each : samples) left += std::pow(each.late - late - slope * (each.at - at), 2.0);
  skew.growth = slope * length;
  skew.growth_uncertainty = 2.0 * length * std::sqrt(left / (count - 2.0) / squares);
  if (skew.force_late != 0.0) skew.growth_phase = skew.growth * skew.phase / skew.force_late;
}

std::optional<Skew> skew_of(std::vector<Sample> const& samples, double least_uncertainty, int block) {
  if (static_cast<int>(samples.size()) < least_reversals) return std::nullopt;
  auto const count = static_cast<double>(samples.size());
  Skew found;
  found.force_late = num::median_over(samples, &Sample::late);
  found.phase = num::median_over(samples, &Sample::phase);
  found.reversals = static_cast<int>(samples.size());
  auto const agrees = [&](Sample const& each) { return each.late / found.force_late >= 0.5; };
  found.agreement = static_cast<double>(std::ranges::count_if(samples, agrees)) / count;
  double squares = 0.0;
  for (auto const& each : samples) squares += (each.late - found.force_late) * (each.late - found.force_late);
  found.uncertainty = std::max(2.0 * std::sqrt(squares / (count - 1.0) / count), least_uncertainty);
  double excess = 0.0, chance = 0.0;
  for (auto const& each : samples) {
    excess += (each.left * each.left - each.noise * each.noise) / count;
    chance += 2.0 * std::pow(each.noise, 4.0) / each.samples / count / count;
  }
  add_growth(found, samples, block);
  found.is_followed = excess < good_fit * good_fit + 2.0 * std::sqrt(chance);
  return found;
}

// The longest mean sampling interval of the tests, in s; 1 sample without time.
double longest_interval(CycleView const& view) {
  if (view.time_s.empty()) return 1.0;
  double longest = 0.0;
  for (auto const& test : test_ranges(view.starts, view.time_s.size())) {
    auto const time = test.slice(view.time_s);
    longest = std::max(longest, (time.back() - time.front()) / static_cast<double>(time.size() - 1));
  }
  return longest;
}

}  // namespace

bool held_at_extreme(std::span<double const> disp_mm, Cycle const& cycle, bool upper, double noise_mm) {
  auto const peaks = peak_positions(disp_mm, cycle.first, cycle.last);
  return is_held(disp_mm, upper ? peaks.largest : peaks.smallest, upper ? cycle.d_plus_mm : cycle.d_minus_mm, cycle,
                 noise_mm);
}

bool Skew::significant() const {
  // Uses Student's t, because a few reversals give a poor estimate of the scatter.
  boost::math::students_t const chance(std::max(1, reversals - 1));
  double const errors = std::max(standard_errors, boost::math::quantile(boost::math::complement(chance, by_chance)));
  return std::abs(force_late) > errors / 2.0 * uncertainty && agreement >= most_agree &&
         ((is_followed ? phase > least_late : phase > least_late_by_shape && force_late > interval) ||
          phase < -least_early);
}

bool Skew::grows() const {
  boost::math::students_t const chance(std::max(1, growth_reversals - 2));
  double const errors = std::max(standard_errors, boost::math::quantile(boost::math::complement(chance, by_chance)));
  return growth_reversals >= 5 && std::abs(growth_phase) > least_growth &&
         std::abs(growth) > errors / 2.0 * growth_uncertainty;
}

std::optional<Skew> estimate_skew(CycleView const& of, Properties const& properties, double friction_kN) {
  auto const cycles = chosen_cycles(properties);
  if (cycles.empty()) return std::nullopt;
  auto const amplitude = std::ranges::min(cycles, {}, &Cycle::amplitude_mm)->amplitude_mm;
  double const noise = noise_deviation(of.disp_mm), force_noise = noise_deviation(of.force_kN);
  if (noise > too_noisy * amplitude) return std::nullopt;
  CycleView view = of;
  std::vector<double> smooth;
  double left_of_noise = noise;
  if (noise > quiet * amplitude) {
    auto const* shortest = std::ranges::min(cycles, {}, samples_of);
    auto const half =
        std::clamp<std::size_t>(static_cast<std::size_t>(smoothed_over * samples_of(shortest)), 2, most_smoothed);
    smooth = smoothed(of.disp_mm, half);
    view.disp_mm = smooth;
    // Smoothing leaves 9 / (4 (2 half + 1)) of the noise's variance.
    left_of_noise *= 1.5 / std::sqrt(2.0 * static_cast<double>(half) + 1.0);
  }
  std::vector<Sample> of_wide, of_narrow;
  for (auto const* cycle : cycles) {
    auto const peaks = peak_positions(view.disp_mm, cycle->first, cycle->last);
    double const length = samples_of(cycle);
    double const force_amplitude = std::abs(cycle->F_plus_kN - cycle->F_minus_kN) / 2.0;
    for (bool const upper : {true, false}) {
      double const at = upper ? peaks.largest : peaks.smallest;
      double const raw_tip = upper ? cycle->d_plus_mm : cycle->d_minus_mm;
      Reversal const reversal{.at = at,
                              .cycle = length,
                              .tip_mm = smooth.empty() ? raw_tip : value_at(smooth, at),
                              .reach_mm = 0.15 * cycle->amplitude_mm,
                              .friction_kN = upper ? friction_kN : -friction_kN};
      // Leaves out reversals with a hold. Noise can hide a hold, but little noise is left in the smoothed displacement.
      if (held_at_extreme(of.disp_mm, *cycle, upper, noise) ||
          is_held(view.disp_mm, at, reversal.tip_mm, *cycle, left_of_noise))
        continue;
      auto const add = [&](double window, std::vector<Sample>& to) {
        auto const shift = best_shift(window, reversal, view, force_amplitude);
        if (!shift) return;
        double const interval =
            view.time_s.empty()
                ? 1.0
                : (value_at(view.time_s, reversal.at + 1.0) - value_at(view.time_s, reversal.at - 1.0)) / 2.0;
        to.push_back({.at = reversal.at,
                      .block = cycle->block,
                      .cycle = cycle->number,
                      .phase = 2.0 * std::numbers::pi * shift->samples / length,
                      .late = shift->samples * interval,
                      .left = shift->left,
                      .noise = force_noise / force_amplitude,
                      .samples = 2.0 * window * length});
      };
      add(wide, of_wide);
      if (noise < quiet / 4.0 * amplitude) add(narrow, of_narrow);
    }
  }
  double const sampling = longest_interval(view);
  // Friction changes its sign between two samples, which makes the skew uncertain by half an interval.
  double const least = (friction_kN != 0.0 ? 0.5 : 0.1) * sampling;
  int const block = properties.reported ? properties.reported->block : 0;
  auto found = skew_of(of_wide, least, block), near = skew_of(of_narrow, least, block);
  for (auto* skew : {&found, &near})
    if (*skew) (*skew)->interval = sampling;
  // The shape of the loop disturbs only the fit in the wide window; noise disturbs the fit in the narrow window more.
  // So the narrow window is taken only if the wide one has a poor fit and the two clearly differ.
  if (!near || !found) return near ? near : found;
  double const apart = std::abs(near->phase - found->phase);
  double const unsure = std::abs(near->uncertainty * near->phase / near->force_late);
  return !found->is_followed && apart > std::max(most_apart, unsure) ? near : found;
}

}  // namespace isolaw::data
