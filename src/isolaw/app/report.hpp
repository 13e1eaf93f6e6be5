// Printing results, shared by `report`, `calibrate` and `check`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/render/figures/figures.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::app {

// Says which figures were not drawn, though their data are written. `again` is the command that draws them.
void say_drawn(render::FigureOutcome const& outcome, std::filesystem::path const& directory, std::string_view again);
void draw_figures(study::Summary const& summary, render::FigureChoice choice, std::filesystem::path const& directory);

struct Printed {
  bool json = false, details = false;
};
// Prints one screen or all details, then the verdicts of a rule set; or summary.json with the campaign's profile.
void print(study::Summary const& summary, std::filesystem::path const& directory, Printed how,
           std::string_view profile = {});

// 1 if a device was refused, a law could not be fitted to a device, a run failed, or a limit of the rules is exceeded.
int exit_code(study::Summary const& summary);

std::string what_is_missing(study::Summary const& summary);

}  // namespace isolaw::app
