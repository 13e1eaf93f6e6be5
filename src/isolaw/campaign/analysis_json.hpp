// Converts a DeviceAnalysis, LotAnalysis or LeftOutAnalysis to the JSON text that the store holds, and back. Finite
// numbers come back exactly; the others are written as null and come back as NaN. Device, law and maker (the build that
// computed the analysis) are not in the text, since the store has columns for them.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

template <class Analysis>
std::string analysis_json(Analysis const& analysis);

// Throws nlohmann::json::exception or Error if the text is not an analysis of this type.
template <class Analysis>
void read_analysis(std::string_view json, Analysis& analysis);

}  // namespace isolaw::campaign
