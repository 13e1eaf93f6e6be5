// The figures of `isolaw conditions` for print.
#pragma once

#include <vector>

#include "isolaw/render/figures/figures_of.hpp"

namespace isolaw::render {

// The factor on K_eff, and on damping below it, over each condition: every device, the mean with its intervals, and the
// range of the design. Nothing without a tested level.
MaybeFigure conditions_figure(ConditionsResult const& result, UnitSystem const& units = record_units);
// The largest and the smallest factor of each effect over the design conditions, as bars. Nothing without a design.
MaybeFigure factors_figure(ConditionsResult const& result);

// Both figures, those that exist.
std::vector<Figure> conditions_figures(ConditionsResult const& result, UnitSystem const& units = record_units);

}  // namespace isolaw::render
