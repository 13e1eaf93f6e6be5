// Reads test records as laboratories write them: delimited text, Excel workbooks, MATLAB files, JSON, told apart by
// their first bytes. Dialect, columns and units are recognised, or the file is refused with the reason.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/data/record.hpp"

namespace isolaw::data {

std::string_view name(Channel channel);

// Parses "time=1,disp=Displacement,force=3" (option --columns); throws Error on an unknown channel.
// "none" leaves out a time or load column that the header names.
std::map<Channel, std::string> parse_columns(std::string_view text);
// Parses "disp=cm,force=tonf,time=s" (option --units); throws Error on an unknown unit.
std::map<Channel, std::string> parse_units(std::string_view text);

// Parses "all" or "2" (option --test); throws Error on anything else.
std::string parse_test(std::string_view text);

// Parses "101:700", "101:" and ":700" (option --rows); throws Error on anything else.
RowRange parse_rows(std::string_view text);
std::string rows_text(RowRange const& range);

// Extensions of files that may be records.
inline constexpr std::array<std::string_view, 9> record_extensions{".csv", ".tsv", ".txt",  ".dat", ".asc",
                                                                   ".lvm", ".mat", ".xlsx", ".json"};
bool is_record_name(std::string_view file);

// A channel in a file of its own: "loadcell.csv:Force" is column Force of that file. file_column() returns nullopt if
// the text names no record's file before a colon; it then is a column.
struct FileColumn {
  std::string file, column;
  std::string text() const { return file + ":" + column; }  // reads back
};
std::optional<FileColumn> file_column(std::string_view text);

// Reads one file, and other files if channels are in them. Throws one Error that holds every problem found: unreadable
// or empty file, missing or ambiguous column, unknown unit, values that are no numbers or lie beyond the sensor's
// range, time that does not increase, constant force or displacement, force and displacement exchanged, flipped sign,
// several tests or sheets of which none is chosen.
TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options = {});
// The same for a file's bytes; messages call the file `name`.
TestRecord read_record_text(std::string_view bytes, std::string const& name, ReadOptions const& options = {});

// Reads a displacement history, cyclic or seismic, with its time if there is one, and checks it in the same way. Force
// and load are ignored and stay empty. A file of accelerations is refused; the message says what is needed instead.
TestRecord read_motion(std::filesystem::path const& file, ReadOptions const& options = {});
TestRecord read_motion_text(std::string_view bytes, std::string const& name, ReadOptions const& options = {});

// Reads vertical displacement and load of a compression test, without time and force; checks each channel by itself.
TestRecord read_compression(std::filesystem::path const& file, ReadOptions const& options = {});

// A record of values in memory, in mm, kN and s; time and load may be empty, and a record without force is a motion.
// Throws Error as read_record() does, with samples counted from 1, and if values are not finite or lengths differ.
struct Values {
  std::vector<double> disp_mm, force_kN, time_s, load_kN;
};
TestRecord record_of_values(std::string const& name, Values values);

// One of the tests of a file, and the options that read it.
struct TestChoice {
  std::optional<std::string> sheet;  // as TestRecord::layout has it
  std::optional<std::string> test;
  std::string place;                          // "d01.csv:204", "d01.xlsx:Sheet 2:1"
  std::vector<std::string> passed_over = {};  // sheets of the file that are no test; with its first test alone
};
// All tests of a file in order, or only those of the sheet, or the test, that `options` names. Throws Error if the file
// cannot be read at all.
std::vector<TestChoice> list_tests(std::filesystem::path const& file, ReadOptions const& options = {});

// Appends the next part of a device's history, whose time continues one sampling interval after the end. `label` names
// the part in messages. Throws Error if only one of the two has a time channel.
void continue_with(TestRecord& history, TestRecord const& next, std::string const& label);

}  // namespace isolaw::data
