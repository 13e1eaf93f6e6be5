// summary.json: the campaign in numbers for machines. Its schema is docs/summary-json.md.
#pragma once

#include <string>

#include "isolaw/report/summary.hpp"

namespace isolaw::report {

// Deterministic: equal summaries give equal bytes. Numbers read back as the same doubles; what is undefined is null.
std::string summary_json(Summary const& summary);

}  // namespace isolaw::report
