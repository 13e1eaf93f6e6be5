// Systems of units. isolaw stores kN, mm and s; an export or a report names a system and converts its values to it.
#pragma once

#include <array>
#include <cmath>
#include <ranges>
#include <string>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw {

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
inline constexpr UnitSystem const& record_units = unit_systems[0];

// Throws Error about `where` if there is no such system.
inline UnitSystem const& find_unit_system(std::string_view id, std::string_view where = "--units") {
  for (auto const& system : unit_systems)
    if (system.id == id) return system;
  throw Error({.where = std::string(where),
               .found = std::string(id),
               .allowed = joined(unit_systems | std::views::transform(&UnitSystem::id))});
}

// A unit in which a report shows values, and the factor that converts a value to it.
struct ShownUnit {
  std::string unit;
  double factor = 1.0;

  // The number of decimals that make a converted value as precise as the original value with `decimals` decimals.
  int decimals(int decimals) const;
};
// Returns the unit in which `system` shows values that are stored in `unit`: "kip/in" for "kN/mm", "in" for "mm". In N
// and m a pressure stays in MPa. The system kN-mm changes no unit, and no system changes a unit without force and
// length ("%", "Hz").
ShownUnit shown_unit(std::string_view unit, UnitSystem const& system);

// The unit with which the name of a number ends: "kN/mm" for "K_eff_kN_per_mm"; "" if it ends with no unit of force or
// length.
std::string_view unit_of_name(std::string_view name);
// The name of a number after its value was converted: "isolator_in" for "isolator_mm".
std::string name_in(std::string_view name, UnitSystem const& system);
// A unit of results. The name of a result in this unit ends with `ending`. `form` says how another unit system writes
// the unit, where F stands for that system's force and L for its length. The unit is scale * kN^force * mm^length.
// Longer endings come first, so that unit_of_name() does not find "_mm" in "_kN_mm".
struct ResultUnit {
  std::string_view ending, unit, form;
  double force, length, scale = 1.0;
};
inline constexpr std::array result_units{ResultUnit{"_kN_per_mm", "kN/mm", "F/L", 1.0, -1.0},
                                         ResultUnit{"_kN_mm", "kN mm", "F L", 1.0, 1.0},
                                         ResultUnit{"_kNm", "kN m", "F L", 1.0, 1.0, 1e3},
                                         ResultUnit{"_mm_s2", "mm/s^2", "L/s^2", 0.0, 1.0},
                                         ResultUnit{"_mm_s", "mm/s", "L/s", 0.0, 1.0},
                                         ResultUnit{"_mm2", "mm^2", "L^2", 0.0, 2.0},
                                         ResultUnit{"_MPa", "MPa", "ksi", 1.0, -2.0, 1e-3},
                                         ResultUnit{"_kN", "kN", "F", 1.0, 0.0},
                                         ResultUnit{"_mm", "mm", "L", 0.0, 1.0}};

}  // namespace isolaw
