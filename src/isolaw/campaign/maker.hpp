// Tells which build of isolaw computed a campaign. One build must compute all of it, since two builds may give
// different numbers.
#pragma once

#include <span>
#include <string>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

Maker this_maker();  // the running program
// Whether two makers are the same known build, and so compute the same numbers. Their instruction sets may differ.
bool same_build(Maker const& a, Maker const& b);
// Text such as "0.1.0, build 0123456789ab", with "and" between several builds. An empty list stands for this program.
std::string text(std::span<Maker const> makers);
std::string text(Maker const& maker);
// The different builds among the makers, without instruction sets. An empty list stands for this program.
std::vector<Maker> builds(std::span<Maker const> makers);

}  // namespace isolaw::campaign
