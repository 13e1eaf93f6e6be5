// report.html and building.html: self-contained pages that open offline and load nothing from the network.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "isolaw/base/embedded.hpp"
#include "isolaw/render/results.hpp"

namespace isolaw::building {
struct Study;
struct Answers;
}  // namespace isolaw::building

namespace isolaw::render {

// The page with styles, scripts and data inlined. Text from the input reaches it only inside the data block, escaped,
// and the title.
std::string html(Summary const& summary);
// The same for a building; its data are those of building.json.
std::string building_html(building::Study const& study, building::Answers const& answers);
// The state of acceptance that an existing page was written with; nullopt where it states none.
std::optional<campaign::Acceptance> asked_in(std::string_view page);
// page.html, with the placeholders that html() fills, page.css, page.js, building.js and plotly-basic.min.js.
std::span<Embedded const> page_files();

}  // namespace isolaw::render
