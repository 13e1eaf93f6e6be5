// A file that the user asked for by name.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isolaw::app {

// Writes the file whole or not at all; a pipe or a device is written to directly. Throws Error if it cannot be written,
// if it is one of `inputs`, or if it is a campaign's store.
void write_output(std::filesystem::path const& out, std::string_view text,
                  std::vector<std::filesystem::path> const& inputs);

}  // namespace isolaw::app
