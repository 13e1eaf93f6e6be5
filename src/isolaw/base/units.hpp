// Units of the channels of a test record. Inside isolaw records are in kN, mm, s; laws convert once per record.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isolaw {

enum class Dimension { force, length, time };

// A unit as a laboratory writes it and its size in the record units (kN, mm, s).
struct Unit {
  Dimension dimension;
  std::string_view symbol;
  double in_record_units;  // kN, mm or s per one of this unit
};

inline constexpr Unit kN{Dimension::force, "kN", 1.0};
inline constexpr Unit N{Dimension::force, "N", 1e-3};
inline constexpr Unit mm{Dimension::length, "mm", 1.0};
inline constexpr Unit cm{Dimension::length, "cm", 10.0};
inline constexpr Unit m{Dimension::length, "m", 1e3};
inline constexpr Unit s{Dimension::time, "s", 1.0};

// The unit that `text` names ("kN", "[mm]", "tonf", "lbf", "ms", ...), brackets and blanks ignored.
// Case decides only where it must (mN is not a unit a load cell reports; "MN" is). nullopt when unknown.
std::optional<Unit> parse_unit(std::string_view text);

// The symbols accepted for a dimension, "kN, N, MN, tonf, kgf, kip, lbf".
std::string known_units(Dimension dimension);

std::string_view name(Dimension dimension);

}  // namespace isolaw
