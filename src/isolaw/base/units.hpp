// Units of a record's channels. isolaw stores kN, mm and s. Before a law is fitted, the record is converted once to the
// units of the law.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isolaw {

enum class Dimension { force, length, time, count };

struct Unit {
  Dimension dimension;
  std::string_view symbol;
  double in_record_units;  // the size of this unit in kN, mm or s
};

inline constexpr Unit kN{Dimension::force, "kN", 1.0};
inline constexpr Unit N{Dimension::force, "N", 1e-3};
inline constexpr Unit mm{Dimension::length, "mm", 1.0};
inline constexpr Unit cm{Dimension::length, "cm", 10.0};
inline constexpr Unit m{Dimension::length, "m", 1e3};
inline constexpr Unit s{Dimension::time, "s", 1.0};
inline constexpr Unit counts{Dimension::count, "1", 1.0};  // for a channel of counts; parse_unit() never returns it

// The unit that `text` names ("kN", "[mm]", "tonf", "lbf", "ms", ...); nullopt if unknown. Brackets, blanks and case
// are ignored. "mN" counts as unknown nevertheless, because a millinewton would be read as a meganewton if case is
// ignored.
std::optional<Unit> parse_unit(std::string_view text);

std::string known_units(Dimension dimension);  // "mm, cm, m, in, ft, dm, um" for length

std::string_view name(Dimension dimension);

}  // namespace isolaw
