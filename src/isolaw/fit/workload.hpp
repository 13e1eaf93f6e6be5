// Makes the record on which isolaw's speed is measured: three cycles of +-208 mm at 0.5 Hz with a bilinear loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "isolaw/data/channels/record.hpp"

namespace isolaw::fit {

inline data::FitRecord workload(std::size_t samples) {
  data::FitRecord record;
  double const interval = 6.0 / static_cast<double>(samples), w = std::numbers::pi;
  double hysteretic = 0.0, before = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    double const t = interval * static_cast<double>(i);
    double const x = 208.0 * std::sin(w * t);
    hysteretic = std::clamp(hysteretic + 3.0 * (x - before), -45.0, 45.0);
    before = x;
    record.time_s.push_back(t);
    record.disp_mm.push_back(x);
    record.vel_mm_s.push_back(208.0 * w * std::cos(w * t));
    record.force_kN.push_back(0.5 * x + hysteretic);
  }
  return record;
}

}  // namespace isolaw::fit
