// Short names for the two values that are not finite numbers.
#pragma once

#include <limits>

namespace isolaw {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace isolaw
