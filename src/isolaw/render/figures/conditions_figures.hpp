// Makes the figures of `isolaw conditions` for print.
#pragma once

#include <vector>

#include "isolaw/render/figures/figures_of.hpp"

namespace isolaw::render {

// Draws the factor on K_eff, and below it the factor on damping, over each condition (temperature, rate, ...). The
// figure shows every device, their mean with its intervals, and the design range. Returns nothing if no level was
// tested.
MaybeFigure conditions_figure(ConditionsResult const& result, UnitSystem const& units = record_units);
// Draws the largest and the smallest factor of each effect over the design conditions, as bars. Returns nothing if the
// lot states no design conditions.
MaybeFigure factors_figure(ConditionsResult const& result);

// Returns those of the two figures that can be made.
std::vector<Figure> conditions_figures(ConditionsResult const& result, UnitSystem const& units = record_units);

}  // namespace isolaw::render
