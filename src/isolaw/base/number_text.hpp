// Writes a number for sentences and for the terminal.
#pragma once

#include <string>

namespace isolaw {

// Rounds to `digits` significant digits and writes no exponent between 0.0001 and a million: "28390", not "2.839e+04".
std::string number_text(double value, int digits = 4);

}  // namespace isolaw
