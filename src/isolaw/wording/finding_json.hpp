// The JSON form in which a store keeps findings: an array of objects {kind, law, other_laws, devices, parameters,
// blocks, numbers, words}, without empty members. The value of `kind` is the key of a row in the table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"

namespace isolaw::wording {

std::string findings_json(std::vector<Finding> const& findings);
// Reads what findings_json() wrote. Throws Error or nlohmann::json::exception for any other text.
std::vector<Finding> findings_of(std::string_view json);

}  // namespace isolaw::wording
