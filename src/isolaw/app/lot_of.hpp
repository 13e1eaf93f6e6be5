// Builds the lot from the files and options that the user gave.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::app {

// The lot of the lot file or of the records, with the command line's options, which override those of the lot file.
campaign::Lot lot_of(CalibrateArguments const& arguments);
bool is_of_lot_file(CalibrateArguments const& arguments);

// The files named. A directory stands for the files in it whose names are those of records, without subdirectories.
// Throws Error for a directory without records.
std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs);

// Reads a lot file that may name built-in rule sets.
campaign::Lot lot_of_file(std::filesystem::path const& file, campaign::LotFileOptions options);

// One lot file or the records named; a directory stands for the records in it.
campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options);

// Puts the values given into `acceptance`, then loads its rule set and checks everything. Throws Error.
void apply(Values const& given, campaign::Acceptance& acceptance);

// Takes "DEVICE=FILE", the compression test of a device of the lot, which replaces the lot file's. Throws Error.
void apply_vertical(std::vector<std::string> const& given, campaign::Lot& lot);

// Options given on the command line win over those in `options`.
void apply(Values const& given, data::ReadOptions& options);

// The directory of the results: --out, the lot file's `out`, or out/<name of the lot file's directory or of the first
// record>.
std::filesystem::path output_directory(CalibrateArguments const& arguments, campaign::Lot const& lot);

}  // namespace isolaw::app
