// The lot file (TOML): which records make the lot, how they are read, what is asked for. Read and written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::campaign {

// One device before its record is read.
struct DeviceInput {
  std::string name;
  std::vector<std::filesystem::path> files;  // read one after another as one history
  std::filesystem::path directory;           // of the lot file; empty for files named on the command line
  std::string shown_file;                    // as reports name it
  DeviceInfo info;
  data::ReadOptions read;
};

struct Lot {
  std::string title;
  Settings settings;
  std::vector<DeviceInput> devices;
  std::optional<std::filesystem::path> out;  // directory of the results, relative to where the program runs
  std::optional<int> jobs;
};

// Throws one Error that holds every problem of the file with its line: syntax, unknown keys, wrong types, values that
// are not allowed, devices without name or file, a name twice. Keys of [calibrate] are the command line's options.
Lot read_lot_file(std::filesystem::path const& file);

// A lot of files named on the command line; devices are named after them.
Lot lot_of_files(std::vector<std::filesystem::path> const& files);

// The text of a lot file that reads back as `lot`; file names relative to `directory` where they lie below it.
std::string lot_file_text(Lot const& lot, std::filesystem::path const& directory);

}  // namespace isolaw::campaign
