// Prints a campaign on a terminal: the answer on one screen, and all details on request.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// UTF-8 text of at most `width` columns (at least 60 are used), without colours or control characters from the input.
// For the usual laws it has at most 25 lines: the recommended law, the confidence, the table of laws, warnings, and the
// next command. `directory` is the report's directory and `campaign` the campaign's, both as the user would type them.
std::string answer(Summary const& summary, std::string_view directory, std::string_view campaign, int width = 80);
std::string ranking(Summary const& summary, int width = 80);
// Breaks `text` into lines of `width` columns, indented by `indent`. The first line starts with `bullet`.
std::string wrapped(std::string_view bullet, std::string_view text, int indent, int width);

}  // namespace isolaw::render
