// The files of a report.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/render/results.hpp"

namespace isolaw::building {
struct Study;
struct Answers;
}  // namespace isolaw::building

namespace isolaw::render {

// summary.json, tables/*.csv and report.html in `dir`, which is made if needed. Throws Error.
void write_outputs(Summary const& summary, std::filesystem::path const& dir);

// inspection.html, inspection.json and the tables of cycles, verdicts and the lot, in the same way.
void write_inspection(Summary const& summary, std::filesystem::path const& dir);

// building.html, building.json and the tables of a building, in the same way.
void write_building_outputs(building::Study const& study, building::Answers const& answers,
                            std::filesystem::path const& dir);

// Names of write_outputs() relative to `dir`, and their texts.
std::vector<std::pair<std::string, std::string>> output_texts(Summary const& summary);

// Takes all of these, run.json and the figures away: the reports of one campaign must not stand beside the store of
// another.
void remove_outputs(std::filesystem::path const& dir);
// And those of a study of a building.
void remove_building_outputs(std::filesystem::path const& dir);

// Parts that a killed process left in `dir`.
void remove_leftovers(std::filesystem::path const& dir);

}  // namespace isolaw::render
