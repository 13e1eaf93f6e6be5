// Makes the built-in examples. All of their records are computed, none is measured.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/channels/record.hpp"

namespace isolaw::app {

struct TextFile {
  std::string name;
  std::string text;  // the bytes of the file, in its encoding
};

// Returns a lot: ten records in ten file formats, lot.toml, study.toml and README.md. The records are computed from
// mean parameters that Cucuzza et al. 2025 published. The noise has a fixed seed, so every call returns the same bytes.
std::vector<TextFile> example_lot();
// Returns five records, lot.toml and README.md. Each record is a test at three amplitudes, with scragging. One bearing
// is too soft, and in one record the force channel is clipped.
std::vector<TextFile> example_tests();
// Returns 26 records, lot.toml and README.md. The tests are at several temperatures, frequencies and loads, on aged
// bearings, and after rests.
std::vector<TextFile> example_conditions();

// Returns the force of a law under a motion. Names in `parameters` that the law does not have are ignored, because
// Table A.5 has a parameter p that abe-y0 lacks. A parameter that is not given gets its default value, or 0 if it has
// none.
std::vector<double> force_of(std::string_view law_id, data::FitRecord const& motion,
                             std::map<std::string_view, double> const& parameters);

// Creates `directory` if necessary. Throws Error instead of overwriting a file with other content.
void write_example(std::filesystem::path const& directory, std::vector<TextFile> const& files);

}  // namespace isolaw::app
