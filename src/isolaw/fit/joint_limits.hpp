// Checks overrides and search boxes against joint limits: limits on several parameters of a law together, such as
// K1 >= K2 (laws/law.hpp). If only a part of a box meets a limit, the search still uses the whole box.
#pragma once

#include <span>

#include "isolaw/fit/box.hpp"

namespace isolaw::fit {

// Throws Error if no point of the box meets one of the law's joint limits. The message names the overrides responsible.
void require_joint_limits(laws::LawEntry const& law, SearchBox const& box, std::span<Override const> overrides);
// Checks overrides before a record is known: a parameter without override may then have any physically possible value.
void require_joint_limits(laws::LawEntry const& law, std::span<Override const> overrides);

}  // namespace isolaw::fit
