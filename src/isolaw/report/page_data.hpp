// The data block of the page: everything report.html draws and prints, as compact JSON for the scripts in assets/page/.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "isolaw/report/summary.hpp"

namespace isolaw::report {

// Keys are those of summary.json where they mean the same. Statistics have nine significant digits. A curve is
// {"o":offset,"s":step,"d":[...]}: value k = offset + step * (sum of d[0..k]), d integers, a 20,000th of the range. Profiles and intervals have
// six significant digits.
std::string page_data_json(Summary const& summary);

// Indices of the samples drawn of `samples`: all, or evenly thinned to at most `most`, first and last kept.
std::vector<std::size_t> drawn_samples(std::size_t samples, std::size_t most);

}  // namespace isolaw::report
