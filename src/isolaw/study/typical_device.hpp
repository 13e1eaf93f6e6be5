// Chooses the device that stands for its lot where only one is shown.
#pragma once

#include <cstddef>
#include <optional>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Index of the device nearest to the lot's means of effective stiffness (in the reported cycle) and of each law's
// objective, in relative terms. Refused devices are passed over; the first of equals counts.
std::optional<std::size_t> typical_device(Summary const& summary);

}  // namespace isolaw::study
