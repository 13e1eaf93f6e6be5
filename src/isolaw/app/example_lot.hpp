// The built-in examples. All of their records are computed, none is measured.
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
  std::string text;  // the bytes, in the encoding that this file has
};

// Ten records in ten file formats, lot.toml, study.toml and README.md: a lot computed from mean parameters that Cucuzza
// et al. 2025 published. The noise is seeded, so every call gives the same bytes.
std::vector<TextFile> example_lot();
// Five records, lot.toml and README.md: tests of three amplitudes, with scragging, a soft bearing and a clipped
// channel.
std::vector<TextFile> example_tests();
// 26 records, lot.toml and README.md: tests at several temperatures, frequencies and loads, aged, and after rests.
std::vector<TextFile> example_conditions();

// The force of a law on a motion. Names in `parameters` that the law does not have are ignored, because Table A.5 has a
// parameter p that abe-y0 lacks. A parameter that is not given gets its default value, or 0 if it has none.
std::vector<double> force_of(std::string_view law_id, data::FitRecord const& motion,
                             std::map<std::string_view, double> const& parameters);

// Creates `directory` if necessary. Throws Error instead of overwriting a file with other content.
void write_example(std::filesystem::path const& directory, std::vector<TextFile> const& files);

}  // namespace isolaw::app
