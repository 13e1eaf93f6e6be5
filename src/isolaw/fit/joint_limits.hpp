// What the parameters of a law must meet together (laws/law.hpp), asked of overrides and of search boxes. A box that
// crosses such a limit is searched as it is.
#pragma once

#include <span>

#include "isolaw/fit/box.hpp"

namespace isolaw::fit {

// Throws Error where no point of the box meets a joint limit of the law; `overrides` are those that made it.
void require_joint_limits(laws::LawEntry const& law, SearchBox const& box, std::span<Override const> overrides);

// The same whatever the record: a parameter that is left to its box may be anything within its limits.
void require_joint_limits(laws::LawEntry const& law, std::span<Override const> overrides);

}  // namespace isolaw::fit
