// Writes files so that a reader never sees half of one.
#pragma once

#include <filesystem>
#include <string_view>

namespace isolaw {

// Writes beside the file and then renames: a reader sees the old or the new file, never a part. Throws Error.
void write_file(std::filesystem::path const& path, std::string_view text);

// Creates the folder if it is missing. Throws Error if that fails or if the name is a symbolic link.
void make_folder(std::filesystem::path const& folder);

// Removes partly written files that killed processes left in `folder`.
void remove_unfinished_files(std::filesystem::path const& folder);

}  // namespace isolaw
