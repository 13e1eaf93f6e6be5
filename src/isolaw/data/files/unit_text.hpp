// Reads a unit with a factor, as headers write it: "x10 kN", "10^3 N", "1/100 mm". Also finds hints in a column's name
// that its values are a multiple of the measured quantity.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "isolaw/base/units.hpp"

namespace isolaw::data {

struct UnitText {
  Unit unit;
  double factor = 1.0;  // a value of 1 in the file is `factor` units
  // False if the factor may also mean something else: "10 kN" may be a sensor's range, and "kN x10" may say that the
  // values were multiplied before they were written.
  bool is_certain = true;
};
// Returns nullopt if the text is no unit. Brackets and blanks are ignored.
std::optional<UnitText> parse_unit_text(std::string_view text);

// The sensitivity of a sensor that the file records as a voltage in `unit` (V or mV): a name with "25 mm/V" gives 25 mm
// for each V. nullopt if `unit` is no voltage or `name` states no sensitivity.
std::optional<UnitText> sensitivity_in(std::string_view name, std::string_view unit);

// The name without its sensitivity: "Disp [V] ()" for "Disp [V] (25 mm/V)".
std::string without_sensitivity(std::string_view name);

// Whether the text is the unit of another quantity, which no displacement or force can have: "%", "V", "MPa", "mm/s".
bool is_other_quantity(std::string_view unit);

// The part of a column's name that makes the scale of its values doubtful, such as "/2", "x10", "half", "per bearing"
// or "two bearings"; "" if there is none. `base` is the name without its unit. A word for a mean makes only forces
// doubtful: the mean of several displacement sensors is the device's displacement.
std::string scale_hint(std::string_view base, Dimension dimension);

// Another unit of the same dimension in `base`, as "mm" in "Displacement mm [in]"; "" if there is none. Words that may
// not be units are ignored: "in", single letters, and a unit after a number, which may be a sensor's range.
std::string other_unit_in(std::string_view base, Unit const& unit);

}  // namespace isolaw::data
