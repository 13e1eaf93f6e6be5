#include "isolaw/building/synthetic_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::building {
namespace {

using std::numbers::pi;

// Power spectral density at the circular frequency w, without its constant factor.
double clough_penzien(double w, double ground, double damping) {
  double const slow = 0.1 * ground, r = w / ground, s = w / slow;
  double const soil =
      (1.0 + 4.0 * damping * damping * r * r) / ((1.0 - r * r) * (1.0 - r * r) + 4.0 * damping * damping * r * r);
  double const high_pass = std::pow(s, 4) / ((1.0 - s * s) * (1.0 - s * s) + 4.0 * damping * damping * s * s);
  return soil * high_pass;
}

double envelope(double share) {
  constexpr double risen = 0.15, falls = 0.5;
  if (share < risen) return share * share / (risen * risen);
  return share < falls ? 1.0 : std::exp(-5.0 * (share - falls));
}

std::vector<double> component(num::Draws& numbers, SyntheticMotion const& wanted, double peak_mm_s2) {
  constexpr std::size_t waves = 400;
  constexpr double highest_Hz = 20.0;
  double const ground = 2.0 * pi / wanted.ground_period_s, width = 2.0 * pi * highest_Hz / waves;
  std::vector<double> amplitude, frequency, phase;
  for (std::size_t i = 0; i < waves; ++i) {
    // The frequencies are random, because a sum of waves with equally spaced frequencies repeats itself.
    frequency.push_back(width * (static_cast<double>(i) + numbers.uniform()));
    amplitude.push_back(std::sqrt(clough_penzien(frequency.back(), ground, wanted.ground_damping)));
    phase.push_back(2.0 * pi * numbers.uniform());
  }
  auto const samples = static_cast<std::size_t>(std::llround(wanted.duration_s / wanted.step_s)) + 1;
  std::vector<double> values(samples);
  for (std::size_t n = 0; n < samples; ++n) {
    double const t = static_cast<double>(n) * wanted.step_s;
    for (std::size_t i = 0; i < waves; ++i) values[n] += amplitude[i] * std::cos(frequency[i] * t + phase[i]);
    values[n] *= envelope(t / wanted.duration_s);
  }
  double most = 0.0;
  for (double const a : values) most = std::max(most, std::abs(a));
  for (double& a : values) a *= peak_mm_s2 / most;
  return values;
}

}  // namespace

Motion synthetic_motion(std::uint64_t seed, std::uint32_t index, SyntheticMotion const& wanted) {
  num::Draws x(num::Stream(seed), index, 0), y(num::Stream(seed), index, 1);
  double const peak = wanted.peak_g * data::gravity_mm_s2;
  Motion motion{
      .name = fmt::format("synthetic {}", index + 1), .step_s = wanted.step_s, .x_mm_s2 = component(x, wanted, peak)};
  if (wanted.two_components) motion.y_mm_s2 = component(y, wanted, 0.85 * peak);
  return motion;
}

Motion example_motion(std::uint32_t index) {
  return synthetic_motion(1940, index, {.step_s = 0.01, .duration_s = 20.0});
}

}  // namespace isolaw::building
