// The data block of the page: everything report.html draws and prints, as compact JSON for the modules in script/.
#pragma once

#include <string>

#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Keys are those of summary.json where they mean the same. Statistics have nine significant digits. A curve is
// {"o":offset,"s":step,"d":[...]}: value k = offset + step * (sum of d[0..k]), d integers, a 20,000th of the range.
// Profiles and intervals have six significant digits.
std::string page_data_json(Summary const& summary);

}  // namespace isolaw::render
