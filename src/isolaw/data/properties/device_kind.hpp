// Recognises viscous and sliding devices by the loop of one cycle.
#pragma once

#include <optional>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// Fits F = F_0 + C |v|^alpha to the samples of a cycle at which the speed is 5 % of the largest or more, for each
// direction of motion by itself. The fit is least squares of the logarithms of |F - F_0| and |v|. nullopt in these
// cases:
// - The device has stiffness: K_eff D is a tenth of the loop's mean half height or more.
// - Its force hardly depends on speed (alpha below 0.05), so it is friction.
// - A fit misses the forces by 15 % (rms) or more.
// - The record has no time.
std::optional<ViscousLaw> viscous_law(CycleView const& view, Cycle const& cycle);

// The friction coefficient mu = Q_d / N and the radius R = N / K_d of a slider; no R without restoring stiffness. A
// loop is a slider's if its energy is at least 97 % of 4 Q_d D (the energy of a device that yields at once) and Q_d is
// 0.2 to 25 % of the vertical load N. Returns nullopt for other loops and for records without the load.
std::optional<Slider> slider(Cycle const& cycle);

}  // namespace isolaw::data
