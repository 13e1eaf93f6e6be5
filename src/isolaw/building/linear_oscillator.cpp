#include "isolaw/building/linear_oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include "isolaw/data/channels/ground_motion.hpp"

namespace isolaw::building {
namespace {

using std::numbers::pi;

// Largest relative displacement of a linear oscillator that starts at rest, by Newmark's average acceleration.
double linear_peak(Motion const& motion, double period_s, double damping) {
  double const w = 2.0 * pi / period_s;
  auto const parts = static_cast<std::size_t>(std::ceil(motion.step_s / std::min(0.005, period_s / 50.0)));
  double const dt = motion.step_s / static_cast<double>(parts);
  double const share = 1.0 / (1.0 + damping * w * dt + 0.25 * w * w * dt * dt);
  double u[2]{}, v[2]{}, a[2]{}, most = 0.0;
  for (std::size_t i = 0; i + 1 < motion.x_mm_s2.size(); ++i)
    for (std::size_t k = 1; k <= parts; ++k) {
      double const part = static_cast<double>(k) / static_cast<double>(parts);
      for (std::size_t d = 0; d < 2; ++d) {
        auto const& ground = d == 0 ? motion.x_mm_s2 : motion.y_mm_s2;
        if (ground.empty()) continue;
        double const g = ground[i] + part * (ground[i + 1] - ground[i]);
        double const speed = v[d] + 0.5 * dt * a[d], place = u[d] + dt * v[d] + 0.25 * dt * dt * a[d];
        double const next = share * (-g - 2.0 * damping * w * speed - w * w * place);
        u[d] = place + 0.25 * dt * dt * next;
        v[d] = speed + 0.5 * dt * next;
        a[d] = next;
      }
      most = std::max(most, std::hypot(u[0], u[1]));
    }
  return most;
}

}  // namespace

Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, double period_s,
                    Coupling coupling) {
  auto const bearing = make_bearing(law, parameters, coupling);
  constexpr int steps = 200, cycles = 3;
  double before = 0.0, force_before = 0.0, energy = 0.0, forward = 0.0, backward = 0.0;
  for (int i = 1; i <= steps * cycles; ++i) {
    double const angle = 2.0 * pi * i / steps, x = amplitude_mm * std::sin(angle);
    double const velocity = amplitude_mm * 2.0 * pi / period_s * std::cos(angle);
    double const force = bearing->trial({x, 0.0}, {velocity, 0.0}, period_s / steps).force.x;
    bearing->commit();
    if (i > steps * (cycles - 1)) energy += 0.5 * (force + force_before) * (x - before);
    if (i == steps * (cycles - 1) + steps / 4) forward = force;
    if (i == steps * (cycles - 1) + 3 * steps / 4) backward = force;
    before = x, force_before = force;
  }
  double const k = (forward - backward) / (2.0 * amplitude_mm);
  return {k, energy / (2.0 * pi * k * amplitude_mm * amplitude_mm)};
}

Effective effective(Devices const& devices, std::span<double const> bearings, double amplitude_mm, double period_s) {
  auto const& source = devices.source();
  std::size_t const each = source.lot.size();
  Effective all, bearing;
  for (std::size_t at = 0; at + each <= bearings.size(); at += each) {
    auto const values = bearings.subspan(at, each);
    if (at == 0 || !std::ranges::equal(values, bearings.subspan(at - each, each)))
      bearing = effective(source.law, values, amplitude_mm, period_s, devices.coupling());
    all.stiffness_kN_mm += bearing.stiffness_kN_mm;
    all.damping += bearing.stiffness_kN_mm * bearing.damping;
  }
  all.damping /= all.stiffness_kN_mm;
  return all;
}

// Looks for the displacement D and the period T that reproduce themselves: a linear oscillator with the bearings'
// effective stiffness and damping at D and T must have the peak displacement D and the period T. Repeats from the last
// result until it no longer changes.
std::optional<EquivalentLinear> equivalent_linear(Devices const& devices, Motion const& motion,
                                                  std::vector<double> const& bearings, double mass) {
  EquivalentLinear linear;
  double amplitude_mm = 100.0;
  linear.period_s = 2.0;
  for (int i = 0; i < 60; ++i) {
    auto const all = effective(devices, bearings, amplitude_mm, linear.period_s);
    if (!(all.stiffness_kN_mm > 0.0)) return std::nullopt;
    linear.period_s = 2.0 * pi * std::sqrt(mass / all.stiffness_kN_mm);
    linear.damping = std::min(0.6, all.damping);
    double const next = linear_peak(motion, linear.period_s, linear.damping);
    double const change = next - amplitude_mm;
    amplitude_mm = std::max(1e-3, amplitude_mm + 0.5 * change);
    if (std::abs(change) < 1e-4 * amplitude_mm) break;
  }
  linear.displacement_mm = amplitude_mm;
  return linear;
}

// Thirty periods from 0.05 s (stiff equipment) to 4 s (isolators), each a fixed factor longer than the one before.
std::vector<double> const& spectrum_periods_s() {
  static std::vector<double> const all_periods = [] {
    constexpr std::size_t count = 30;
    constexpr double first = 0.05, last = 4.0;
    std::vector<double> periods;
    for (std::size_t i = 0; i < count; ++i)
      periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
    return periods;
  }();
  return all_periods;
}

void add_spectra(std::vector<std::vector<double>>& to, Response const& run, double share) {
  auto const& periods = spectrum_periods_s();
  if (run.history.acceleration.empty()) return;
  auto const diaphragms = run.history.acceleration.front().size() / 2;
  to.resize(diaphragms, std::vector<double>(periods.size(), 0.0));
  for (std::size_t d = 0; d < diaphragms; ++d) {
    Motion floor{.name = {}, .step_s = run.step_s, .x_mm_s2 = {}};
    for (auto const& a : run.history.acceleration) {
      floor.x_mm_s2.push_back(a[2 * d]);
      floor.y_mm_s2.push_back(a[2 * d + 1]);
    }
    for (std::size_t p = 0; p < periods.size(); ++p) {
      double const w = 2.0 * pi / periods[p];
      to[d][p] += share * w * w * linear_peak(floor, periods[p], spectrum_damping) / data::gravity_mm_s2;
    }
  }
}

}  // namespace isolaw::building
