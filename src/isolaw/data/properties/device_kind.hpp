// Recognises viscous and sliding devices by the loop of one cycle.
#pragma once

#include <optional>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Fits F = F_0 + C |v|^alpha to the samples of a cycle, for each direction of motion by itself, by least squares of the
// logarithms of |F - F_0| and |v| where the speed is 5 % of the largest or more. nullopt if the device has stiffness
// (K_eff D is a tenth of the loop's mean half height or more), if its force hardly depends on speed (alpha below 0.05:
// friction), if a fit misses the forces by 15 % (rms) or more, or without time.
std::optional<ViscousLaw> viscous_law(CycleView const& view, Cycle const& cycle);

// mu = Q_d / N and R = N / K_d, if the loop is a slider's: its energy is 97 % or more of that of a loop that yields at
// once, and its Q_d is friction of 0.2 to 25 % of the vertical load. nullopt without the load. A slider without
// restoring stiffness has no R.
std::optional<Slider> slider(Cycle const& cycle);

}  // namespace isolaw::data
