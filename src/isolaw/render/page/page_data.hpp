// Makes the data block of report.html: everything that the page draws and prints, as compact JSON for the JavaScript
// modules in script/.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "isolaw/base/json.hpp"
#include "isolaw/base/unit_system.hpp"
#include "isolaw/render/results.hpp"

namespace isolaw::render {

// The keys are the same as in summary.json. Statistics have nine significant digits, profiles and intervals six. A
// curve is {"o":offset,"s":step,"d":[...]} with integers d: value k is offset + step * (d[0] + ... + d[k]), and step is
// 1/20,000 of the curve's range.
std::string page_data_json(Summary const& summary);

// Writes into the open object what the page needs to convert numbers: the units of every system; the endings of keys
// that state a unit (K_eff_kN_per_mm); and the keys of numbers whose unit is in the member `unit` of the same object.
// The page opens in the units `shown`.
void write_units(JsonWriter& out, UnitSystem const& shown);

// The names to typeset on a page. write_notation() writes the markers of the laws and the symbols of these names into
// the open object. A parameter's name such as a10 is not typeset if a device has the same name.
struct Notation {
  std::set<std::string_view> parameters, devices;
};
void write_notation(JsonWriter& out, Notation const& of);

}  // namespace isolaw::render
