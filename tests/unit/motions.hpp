// Composes displacement histories for tests from pieces, and computes hysteresis loops along them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data::testing {

inline constexpr double pi = std::numbers::pi;

// Holds displacements and forces at fixed intervals of time. Pieces such as a hold, a ramp or a sine are added one
// after another. Each leaves out its last point, because the next piece begins there.
struct Motion {
  double dt_s = 0.01;
  std::vector<double> time_s;
  std::vector<double> disp_mm;
  std::vector<double> force_kN;

  void add(double disp) {
    time_s.push_back(time_s.empty() ? 0.0 : time_s.back() + dt_s);
    disp_mm.push_back(disp);
  }
  Motion& hold(double level, double seconds) {
    for (int i = 0; i < std::lround(seconds / dt_s); ++i) add(level);
    return *this;
  }
  Motion& ramp(double from, double to, double seconds) {
    auto const steps = std::lround(seconds / dt_s);
    for (int i = 0; i < steps; ++i) add(from + (to - from) * i / static_cast<double>(steps));
    return *this;
  }
  // With a negative amplitude the motion starts downwards.
  Motion& sine(double amplitude, double frequency_Hz, double cycles, double centre = 0.0) {
    auto const steps = std::lround(cycles / frequency_Hz / dt_s);
    for (int i = 0; i < steps; ++i) add(centre + amplitude * std::sin(2.0 * pi * frequency_Hz * i * dt_s));
    return *this;
  }
  Motion& end(double level = 0.0) {
    add(level);
    return *this;
  }
  Motion& noise(double deviation, unsigned seed = 1) {
    if (!(deviation > 0.0)) return *this;
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, deviation);
    for (double& x : disp_mm) x += normal(generator);
    return *this;
  }
  Motion& offset(double by) {
    for (double& x : disp_mm) x += by;
    return *this;
  }

  // Sets the force to an exponential loop of Vaiana's law: K x + Q z with dz/d|x| = alpha (sgn(dx) - z).
  Motion& loop(double K = 0.5, double Q = 30.0, double alpha = 0.08) {
    force_kN.clear();
    double z = 0.0, before = disp_mm.front();
    for (double const x : disp_mm) {
      double const way = std::abs(x - before);
      z += (std::copysign(1.0, x - before) - z) * (1.0 - std::exp(-alpha * way));
      before = x;
      force_kN.push_back(K * x + Q * z);
    }
    return *this;
  }

  CycleView view() const { return {disp_mm, force_kN, time_s, {}}; }
  Segmentation cut() const { return segment(disp_mm, time_s); }
  Properties properties() const { return cyclic_properties(view()); }
};

inline std::vector<int> counted_per_block(Segmentation const& cut) {
  std::vector<int> counts;
  for (auto const& cycle : cut.cycles) {
    auto const block = static_cast<std::size_t>(cycle.block);
    if (counts.size() < block) counts.resize(block, 0);
    if (cycle.number > 0) counts[block - 1] = std::max(counts[block - 1], cycle.number);
  }
  return counts;
}

}  // namespace isolaw::data::testing
