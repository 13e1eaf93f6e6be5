// Lets a campaign grow: uses the results of a campaign with fewer devices, laws or runs that is otherwise the same.
#pragma once

#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {

// The reasons why the campaign asked for can neither continue the stored one nor grow from it; empty if it can.
std::vector<std::string> obstacles(Contents const& stored, Contents const& asked, Sides const& sides = {});

// Everything asked for beyond the stored campaign, in words: "2 devices", "law gallardo", "20 runs instead of 10", or
// another order of the devices. Empty if the stored campaign was asked for the same, whether or not it is complete.
std::vector<std::string> growth(Contents const& stored, Contents const& asked);
// Moves to `asked` the results that a campaign begun with everything would compute as well: runs, analyses of devices
// and, if the devices are the same, of the lot. If more runs are asked for, the analyses go to Contents::held_over
// until the new runs show which of them are still valid.
void take_over(Contents stored, Contents& asked);

}  // namespace isolaw::campaign
