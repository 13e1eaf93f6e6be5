// A campaign that grows: one of fewer devices, laws or runs, all else the same, serves the larger one.
#pragma once

#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::campaign {

// What makes the stored campaign none that the one asked for continues or grows from; empty where there is nothing.
std::vector<std::string> obstacles(Contents const& stored, Contents const& asked, Sides const& sides = {});

// What is asked for beyond it, in words: "2 devices", "law gallardo", "20 runs instead of 10", or the devices' order;
// empty where only what was asked for then is missing, or nothing.
std::vector<std::string> growth(Contents const& stored, Contents const& asked);

// Takes over what the stored campaign computed, as far as a campaign begun with all would compute the same: runs, what
// was found on a device, and about the lot where it is of the same devices. What rests on the best of the runs is held
// over until it is known whether that is still the same (Contents::held_over).
void take_over(Contents stored, Contents& asked);

}  // namespace isolaw::campaign
