// What a file says of its device above the rows of numbers: serial, lot, date, temperature, rubber sizes, in the
// languages laboratories write. Values as they are written.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::data {

// Key of a lot file and value, in the order of the file, the first of each key.
using ParticularList = std::vector<std::pair<std::string, std::string>>;

// Adds what a line says, its cells apart by `delimiter`: "Serial No: X", "Specimen;D07", "Temperature [C]", "23".
void take_particulars(std::string_view line, char delimiter, ParticularList& found);

}  // namespace isolaw::data
