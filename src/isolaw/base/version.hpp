// The program's version. base/CMakeLists.txt sets it.
#pragma once

#include <string_view>

namespace isolaw {

std::string_view version();  // "0.2.0"

}  // namespace isolaw
