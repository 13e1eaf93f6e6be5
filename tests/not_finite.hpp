// The values that are no finite number, as tests call them.
#pragma once

#include <limits>

namespace isolaw {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace isolaw
