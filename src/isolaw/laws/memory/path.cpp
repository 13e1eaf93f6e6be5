#include <cmath>
#include <limits>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {
namespace {

double log2_abs(double x) {
  return std::log2(std::max(std::abs(x), num::smallest_power_base));
}

struct Point {
  double x, v;
  bool sample;
};

Path through(std::vector<Point> const& points, int refinement, bool with_memory) {
  Path path;
  if (points.empty()) return path;
  path.steps.reserve((points.size() - 1) * static_cast<std::size_t>(refinement) + 1);
  auto const& first = points.front();
  double const peak = std::abs(first.x), log2_x = log2_abs(first.x);
  path.steps.push_back({.x0 = first.x,
                        .x1 = first.x,
                        .v0 = first.v,
                        .v1 = first.v,
                        .dx = 0.0,
                        .length = 0.0,
                        .direction = 0.0,
                        .reversal = false,
                        .sample = first.sample,
                        .peak0 = peak,
                        .peak1 = peak,
                        .log2_abs_x0 = log2_x,
                        .log2_abs_x1 = log2_x});
  for (std::size_t i = 1; i < points.size(); ++i) {
    Point const &a = points[i - 1], &b = points[i];
    for (int k = 1; k <= refinement; ++k) {
      Step const& before = path.steps.back();
      bool const last = k == refinement;
      double const t = static_cast<double>(k) / refinement;
      double const x1 = last ? b.x : a.x + t * (b.x - a.x);
      double const v1 = last ? b.v : a.v + t * (b.v - a.v);
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
                            .sample = last && b.sample,
                            .peak0 = before.peak1,
                            .peak1 = std::max(before.peak1, std::abs(x1)),
                            .log2_abs_x0 = before.log2_abs_x1,
                            .log2_abs_x1 = log2_abs(x1)});
    }
  }
  for (auto const& step : path.steps) path.sample_count += step.sample ? 1 : 0;
  if (with_memory) remember(path);
  return path;
}

Point sample_at(std::span<double const> x, std::span<double const> v, std::size_t i) {
  return {x[i], v.empty() ? 0.0 : v[i], true};
}

// The vertex of the parabola through three samples. Its time is NaN if x does not turn at the middle sample, or if the
// vertex lies outside the three samples or at the middle one.
struct Vertex {
  double time, x;
};
Vertex vertex(std::span<double const, 3> t, std::span<double const, 3> x) {
  constexpr Vertex none{std::numeric_limits<double>::quiet_NaN(), 0.0};
  if ((x[1] - x[0]) * (x[2] - x[1]) >= 0.0) return none;
  double const before = (x[1] - x[0]) / (t[1] - t[0]), after = (x[2] - x[1]) / (t[2] - t[1]);
  double const half_curvature = (after - before) / (t[2] - t[0]);
  double const time = 0.5 * (t[0] + t[1] - before / half_curvature);
  if (!(time > t[0] && time < t[2]) || std::abs(time - t[1]) < 1e-9 * (t[2] - t[0])) return none;
  return {time, x[0] + (time - t[0]) * (before + half_curvature * (time - t[1]))};
}

}  // namespace

Path make_path(std::span<double const> x, std::span<double const> v, int refinement, bool with_memory) {
  std::vector<Point> points;
  points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back(sample_at(x, v, i));
  return through(points, refinement, with_memory);
}

Path make_path_with_turning_points(std::span<double const> x, std::span<double const> v, std::span<double const> time,
                                   int refinement, bool with_memory) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bool const inside = i > 0 && i + 1 < x.size();
    if (!inside) {
      points.push_back(sample_at(x, v, i));
      continue;
    }
    auto const turn = vertex(time.subspan(i - 1).first<3>(), x.subspan(i - 1).first<3>());
    if (turn.time < time[i]) points.push_back({turn.x, 0.0, false});
    points.push_back(sample_at(x, v, i));
    if (turn.time > time[i]) points.push_back({turn.x, 0.0, false});
  }
  return through(points, refinement, with_memory);
}

}  // namespace isolaw::laws
