// The JSON form in which a store keeps findings: an array of objects {kind, law, other_laws, devices, parameters,
// blocks, numbers, words} without empty members. `kind` is the key of the kind's row in the table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"

namespace isolaw::wording {

std::string findings_json(std::vector<Finding> const& findings);
// Throws Error, or nlohmann::json::exception, for text that findings_json() does not write.
std::vector<Finding> findings_of(std::string_view json);

}  // namespace isolaw::wording
