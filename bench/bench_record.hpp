// What the benchmarks evaluate: three cycles of +-208 mm at 0.5 Hz in 600 samples, and candidates of a search box.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "isolaw/fit/box.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::bench {

// The force is that of a bilinear loop.
inline data::FitRecord record(std::size_t samples) {
  data::FitRecord r;
  double hysteretic = 0.0, before = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    double const t = 6.0 * static_cast<double>(i) / static_cast<double>(samples), w = std::numbers::pi;
    double const x = 208.0 * std::sin(w * t);
    hysteretic = std::clamp(hysteretic + 3.0 * (x - before), -45.0, 45.0);
    before = x;
    r.time_s.push_back(t);
    r.disp_mm.push_back(x);
    r.vel_mm_s.push_back(208.0 * w * std::cos(w * t));
    r.force_kN.push_back(0.5 * x + hysteretic);
  }
  return r;
}

// `count` candidates, uniform in the box: one after another, each in the law's order.
inline std::vector<double> candidates(fit::SearchBox const& box, std::size_t count) {
  std::vector<double> values(count * box.parameters.size()), point(box.free_count());
  for (std::size_t i = 0; i < count; ++i) {
    num::Draws draws(num::Stream(1), 0, static_cast<std::uint32_t>(i));
    for (double& coordinate : point) coordinate = draws.uniform();
    box.expand(point, std::span(values).subspan(i * box.parameters.size(), box.parameters.size()));
  }
  return values;
}

// Of `width` of them, from number `first` on: the first parameter of every candidate, then the second, and so on.
inline std::vector<double> block(std::vector<double> const& candidates, std::size_t parameters, std::size_t first,
                                 std::size_t width) {
  std::vector<double> values(parameters * width);
  for (std::size_t lane = 0; lane < width; ++lane)
    for (std::size_t p = 0; p < parameters; ++p) values[p * width + lane] = candidates[(first + lane) * parameters + p];
  return values;
}

inline std::vector<double> divided(std::vector<double> values, double unit) {
  for (double& v : values) v /= unit;
  return values;
}

}  // namespace isolaw::bench
