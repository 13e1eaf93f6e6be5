// Where the laws lie in the plane of accuracy and robustness, in the three ways that figures and tables show.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Fig. 14 of Cucuzza et al. 2025, of the mean of the runs; of the least objectives; against the objective on devices
// left out.
enum class FrontView { runs, converged, left_out };
inline constexpr FrontView front_views[]{FrontView::runs, FrontView::converged, FrontView::left_out};

std::string_view name(FrontView view);  // "mean of the runs", ...
std::string_view key(FrontView view);   // "runs", "converged", "left-out"

struct FrontPoint {
  std::string law;
  double x = 0.0, y = 0.0;  // robustness, or the objective on devices left out; accuracy
  bool on_front = false;
  // On the front among the laws that describe the devices, where others beat it too; and whether it is one of these.
  bool stands = false, is_adequate = true;
};

// Of the laws that have both, in the order of the summary.
std::vector<FrontPoint> front_points(Summary const& summary, FrontView view);

// Ids of the laws on the front that are no worse in both and better in one; none for a law on it.
std::vector<std::string> dominating(std::vector<FrontPoint> const& points, FrontPoint const& point);

}  // namespace isolaw::study
