// The data block of the page: everything report.html draws and prints, as compact JSON for the modules in script/.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Results of summary.json have the same keys. Statistics have nine significant digits, profiles and intervals six. A
// curve is {"o":offset,"s":step,"d":[...]}: value k = offset + step * (sum of d[0..k]) with integers d; a step is a
// 20,000th of the range.
std::string page_data_json(Summary const& summary);

// Writes the members of the open object that every page's scripts need: how laws are marked, and how to typeset the
// symbols of these parameters and of sentences. A name like a10 is not typeset if a device has it.
struct Notation {
  std::set<std::string_view> parameters, devices;
};
void write_notation(JsonWriter& out, Notation const& of);

}  // namespace isolaw::render
