// The table of options for reading records. The command line, lot files and Python are built from it.
#pragma once

#include <span>

#include "isolaw/base/option.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

struct Reading : Option<ReadOptions> {
  bool of_test = false;                 // applies to tests only, because a motion has no force
  std::string_view motion_option = {};  // the option's name for a motion, if `key` means something else there
};

// If columns or units are given a second time, only the channels named there change. Any other option replaces its
// earlier value.
std::span<Reading const> reading_table();

}  // namespace isolaw::data
