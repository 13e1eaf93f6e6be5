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
// Returns the index of the law in summary.laws, which decides the law's colour and marker.
std::size_t place_in_summary(Summary const& summary, LawResult const& law);
// Makes the figure of accuracy against robustness, as in Fig. 14.
MaybeFigure front_figure(Summary const& summary, FrontView view);
// Make figures of the objective of every law on every device: its mean and standard deviation over the runs, and its
// difference from the mean over the devices. objective_figure() shows all laws in one panel, as Fig. 6.
// objective_by_device_figure() has a panel for each law, with the names of the devices, as Fig. 7.
MaybeFigure objective_figure(Summary const& summary);
MaybeFigure objective_by_device_figure(Summary const& summary);
// Makes the figure with a panel for each calibrated parameter of a law, over the devices, as in Figs. 8 to 13.
MaybeFigure parameters_figure(Summary const& summary, LawResult const& law);
// Make figures with the campaign's results beside those of the study, as in Figs. 6 and 8 to 13. They return nothing if
// the campaign has fewer than two of the study's laws.
MaybeFigure published_objective_figure(Summary const& summary);
MaybeFigure published_parameters_figure(Summary const& summary, LawResult const& law);
// Makes the figure of convergence: the best objective after each generation or start of a search, as median and range
// over the runs.
MaybeFigure convergence_figure(Summary const& summary, LawResult const& law);
// Makes the figure of effective stiffness and damping of every device, with design values and limits if a rule set
// gives them.
MaybeFigure properties_figure(Summary const& summary);
// Makes the figure of a law on a device: measured and computed loop, force over time, and residual, as in Fig. 5. The
// names of the figure's files begin with `stem`.
MaybeFigure loops_figure(Summary const& summary, DeviceResult const& device, LawResult const& law,
                         std::string const& stem);
// Makes the figure with a panel for each law, which shows the measured and the computed loop of a device, as in Fig. 5.
MaybeFigure loops_of_laws_figure(Summary const& summary, DeviceResult const& device, std::string const& stem);
// Makes the figure of a record before and after cleaning, as in Fig. 4.
MaybeFigure record_figure(UnitSystem const& units, DeviceResult const& device, std::string const& stem);

}  // namespace isolaw::render
