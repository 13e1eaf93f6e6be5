#include "isolaw/data/skew.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace isolaw::data {
namespace {

constexpr double window = 0.08;          // of a cycle, to each side of a reversal: half a radian
constexpr double farthest_shift = 0.04;  // of a cycle: a quarter of a radian
constexpr int shifts = 41;
constexpr std::size_t least_samples = 12;  // in a window: twice the unknowns
constexpr std::size_t most_samples = 400;  // in a window: of more, every so many-th is used
constexpr std::size_t most_cycles = 12;
constexpr int least_reversals = 4;
constexpr double poor_fit = 0.012;    // rms of the force's amplitude: the force is not smooth there
constexpr double least_late = 0.015;  // rad
constexpr double least_early = 0.04;

struct Reversal {
  double at = 0.0;      // fractional sample index
  double cycle = 0.0;   // samples of a cycle
  double tip_mm = 0.0;  // displacement
  double reach_mm = 0.0;
};

// Columns of the fit: the tip, parabola before and cubic after, in the distance from the tip.
constexpr std::size_t unknowns = 6;
using Row = std::array<double, unknowns>;

Row row_of(double distance, bool before) {
  double const s = distance;
  return before ? Row{1.0, s, s * s, 0.0, 0.0, 0.0} : Row{1.0, 0.0, 0.0, s, s * s, s * s * s};
}

// Sum of squares that the columns leave of the values, by modified Gram-Schmidt, a column at a time.
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

// What is left when the force is taken to be `shift` samples late. Displacement is shifted, not the force: it is the
// smoother of the two, and interpolating noise would make it smaller between samples.
double left_at(double shift, Reversal const& reversal, CycleView const& view) {
  double const half = window * reversal.cycle;
  auto const begin = static_cast<std::size_t>(std::ceil(reversal.at - half));
  auto const end = static_cast<std::size_t>(std::floor(reversal.at + half));
  std::vector<Row> rows;
  std::vector<double> values;
  auto const stride = std::max<std::size_t>(1, (end - begin) / most_samples);
  for (auto i = begin; i <= end; i += stride) {
    double const then = static_cast<double>(i) - shift;
    double const distance = (value_at(view.disp_mm, then) - reversal.tip_mm) / reversal.reach_mm;
    rows.push_back(row_of(distance, then < reversal.at));
    values.push_back(view.force_kN[i]);
  }
  return residual(rows, values) / static_cast<double>(values.size());
}

// The shift in samples at which least is left, nullopt at the edge of the search or where the fit is poor.
std::optional<double> best_shift(Reversal const& reversal, CycleView const& view, double force_amplitude) {
  double const farthest = farthest_shift * reversal.cycle;
  double const step = 2.0 * farthest / (shifts - 1);
  double const room = window * reversal.cycle + farthest + 2.0;
  if (reversal.at < room || reversal.at + room > static_cast<double>(view.disp_mm.size() - 1)) return std::nullopt;
  if (2.0 * window * reversal.cycle < static_cast<double>(least_samples)) return std::nullopt;
  std::array<double, shifts> left{};
  for (int k = 0; k < shifts; ++k) left[static_cast<std::size_t>(k)] = left_at(-farthest + k * step, reversal, view);
  auto const best = static_cast<std::size_t>(std::ranges::min_element(left) - left.begin());
  if (best == 0 || best + 1 == shifts) return std::nullopt;
  if (!(std::sqrt(left[best]) <= poor_fit * force_amplitude)) return std::nullopt;
  double const curvature = left[best - 1] - 2.0 * left[best] + left[best + 1];
  double const offset = curvature > 0.0 ? (left[best - 1] - left[best + 1]) / (2.0 * curvature) : 0.0;
  return -farthest + (static_cast<double>(best) + offset) * step;
}

std::vector<Cycle const*> chosen_cycles(Properties const& properties) {
  auto const all = properties.counted();
  std::vector<Cycle const*> chosen;
  auto const step = (all.size() + most_cycles - 1) / most_cycles;
  for (std::size_t k = 0; k < all.size(); k += std::max<std::size_t>(1, step)) chosen.push_back(all[k]);
  return chosen;
}

}  // namespace

bool Skew::significant() const {
  return std::abs(force_late) > uncertainty && (phase > least_late || phase < -least_early);
}

std::optional<Skew> estimate_skew(CycleView const& view, Properties const& properties) {
  std::vector<double> phases, intervals;
  for (auto const* cycle : chosen_cycles(properties)) {
    auto const peaks = peak_positions(view.disp_mm, cycle->first, cycle->last);
    double const length = 2.0 * std::abs(peaks.largest - peaks.smallest);
    double const force_amplitude = std::abs(cycle->F_plus_kN - cycle->F_minus_kN) / 2.0;
    for (bool const upper : {true, false}) {
      Reversal const reversal{.at = upper ? peaks.largest : peaks.smallest,
                              .cycle = length,
                              .tip_mm = upper ? cycle->d_plus_mm : cycle->d_minus_mm,
                              .reach_mm = 0.15 * cycle->amplitude_mm};
      auto const shift = best_shift(reversal, view, force_amplitude);
      if (!shift) continue;
      double const interval =
          view.time_s.empty()
              ? 1.0
              : (value_at(view.time_s, reversal.at + 1.0) - value_at(view.time_s, reversal.at - 1.0)) / 2.0;
      phases.push_back(2.0 * std::numbers::pi * *shift / length);
      intervals.push_back(interval * length / (2.0 * std::numbers::pi));
    }
  }
  if (static_cast<int>(phases.size()) < least_reversals) return std::nullopt;
  std::vector<double> late;
  for (std::size_t k = 0; k < phases.size(); ++k) late.push_back(phases[k] * intervals[k]);
  auto const median = [](std::vector<double> values) {
    std::ranges::sort(values);
    auto const half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
  };
  Skew found;
  found.force_late = median(late);
  found.phase = median(phases);
  found.reversals = static_cast<int>(late.size());
  double squares = 0.0;
  for (double const value : late) squares += (value - found.force_late) * (value - found.force_late);
  auto const count = static_cast<double>(late.size());
  double const sampling =
      view.time_s.empty() ? 1.0
                          : (view.time_s.back() - view.time_s.front()) / static_cast<double>(view.time_s.size() - 1);
  found.uncertainty = std::max(2.0 * std::sqrt(squares / (count - 1.0) / count), 0.1 * sampling);
  return found;
}

}  // namespace isolaw::data
