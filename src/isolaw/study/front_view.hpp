// Computes each law's point in the plots of accuracy against robustness. Figures and tables show three such views.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// runs: mean objective over the runs against beta, as in Fig. 14 of Cucuzza et al. 2025. converged: least objective
// against the beta of the best fits. left_out: least objective against the objective on devices left out.
enum class FrontView { runs, converged, left_out };
inline constexpr FrontView front_views[]{FrontView::runs, FrontView::converged, FrontView::left_out};

std::string_view name(FrontView view);  // "mean of the runs", ...
std::string_view key(FrontView view);   // "runs", "converged", "left-out"

struct FrontPoint {
  std::string law;
  double x = 0.0, y = 0.0;  // x: beta, or the objective on devices left out; y: objective
  bool on_front = false;
  // is_adequate: the law describes the devices. is_unbeaten: it is adequate, and no other adequate law beats it.
  bool is_unbeaten = false, is_adequate = true;
};

// One point for each law that has an x and a y in this view, in the order of the summary.
std::vector<FrontPoint> front_points(Summary const& summary, FrontView view);
// Ids of the laws on the front that are no worse than the point in both x and y and better in one of them.
std::vector<std::string> dominating(std::vector<FrontPoint> const& points, FrontPoint const& point);

}  // namespace isolaw::study
