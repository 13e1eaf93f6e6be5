// Analyses as the store holds them: JSON text, numbers to their last digit, null for what is not a finite number.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

std::string analysis_json(DeviceAnalysis const& analysis);
std::string analysis_json(LotAnalysis const& analysis);
std::string analysis_json(LeftOutAnalysis const& analysis);

// Of `device` and `law`, which the text does not say. Throws nlohmann::json::exception, or Error for what is no analysis.
DeviceAnalysis device_analysis(std::size_t device, std::string law, std::string_view json);
LotAnalysis lot_analysis(std::string law, std::string_view json);
LeftOutAnalysis left_out_analysis(std::size_t device, std::string law, std::string_view json);

}  // namespace isolaw::campaign
