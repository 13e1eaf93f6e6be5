// Functions for rows of the table whose wording depends on the findings (`compose` in table.hpp). Each gets the
// findings of one group and returns their sentence without its subject, "device-01: ".
#pragma once

#include <string>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

std::string signal_clipped(Group);
std::string signal_stuck(Group);
std::string signal_without_sign(Group);
std::string signal_interrupted(Group);
std::string signal_spike(Group);
std::string no_complete_cycle(Group);
std::string force_late(Group);
std::string force_early(Group);
std::string jump_of_force(Group);
std::string largest_speed(Group);
std::string spikes_repaired(Group);
std::string skew_removed(Group);
std::string all_samples_kept(Group);

}  // namespace isolaw::wording
