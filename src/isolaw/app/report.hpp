// Prints the results for `report`, `calibrate`, `merge` and `building`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/campaign/merge_stores.hpp"
#include "isolaw/render/figures/figures.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::app {

// Tells the user how many outdated figures were removed, and how many figures were not drawn and why. The data files of
// the figures that were not drawn exist, and the user can draw these figures with the command `again`.
void say_drawn(render::FigureOutcome const& outcome, std::filesystem::path const& directory, std::string_view again);
void draw_figures(study::Summary const& summary, render::FigureChoice choice, std::filesystem::path const& directory);

struct PrintOptions {
  bool json = false, details = false;
  std::optional<std::filesystem::path> campaign = {};  // the campaign's directory, if the report is in another one
};
// Prints the main results on one screen or, with `details`, the complete tables, and then the verdicts of a rule set.
// With `json` it instead prints the content of summary.json, with `profile` (the times of the campaign's phases) added.
void print(study::Summary const& summary, std::filesystem::path const& directory, PrintOptions how,
           std::string_view profile = {});

// Returns 1 if a device or its compression test was refused, a law could not be fitted, a run failed, or a limit of the
// rules is not kept; otherwise 0.
int exit_code(study::Summary const& summary);

void tell_merged(campaign::MergeResult const& merged, std::filesystem::path const& directory, std::string const& store);

}  // namespace isolaw::app
