// The built-in example lot: ten records rebuilt from the published mean parameters.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isolaw::app {

struct TextFile {
  std::string name;
  std::string text;  // bytes, in whatever encoding the file is meant to have
};

// Ten records in ten dialects, lot.toml and README.md. The same bytes at every call: the noise is seeded.
std::vector<TextFile> example_lot();

// Writes the lot into `directory`, which is created if absent. Throws Error if a file with other content is in the way.
void write_example_lot(std::filesystem::path const& directory);

}  // namespace isolaw::app
