// Checks overrides and search boxes against limits that concern several parameters of a law together (laws/law.hpp). A
// box that is partly outside such a limit is searched unchanged.
#pragma once

#include <span>

#include "isolaw/fit/box.hpp"

namespace isolaw::fit {

// Throws Error if no point of the box meets one of the law's joint limits; the message names the overrides concerned.
void require_joint_limits(laws::LawEntry const& law, SearchBox const& box, std::span<Override const> overrides);
// The same before a record is known: parameters without an override may take any value within their physical limits.
void require_joint_limits(laws::LawEntry const& law, std::span<Override const> overrides);

}  // namespace isolaw::fit
