#include "isolaw/base/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace isolaw {

std::string number_text(double value, int digits) {
  double const size = std::abs(value);
  if (size < std::pow(10.0, digits - 1) || size >= 999'999.5) return fmt::format("{:.{}g}", value, digits);
  double const unit = std::pow(10.0, std::floor(std::log10(size)) + 1.0 - digits);
  return fmt::format("{:.0f}", std::round(value / unit) * unit);
}

}  // namespace isolaw
