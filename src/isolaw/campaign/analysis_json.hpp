// Analyses as the store holds them: JSON text, numbers to their last digit, null for what is not a finite number. Of a
// DeviceAnalysis, LotAnalysis or LeftOutAnalysis, without its device, law and maker, which are columns of their own.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

template <class Analysis>
std::string analysis_json(Analysis const& analysis);

// Throws nlohmann::json::exception, or Error for what is no analysis.
template <class Analysis>
void read_analysis(std::string_view json, Analysis& analysis);

}  // namespace isolaw::campaign
