#include "isolaw/base/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace isolaw {

std::string number_text(double value, int digits) {
  double const size = std::abs(value);
  bool const whole = size >= std::pow(10.0, digits - 1) && size < 999'999.5;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits);
}

}  // namespace isolaw
