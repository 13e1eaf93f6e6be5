#include "isolaw/base/unit_system.hpp"

#include <algorithm>
#include <cstddef>

namespace isolaw {
namespace {

// Reads the power that follows a unit's symbol, such as "2" in "mm2" and "^3" in "m^3". Without a power it is 1.
std::optional<double> take_power(std::string_view& rest) {
  bool const marked = rest.starts_with('^');
  if (marked) rest.remove_prefix(1);
  auto const length = std::min(rest.find_first_not_of("0123456789."), rest.size());
  auto const power = number_in<double>(rest.substr(0, length));
  rest.remove_prefix(length);
  return power || marked ? power : std::optional(1.0);
}

// Units of force and length in which results and parameters of laws are stored.
std::optional<Unit> stored_unit(std::string_view symbol) {
  for (auto const& unit : {kN, N, mm, cm, m})
    if (unit.symbol == symbol) return unit;
  return std::nullopt;
}

}  // namespace

int ShownUnit::decimals(int decimals) const {
  return std::clamp(decimals - static_cast<int>(std::lround(std::log10(factor))), 0, 9);
}

ShownUnit shown_unit(std::string_view unit, UnitSystem const& system) {
  ShownUnit const same{std::string(unit), 1.0};
  if (system.id == record_units.id) return same;
  if (unit == "MPa" && system.force.symbol == kip.symbol) return {"ksi", system.convert(1e-3, 1.0, -2.0)};
  ShownUnit shown;
  bool below = false, in_brackets = false;
  for (auto rest = unit; !rest.empty();) {
    if (!is_letter(rest.front())) {
      if (rest.front() == '/') below = true;
      if (rest.front() == '(') in_brackets = true;
      if (rest.front() == ')') below = in_brackets = false;
      // In "122 kip in a cycle" the unit would read as a word.
      shown.unit += rest.front() == ' ' && system.force.symbol == kip.symbol ? '-' : rest.front();
      rest.remove_prefix(1);
      continue;
    }
    auto const length = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_letter) - rest.begin());
    auto const symbol = rest.substr(0, length);
    rest.remove_prefix(length);
    auto const before = rest;
    auto const power = take_power(rest);
    if (!power) return same;
    if (auto const from = stored_unit(symbol)) {
      auto const& to = from->dimension == Dimension::force ? system.force : system.length;
      shown.factor *= std::pow(from->in_record_units / to.in_record_units, below ? -*power : *power);
      shown.unit += to.symbol;
    } else {
      shown.unit += symbol;
    }
    shown.unit += before.substr(0, before.size() - rest.size());
    if (!in_brackets) below = false;
  }
  return shown;
}

std::string_view unit_of_name(std::string_view name) {
  auto const found = std::ranges::find_if(unit_endings, [&](auto const& each) { return name.ends_with(each[0]); });
  return found == unit_endings.end() ? std::string_view() : (*found)[1];
}

std::string name_in(std::string_view name, UnitSystem const& system) {
  auto const found = std::ranges::find_if(unit_endings, [&](auto const& each) { return name.ends_with(each[0]); });
  if (found == unit_endings.end() || system.id == record_units.id) return std::string(name);
  std::string text(name.substr(0, name.size() - (*found)[0].size() + 1));
  for (char const c : shown_unit((*found)[1], system).unit) {
    if (c == '/')
      text += "_per_";
    else
      text += c == ' ' ? '_' : c;
  }
  return text;
}

}  // namespace isolaw
