// One function per figure makes data and script from the summary. It returns nothing if there is nothing to draw.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "isolaw/render/figures/figures.hpp"
#include "isolaw/study/front_view.hpp"

namespace isolaw::render {

using MaybeFigure = std::optional<Figure>;
using MaybeNumber = std::optional<double>;
// Index of the law in summary.laws, which decides its colour and marker.
std::size_t place_in_summary(Summary const& summary, LawResult const& law);
// Accuracy against robustness, Fig. 14.
MaybeFigure front_figure(Summary const& summary, FrontView view);
// Objective of every law on every device: mean, standard deviation over runs and difference from the law's mean, as in
// Figs. 6 and 7. The other figure has a panel per law with the devices' names, as in Fig. 7.
MaybeFigure objective_figure(Summary const& summary);
MaybeFigure objective_by_device_figure(Summary const& summary);
// A panel per calibrated parameter over the devices, Figs. 8 to 13.
MaybeFigure parameters_figure(Summary const& summary, LawResult const& law);
// The campaign beside the study's printed results, Figs. 6 and 8 to 13; empty with fewer than two of the study's laws.
MaybeFigure published_objective_figure(Summary const& summary);
MaybeFigure published_parameters_figure(Summary const& summary, LawResult const& law);
// Best objective after each generation or descent: median and range over the runs.
MaybeFigure convergence_figure(Summary const& summary, LawResult const& law);
// Effective stiffness and damping of every device, with design values and limits if a rule set gives them.
MaybeFigure properties_figure(Summary const& summary);
// Measured and computed loop, force over time, residual, Fig. 5. `stem` names the device in the files.
MaybeFigure loops_figure(Summary const& summary, DeviceResult const& device, LawResult const& law,
                         std::string const& stem);
// A panel per law with the measured and the computed loop of a device, Fig. 5.
MaybeFigure loops_of_laws_figure(Summary const& summary, DeviceResult const& device, std::string const& stem);
// The record before and after cleaning, Fig. 4.
MaybeFigure record_figure(DeviceResult const& device, std::string const& stem);

}  // namespace isolaw::render
