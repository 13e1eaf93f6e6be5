// How records are read, option by option: command line, lot file and Python are made from this table.
#pragma once

#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

struct Reading : Option<ReadOptions> {
  bool of_test = false;                 // not of motions, which have no force
  std::string_view motion_option = {};  // what it is called beside options of a law, where its own name is taken
};

// Columns and units add to those that are there, channel by channel; every other value takes the place of what was
// there. Limits of corrections are those of Corrections::validate().
std::span<Reading const> reading_table();

}  // namespace isolaw::data
