// Makes models of buildings on isolators of one law, without a campaign.
#pragma once

#include "isolaw/programs/model.hpp"
#include "isolaw/programs/model_text.hpp"
#include "unit/programs_fixture.hpp"

namespace isolaw::programs_test {

// Returns a ground motion near the period of the building. In the default duration it makes about two cycles.
inline data::GroundMotion shaking(double amplitude_mm_s2, double step_s = 0.01, double duration_s = 4.5) {
  data::GroundMotion motion{.file = "made here", .step_s = step_s, .acceleration_mm_s2 = {}, .recognised = "made here"};
  for (int i = 0; i * step_s <= duration_s; ++i)
    motion.acceleration_mm_s2.push_back(amplitude_mm_s2 * std::sin(3.2 * i * step_s) * std::min(1.0, 0.5 * i * step_s));
  return motion;
}

inline constexpr double carried_kN = 588.4;  // load on one isolator, which gives a period near two seconds

// Returns isolators at the corners of a rectangle. The two isolators at the larger y carry a load that is larger by the
// share `heavier`.
inline Model four(double amplitude_mm_s2, double heavier = 0.0) {
  Model model;
  model.layout = "made here";
  for (auto const& [name, x, y] :
       {std::tuple("A", 0.0, 0.0), {"B", 6000.0, 0.0}, {"C", 0.0, 4000.0}, {"D", 6000.0, 4000.0}})
    model.bearings.push_back({.name = name,
                              .x_mm = x,
                              .y_mm = y,
                              .angle_deg = 0.0,
                              .load_kN = carried_kN * (y > 0.0 ? 1.0 + heavier : 1.0),
                              .K_v_kN_per_mm = 500.0});
  for (auto const& b : model.bearings) model.weight_kN += b.load_kN;
  for (auto const& b : model.bearings) {
    model.x_mm += b.x_mm * b.load_kN / model.weight_kN;
    model.y_mm += b.y_mm * b.load_kN / model.weight_kN;
  }
  model.gyration_mm = 2100.0;
  model.weight_from = model.centre_from = model.gyration_from = model.K_v_from = "made here";
  model.motions = {shaking(amplitude_mm_s2)};
  return model;
}

}  // namespace isolaw::programs_test
