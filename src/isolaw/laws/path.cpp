#include <cmath>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {
namespace {

double log2_abs(double x) {
  return std::log2(std::max(std::abs(x), num::smallest_power_base));
}

}  // namespace

Path make_path(std::span<double const> x, std::span<double const> v, int refinement) {
  Path path;
  path.refinement = refinement;
  if (x.empty()) return path;
  path.steps.reserve((x.size() - 1) * static_cast<std::size_t>(refinement) + 1);

  double const peak = std::abs(x[0]);
  double const v_first = v.empty() ? 0.0 : v[0];
  path.steps.push_back({.x0 = x[0],
                        .x1 = x[0],
                        .v0 = v_first,
                        .v1 = v_first,
                        .dx = 0.0,
                        .length = 0.0,
                        .direction = 0.0,
                        .reversal = false,
                        .peak0 = peak,
                        .peak1 = peak,
                        .log2_abs_x0 = log2_abs(x[0]),
                        .log2_abs_x1 = log2_abs(x[0])});
  for (std::size_t i = 1; i < x.size(); ++i) {
    for (int k = 1; k <= refinement; ++k) {
      Step const& before = path.steps.back();
      double const t = static_cast<double>(k) / refinement;
      double const x1 = k == refinement ? x[i] : x[i - 1] + t * (x[i] - x[i - 1]);
      double const v1 = v.empty() ? 0.0 : k == refinement ? v[i] : v[i - 1] + t * (v[i] - v[i - 1]);
      double const dx = x1 - before.x1;
      double const direction = dx > 0.0 ? 1.0 : dx < 0.0 ? -1.0 : before.direction;
      path.steps.push_back({.x0 = before.x1,
                            .x1 = x1,
                            .v0 = before.v1,
                            .v1 = v1,
                            .dx = dx,
                            .length = std::abs(dx),
                            .direction = direction,
                            .reversal = direction != before.direction,
                            .peak0 = before.peak1,
                            .peak1 = std::max(before.peak1, std::abs(x1)),
                            .log2_abs_x0 = before.log2_abs_x1,
                            .log2_abs_x1 = log2_abs(x1)});
    }
  }
  return path;
}

}  // namespace isolaw::laws
