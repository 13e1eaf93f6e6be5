// The ranking for a terminal: a table of the laws, what to be careful about, and a small plot of accuracy against
// robustness.
#pragma once

#include <string>
#include <string_view>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// UTF-8 text of at most `width` columns (at least 60 are used); no colours, no control characters from the input.
std::string ranking(Summary const& summary, int width = 80);

// Words of `text` broken at `width` columns, every line indented by `indent`, the first one starting with `bullet`.
std::string wrapped(std::string_view bullet, std::string_view text, int indent, int width);

}  // namespace isolaw::render
