// The device that stands for its lot where one alone is shown.
#pragma once

#include <cstddef>
#include <optional>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Index of the device that lies nearest to the mean of the lot: in effective stiffness of the reported cycle and in the
// objective of each law, relative to their means. Among those that were not refused; the first of equals.
std::optional<std::size_t> typical_device(Summary const& summary);

}  // namespace isolaw::study
