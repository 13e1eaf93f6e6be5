// Reads a test whose channels are in several files: reads each by itself, then brings it to the samples of the first.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "isolaw/data/read.hpp"
#include "isolaw/data/record_parts.hpp"

namespace isolaw::data {

// Removes the channels that are in other files from `options`, and returns these files with the options for each.
std::map<std::string, ReadOptions> other_files(std::filesystem::path const& file, ReadOptions& options);

// The record is not yet checked. Throws Error if a file cannot be read, or if the files do not belong together.
RecordPart read_joined(std::filesystem::path const& file, ReadOptions options,
                       std::map<std::string, ReadOptions> const& others);

}  // namespace isolaw::data
