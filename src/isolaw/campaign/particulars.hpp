// What a record's file says of its device in words ("23.5 °C", "120 cm2"), as the numbers that a lot file holds.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isolaw::campaign {

// What a lot file's key is a number of; text where it is none.
enum class Measure { text, temperature_C, length_mm, area_mm2 };

// The number that `text` states, in the unit of the measure. nullopt: no number or no unit that is known, or one comma
// before exactly three digits, which may group them ("282,743 mm2") as well as begin a fraction.
std::optional<double> stated(std::string_view text, Measure measure);

}  // namespace isolaw::campaign
