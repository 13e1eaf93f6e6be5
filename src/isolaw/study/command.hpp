// Writes the command that computes a campaign again.
#pragma once

#include <string>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// `isolaw calibrate FILES --laws ... --seed N`, from what the store says: the files as they were named and every
// setting that is an option, but not how columns and units were read. LOT.toml stands in place of the files where a lot
// file named the devices. Empty for an inspection.
std::string command_again(Summary const& summary);
bool takes_lot_file(Summary const& summary);

}  // namespace isolaw::study
