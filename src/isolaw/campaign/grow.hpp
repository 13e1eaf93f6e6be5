// Lets a campaign grow: takes over the results of a stored campaign that has fewer devices, laws or runs and is
// otherwise the same.
#pragma once

#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {

// Returns the reasons why the campaign `asked` cannot use the results of `stored`. Empty if both are the same campaign,
// or if `stored` can grow to `asked`.
std::vector<std::string> obstacles(Contents const& stored, Contents const& asked, Sides const& sides = {});

// Says in words what `asked` has beyond `stored`: "2 devices", "law gallardo", "20 runs instead of 10", or another
// order of the devices. Empty if both campaigns ask for the same, even if `stored` is incomplete.
std::vector<std::string> growth(Contents const& stored, Contents const& asked);
// Moves to `asked` the stored results that are right for the larger campaign too: runs, analyses of devices and, if the
// devices are the same, of the lot. If more runs are asked for, the analyses go to Contents::held_over until the new
// runs show which analyses are still valid.
void take_over(Contents stored, Contents& asked);

}  // namespace isolaw::campaign
