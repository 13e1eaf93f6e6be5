#include "isolaw/base/unit_system.hpp"

#include <algorithm>

namespace isolaw {

int ShownUnit::decimals(int decimals) const {
  return std::clamp(decimals - static_cast<int>(std::lround(std::log10(factor))), 0, 9);
}

ShownUnit shown_unit(std::string_view unit, UnitSystem const& system) {
  auto const stored = std::ranges::find(result_units, unit, &ResultUnit::unit);
  bool const uses_kip = system.force.symbol == kip.symbol;
  if (stored == result_units.end() || system.id == record_units.id || (unit == "MPa" && !uses_kip))
    return {std::string(unit), 1.0};
  ShownUnit shown{{}, system.convert(stored->scale, stored->force, stored->length)};
  for (char const c : stored->form) {
    if (c == 'F')
      shown.unit += system.force.symbol;
    else if (c == 'L')
      shown.unit += system.length.symbol;
    else  // "kip-in" instead of "kip in": in "122 kip in a cycle", the inch would read as the word "in"
      shown.unit += c == ' ' && uses_kip ? '-' : c;
  }
  return shown;
}

std::string_view unit_of_name(std::string_view name) {
  auto const found = std::ranges::find_if(result_units, [&](auto const& each) { return name.ends_with(each.ending); });
  return found == result_units.end() ? std::string_view() : found->unit;
}

std::string name_in(std::string_view name, UnitSystem const& system) {
  auto const unit = unit_of_name(name);
  if (unit.empty() || system.id == record_units.id) return std::string(name);
  auto const ending = std::ranges::find(result_units, unit, &ResultUnit::unit)->ending;
  std::string text(name.substr(0, name.size() - ending.size() + 1));
  for (char const c : shown_unit(unit, system).unit) {
    if (c == '/')
      text += "_per_";
    else
      text += c == ' ' ? '_' : c;
  }
  return text;
}

}  // namespace isolaw
