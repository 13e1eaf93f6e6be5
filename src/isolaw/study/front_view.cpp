#include "isolaw/study/front_view.hpp"

#include <cmath>

namespace isolaw::study {

std::string_view name(FrontView view) {
  return view == FrontView::published   ? "as published"
         : view == FrontView::converged ? "without the optimiser's noise"
                                        : "device left out";
}

std::vector<FrontPoint> front_points(Summary const& summary, FrontView view) {
  std::vector<FrontPoint> points;
  for (auto const& law : summary.laws) {
    auto const x = view == FrontView::published   ? law.beta
                   : view == FrontView::converged ? law.beta_converged
                                                  : law.loo_objective;
    auto const y = view == FrontView::published ? law.objective.mean : law.objective_converged;
    bool const on_front = view == FrontView::published   ? law.on_front
                          : view == FrontView::converged ? law.on_front_converged
                                                         : law.on_front_loo;
    if (x && y && std::isfinite(*x) && std::isfinite(*y)) points.push_back({law.id, *x, *y, on_front});
  }
  return points;
}

std::vector<std::string> dominating(std::vector<FrontPoint> const& points, FrontPoint const& point) {
  std::vector<std::string> laws;
  if (point.on_front) return laws;
  for (auto const& other : points)
    if (other.on_front && other.x <= point.x && other.y <= point.y && (other.x < point.x || other.y < point.y))
      laws.push_back(other.law);
  return laws;
}

}  // namespace isolaw::study
