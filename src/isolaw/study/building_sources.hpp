// What a building takes of a campaign: of each law the lot's, the tested devices and the population that they are of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/sources.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// What the file's building takes of a law: of one that goes into the plane as springs, the values that were fitted as
// such, where they were; and what is known against the lot's law and against that of every device that stands there.
// Throws Error: the law is not of this campaign, or was not analysed.
building::LawSource law_source(campaign::Contents const& contents, Summary const& summary, std::string_view law,
                               std::string_view where, building::BuildingFile const& file);

// The law that the campaign recommends for a device not tested; throws Error where there is none.
std::string recommended_law(Summary const& summary, std::string_view where);

}  // namespace isolaw::study
