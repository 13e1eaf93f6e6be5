// Writes summary.json: the campaign in numbers, for programs. docs/summary-json.md has the schema.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Equal summaries give equal text. Numbers read back as the same doubles; undefined values are null.
std::string summary_json(Summary const& summary);
// Adds a last member "profile", the text from profile_json(), unless `profile` is empty. The file summary.json has no
// profile, since times differ between runs.
std::string summary_json(Summary const& summary, std::string_view profile);
// Reads the number of missing runs from the text of a summary.json; nullopt if it states none.
std::optional<std::size_t> missing_runs_in(std::string_view summary_json);

}  // namespace isolaw::render
