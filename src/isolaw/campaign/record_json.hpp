// Everything about a record but the values of its channels, as JSON.
#pragma once

#include <string>

#include "isolaw/base/option.hpp"
#include "isolaw/data/channels/record.hpp"

namespace isolaw::campaign {

Json fault_json(data::SignalFault const& fault);
// Reads what fault_json() wrote. Throws Error or nlohmann::json::exception for any other object, and for a fault that
// lies in none of `samples` samples.
data::SignalFault fault_of(Json const& json, std::size_t samples);

std::string facts_json(data::TestRecord const& record);
// Adds the facts that facts_json() wrote to a record that has its channels. Throws as fault_of() does.
void take_facts(std::string const& json, data::TestRecord& record);

}  // namespace isolaw::campaign
