// Makes a campaign's contents from a lot file or records in memory: cleans the records and makes the box of every law.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::campaign {

// The first finding about how a record was read has a word (Finding::words) with this key. The word is a JSON object of
// the options with which the record was read.
inline constexpr std::string_view given_options = "given_options";

// Keeps a device that cannot be used, with the reason in Device::refusal. Throws Error if no device is usable or a
// setting is not allowed.
Contents prepare(Lot const& lot);

struct NamedRecord {  // a record in memory; a lot file must be able to hold its name
  std::string name;
  data::TestRecord record;
  data::TestRecord uncorrected = {};  // see Device::uncorrected; also empty if the uncorrected record is not known
  DeviceInfo info = {};
  VerticalInput vertical = {};
};
// Makes the contents from records in memory. Throws Error also for names that no lot file could hold.
Contents prepare(std::vector<NamedRecord> records, Settings const& settings, std::string const& title);
// Reads a compression test. If it gives no stiffness, `refusal` says why. Messages name files relative to `directory`.
data::VerticalTest prepare_vertical(VerticalInput const& given, std::filesystem::path const& directory);
// Reads the files of one test, one after another as one history. Throws Error as data::read_record() does.
data::TestRecord read_history(TestInput const& input);
// Cuts `directory` from the paths in a text, so that results do not depend on the folder in which the program started.
std::string with_shown_files(std::string text, std::filesystem::path const& directory);
// Only reads and cleans the devices, without laws and boxes. Does not throw for devices that cannot be used.
Contents prepare_devices(Lot const& lot);
// Does the same for records in memory. Throws Error as prepare() does for their names.
Contents prepare_devices(std::vector<NamedRecord> records, Acceptance const& acceptance);
fit::SearchBox search_box(laws::LawEntry const& law, data::FitRecord const& record, Settings const& settings);

}  // namespace isolaw::campaign
