// The built-in example lot: ten records computed from mean parameters that Cucuzza et al. 2025 published.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isolaw::app {

struct TextFile {
  std::string name;
  std::string text;  // the bytes, in the encoding that this file has
};

// Ten records in ten file formats, lot.toml and README.md. The noise is seeded, so every call gives the same bytes.
std::vector<TextFile> example_lot();

// Creates `directory` if necessary. Throws Error instead of overwriting a file with other content.
void write_example_lot(std::filesystem::path const& directory);

}  // namespace isolaw::app
