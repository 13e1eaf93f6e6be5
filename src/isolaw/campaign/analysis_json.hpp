// Converts a DeviceAnalysis, LotAnalysis or LeftOutAnalysis to the JSON text that the store holds, and back. Numbers
// keep their last digit; one that is not finite is null. Device, law and maker are columns of their own in the store.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

template <class Analysis>
std::string analysis_json(Analysis const& analysis);

// Throws nlohmann::json::exception or Error if the text is not such an analysis.
template <class Analysis>
void read_analysis(std::string_view json, Analysis& analysis);

}  // namespace isolaw::campaign
