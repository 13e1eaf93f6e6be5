// The built-in examples. All of their records are computed, none is measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isolaw::app {

struct TextFile {
  std::string name;
  std::string text;  // the bytes, in the encoding that this file has
};

// Ten records in ten file formats, lot.toml, study.toml and README.md: a lot computed from mean parameters that Cucuzza
// et al. 2025 published. The noise is seeded, so every call gives the same bytes.
std::vector<TextFile> example_lot();
// Five records, lot.toml and README.md: tests of three amplitudes, with scragging, a soft bearing and a clipped
// channel.
std::vector<TextFile> example_tests();

// Creates `directory` if necessary. Throws Error instead of overwriting a file with other content.
void write_example(std::filesystem::path const& directory, std::vector<TextFile> const& files);

}  // namespace isolaw::app
