// Builds the lot from the files and options that the user gave.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::app {

campaign::Lot lot_of(CalibrateArguments const& arguments);
bool is_of_lot_file(CalibrateArguments const& arguments);

// Replaces a directory by the records in it, not in its subdirectories. Throws Error for a directory without records.
std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs);

// If `same_device`, all records are tests of one device.
campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options,
                            bool same_device);

// Sets the given options, loads the rule set and parses the design values. Throws Error if one of them is wrong.
void apply(Values const& given, campaign::Acceptance& acceptance);

// Replaces a device's compression test by "DEVICE=FILE". Throws Error for an unknown device or one that is given twice.
void apply_vertical(std::vector<std::string> const& given, campaign::Lot& lot);
void apply(Values const& given, data::ReadOptions& options);
void apply(Values const& given, campaign::DeviceInput& device);  // sets the reading options of all its tests

// The directory for the results: --out, else `out` of the lot file, else out/<name of the lot>.
std::filesystem::path output_directory(CalibrateArguments const& arguments, campaign::Lot const& lot);

}  // namespace isolaw::app
