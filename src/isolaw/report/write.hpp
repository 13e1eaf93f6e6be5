// The files of a report.
#pragma once

#include <filesystem>
#include <string_view>

#include "isolaw/report/summary.hpp"

namespace isolaw::report {

// summary.json, tables/{parameters,objective,robustness,properties}.csv and report.html in `dir`, which is made if
// needed. Each file is written aside and renamed: a reader sees the old or the new one, never a part. Throws Error.
void write_outputs(Summary const& summary, std::filesystem::path const& dir);

// The same for one file.
void write_file(std::filesystem::path const& path, std::string_view text);

}  // namespace isolaw::report
