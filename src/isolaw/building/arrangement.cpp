#include "isolaw/building/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace isolaw::building {

Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness) {
  auto const n = places.size();
  Arrangement arrangement;
  arrangement.device.resize(stiffness.size());
  std::iota(arrangement.device.begin(), arrangement.device.end(), std::size_t{0});
  auto const eccentricity = [&] {
    double sum = 0.0, x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double const k = stiffness[arrangement.device[i]];
      sum += k, x += k * (places[i].x_mm - centre.x_mm), y += k * (places[i].y_mm - centre.y_mm);
    }
    return std::hypot(x, y) / sum;
  };
  arrangement.in_order_mm = arrangement.eccentricity_mm = eccentricity();
  for (bool better = true; better;) {
    better = false;
    std::size_t best_i = 0, best_j = 0;
    double best = arrangement.eccentricity_mm * (1.0 - 1e-12);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < arrangement.device.size(); ++j) {
        std::swap(arrangement.device[i], arrangement.device[j]);
        if (double const now = eccentricity(); now < best) best = now, best_i = i, best_j = j, better = true;
        std::swap(arrangement.device[i], arrangement.device[j]);
      }
    if (!better) break;
    std::swap(arrangement.device[best_i], arrangement.device[best_j]);
    arrangement.eccentricity_mm = best;
  }
  arrangement.device.resize(n);
  return arrangement;
}

}  // namespace isolaw::building
