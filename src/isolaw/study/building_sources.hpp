// Takes from a campaign what a building needs of a law: the parameters of lot and tested devices, and their population.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/sources.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// The parameters of one law for the building of `file`, and the findings against the law on the lot and on the devices
// that stand there. A law that acts in plan as springs comes with the parameters fitted to springs, if there are any.
// Throws Error where the law is not of this campaign or was not analysed.
building::LawSource law_source(campaign::Contents const& contents, Summary const& summary, std::string_view law,
                               std::string_view where, building::BuildingFile const& file);
// The law that the campaign recommends for a device not tested; throws Error where it recommends none.
std::string recommended_law(Summary const& summary, std::string_view where);

}  // namespace isolaw::study
