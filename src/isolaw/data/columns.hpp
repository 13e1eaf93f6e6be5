// Finds each channel's column and unit by the user's options, or else by the header. Asks for what is missing.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/data/header.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

inline constexpr Channel all_channels[] = {Channel::time, Channel::disp, Channel::force, Channel::load};

// The content to read: a test, only its displacement history, a compression test, or some channels of a test.
struct Wanted {
  bool time = true, disp = true, force = true, load = true;
  bool part = false;      // this file has only some of the channels
  bool vertical = false;  // a compression test: vertical displacement and load
  static Wanted test() { return {}; }
  static Wanted compression() { return {.time = false, .force = false, .vertical = true}; }
  static Wanted motion() { return {.force = false, .load = false}; }
  bool has(Channel channel) const {
    return channel == Channel::time ? time : channel == Channel::disp ? disp : channel == Channel::force ? force : load;
  }
};

Dimension dimension(Channel channel);

struct Column {
  std::size_t index = 0;                        // from 0
  std::optional<Unit> unit;                     // empty if missing or wrong; a complaint says so
  StampKind stamp = StampKind::none;            // kind of time stamps in the column
  std::optional<std::size_t> date_column = {};  // for times of day: the column with their dates
};

struct Columns {
  std::map<Channel, Column> channels;
  std::vector<Complaint> complaints;
  std::vector<Finding> recognised;
  std::vector<Finding> warnings;
};

// `where` names the file, or its part, in messages; `count` is the number of columns. Problems become complaints.
Columns recognise_columns(std::string const& where, Header const& header, std::size_t count, ReadOptions const& options,
                          Wanted wanted = Wanted::test());

// The column's name if it is unique and --columns can hold it, else its number.
std::string column_key(std::size_t index, Header const& header);

// The text that --columns accepts for a column: its number, its letter, or the name of a variable.
std::string option_key(std::size_t index, Header const& header);
// The letter of a workbook's column with this index, from 0: "A" to "Z", "AA", ...
std::string column_letters(std::size_t index);
std::optional<std::size_t> letters_column(std::string_view letters);

// How messages call a column: "column 2 'Force [kN]'", "column B 'Force [kN]'", "variable 'Force'".
std::string column_text(std::size_t index, Header const& header);

}  // namespace isolaw::data
