// Numbers as a person says them, in the sentences of findings.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A law as sentences name it; its id is for what is typed.
inline std::string called(LawResult const& law) {
  return std::string(laws::called(law.id));
}

// Nobody reads three hundred digits.
inline std::string with_decimals(double value, int decimals) {
  constexpr double largest = 1e6;
  return std::abs(value) < largest ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.3g}", value);
}

// Two significant digits below ten, none behind the point above.
inline std::string percent(double fraction) {
  double const value = 100.0 * fraction;
  return with_decimals(value, std::abs(value) < 9.95 ? 1 : 0) + " %";
}

inline std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 32);
  return text;
}

}  // namespace isolaw::study
