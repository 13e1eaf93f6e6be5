// What `report` does with results, and `calibrate` and `check` too.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/render/figures/figures.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::app {

// Figures that cannot be drawn are no failure: their data and scripts are there.
// `again`: what draws them once gnuplot is there.
void say_drawn(render::FigureOutcome const& outcome, std::filesystem::path const& directory, std::string_view again);
void draw_figures(study::Summary const& summary, render::FigureChoice choice, std::filesystem::path const& directory);

// The ranking and the verdicts, or summary.json, with a campaign's profile where there is one.
void print(study::Summary const& summary, bool json, std::string_view profile = {});

// Exit code 1 whenever a device was refused, a law could not be searched on a device, a run failed, or a limit of the
// rule set is not kept.
int exit_code(study::Summary const& summary);

// Of a campaign that is not complete.
std::string what_is_missing(study::Summary const& summary);

}  // namespace isolaw::app
