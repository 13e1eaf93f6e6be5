#include "isolaw/analysis/steady_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/row_kernels.hpp"

namespace isolaw::analysis {
namespace {

constexpr std::size_t per_cycle = 4000, cycles = 3;
// SteadyCycle::jump looks for jumps of force only where |displacement| is below this fraction of the amplitude. Nearer
// to the peaks a plausible force may change fast.
constexpr double inner_part = 0.8;

// The sine motion as a record. Its force of 1 kN per mm stands for a measured force: the kernels compute the difference
// between this force and a law's, from which steady_cycles() gets the law's force. Any force that varies would do.
data::FitRecord sine(SteadyMotion const& motion) {
  data::FitRecord record;
  double const rate = 2.0 * std::numbers::pi / motion.period_s;
  for (std::size_t i = 0; i <= cycles * per_cycle; ++i) {
    double const t = motion.period_s * static_cast<double>(i) / static_cast<double>(per_cycle);
    record.time_s.push_back(t);
    record.disp_mm.push_back(motion.amplitude_mm * std::sin(rate * t));
    record.vel_mm_s.push_back(motion.amplitude_mm * rate * std::cos(rate * t));
    record.force_kN.push_back(record.disp_mm.back());
  }
  return record;
}

SteadyCycle third_cycle(std::vector<double> const& F, std::vector<double> const& x, double amplitude_mm) {
  SteadyCycle cycle{.finite = std::ranges::all_of(F, [](double f) { return std::isfinite(f); })};
  if (!cycle.finite) return cycle;
  std::size_t const first = 2 * per_cycle, last = 3 * per_cycle;
  double steepest = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    cycle.energy_kN_mm += 0.5 * (F[i] + F[i + 1]) * (x[i + 1] - x[i]);
    cycle.largest_kN = std::max(cycle.largest_kN, std::abs(F[i]));
    bool const inside = std::max(std::abs(x[i]), std::abs(x[i + 1])) < inner_part * amplitude_mm;
    if (inside) steepest = std::max(steepest, std::abs(F[i + 1] - F[i]));
  }
  cycle.K_kN_per_mm = (F[first + per_cycle / 4] - F[first + 3 * per_cycle / 4]) / (2.0 * amplitude_mm);
  cycle.damping = cycle.energy_kN_mm / (2.0 * std::numbers::pi * cycle.K_kN_per_mm * amplitude_mm * amplitude_mm);
  double const at_peak = std::abs(cycle.K_kN_per_mm) * amplitude_mm;
  cycle.overshoot = cycle.largest_kN / at_peak;
  cycle.jump = steepest / at_peak;
  return cycle;
}

}  // namespace

std::vector<SteadyCycle> steady_cycles(laws::LawEntry const& law, std::span<std::vector<double> const> parameters,
                                       SteadyMotion const& motion, laws::Integration integration) {
  constexpr std::size_t most_at_once = 32;  // parameter sets computed together; more would need more memory for forces
  auto const record = sine(motion);
  fit::LawOnRecord const model(law, record, integration);
  std::vector<SteadyCycle> found;
  double const spread_kN = model.spreads_kN().front();
  std::vector<double> rows, force(record.size());
  for (std::size_t first = 0; first < parameters.size(); first += most_at_once) {
    std::size_t const count = std::min(most_at_once, parameters.size() - first), stride = num::padded(count);
    rows.resize(stride * record.size());
    model.residual_rows(
        count,
        [&](std::size_t i, std::span<double> values) { std::ranges::copy(parameters[first + i], values.begin()); },
        stride, rows);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < record.size(); ++j) force[j] = record.force_kN[j] - spread_kN * rows[j * stride + i];
      found.push_back(third_cycle(force, record.disp_mm, motion.amplitude_mm));
    }
  }
  return found;
}

}  // namespace isolaw::analysis
