// Converts everything about a record, except the values of its channels, to JSON and back.
#pragma once

#include <string>

#include "isolaw/base/option.hpp"
#include "isolaw/data/channels/record.hpp"

namespace isolaw::campaign {

Json fault_json(data::SignalFault const& fault);
// Reads what fault_json() wrote. Throws Error or nlohmann::json::exception for any other object, and if an index in the
// fault is not below `samples`.
data::SignalFault fault_of(Json const& json, std::size_t samples);

std::string facts_json(data::TestRecord const& record);
// Adds the facts that facts_json() wrote to a record that has its channels. Throws as fault_of() does.
void take_facts(std::string const& json, data::TestRecord& record);

}  // namespace isolaw::campaign
