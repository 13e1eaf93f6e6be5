// Writes summary.json: the campaign in numbers for machines. Its schema is docs/summary-json.md.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Equal summaries give equal bytes. Numbers read back as the same doubles; undefined values are null.
std::string summary_json(Summary const& summary);
// The same with a last member "profile", from profile_json(), unless `profile` is empty. The file summary.json has no
// profile, since times differ between runs.
std::string summary_json(Summary const& summary, std::string_view profile);
// The number of missing runs that the text of a summary.json states; nullopt if it states none.
std::optional<std::size_t> missing_runs_in(std::string_view summary_json);

}  // namespace isolaw::render
