// Writes a file that the user named with --out.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isolaw::app {

// Writes `text` to `out` and leaves no half-written file. Throws Error if writing fails, or if `out` is one of `inputs`
// or a campaign's store.
void write_output(std::filesystem::path const& out, std::string_view text,
                  std::vector<std::filesystem::path> const& inputs);

}  // namespace isolaw::app
