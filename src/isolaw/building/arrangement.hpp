// Chooses where to put each tested device, so that the isolation layer twists least.
#pragma once

#include <cstddef>
#include <span>
#include <vector>
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

// Puts a device of known stiffness on each place, so that the centre of stiffness is as near to `centre` as possible.
// If there are at most most_tried arrangements, for example of 8 devices on 8 places, all are tried. Otherwise pairs of
// devices are exchanged until no exchange helps, from many starts; the result is good but need not be the best. Needs
// at least as many devices as places.
inline constexpr double most_tried = 5e4;
struct Arrangement {
  std::vector<std::size_t> device;  // the index of the device on each place
  // Distance of the centre of stiffness from `centre`: as arranged here, and with the devices in the given order.
  double eccentricity_mm = 0.0, in_order_mm = 0.0;
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

}  // namespace isolaw::building
