// From a lot, or from records that are there already, to devices and the searches of every law on each: read, cleaned,
// boxes made.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::campaign {

// Reads and cleans every record and makes every box. A device that cannot be used is kept with its reason; throws Error
// only when none is usable.
Contents prepare(Lot const& lot);

// A record that a program holds already; its name counts as a device's in a lot file does.
struct NamedRecord {
  std::string name;
  data::TestRecord record;
  DeviceInfo info = {};
  VerticalInput vertical = {};
};
// The same of these. Throws Error also for names that no lot file could hold.
Contents prepare(std::vector<NamedRecord> records, Settings const& settings, std::string const& title);

// A compression test, read; with its reason where it gives no stiffness. Names of files are those of a lot file in
// `directory`.
data::VerticalTest prepare_vertical(VerticalInput const& given, std::filesystem::path const& directory);

// Only that: devices as they are read and cleaned, no boxes, none of the laws. Never throws for a device.
Contents prepare_devices(Lot const& lot);

// Where a law is searched on a record under these settings.
fit::SearchBox search_box(laws::LawEntry const& law, data::FitRecord const& record, Settings const& settings);

}  // namespace isolaw::campaign
