// The lot file (TOML): which records make the lot, how they are read, what is asked for. Read and written.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::campaign {

// A compression test before it is read: a file, or the stiffness alone.
struct VerticalInput {
  std::filesystem::path file;
  std::string shown_file;
  data::ReadOptions read = {};
  std::optional<data::LoadRange> loads = {};
  std::optional<double> stated_kN_per_mm = {};

  bool given() const { return !file.empty() || stated_kN_per_mm; }
};

// One device before its record is read.
struct DeviceInput {
  std::string name;
  std::vector<std::filesystem::path> files;  // read one after another as one history
  std::filesystem::path directory;           // of the lot file; empty for files named on the command line
  std::string shown_file;                    // as reports name it
  DeviceInfo info;
  data::ReadOptions read;
  VerticalInput vertical = {};
};

// All files that the device is read from: its records, then those of single channels.
std::vector<std::filesystem::path> files_of(DeviceInput const& device);

struct Lot {
  std::string title;
  Acceptance acceptance;
  bool rules_are_file = false;  // acceptance.rules_file is the path of a file, no built-in set
  Settings settings;
  data::ReadOptions read;  // how records are read where a device does not say otherwise
  std::vector<DeviceInput> devices;
  std::optional<std::filesystem::path> out;  // directory of the results, relative to where the program runs
  std::optional<int> jobs;
};

// A lot file comes from others: what it names must lie in its own folder or below, links followed, and what it has
// written below the current directory, unless the user says otherwise. Never a key of the file itself.
struct LotFileOptions {
  bool allow_outside = false;  // --allow-outside
  bool other_out = false;      // --out is given: the file's `out` does not count
  // Names of rule sets that need no file, which this module does not know; empty: every name is a file's.
  std::function<bool(std::string_view)> is_built_in_rules = {};
  std::function<void(std::string_view)> check_design = {};  // throws Error; of that module too
};

inline constexpr std::size_t most_devices = 10'000;
inline constexpr std::size_t longest_name = 512;           // bytes of a name, a serial, a title
inline constexpr std::size_t largest_lot_file = 16 << 20;  // bytes

// Throws one Error that holds every problem of the file with its line: syntax, unknown keys, wrong types, values that
// are not allowed, text that is not printable, devices without name or file, a name twice, files outside the folder.
// Keys of [calibrate] are the command line's options.
Lot read_lot_file(std::filesystem::path const& file, LotFileOptions const& options = {});
// The same of a file's text; `file` is its name, for messages and for its folder.
Lot read_lot_text(std::string_view text, std::filesystem::path const& file, LotFileOptions const& options = {});

// What a device is called by its record's name: printable, no blanks around it, as lot files ask for.
std::string name_of_file(std::filesystem::path const& file);

// A lot of files named on the command line; devices are named after them.
Lot lot_of_files(std::vector<std::filesystem::path> const& files);

using Particulars = std::map<std::string, std::string>;  // by key: what a file says of its device, as it says it

// What is written beside the keys, for a person.
struct LotFileRemarks {
  bool open_keys = false;           // the keys of a device that nothing was said of, as comments
  std::vector<Particulars> stated;  // of each device: what stands there in a form that cannot be taken over
  std::vector<std::pair<std::filesystem::path, std::string>> left_out;  // files, and why
};

// The text of a lot file that reads back as `lot`: each key of reading that all devices share in [read]; file names
// relative to `directory` where they lie below it.
std::string lot_file_text(Lot const& lot, std::filesystem::path const& directory, LotFileRemarks const& remarks = {});

// Takes what a file says of its device into what is known of it; what cannot be taken as it stands (a temperature
// without a unit) comes back.
Particulars take_particulars(std::vector<std::pair<std::string, std::string>> const& particulars, DeviceInfo& info);

}  // namespace isolaw::campaign
