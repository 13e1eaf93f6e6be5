// Reads test records of laboratories. Refuses what it cannot recognise, and says why.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/vertical.hpp"

namespace isolaw::data {

// Reads a record from one file, or from several if options.columns names others. Throws one Error that holds every
// problem found: file, columns, units, values, time, constant or exchanged channels, flipped sign, or a missing choice
// among several tests or sheets.
TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options = {});
// Reads a record from the bytes of a file. Messages call the file `name`.
TestRecord read_record_text(std::string_view bytes, std::string const& name, ReadOptions const& options = {});

// Reads and checks a displacement history alone; force and load stay empty. Refuses a file of accelerations.
TestRecord read_motion(std::filesystem::path const& file, ReadOptions const& options = {});
TestRecord read_motion_text(std::string_view bytes, std::string const& name, ReadOptions const& options = {});

// Reads vertical displacement and load of a compression test, without time and force. `loads` is the range of load for
// the vertical stiffness; nullopt means the usual range.
VerticalTest read_vertical(std::filesystem::path const& file, ReadOptions const& options,
                           std::optional<LoadRange> const& loads);

// A record in mm, kN and s. Time and load may be empty; a record without force is a displacement history.
struct Values {
  std::vector<double> disp_mm, force_kN, time_s, load_kN;
};
TestRecord record_of_values(std::string const& name, Values values);

struct TestChoice {
  // Values of --sheet and --test that choose this test; nullopt if the option is not needed.
  std::optional<std::string> sheet;
  std::optional<std::string> test;
  std::string place;                          // where the test starts: "d01.csv:204", "d01.xlsx:Sheet 2:1"
  std::vector<std::string> passed_over = {};  // names of sheets that are no test; set only for the file's first test
};
// Lists all tests of a file, or only those that options.sheet and options.test choose. Throws Error if the file cannot
// be read.
std::vector<TestChoice> list_tests(std::filesystem::path const& file, ReadOptions const& options = {});

// Appends `next`, named `label` in messages, one sampling interval after `history`. Throws Error if only one has time.
void continue_with(TestRecord& history, TestRecord const& next, std::string const& label);

// record_of_tests() joins several tests of a device into one record. Throws Error if only some have time, if two have
// the same name or the same values, or if one of the records already holds several tests.
struct NamedTest {
  std::string name;
  TestRecord record;
};
TestRecord record_of_tests(std::vector<NamedTest> tests);

}  // namespace isolaw::data
