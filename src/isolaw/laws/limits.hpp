// Physical limits that parameters share.
#pragma once

#include <limits>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Interval any_value{-infinity, infinity};
inline constexpr Interval not_negative{0.0, infinity};
inline constexpr Interval not_positive{-infinity, 0.0};
inline constexpr Interval positive{std::numeric_limits<double>::min(), infinity};

}  // namespace isolaw::laws
