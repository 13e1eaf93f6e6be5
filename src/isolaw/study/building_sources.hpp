// Takes a law's parameters for a building from a campaign: for the lot, the tested devices and their population.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/sources.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Takes one law's parameters for the building of `file`, and the findings against the law on the lot and on the devices
// in the building. If the building models the law in two directions by springs around a circle (fit/as_springs.hpp), it
// takes the parameters fitted to such springs, where the campaign has them. Throws Error, with a message that begins
// with `where`, if the campaign lacks the law or did not analyse it.
building::LawSource law_source(campaign::Contents const& contents, Summary const& summary, std::string_view law,
                               std::string_view where, building::BuildingFile const& file);
// The law that the campaign recommends for untested devices. If there is none, throws Error that begins with `where`.
std::string recommended_law(Summary const& summary, std::string_view where);

}  // namespace isolaw::study
