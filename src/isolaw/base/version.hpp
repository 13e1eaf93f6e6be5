// The version of the program.
#pragma once

#include <string_view>

namespace isolaw {

std::string_view version();  // "0.2.0"

}  // namespace isolaw
