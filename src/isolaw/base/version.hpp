// The program's version. The number comes from the build (base/CMakeLists.txt).
#pragma once

#include <string_view>

namespace isolaw {

std::string_view version();  // "0.2.0"

}  // namespace isolaw
