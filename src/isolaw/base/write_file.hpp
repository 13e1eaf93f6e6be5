// Files that are whole or not there.
#pragma once

#include <filesystem>
#include <string_view>

namespace isolaw {

// Written aside and renamed: a reader sees the old or the new file, never a part. Throws Error.
void write_file(std::filesystem::path const& path, std::string_view text);

// Made where it is not there. Throws Error: it cannot be, or is a link to somewhere else.
void make_folder(std::filesystem::path const& folder);

// Parts that a killed process left in `folder`.
void remove_unfinished_files(std::filesystem::path const& folder);

}  // namespace isolaw
