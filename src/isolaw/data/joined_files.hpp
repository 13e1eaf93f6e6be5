// A test whose channels stand in several files: each is read by itself, then brought to the samples of the first.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "isolaw/data/read.hpp"
#include "isolaw/data/record_parts.hpp"

namespace isolaw::data {

// The other files that `options` name channels of, with what is asked of each; taken out of `options`.
std::map<std::string, ReadOptions> other_files(std::filesystem::path const& file, ReadOptions& options);

// The channels of `file` and of `others`, before anything is asked of them together. Throws Error where one cannot be
// read, or they do not belong together.
RecordPart read_joined(std::filesystem::path const& file, ReadOptions options,
                       std::map<std::string, ReadOptions> const& others);

}  // namespace isolaw::data
