// Finds each channel's column and unit by the user's options, or else by the header. If a column or unit cannot be
// found, a complaint names the option that the user can give.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/data/channels/read_options.hpp"
#include "isolaw/data/files/header.hpp"
#include "isolaw/data/files/table.hpp"

namespace isolaw::data {

// The channels to look for in a file: all channels of a test, its displacement history alone, the channels of a
// compression test, or a part of a test's channels.
struct Wanted {
  bool time = true, disp = true, force = true, load = true;
  bool part = false;      // this file has only some of the channels
  bool vertical = false;  // a compression test: vertical displacement and load
  static Wanted test() { return {}; }
  static Wanted compression() { return {.time = false, .force = false, .vertical = true}; }
  static Wanted motion() { return {.force = false, .load = false}; }
  bool has(Channel channel) const {
    if (channel == Channel::cycle) return force && disp && !part;
    if (channel == Channel::second_disp) return part || (force && disp);
    return channel == Channel::time ? time : channel == Channel::disp ? disp : channel == Channel::force ? force : load;
  }
};

struct Columns {
  ChannelColumns channels;
  std::vector<Complaint> complaints;
  std::vector<Finding> recognised;
  std::vector<Finding> warnings;
};

// `where` names the file, or its part, in messages; `count` is the number of columns. Problems become complaints.
Columns recognise_columns(std::string const& where, Header const& header, std::size_t count, ReadOptions const& options,
                          Wanted wanted = Wanted::test());

}  // namespace isolaw::data
