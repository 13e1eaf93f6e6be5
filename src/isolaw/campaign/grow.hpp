// Lets a campaign grow: uses the results of a campaign with fewer devices, laws or runs that is otherwise the same.
#pragma once

#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {

// The reasons why the campaign asked for cannot use the results of the stored one. Empty if both are the same campaign,
// or if the stored one can grow to the one asked for.
std::vector<std::string> obstacles(Contents const& stored, Contents const& asked, Sides const& sides = {});

// All that is asked for beyond the stored campaign, in words: "2 devices", "law gallardo", "20 runs instead of 10", or
// another order of the devices. Empty if both campaigns ask for the same, even if the stored one is incomplete.
std::vector<std::string> growth(Contents const& stored, Contents const& asked);
// Moves to `asked` the stored results that are right for the larger campaign too: runs, analyses of devices and, if the
// devices are the same, of the lot. If more runs are asked for, the analyses go to Contents::held_over until the new
// runs show which analyses are still valid.
void take_over(Contents stored, Contents& asked);

}  // namespace isolaw::campaign
