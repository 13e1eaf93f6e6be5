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

// The page with styles, scripts and data inlined. It contains text from the input only in its title and inside the data
// block, escaped.
std::string html(Summary const& summary);
// The page of a building, with the data of building.json.
std::string building_html(building::Study const& study, building::Answers const& answers);
// The state of acceptance that an existing page was written with; nullopt if it states none.
std::optional<campaign::Acceptance> asked_in(std::string_view page);
// page.html (html() fills its placeholders), page.css, page.js, building.js and plotly-basic.min.js.
std::span<Embedded const> page_files();

}  // namespace isolaw::render
