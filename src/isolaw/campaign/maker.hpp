// Tells which build of isolaw computed a campaign. Two builds may give different numbers, so only one may compute it.
#pragma once

#include <span>
#include <string>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

Maker this_maker();  // the running program
// Whether both are one known build and thus compute the same; their instruction sets may differ.
bool same_build(Maker const& a, Maker const& b);
// "0.1.0, build 0123456789ab"; the different builds of several makers are joined by "and". No makers: this program.
std::string text(std::span<Maker const> makers);
std::string text(Maker const& maker);
// The different builds among the makers, each once, without instruction sets. Without makers: this program.
std::vector<Maker> builds(std::span<Maker const> makers);

}  // namespace isolaw::campaign
