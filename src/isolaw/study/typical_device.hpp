// Chooses the device that represents its lot if only one is shown.
#pragma once

#include <cstddef>
#include <optional>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Index of the device nearest to the lot's means of effective stiffness (in the reported cycle) and of each law's
// objective, in relative terms. Refused devices are skipped; the first of equally near devices is chosen.
std::optional<std::size_t> typical_device(Summary const& summary);

}  // namespace isolaw::study
