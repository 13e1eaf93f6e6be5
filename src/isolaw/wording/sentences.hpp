// Functions for those rows of the table whose wording depends on the findings (`Row::compose` in table.hpp). Each
// function gets the findings of one group and returns their sentence without its subject, such as "device-01: ".
#pragma once

#include <string>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

std::string signal_clipped(Group, UnitSystem const&);
std::string signal_stuck(Group, UnitSystem const&);
std::string signal_without_sign(Group, UnitSystem const&);
std::string signal_wraps(Group, UnitSystem const&);
std::string signal_interrupted(Group, UnitSystem const&);
std::string signal_spike(Group, UnitSystem const&);
std::string no_complete_cycle(Group, UnitSystem const&);
std::string force_late(Group, UnitSystem const&);
std::string force_early(Group, UnitSystem const&);
std::string jump_of_force(Group, UnitSystem const&);
std::string largest_speed(Group, UnitSystem const&);
std::string spikes_repaired(Group, UnitSystem const&);
std::string skew_removed(Group, UnitSystem const&);
std::string all_samples_kept(Group, UnitSystem const&);

}  // namespace isolaw::wording
