// Delimited text as laboratories write it: recognised dialect, columns and units, or refused with the reason.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/data/record.hpp"

namespace isolaw::data {

std::string_view name(Channel channel);

struct ReadOptions {
  std::map<Channel, std::string> columns;  // name or 1-based number; what is missing is recognised; "none": not read
  std::map<Channel, std::string> units;    // "cm", "tonf", ...; what is missing is read from the header
  std::optional<double> dt_s;              // sampling interval of a file without a time column
  bool flip_force = false;                 // multiply the force by -1 (option --flip-force)
};

// Parses "time=1,disp=Displacement,force=3" (option --columns); throws Error on an unknown channel.
// "none" leaves out a time or load column that the header names.
std::map<Channel, std::string> parse_columns(std::string_view text);
// Parses "disp=cm,force=tonf,time=s" (option --units); throws Error on an unknown unit.
std::map<Channel, std::string> parse_units(std::string_view text);

// Reads one file. Throws one Error that holds every problem found: unreadable or empty file, missing or ambiguous
// column, unknown unit, values that are no numbers or lie beyond the sensor's range, time that does not increase,
// constant force or displacement, force and displacement swapped, flipped sign.
TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options = {});
// The same of a file's bytes; `name` is the file in messages.
TestRecord read_record_text(std::string_view bytes, std::string const& name, ReadOptions const& options = {});

}  // namespace isolaw::data
