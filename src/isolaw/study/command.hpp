// Writes the command that computes a campaign again.
#pragma once

#include <string>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Rebuilds `isolaw calibrate FILES --laws ... --seed N` from the store, with every setting that is an option, but not
// how columns and units were read. LOT.toml replaces FILES if a lot file named the devices. Empty for an inspection.
std::string command_again(Summary const& summary);
bool takes_lot_file(Summary const& summary);

}  // namespace isolaw::study
