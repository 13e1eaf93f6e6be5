// How to read a file: the options of the command line, lot files and Python, and the texts in which they are given.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include "isolaw/data/files/channel.hpp"
#include "isolaw/data/files/row_range.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data {

// The corrections that the user asks for. They undo errors of the test rig; signals/corrections.hpp makes them.
struct Corrections {
  bool repair_spikes = false;                       // replaces single samples far from their neighbours
  std::optional<double> skew_s = {};                // delay of the force behind displacement, to be removed
  std::optional<double> friction_kN = {};           // friction of the rig in the measured force, to be subtracted
  std::optional<double> friction_coefficient = {};  // friction of the rig as a fraction of the measured vertical load
  std::optional<double> moving_mass_kg = {};        // mass between device and load cell; its inertia is subtracted
  std::optional<double> force_factor = {};  // multiplies the force at the end: 0.5 for two devices in double shear

  bool any() const;
  bool operator==(Corrections const&) const = default;
  void validate() const;  // throws Error that names the options
};

// How to read a file. isolaw recognises from the file what the user does not state here.
struct ReadOptions {
  std::map<Channel, std::string> columns = {};     // name or number from 1; "none": leave the channel out
  std::map<Channel, std::string> units = {};       // "cm", "tonf", ...; for other channels the header states the unit
  std::map<Channel, std::string> scales = {};      // a value of 1 in the file is this many units ("0.01")
  std::optional<double> dt_s = {};                 // sampling interval of a file without a time column
  std::optional<DateOrder> date_order = {};        // for dates like 03/04/2024
  std::optional<RowRange> rows = {};               // rows to read
  std::optional<double> from_s = {}, to_s = {};    // time interval to read
  bool skip_footer = false;                        // ignore text below the rows (option --footer skip)
  std::optional<char> thousands = {};              // mark that groups digits: , . ' or a blank
  MissingValues missing = MissingValues::refused;  // how to treat rows in which a channel has no value
  bool flip_force = false;                         // multiply the force by -1 (option --flip-force)
  std::optional<std::string> sheet = {};  // name or number of a workbook's sheet, a .mat file's struct or a JSON key
  std::optional<std::string> test = {};   // which test of several: a number from 1, or "all" to join them
  bool half_cycles = false;               // swings that belong to no full cycle count as half cycles
  Corrections corrections = {};           // options --repair, --skew-ms and so on
  bool checks_physics = true;             // refuse a record whose loops supply energy instead of dissipating it

  bool operator==(ReadOptions const&) const = default;
};

// Returns options that read the record as it was measured, without the corrections that the user asked for; nullopt if
// there are no corrections. The factor of the force stays, because it says what the rig measures. The check of physics
// (checks_physics) is off, because without the corrections the loops may be impossible.
std::optional<ReadOptions> without_corrections(ReadOptions options);

// Parses "time=1,disp=Displacement,force=3" (option --columns). The column "none" leaves out time or load, even if the
// header names it. Throws Error on an unknown channel.
std::map<Channel, std::string> parse_columns(std::string_view text);
// Parses "disp=cm,force=tonf,time=s" (option --units); throws Error on an unknown unit.
std::map<Channel, std::string> parse_units(std::string_view text);
// Parses "disp=0.01,force=10" (option --channel-scale); throws Error unless each is a positive number.
std::map<Channel, std::string> parse_scales(std::string_view text);
// Parses "all" or "2" (option --test); throws Error on anything else.
std::string parse_test(std::string_view text);

inline constexpr std::array<std::string_view, 9> record_extensions{".csv", ".tsv", ".txt",  ".dat", ".asc",
                                                                   ".lvm", ".mat", ".xlsx", ".json"};
bool is_record_name(std::string_view file);

// A column in another file: "loadcell.csv:Force". file_column() returns nullopt if no file name precedes a colon.
struct FileColumn {
  std::string file, column;
  std::string text() const { return file + ":" + column; }  // file_column() parses this text
};
std::optional<FileColumn> file_column(std::string_view text);

}  // namespace isolaw::data
