// Finds facts about the device above the rows of numbers (serial number, lot, date, ...) and keeps them as written.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::data {

// Keys and values in the order of the file. If a key occurs twice, the first counts.
using DeviceFacts = std::vector<std::pair<std::string, std::string>>;

// Adds the facts that a line states, such as "Serial No: X", "Specimen;D07" or "Temperature [C]", "23".
void take_device_facts(std::string_view line, char delimiter, DeviceFacts& found);

}  // namespace isolaw::data
