// Finds facts about the device above the rows of numbers: serial, lot, date, ... Values are kept as they are written.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::data {

// In the order of the file; only the first of each key.
using ParticularList = std::vector<std::pair<std::string, std::string>>;

// A line may read "Serial No: X", "Specimen;D07", "Temperature [C]", "23".
void take_particulars(std::string_view line, char delimiter, ParticularList& found);

}  // namespace isolaw::data
