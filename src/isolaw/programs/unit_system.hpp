// The unit systems of exports. Programs have no units: an export names its system and converts all values to it.
#pragma once

#include <array>
#include <cmath>
#include <ranges>
#include <string>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::programs {

struct UnitSystem {
  std::string_view id;  // for example "kN-mm"
  Unit force, length;   // time is always in seconds

  double from_kN(double force_kN) const { return force_kN / force.in_record_units; }
  double from_mm(double disp_mm) const { return disp_mm / length.in_record_units; }
  // Converts a value in kN^force_power mm^length_power to this system. Powers need not be whole (1/mm^n).
  double convert(double value, double force_power, double length_power) const {
    if (force_power != 0.0) value *= std::pow(1.0 / force.in_record_units, force_power);
    if (length_power != 0.0) value *= std::pow(1.0 / length.in_record_units, length_power);
    return value;
  }
};

inline constexpr Unit kip{Dimension::force, "kip", 4.4482216152605};
inline constexpr Unit inch{Dimension::length, "in", 25.4};
inline constexpr std::array unit_systems{UnitSystem{"kN-mm", kN, mm}, UnitSystem{"N-m", N, m},
                                         UnitSystem{"kip-in", kip, inch}};

inline UnitSystem const& find_unit_system(std::string_view id) {
  for (auto const& system : unit_systems)
    if (system.id == id) return system;
  throw Error({.where = "--units",
               .found = std::string(id),
               .allowed = joined(unit_systems | std::views::transform(&UnitSystem::id))});
}

}  // namespace isolaw::programs
