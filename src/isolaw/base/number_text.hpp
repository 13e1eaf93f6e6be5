// Numbers in sentences and on the terminal.
#pragma once

#include <string>

namespace isolaw {

// As people read it: so many significant digits, without a power of ten from a thousandth to a million: "28390".
std::string number_text(double value, int digits = 4);

}  // namespace isolaw
