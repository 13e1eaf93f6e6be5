// Makes report.html and building.html, which are single files that open offline and load nothing from the network.
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

// Returns the text of report.html with its styles, scripts and data. Only its title and its blocks of data contain text
// from the input, in escaped form.
std::string html(Summary const& summary);
std::string building_html(building::Study const& study, building::Answers const& answers);
// Returns the rules and design values with which the text `page` of an existing page was made, or nullopt if the page
// does not state them.
std::optional<campaign::Acceptance> asked_in(std::string_view page);
// Returns the files that are embedded in the program: page.html with placeholders, page.css, page.js, building.js and
// plotly-basic.min.js.
std::span<Embedded const> page_files();

}  // namespace isolaw::render
