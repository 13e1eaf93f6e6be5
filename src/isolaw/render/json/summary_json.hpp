// summary.json: the campaign in numbers for machines. Its schema is docs/summary-json.md.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Deterministic: equal summaries give equal bytes. Numbers read back as the same doubles; what is undefined is null.
std::string summary_json(Summary const& summary);

// How many runs were missing when a summary.json was made; empty for a text that does not say so.
std::optional<std::size_t> missing_runs_in(std::string_view summary_json);

}  // namespace isolaw::render
