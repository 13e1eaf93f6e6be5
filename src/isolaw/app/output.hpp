// A file that the user asked for by name.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isolaw::app {

// Writes a regular file whole or not at all. Throws Error on failure, for one of `inputs`, or for a campaign's store.
void write_output(std::filesystem::path const& out, std::string_view text,
                  std::vector<std::filesystem::path> const& inputs);

}  // namespace isolaw::app
