// Writes summary.json: the campaign in numbers, for programs. docs/summary-json.md has the schema.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns the text of summary.json. Equal summaries give equal text. Reading the numbers gives the same doubles again;
// undefined values are null.
std::string summary_json(Summary const& summary);
// Adds a last member "profile", the text from profile_json(), unless `profile` is empty. The file summary.json has no
// profile, since times differ between runs.
std::string summary_json(Summary const& summary, std::string_view profile);
// Returns the number of missing runs that the text of a summary.json states, or nullopt if it does not state the
// number.
std::optional<std::size_t> missing_runs_in(std::string_view summary_json);

}  // namespace isolaw::render
