// The channels of a test record, and their names.
#pragma once

#include <string_view>
#include "isolaw/base/units.hpp"

namespace isolaw::data {

enum class Channel { time, disp, force, load, cycle, second_disp };

inline constexpr Channel all_channels[] = {Channel::time, Channel::disp,  Channel::force,
                                           Channel::load, Channel::cycle, Channel::second_disp};

std::string_view name(Channel channel);      // "disp", as options write it
std::string_view quantity(Channel channel);  // "horizontal displacement"
Dimension dimension(Channel channel);

}  // namespace isolaw::data
