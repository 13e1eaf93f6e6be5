// Chooses where to put each tested device, so that the isolation layer twists least.
#pragma once

#include <cstddef>
#include <span>
#include <vector>
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

// Puts a device of known stiffness on each place. Exchanges pairs of devices until no exchange brings the centre of
// stiffness nearer to `centre`. This search may miss the best arrangement. Needs as many devices as places, or more.
struct Arrangement {
  std::vector<std::size_t> device;                  // [place]
  double eccentricity_mm = 0.0, in_order_mm = 0.0;  // as arranged here, and with the devices in order
};
Arrangement arrange(std::span<Point const> places, Point centre, std::span<double const> stiffness);

}  // namespace isolaw::building
