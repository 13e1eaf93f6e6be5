// Assigns columns to channels and units, by the user's options or else by the header. Asks for what remains uncertain.
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

// The channels wanted: a test, only its displacement history, a compression test, or single channels of a test.
struct Wanted {
  bool time = true, disp = true, force = true, load = true;
  bool part = false;      // other channels are in another file
  bool vertical = false;  // displacement and load of a compression test
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
  std::optional<Unit> unit;                     // empty if it is missing or wrong, which a complaint says
  StampKind stamp = StampKind::none;            // how the column writes time, if by time stamps
  std::optional<std::size_t> date_column = {};  // the column with the dates of its times of day
};

struct Columns {
  std::map<Channel, Column> channels;
  std::vector<Complaint> complaints;
  std::vector<Finding> recognised;
  std::vector<Finding> warnings;
};

// `where` is the file as given, or its part with the `count` columns. Never throws: problems become complaints.
Columns recognise_columns(std::string const& where, Header const& header, std::size_t count, ReadOptions const& options,
                          Wanted wanted = Wanted::test());

// The column's name if it is unique and an option can hold it, else its number.
std::string column_key(std::size_t index, Header const& header);

// The text that --columns accepts for a column: its number, its letter, or the name of a variable.
std::string option_key(std::size_t index, Header const& header);
// "A" to "Z", "AA", ...: the columns of a workbook, from 0.
std::string column_letters(std::size_t index);
std::optional<std::size_t> letters_column(std::string_view letters);

// "column 2 'Force [kN]'", "column B 'Force [kN]'", "variable 'Force'"
std::string column_text(std::size_t index, Header const& header);

}  // namespace isolaw::data
