// The data block of the page: everything report.html draws and prints, as compact JSON for the modules in script/.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Keys are those of summary.json where they mean the same. Statistics have nine significant digits. A curve is
// {"o":offset,"s":step,"d":[...]}: value k = offset + step * (sum of d[0..k]), d integers, a 20,000th of the range.
// Profiles and intervals have six significant digits.
std::string page_data_json(Summary const& summary);

// Members of the open object that every page's scripts ask for: how laws are marked, and how the symbols of these
// parameters and of sentences are set; no word that a device is called by.
struct Notation {
  std::set<std::string_view> parameters, devices;
};
void write_notation(JsonWriter& out, Notation const& of);

}  // namespace isolaw::render
