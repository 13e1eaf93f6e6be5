// The data block of the page: everything report.html draws and prints, as compact JSON for the modules in script/.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "isolaw/base/json.hpp"
#include "isolaw/base/unit_system.hpp"
#include "isolaw/render/results.hpp"

namespace isolaw::render {

// Keys are those of summary.json. Statistics have nine significant digits, profiles and intervals six. A curve is
// {"o":offset,"s":step,"d":[...]}: value k = offset + step * (sum of d[0..k]) with integers d and step = range /
// 20,000.
std::string page_data_json(Summary const& summary);

// Writes into the open object how the page converts its numbers: the units of every system, the endings of keys from
// which the page reads the unit of a number, and the keys of numbers whose unit is a member of the same object. The
// page opens in the units `shown`.
void write_units(JsonWriter& out, UnitSystem const& shown);

// The names to typeset on a page. write_notation() writes the markers of the laws and the symbols of these names into
// the open object. A parameter's name such as a10 is not typeset if a device has the same name.
struct Notation {
  std::set<std::string_view> parameters, devices;
};
void write_notation(JsonWriter& out, Notation const& of);

}  // namespace isolaw::render
