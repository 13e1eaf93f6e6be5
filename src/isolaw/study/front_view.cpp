#include "isolaw/study/front_view.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/study/adequacy.hpp"

namespace isolaw::study {

std::string_view name(FrontView view) {
  return view == FrontView::runs        ? "mean of the runs"
         : view == FrontView::converged ? "without the optimiser's noise"
                                        : "device left out";
}

std::string_view key(FrontView view) {
  return view == FrontView::runs ? "runs" : view == FrontView::converged ? "converged" : "left-out";
}

namespace {

bool beats(FrontPoint const& one, FrontPoint const& other) {
  return one.x <= other.x && one.y <= other.y && (one.x < other.x || one.y < other.y);
}

bool stands_among(std::vector<FrontPoint> const& points, FrontPoint const& point) {
  if (!point.is_adequate || point.on_front) return point.is_adequate;
  return std::ranges::any_of(points, [](auto const& one) { return !one.is_adequate; }) &&
         std::ranges::none_of(points, [&](auto const& one) { return one.is_adequate && beats(one, point); });
}

}  // namespace

std::vector<FrontPoint> front_points(Summary const& summary, FrontView view) {
  std::vector<FrontPoint> points;
  for (auto const& law : summary.laws) {
    auto const x = view == FrontView::runs        ? law.beta
                   : view == FrontView::converged ? law.beta_converged
                                                  : law.loo_objective;
    auto const y = view == FrontView::runs ? law.objective.mean : law.objective_converged;
    bool const on_front = view == FrontView::runs        ? law.on_front
                          : view == FrontView::converged ? law.on_front_converged
                                                         : law.on_front_loo;
    if (x && y && std::isfinite(*x) && std::isfinite(*y))
      points.push_back({law.id, *x, *y, on_front, false, is_adequate(law)});
  }
  for (auto& point : points) point.is_unbeaten = stands_among(points, point);
  return points;
}

std::vector<std::string> dominating(std::vector<FrontPoint> const& points, FrontPoint const& point) {
  std::vector<std::string> laws;
  if (point.on_front) return laws;
  for (auto const& other : points)
    if (other.on_front && beats(other, point)) laws.push_back(other.law);
  return laws;
}

}  // namespace isolaw::study
