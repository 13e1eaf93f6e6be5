// The program's version. base/CMakeLists.txt sets it.
#pragma once

#include <string_view>

namespace isolaw {

std::string_view version();  // for example "0.4.0"

}  // namespace isolaw
