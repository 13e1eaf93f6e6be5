// Finds faulty signals of a compression test, as signal_faults.hpp does of a shear test.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signal_faults.hpp"

namespace isolaw::data {

// Both channels are positive in compression. Creep, a press that lifts off and steps of a digitiser are no faults.
std::vector<SignalFault> vertical_faults(std::span<double const> disp_mm, std::span<double const> load_kN);

}  // namespace isolaw::data
