// Converts what a record's file states about its device in words ("23.5 °C", "120 cm2") to the numbers of a lot file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isolaw::campaign {

// The quantity and unit of the number that a key of a lot file takes. A key with Measure::text takes no number.
enum class Measure { text, temperature_C, length_mm, area_mm2 };

// Returns the number that `text` states, in the unit of the measure. nullopt if it has no number or no known unit, or
// if a single comma precedes exactly three digits: the comma may group digits ("282,743 mm2") or begin a fraction.
std::optional<double> stated(std::string_view text, Measure measure);

}  // namespace isolaw::campaign
