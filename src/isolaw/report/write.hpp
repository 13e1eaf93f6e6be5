// The files of a report.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/report/summary.hpp"

namespace isolaw::report {

// summary.json, tables/*.csv and report.html in `dir`, which is made if
// needed. Each file is written aside and renamed: a reader sees the old or the new one, never a part. Throws Error.
void write_outputs(Summary const& summary, std::filesystem::path const& dir);

// inspection.html, inspection.json and the tables of cycles, verdicts and the lot, in the same way.
void write_inspection(Summary const& summary, std::filesystem::path const& dir);

// Names of write_outputs() relative to `dir`, and their texts.
std::vector<std::pair<std::string, std::string>> output_texts(Summary const& summary);

// Takes all of these, run.json and the figures away: the reports of one campaign must not stand beside the store of another.
void remove_outputs(std::filesystem::path const& dir);

// Made where it is not there. Throws Error: it cannot be, or is a link to somewhere else.
void make_directory(std::filesystem::path const& dir);

// Parts that a killed process left in `dir`.
void remove_leftovers(std::filesystem::path const& dir);

// The same for one file.
void write_file(std::filesystem::path const& path, std::string_view text);

}  // namespace isolaw::report
