// Prints the results of a campaign on a terminal: the answer on one screen, and all details if the user asks for them.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Returns the answer as UTF-8 text: the recommended law, the confidence, the table of laws, warnings, and the next
// command. Its lines have at most `width` columns (a smaller width than 60 counts as 60). It has no colours and no
// control characters from the input. For the usual laws it has at most 25 lines. `directory` is the directory of the
// report and `campaign` that of the campaign, both as the user would type them.
std::string answer(Summary const& summary, std::string_view directory, std::string_view campaign, int width = 80);
std::string ranking(Summary const& summary, int width = 80);
// Breaks `text` into lines of `width` columns, indented by `indent`. The first line starts with `bullet`.
std::string wrapped(std::string_view bullet, std::string_view text, int indent, int width);

}  // namespace isolaw::render
