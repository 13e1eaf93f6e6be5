// Pieces of sentences: lists of names, percentages, and the numbers of a group of findings.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

// Lists names as "A, B and C" or, if there are more than `most`, as "A, B and 5 more".
std::string enumerate(std::vector<std::string> const& names, std::size_t most = 5);

// Writes a number with fixed decimals. From a million on it has three significant digits, since fixed decimals could
// give hundreds of digits.
std::string with_decimals(double value, int decimals);
// Writes 0.042 as "4.2 %": one decimal below ten per cent, none above.
std::string percent(double fraction);
std::string capitalised(std::string text);
// The law's name in sentences, such as "Bouc-Wen". Users type the law's id instead.
std::string law_name(Finding const& finding);

// The number `name` of the findings as text: one number, or "4.2 to 6.1" if they differ.
template <class Print>
std::string range(Group group, std::string_view name, Print print) {
  double least = group.front().number(name), largest = least;
  for (auto const& finding : group) {
    double const value = finding.number(name);
    if (value < least) least = value;
    if (value > largest) largest = value;
  }
  std::string const low = print(least), high = print(largest);
  return low == high ? low : low + " to " + high;
}
// range() with numbers that are printed with `digits` significant digits.
std::string range(Group group, std::string_view name, int digits = 3);

// Joins the texts that say_one makes for the findings: "sample 151 on device-01, sample 421 on device-02 and 3 more".
// If all findings are about one device, the text does not name it, since the sentence begins with its name.
template <class Say>
std::string each(Group group, Say say_one, std::size_t most = 4) {
  if (group.size() == 1) return say_one(group.front());
  std::vector<std::string> parts;
  bool const several = devices_of(group).size() > 1;
  for (auto const& finding : group)
    parts.push_back(several ? say_one(finding) + " on " + enumerate(finding.devices) : say_one(finding));
  return enumerate(parts, most);
}

}  // namespace isolaw::wording
