// Writes and removes the output files (page, JSON and tables) of a report, an inspection, a study of conditions or a
// study of a building. The functions that write create `dir` if necessary and throw Error on failure.
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

void write_outputs(Summary const& summary, std::filesystem::path const& dir);
void write_inspection(Summary const& summary, std::filesystem::path const& dir);
// Writes conditions.json and the tables of the study of conditions.
void write_conditions_outputs(ConditionsResult const& result, UnitSystem const& units,
                              std::filesystem::path const& dir);
void write_building_outputs(building::Study const& study, building::Answers const& answers,
                            std::filesystem::path const& dir);
// Returns the files that write_outputs() writes, as pairs of name, relative to `dir`, and text.
std::vector<std::pair<std::string, std::string>> output_texts(Summary const& summary);
// Removes run.json, the figures and the files of write_outputs(), because they must not stay beside the results of
// another campaign.
void remove_outputs(std::filesystem::path const& dir);
void remove_building_outputs(std::filesystem::path const& dir);
// Removes the unfinished files that a killed process left in `dir` and in its folders of tables and figures.
void remove_leftovers(std::filesystem::path const& dir);

}  // namespace isolaw::render
