// The options that say how records are read. The command line, lot files and Python are built from this table.
#pragma once

#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

struct Reading : Option<ReadOptions> {
  bool of_test = false;                 // not for motions, which have no force
  std::string_view motion_option = {};  // its name for a motion, if the key already means something else
};

// Columns and units add to those given before, channel by channel; every other value replaces the one given before.
std::span<Reading const> reading_table();

}  // namespace isolaw::data
