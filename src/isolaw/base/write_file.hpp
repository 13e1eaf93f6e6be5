// Writes a file under another name and then renames it, so that a reader never sees half a file.
#pragma once

#include <filesystem>
#include <string_view>

namespace isolaw {

void write_file(std::filesystem::path const& path, std::string_view text);  // throws Error
// Creates the folder if it is missing. Throws Error if that fails or if the name is a symbolic link.
void make_folder(std::filesystem::path const& folder);

// Removes the temporary files of write_file() whose process ended before it could rename them.
void remove_unfinished_files(std::filesystem::path const& folder);

}  // namespace isolaw
