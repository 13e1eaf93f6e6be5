// Powers of force, length and time in a parameter's unit. They tell how the parameter grows with the size of a device.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "isolaw/laws/all_laws.hpp"

namespace isolaw::law_tests {

struct Powers {
  double force = 0.0, length = 0.0, time = 0.0;
};

// Returns the powers in a printed unit such as "kN s/mm" or "1/(N cm)". The exponent n in "1/mm^n" counts as 1.
inline std::optional<Powers> powers_of(std::string_view unit) {
  std::map<std::string_view, double Powers::*> const known{{"N", &Powers::force},   {"kN", &Powers::force},
                                                           {"mm", &Powers::length}, {"cm", &Powers::length},
                                                           {"m", &Powers::length},  {"s", &Powers::time}};
  Powers powers;
  double side = 1.0;
  for (std::size_t at = 0; at < unit.size();) {
    if (unit[at] == '/') side = -1.0;
    if (std::isalnum(static_cast<unsigned char>(unit[at])) == 0) {
      ++at;
      continue;
    }
    auto const word = unit.substr(at, unit.find_first_of(" /()", at) - at);
    auto const hat = std::min(word.find('^'), word.size());
    auto const found = known.find(word.substr(0, hat));
    if (found == known.end() && word != "1") return std::nullopt;
    if (found != known.end())
      powers.*found->second += side * (hat < word.size() && word[hat + 1] != 'n' ? word[hat + 1] - '0' : 1);
    at += word.size();
  }
  return powers;
}

// The automatic interval of a parameter is a multiple of a size of the device, such as its peak force. Some laws state
// a parameter at 100 mm instead; the size is then converted from the device's largest displacement to 100 mm, by
// laws::force_at_reference for example, which adds a power of length. This function returns that power, and 0 for all
// other sizes.
inline double at_reference(double (*size)(laws::RecordScales const&)) {
  std::map<double (*)(laws::RecordScales const&), double> const known{{laws::force_at_reference, -0.4},
                                                                      {laws::coefficient_at_reference<1>, -1.0},
                                                                      {laws::coefficient_at_reference<3>, -3.0},
                                                                      {laws::coefficient_at_reference<5>, -5.0},
                                                                      {laws::rate_at_reference, -0.5}};
  auto const found = known.find(size);
  return found == known.end() ? 0.0 : found->second;
}

}  // namespace isolaw::law_tests
