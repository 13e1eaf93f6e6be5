// Numbers as they are written in sentences and on the terminal.
#pragma once

#include <string>

namespace isolaw {

// `digits` significant digits, and no power of ten between 0.0001 and a million: "28390", not "2.839e+04".
std::string number_text(double value, int digits = 4);

}  // namespace isolaw
