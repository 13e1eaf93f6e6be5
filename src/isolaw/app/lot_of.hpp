// Builds the lot from the files and options that the user gave.
#pragma once

#include "isolaw/app/commands.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::app {

campaign::Lot lot_of(CalibrateArguments const& arguments);
bool is_of_lot_file(CalibrateArguments const& arguments);

// Replaces each directory among the inputs by the record files in it, without those in its subdirectories. Throws Error
// for a directory without records.
std::vector<std::filesystem::path> records_of(std::vector<std::filesystem::path> const& inputs);

// Makes the lot from a lot file or from records. If `same_device` is true, all records are tests of one device.
campaign::Lot lot_of_inputs(std::vector<std::filesystem::path> const& inputs, campaign::LotFileOptions const& options,
                            bool same_device);

// Copies the given options into `acceptance`, loads the rule set and parses the design values. Throws Error if one of
// them is wrong.
void apply(Values const& given, campaign::Acceptance& acceptance);

// Sets the compression tests of devices from texts "DEVICE=FILE". Throws Error for an unknown device or one that is
// given twice.
void apply_vertical(std::vector<std::string> const& given, campaign::Lot& lot);
void apply(Values const& given, data::ReadOptions& options);
void apply(Values const& given, campaign::DeviceInput& device);  // sets the reading options of all its tests

// Returns the directory for the results: --out, or else `out` of the lot file, or else out/<name of the lot>.
std::filesystem::path output_directory(CalibrateArguments const& arguments, campaign::Lot const& lot);

}  // namespace isolaw::app
