// Finds faulty signals of a compression test. signal_faults.hpp does so for shear tests.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/signals/signal_faults.hpp"

namespace isolaw::data {

// Both channels must be positive in compression. Creep, a press that lifts off and a digitiser's steps are no faults.
std::vector<SignalFault> vertical_faults(std::span<double const> disp_mm, std::span<double const> load_kN);

}  // namespace isolaw::data
