// Reads and writes the lot file (TOML): the records of a lot, how to read them, and the settings of the campaign.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/lot_conditions.hpp"
#include "isolaw/campaign/names_of_tests.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::campaign {

struct VerticalInput {  // a compression test before it is read: a file, or just the stiffness
  std::filesystem::path file;
  std::string shown_file;
  data::ReadOptions read = {};
  std::optional<data::LoadRange> loads = {};
  std::optional<double> stated_kN_per_mm = {};

  bool is_given() const { return !file.empty() || stated_kN_per_mm; }
};

struct TestInput {                           // one test before its record is read
  std::string name = {};                     // empty for the only test of a device
  std::vector<std::filesystem::path> files;  // read one after another as one history
  std::string shown_file;                    // the name in reports
  std::string place = {};                    // its table in the lot file, such as "lot.toml:38"; empty without one
  data::ReadOptions read;
  StatedTest stated = {};  // the condition of the test; only in a lot file with [conditions]
};

struct DeviceInput {  // one device before its record is read
  std::string name;
  std::vector<TestInput> tests{1};  // one or more, which share the parameters of every law
  // All tests of the device in the order in which they were made, if the lot file has a table [conditions]. `tests`
  // then holds only those to which a campaign fits laws, usually one.
  std::vector<TestInput> history = {};
  StatedDevice stated = {};         // only in a lot file with [conditions]
  std::filesystem::path directory;  // folder of the lot file; empty for files named on the command line
  DeviceInfo info;
  VerticalInput vertical = {};

  std::string shown_file() const;  // the name in reports: the files of all tests
};

// All files of the device: for each test its records, then the files that hold single channels.
std::vector<std::filesystem::path> files_of(DeviceInput const& device);

struct Lot {
  std::string title;
  Acceptance acceptance;
  bool rules_are_file = false;  // acceptance.rules_file is a path, not the name of a built-in set
  Settings settings;
  data::ReadOptions read;  // defaults for reading the devices' records
  std::vector<DeviceInput> devices;
  std::optional<StatedConditions> conditions;
  std::optional<std::filesystem::path> out;  // directory for results, relative to the program's current directory
  std::optional<int> jobs;
};

// A lot file may come from someone else. The files that it names must be in its own folder or below it (with links
// followed), and results go below the current directory. Only the user can lift these limits, not the file.
struct LotFileOptions {
  bool allow_outside = false;                    // the user gave --allow-outside
  bool other_out = false;                        // the user gave --out, so the file's `out` is ignored
  std::vector<std::string> built_in_rules = {};  // names of the built-in rule sets; if empty, every name means a file
  std::function<void(std::string_view)> check_design = {};  // checks design values (module `rules`); throws Error
};

inline constexpr std::size_t most_devices = 10'000;
inline constexpr std::size_t longest_name = 512;           // bytes in a name, serial or title
inline constexpr std::size_t largest_lot_file = 16 << 20;  // bytes
// Throws one Error with every problem of the file and its line: syntax, unknown keys, wrong types, values that are not
// allowed, text that is not printable, devices without a file, duplicate names, files outside the folder. The keys of
// [calibrate] are the options of the command line.
Lot read_lot_file(std::filesystem::path const& file, LotFileOptions const& options = {});
// Reads the text of a lot file. Messages call it `file`. The files that it names are sought in the folder of `file`.
Lot read_lot_text(std::string_view text, std::filesystem::path const& file, LotFileOptions const& options = {});
// Does the same for tables that are not in a file, such as those of a Python program. The files that they name are
// sought in `folder`. Messages name the device and the test in place of a line.
Lot lot_of_tables(Json const& tables, std::filesystem::path const& folder, LotFileOptions const& options = {});
std::string name_of_file(std::filesystem::path const& file);        // printable and without blanks around it
Lot lot_of_files(std::vector<std::filesystem::path> const& files);  // devices are named after their files
// One name for several tests, such as "a + b", "a + b + c", or "a and 3 more tests".
std::string name_of_tests(std::span<data::TestSource const> tests);

using StatedFacts = std::map<std::string, std::string>;  // facts that a record's file states about its device, by key

// Makes one device, whose tests are all records of the lot and whose name comes from them. Returns the facts that the
// records state differently, with the name of each record. The device gets no value for such a fact.
StatedFacts make_one_device(Lot& lot);

struct LotFileRemarks {             // comments for the person who edits the file
  bool open_keys = false;           // list, as comments, the keys of a device that have no value yet
  std::vector<StatedFacts> stated;  // for each device, facts that its record states but that could not be used
  std::vector<std::pair<std::filesystem::path, std::string>> left_out;  // files that are no devices, and why
  // If the names of the records state conditions, record i is written as a test of the device tests[i].device, and
  // `reference` is the TOML table of the reference conditions. Otherwise both members are empty.
  std::vector<ProposedTest> tests = {};
  std::string reference = {};
};

// The text of a lot file that reads back as `lot`. Reading options that all devices share are written in [read]. File
// names below `directory` are relative to it.
std::string lot_file_text(Lot const& lot, std::filesystem::path const& directory, LotFileRemarks const& remarks = {});

// Copies the facts that a record's file states into empty fields of `info`. Returns those facts that cannot be used as
// they are.
StatedFacts take_device_facts(std::vector<std::pair<std::string, std::string>> const& device_facts, DeviceInfo& info);

}  // namespace isolaw::campaign
