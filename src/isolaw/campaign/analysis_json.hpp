// Converts a DeviceAnalysis, LotAnalysis or LeftOutAnalysis to the JSON text that the store holds, and back. Numbers
// keep their last digit; numbers that are not finite become null. Device, law and maker are not in the text, since the
// store has columns for them.
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
