// A file that the user asked for by name.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isolaw::app {

// Written whole or not at all; a pipe or a device is written to. Throws Error: it cannot be written, is one of
// `inputs`, which it would replace, or a campaign's store.
void write_output(std::filesystem::path const& out, std::string_view text,
                  std::vector<std::filesystem::path> const& inputs);

}  // namespace isolaw::app
