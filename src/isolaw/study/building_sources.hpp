// What a building takes of a campaign: of each law the lot's, the tested devices and the population that they are of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/sources.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Throws Error: the law is not of this campaign, or was not analysed.
building::LawSource law_source(campaign::Contents const& contents, Summary const& summary, std::string_view law,
                               std::string_view where);

// The law that the campaign recommends for a device not tested; throws Error where there is none.
std::string recommended_law(Summary const& summary, std::string_view where);

}  // namespace isolaw::study
