// The ranking for a terminal: a table of the laws, what to be careful about, and a small plot of accuracy against
// robustness.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// UTF-8 text of at most `width` columns (at least 60 are used); no colours, no control characters from the input.
std::string ranking(Summary const& summary, int width = 80);

}  // namespace isolaw::render
