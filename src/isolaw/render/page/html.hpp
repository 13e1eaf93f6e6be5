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

// The page with styles, scripts and data. Only its title and its blocks of data contain text from the input, escaped.
std::string html(Summary const& summary);
std::string building_html(building::Study const& study, building::Answers const& answers);
// The rules and design values that an existing page was written with; nullopt if the page states none.
std::optional<campaign::Acceptance> asked_in(std::string_view page);
// The embedded files: page.html with placeholders, page.css, page.js, building.js and plotly-basic.min.js.
std::span<Embedded const> page_files();

}  // namespace isolaw::render
