// Makes the structures, plans of bearings and ground motions that the tests of buildings share.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string_view>
#include <vector>

#include "isolaw/building/bearing.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/building/integrate.hpp"
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

using Bearings = std::vector<std::unique_ptr<Bearing>>;
using Values = std::vector<double>;

// Returns three equal floors on a base slab, 400 Mg each. On a fixed base the periods are 0.45 s along x and 0.4 s
// along y, and the damping is 2 %.
inline Frame three_floors() {
  Diaphragm const slab{.mass_Mg = 400.0, .gyration_mm = 7000.0};
  return {.base = slab, .floors = equal_floors(3, slab, 0.45, 0.4), .damping = {0.02}};
}

inline Plan grid(std::size_t along, std::size_t across, double spacing_mm) {
  Plan plan;
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < across; ++j)
      plan.bearings.push_back({(static_cast<double>(i) - 0.5 * static_cast<double>(along - 1)) * spacing_mm,
                               (static_cast<double>(j) - 0.5 * static_cast<double>(across - 1)) * spacing_mm});
  return plan;
}

// Returns a ground motion of several frequencies under a bell-shaped envelope, different along x and y.
inline Motion shaking(double step_s = 0.01, double duration_s = 12.0, double peak_g = 0.15) {
  using std::numbers::pi;
  Motion motion{.name = "shaking", .step_s = step_s, .x_mm_s2 = {}};
  auto const samples = static_cast<std::size_t>(duration_s / step_s) + 1;
  for (std::size_t i = 0; i < samples; ++i) {
    double const t = static_cast<double>(i) * step_s;
    double const bell = std::exp(-std::pow((t - 0.35 * duration_s) / (0.18 * duration_s), 2));
    auto const waves = [&](double phase) {
      return std::sin(2.0 * pi * 0.45 * t + phase) + 0.6 * std::sin(2.0 * pi * 1.3 * t + 2.0 * phase) +
             0.4 * std::sin(2.0 * pi * 3.1 * t + 3.0 * phase);
    };
    motion.x_mm_s2.push_back(peak_g * 9806.65 / 1.6 * bell * waves(0.3));
    motion.y_mm_s2.push_back(0.8 * peak_g * 9806.65 / 1.6 * bell * waves(1.7));
  }
  return motion;
}

// Returns bilinear parameters of equal bearings that carry 1600 Mg together: period 2.5 s after yielding, strength 6 %
// of the weight, yield displacement 10 mm.
inline Values usual_bilinear(std::size_t bearings) {
  double const share = 1.6 / static_cast<double>(bearings), K2 = share * std::pow(2.0 * std::numbers::pi / 2.5, 2);
  return {K2 + 0.06 * share * 9806.65 / 10.0, K2, 10.0};
}

inline Bearings equal_bearings(std::size_t count, std::string_view law, Values const& parameters) {
  Bearings copies;
  for (std::size_t j = 0; j < count; ++j) copies.push_back(make_bearing(law, parameters, Coupling::coupled));
  return copies;
}

}  // namespace isolaw::building
