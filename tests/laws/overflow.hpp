// Values that carry a law's force beyond the largest double, on any record of ordinary size.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace isolaw::law_tests {

inline std::vector<std::pair<char const*, double>> overflowing_values(std::string_view law) {
  if (law == "bilinear") return {{"K2", 1e307}};
  if (law == "jankowski") return {{"a1", 1.7e308}, {"a6", 1.7e308}};
  if (law == "vaiana") return {{"beta2+", 1e5}};
  if (law == "bouc-wen") return {{"Ke", 1e308}};
  if (law == "abe" || law == "abe-y0") return {{"K2", 1e308}};
  if (law == "hwang-wu") return {{"a1", 1e308}};
  return {};
}

}  // namespace isolaw::law_tests
