// Reads a test that has its channels in several files. Brings them to the first file's samples, by time or by row.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "isolaw/data/channels/record_parts.hpp"

namespace isolaw::data {

// Removes from `options` the channels that the user takes from files other than `file`. Returns these other files, each
// with options that name its channels.
std::map<std::string, ReadOptions> other_files(std::filesystem::path const& file, ReadOptions& options);

// Reads `file` and the files `others` and joins their channels. Does not check the values. Throws Error if a file
// cannot be read, or if the files do not belong together.
RecordPart read_joined(std::filesystem::path const& file, ReadOptions options,
                       std::map<std::string, ReadOptions> const& others);

}  // namespace isolaw::data
