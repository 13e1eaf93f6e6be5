// Writes the command that computes a campaign again.
#pragma once

#include <string>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Rebuilds `isolaw calibrate FILES --laws ... --seed N` from the store, with every setting and every option about how
// to read the records. FILES are names without folders: a store holds no folders, so that it does not depend on where
// it was made. LOT.toml replaces FILES if a lot file named the devices or reads them in several ways. Empty for an
// inspection.
std::string command_again(Summary const& summary);
bool takes_lot_file(Summary const& summary);

}  // namespace isolaw::study
