// Writes the command that computes a campaign again.
#pragma once

#include <string>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// `isolaw calibrate FILES --laws ... --seed N`, from the store: the files under their given names and every setting
// that is an option, but not how columns and units were read. It has LOT.toml in place of the files if a lot file named
// the devices. Empty for an inspection.
std::string command_again(Summary const& summary);
bool takes_lot_file(Summary const& summary);

}  // namespace isolaw::study
