// Which build of isolaw computed a campaign. Numbers of two builds may differ, so that one campaign is of one.
#pragma once

#include <span>
#include <string>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// Of this program.
Maker this_maker();
// Whether they compute the same; what they ran on may differ.
bool same_build(Maker const& a, Maker const& b);
// "0.1.0, build 0123456789ab", of several "... and ..."; of none that of this program.
std::string text(std::span<Maker const> makers);
std::string text(Maker const& maker);
// Those that compute differently, each once, without what they ran on; of none that of this program.
std::vector<Maker> builds(std::span<Maker const> makers);

}  // namespace isolaw::campaign
