// Chooses where to put each tested device, so that the isolation layer twists least.
#pragma once

#include <cstddef>
#include <span>
#include <vector>
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

// Puts a device of known stiffness on each place, so that the centre of stiffness is as near to `centre` as possible.
// Up to most_tried arrangements are all tried, which is so for 8 devices on 8 places. Of more, isolaw exchanges pairs
// of devices until no exchange helps, from many starts; this finds a near arrangement that may not be the nearest.
// Needs as many devices as places, or more.
inline constexpr double most_tried = 5e4;
struct Arrangement {
  std::vector<std::size_t> device;                  // [place]
  double eccentricity_mm = 0.0, in_order_mm = 0.0;  // as arranged here, and with the devices in order
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

}  // namespace isolaw::building
