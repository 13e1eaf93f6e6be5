// Each function makes the data and the script of one figure from the summary, or returns nothing if there are no data.
// "The study" below means Cucuzza et al. 2025; Fig. 4 to Fig. 14 are figures of that paper.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "isolaw/render/figures/figures.hpp"
#include "isolaw/study/front_view.hpp"

namespace isolaw::render {

using MaybeFigure = std::optional<Figure>;
using MaybeNumber = std::optional<double>;
// The index of the law in summary.laws, which decides its colour and marker.
std::size_t place_in_summary(Summary const& summary, LawResult const& law);
// Accuracy against robustness, as in Fig. 14.
MaybeFigure front_figure(Summary const& summary, FrontView view);
// The objective of every law on every device: mean, standard deviation over runs and difference from the law's mean.
// objective_figure() shows all laws in one panel, as Fig. 6. objective_by_device_figure() has a panel with the devices'
// names for each law, as Fig. 7.
MaybeFigure objective_figure(Summary const& summary);
MaybeFigure objective_by_device_figure(Summary const& summary);
// A panel for each calibrated parameter, over the devices, as in Figs. 8 to 13.
MaybeFigure parameters_figure(Summary const& summary, LawResult const& law);
// The campaign's results beside the study's, as in Figs. 6 and 8 to 13. There is no figure if the campaign has fewer
// than two of the study's laws.
MaybeFigure published_objective_figure(Summary const& summary);
MaybeFigure published_parameters_figure(Summary const& summary, LawResult const& law);
// The best objective after each generation or descent, as median and range over the runs.
MaybeFigure convergence_figure(Summary const& summary, LawResult const& law);
// Effective stiffness and damping of every device, with design values and limits if a rule set gives them.
MaybeFigure properties_figure(Summary const& summary);
// Measured and computed loop, force over time, and residual, as in Fig. 5. `stem` begins the names of the files.
MaybeFigure loops_figure(Summary const& summary, DeviceResult const& device, LawResult const& law,
                         std::string const& stem);
// A panel for each law with the measured and the computed loop of a device, as in Fig. 5.
MaybeFigure loops_of_laws_figure(Summary const& summary, DeviceResult const& device, std::string const& stem);
// The record before and after cleaning, as in Fig. 4.
MaybeFigure record_figure(UnitSystem const& units, DeviceResult const& device, std::string const& stem);

}  // namespace isolaw::render
