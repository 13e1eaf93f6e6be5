// From what the user named, files and options, to a lot.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::app {

// The lot file or the lot of the files named, with the options of the command line laid over it.
campaign::Lot lot_of(CalibrateArguments const& arguments);
bool is_of_lot_file(CalibrateArguments const& arguments);

// The files named; in place of a directory the records in it by name, directories below it left out. Throws Error for
// one without records.
std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs);

// A lot file with the built-in rule sets known by their names.
campaign::Lot lot_of_file(std::filesystem::path const& file, campaign::LotFileOptions options);

// One lot file or the records named; a directory stands for the records in it.
campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options);

// Lays what is given over `acceptance`, whose rule set is then loaded and everything checked. Throws Error.
void apply(Values const& given, campaign::Acceptance& acceptance);

// "DEVICE=FILE": the compression test of a device of the lot, in place of what the lot file says. Throws Error.
void apply_vertical(std::vector<std::string> const& given, campaign::Lot& lot);

// Options given on the command line win over those in `options`.
void apply(Values const& given, data::ReadOptions& options);

// The directory of the results: --out, the lot file's `out`, or out/<name of the lot file's directory or of the first
// record>.
std::filesystem::path output_directory(CalibrateArguments const& arguments, campaign::Lot const& lot);

}  // namespace isolaw::app
