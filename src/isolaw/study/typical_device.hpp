// Chooses the device that represents its lot if only one is shown.
#pragma once

#include <cstddef>
#include <optional>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The index of the device whose effective stiffness (in the reported cycle) and objectives for each law are nearest to
// the lot's means, in relative terms. Refused devices are skipped. The first of equally near devices is chosen.
std::optional<std::size_t> typical_device(Summary const& summary);

}  // namespace isolaw::study
